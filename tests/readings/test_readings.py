"""One text, three readings: for every entry they emit and write the same numbers, bit for bit."""

import ast
import copy
import inspect
import re
import textwrap
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine import compiled
from workbench.engine.arguments import bind
from workbench.engine.dialect import refusals
from workbench.engine.lowering import lower

ENTRIES = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries()]
COMPILED = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries() if not entry.compiles]
EXTENT = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries() if entry.extent]


def bits(rows: Any) -> bytes:
    return np.array(rows, np.float64).tobytes()


def emitted(entry: Entry, values: tuple[Any, ...]) -> list[tuple[Any, ...]]:
    return list(entry.function(*copy.deepcopy(values)))


def collected_in_place(
    entry: Entry, values: tuple[Any, ...], count: int, flavour: str
) -> tuple[Any, tuple[Any, ...]]:
    """The ``count`` rows that are emitted, and the arguments as they are then: one driver does for both."""
    kernel = compiled.kernel(entry.function, flavour=flavour)
    arity = kernel.lowered.arity
    whole = kernel.emits in ("pixels", "spans")
    room, emitted = np.zeros(count * arity, np.int64 if whole else np.float64), np.zeros(1, np.int64)
    written = bind(entry.function, values, True)
    kernel.call("_collect", (room, emitted, compiled.Stop().flag, *written), True)
    assert emitted[0] == count
    return room.reshape(-1, arity), written


def runs(entry: Entry) -> st.SearchStrategy[tuple[Any, ...]]:
    """Generated arguments, and the example at times: it may be larger than what is generated."""
    return st.one_of(arguments(entry), arguments(entry), st.builds(lambda: entry.example))


@pytest.mark.parametrize("entry", COMPILED)
@given(data=st.data())
@settings(max_examples=40)
def test_the_three_readings_emit_and_write_the_same(entry: Entry, data: st.DataObject) -> None:
    values = data.draw(runs(entry))
    shown = copy.deepcopy(values)
    rows = list(entry.function(*shown))
    for flavour in ("interpreted", "checked"):
        collected, written = collected_in_place(entry, values, len(rows), flavour)
        assert bits(collected) == bits(rows), flavour
        for one, other in zip(shown, written, strict=True):
            if isinstance(one, np.ndarray):
                assert other.astype(one.dtype).tobytes() == one.tobytes(), flavour


@pytest.mark.parametrize("entry", EXTENT)
@given(data=st.data())
@settings(max_examples=200)
def test_no_pixel_leaves_the_declared_box(entry: Entry, data: st.DataObject) -> None:
    far = all(parameter.kind == "int" for parameter in entry.parameters) and data.draw(st.booleans())
    values = data.draw(
        st.tuples(*(st.integers(int(p.low or 0), int(p.high or 0)) for p in entry.parameters))
        if far
        else arguments(entry)
    )
    names = dict(zip((parameter.name for parameter in entry.parameters), values, strict=True))
    left, low, right, high = eval(entry.extent, {}, names)
    pixels = compiled.collect(entry.function, *values, flavour="checked")
    assert len(pixels) == 0 or (left <= pixels[:, 0].min() and pixels[:, 0].max() <= right)
    assert len(pixels) == 0 or (low <= pixels[:, 1].min() and pixels[:, 1].max() <= high)


class _Raised(ast.NodeTransformer):
    """Undoes the lowering: what emits yields again. Written apart from it, on purpose."""

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        self.generic_visit(node)
        node.decorator_list = []
        node.returns = None
        node.args.args = [a for a in node.args.args if a.arg != "_sink"]
        for one in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]:
            one.annotation = None
        first = node.body[0]
        if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant):
            del node.body[0]
        return node

    def visit_If(self, node: ast.If) -> ast.If | None:
        """The way out of a run that was stopped is no part of the text."""
        if ast.unparse(node.test) == "_stopped(_sink)":
            assert [type(each) for each in (*node.body, *node.orelse)] == [ast.Return]
            return None
        self.generic_visit(node)
        return node

    def visit_For(self, node: ast.For) -> ast.For:
        """A branch whose items were chosen is a branch again."""
        self.generic_visit(node)
        branch: ast.If | None = None
        body: list[ast.stmt] = []
        for statement in node.body:
            match statement:
                case ast.Assign(targets=[ast.Name(id="_taken")], value=test):
                    branch = ast.If(test, [], [])
                    body.append(branch)
                case ast.Assign(value=ast.Call(func=ast.Name(id="_chosen"), args=[_, value, _])) if branch:
                    branch.body.append(ast.Assign(statement.targets, value))
                case ast.If(test=ast.Name(id="_taken")) if branch:
                    branch.body += statement.body
                case _:
                    body.append(statement)
        node.body = body
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.stmt:
        assert node.value is not None
        return ast.Assign([node.target], node.value, lineno=node.lineno)

    def visit_ListComp(self, node: ast.ListComp) -> ast.expr:
        self.generic_visit(node)
        empty = ast.unparse(node.generators[0]).strip() == "for _none in range(0)"
        return ast.List([], ast.Load()) if empty else node

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id in ("_place", "_beside"):
            return node.args[0]
        if not (node.args and isinstance(node.args[0], ast.Name) and node.args[0].id == "_sink"):
            return node
        assert isinstance(node.func, ast.Name)
        given = node.args[1:]
        if node.func.id == "emit":
            return ast.Yield(given[0] if len(given) == 1 else ast.Tuple(given, ast.Load()))
        return ast.YieldFrom(ast.Call(node.func, given, node.keywords))


class _InPlace(ast.NodeTransformer):
    """Writes functions that are one expression where they are called with plain names: on both sides."""

    def __init__(self, functions: list[ast.FunctionDef]) -> None:
        self.expressions = {
            function.name: ([argument.arg for argument in function.args.args], value)
            for function in functions
            if (value := one_expression(function)) is not None
        }

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        names, text = self.expressions.get(name, ([], ""))
        given = [argument.id for argument in node.args if isinstance(argument, ast.Name)]
        if not text or len(given) != len(node.args) or len(given) != len(names):
            return node
        words = re.split(r"(\w+)", text)
        swapped = dict(zip(names, given, strict=True))
        return ast.parse("".join(swapped.get(word, word) for word in words), mode="eval").body


def one_expression(function: ast.FunctionDef) -> str | None:
    """What a function without a docstring gives back, where it does nothing else."""
    match function.body:
        case [ast.Return(value=ast.expr() as value)]:
            return ast.unparse(value)
        case [ast.If(body=[ast.Return(value=ast.expr())], orelse=[]), ast.Return(value=ast.expr())]:
            one, other = function.body
            assert isinstance(one, ast.If)
            assert isinstance(one.body[0], ast.Return)
            assert isinstance(other, ast.Return)
            parts = [part for part in (one.body[0].value, one.test, other.value) if part is not None]
            return "{} if {} else {}".format(*map(ast.unparse, parts))
    return None


@pytest.mark.parametrize("entry", ENTRIES)
def test_the_text_shown_is_the_text_lowered(entry: Entry) -> None:
    lowered = lower(entry.function)
    assert lowered.sources[-1] == inspect.getsource(entry.function)
    back = _Raised()
    written = [back.visit(node) for node in ast.parse(lowered.text).body if isinstance(node, ast.FunctionDef)]
    shown = [back.visit(ast.parse(textwrap.dedent(source)).body[0]) for source in lowered.sources]
    assert [node.name for node in written] == list(lowered.names)
    in_place = _InPlace(shown)
    for one, other in zip(written, shown, strict=True):
        texts = [ast.unparse(ast.fix_missing_locations(in_place.visit(node))) for node in (one, other)]
        assert texts[0] == texts[1]


@pytest.mark.parametrize("entry", ENTRIES)
def test_every_entry_is_in_the_dialect(entry: Entry) -> None:
    for source in lower(entry.function).sources:
        tree = ast.parse(textwrap.dedent(source)).body[0]
        assert isinstance(tree, ast.FunctionDef)
        assert refusals(tree) == []


def test_an_entry_that_is_not_compiled_says_why_and_is_read_as_python() -> None:
    for entry in (entry for entry in catalogue.entries() if entry.compiles):
        assert entry.compiles.strip()
        assert not compiled.ready(entry.function, "collect")
        assert bits(compiled.collect(entry.function, *entry.example)) == bits(emitted(entry, entry.example))
