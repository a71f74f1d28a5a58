"""The rewritten text stands alone and does what the shown one does."""

import ast
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.engine import written_texts as texts
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine import compiled
from workbench.engine.dialect import DialectError
from workbench.engine.lowering import Variant, lower
from workbench.engine.texts import DECORATORS, DRIVEN


def interpreted(function: Callable[..., Any], *arguments: Any) -> list[tuple[Any, ...]]:
    return [tuple(row) for row in compiled.collect(function, *arguments, flavour="interpreted").tolist()]


def test_callees_come_first_and_each_once() -> None:
    lowered = lower(texts.box)
    assert lowered.names == ("row_of", "box")
    assert lowered.text.index("def row_of(_sink") < lowered.text.index("def box(_sink")
    assert lowered.arity == 2
    assert not lowered.recursive


def test_a_plain_callee_keeps_its_arguments_and_records_are_imported() -> None:
    text = lower(texts.edges).text
    assert "def stepped(edge)" in text
    assert "from tests.engine.written_texts import Edge as Edge" in text
    assert "def round_half_up(value)" in text
    assert "rounded(" not in text
    assert "WEIGHTS = numpy.array([0.5, 0.25], dtype='float64')" in text
    assert "FAR = float('inf')" in text


@given(width=st.integers(-2, 5), height=st.integers(-1, 6))
def test_loops_with_else_continue_and_early_return(width: int, height: int) -> None:
    assert interpreted(texts.box, width, height) == list(texts.box(width, height))


@given(count=st.integers(0, 20))
def test_records_constants_and_aliases(count: int) -> None:
    assert interpreted(texts.edges, count) == list(texts.edges(count))
    assert interpreted(texts.corners) == list(texts.corners())


def test_an_empty_list_has_the_type_that_it_says() -> None:
    text = lower(texts.gathered).text
    assert "stack = [(0, 0) for _none in range(0)]" in text
    assert "rows = [[0.0 for _none in range(0)] for _none in range(0)]" in text
    assert "spans = [Span(Edge(0.0, 0.0), (0, 0), False) for _none in range(0)]" in text
    assert "from tests.engine.written_texts import Edge as Edge" in text
    emitted = [tuple(row) for row in texts.gathered(4)]
    assert emitted[-1] == (2, 3, 3.5, 1)
    assert interpreted(texts.gathered, 4) == emitted
    assert compiled.collect(texts.gathered, 4).tolist() == [list(row) for row in emitted]


def test_what_only_reads_an_item_stands_where_it_is_called() -> None:
    text = lower(texts.items).text
    body = text[text.index("def items(") :]
    inside = "0 <= x < image.shape[1] and 0 <= y < image.shape[0]"
    assert f"np.int64(image[y, _place(x)]) if {inside} else left" in body
    assert "item(image, x + 1, y, -2)" in body
    assert "np.int64(image[y - LIMIT, _place(x)])" in body
    assert "item_below(image, x, y)" in lower(texts.items_hidden).text
    assert "item(image, x, y, left)" in lower(texts.items, "counting").text.replace("_sink, ", "")
    image = np.arange(20, dtype=np.uint8).reshape(4, 5)
    for function in (texts.items, texts.items_hidden):
        emitted = [[int(value) for value in row] for row in function(image, 5)]
        assert compiled.collect(function, image, 5).tolist() == emitted
        assert compiled.collect(function, image, 5, flavour="interpreted").tolist() == emitted


def test_self_recursion_is_noticed_and_read_as_python() -> None:
    assert lower(texts.downwards).recursive
    assert compiled.collect(texts.downwards, 3).tolist() == [[3, 0], [2, 0], [1, 0], [0, 0]]
    assert not compiled.ready(texts.downwards, "collect")


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (texts.mixed, "3 numbers are emitted here, 2 elsewhere"),
        (texts.taking, "take it with yield from"),
        (texts.silent, "nothing is emitted"),
        (texts.unknown, "nowhere is not known here"),
        (texts.of_anything, "does not say what it is of"),
        (texts.of_no_list, "does not say what it is of"),
        (texts.naming_bounds, "the name Bounds is taken"),
        (texts.taking_count, "the name _count is taken"),
        (texts.taking_hit, "the name Hit is taken"),
    ],
)
def test_what_cannot_be_lowered_names_line_and_reason(function: Callable[..., Any], words: str) -> None:
    with pytest.raises(DialectError, match=words) as caught:
        lower(function)
    first = function.__code__.co_firstlineno
    assert first <= caught.value.line <= first + 4
    assert caught.value.function == function.__name__


@pytest.mark.parametrize("function", [texts.calling_part, texts.calling_run])
def test_a_callee_cannot_have_a_name_of_the_module_around_it(function: Callable[..., Any]) -> None:
    with pytest.raises(DialectError, match="this name is taken"):
        lower(function)


@pytest.mark.parametrize("entry", [pytest.param(entry, id=entry.slug) for entry in catalogue.entries()])
def test_all_names_of_the_module_around_a_text_are_taken(entry: Entry) -> None:
    variants: tuple[Variant, ...] = ("plain", "counting", "probing")
    for variant in variants:
        kernel = compiled.kernel(entry.function, variant=variant)
        own = ast.parse(kernel.text.replace(kernel.lowered.text, ""))
        bound = {node.name for node in own.body if isinstance(node, ast.FunctionDef)}
        for node in own.body:
            if isinstance(node, ast.ImportFrom):
                bound |= {alias.asname or alias.name for alias in node.names}
        assert bound <= DRIVEN
        assert {
            node.id
            for function in ast.parse(kernel.text).body
            if isinstance(function, ast.FunctionDef)
            for node in function.decorator_list
            if isinstance(node, ast.Name)
        } <= DECORATORS


def test_two_callees_of_one_name_are_refused() -> None:
    def same(name: str) -> Callable[..., Any]:
        return vars(texts)[name]  # type: ignore[no-any-return]

    renamed = same("spans")
    scope: dict[str, Any] = dict(vars(texts))
    scope["other"] = type(renamed)(renamed.__code__, scope, "row_of")
    clash = type(texts.box)(texts.box.__code__, scope, "box")
    scope["row_of"], scope["LIMIT"] = texts.row_of, scope["other"]
    with pytest.raises(DialectError, match="two functions of this name"):
        lower(clash)


def test_a_function_inside_another_cannot_hide_its_surroundings() -> None:
    step = 2

    def inner(count: int) -> Iterator[tuple[int, int]]:
        yield count * step, 0

    with pytest.raises(DialectError, match="pass them instead"):
        lower(inner)


def test_the_counting_text_emits_the_same() -> None:
    counting = lower(texts.box, "counting")
    assert counting.slots
    assert {line for slot in counting.slots for line in slot.lines} > set()
    assert np.array_equal(compiled.collect(texts.box, 3, 4, flavour="interpreted"), list(texts.box(3, 4)))
