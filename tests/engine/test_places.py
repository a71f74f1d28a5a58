"""Which subscripts are marked as never negative, and that nothing changes by it."""

import ast
import textwrap
from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray

from workbench.engine import compiled
from workbench.engine.lowering import lower
from workbench.engine.places import counted_up, met, unsigned


def names(text: str, own: frozenset[str] = frozenset()) -> set[str]:
    tree = ast.parse(textwrap.dedent(text)).body[0]
    assert isinstance(tree, ast.FunctionDef)
    return set(counted_up(tree, own))


@pytest.mark.parametrize(
    ("loop", "marked"),
    [
        ("for x in range(n): pass", {"x"}),
        ("for x in range(2, n): pass", {"x"}),
        ("for x in range(max(n, 0), 9): pass", {"x"}),
        ("for x in range(max(0, n), 9): pass", {"x"}),
        ("for x in range(n, 9): pass", set()),
        ("for x in range(-1, 9): pass", set()),
        ("for x in range(max(n, -1), 9): pass", set()),
        ("for x in range(max(n), 9): pass", set()),
        ("for x in range(9, -1, -1): pass", set()),
        ("for x in [n]: pass", set()),
        ("for x in range(n): x -= 1", set()),
        ("for x in range(n): pass\n    x = -1", set()),
        ("for x in range(n): pass\n    for x in range(-1, n): pass", set()),
        ("for x in range(n): pass\n    for x in range(3): pass", {"x"}),
        ("for n in range(n): pass", set()),
        ("for x in range(n): pass\n    y = [x for x in (-1, 2)]", set()),
        ("max = min\n    for x in range(n): pass", set()),
    ],
)
def test_a_name_is_never_negative_where_every_loop_counts_it_up_from_0(loop: str, marked: set[str]) -> None:
    assert names(f"def f(n):\n    {loop}") == marked


def test_a_range_of_ones_own_proves_nothing() -> None:
    text = "def f(n):\n    for x in range(n): pass"
    assert names(text, frozenset({"range"})) == set()


def test_only_subscripts_of_several_items_are_marked() -> None:
    def written(text: str) -> str:
        node = ast.parse(text, mode="eval").body
        assert isinstance(node, ast.Subscript)
        return ast.unparse(unsigned(node, frozenset({"x", "y"})))

    assert written("a[y, x]") == "a[_place(y), _place(x)]"
    assert written("a[y, 0]") == "a[_place(y), 0]"
    assert written("a[k, x - 1]") == "a[k, x - 1]"
    assert written("a[x]") == "a[x]"


def test_only_a_small_number_beside_a_name_or_field_is_marked() -> None:
    def written(text: str) -> str:
        node = ast.parse(text, mode="eval").body
        assert isinstance(node, ast.BinOp)
        return ast.unparse(met(node, frozenset({"x"})))

    assert written("x - low.x") == "_beside(x, low.x) - low.x"
    assert written("x * slope") == "_beside(x, slope) * slope"
    assert written("n - low.x") == "n - low.x"
    assert written("x / n") == "x / n"
    assert written("x - f(n)") == "x - f(n)"


def scaled(values: NDArray[np.float64], slope: float, back: int) -> Iterator[tuple[float, int]]:
    """A number that is counted beside a float, and beside a whole one that may be negative."""
    (count,) = values.shape
    for k in range(count):
        yield k * slope, k - back


def test_what_is_marked_is_the_same_number() -> None:
    values = np.zeros(9)
    for slope in (0.1, -1e300, float("inf")):
        assert "_beside(k, slope)" in lower(scaled).text
        expected = np.array(list(scaled(values, slope, 5)), float)
        assert np.array_equal(compiled.collect(scaled, values, slope, 5), expected, equal_nan=True)
