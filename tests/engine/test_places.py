"""Which subscripts are marked as never negative, and that nothing changes by it."""

import ast
import textwrap

import pytest

from workbench.engine.places import counted_up, unsigned


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
