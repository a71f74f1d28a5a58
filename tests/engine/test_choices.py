"""Which branches become choices, and that nothing changes by it."""

import ast
import textwrap
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray

from workbench.engine import compiled
from workbench.engine.choices import bounded, choices
from workbench.engine.lowering import lower
from workbench.engine.places import counted_up

HEAD = "h, w = a.shape\n"


def written(branch: str, loops: str = "for y in range(h):\n    for x in range(min(n, w)):") -> str:
    """What stands for ``branch`` inside ``loops``, in a function of a, b and n."""
    body = textwrap.indent(branch, "        ")
    text = "def f(a, b, n):\n" + textwrap.indent(HEAD + loops + "\n" + body, "    ")
    tree = ast.parse(text).body[0]
    assert isinstance(tree, ast.FunctionDef)
    node = next(each for each in ast.walk(tree) if isinstance(each, ast.If))
    choice = choices(node, bounded(tree, counted_up(tree, frozenset())))
    return (
        "" if choice is None else "\n".join(ast.unparse(ast.fix_missing_locations(each)) for each in choice)
    )


def test_items_are_chosen_and_the_rest_stays_a_branch() -> None:
    assert written("if n < b[y, x]:\n    b[y, x] = n\n    a[y, x] = 1\n    won = 1").splitlines() == [
        "_taken = n < b[y, x]",
        "b[y, x] = _chosen(_taken, n, b[y, x])",
        "a[y, x] = _chosen(_taken, 1, a[y, x])",
        "if _taken:",
        "    won = 1",
    ]


@pytest.mark.parametrize(
    "branch",
    [
        "if n < 1:\n    b[y, x] = n",  # b may be smaller than a
        "if n < 1:\n    a[x, y] = n",
        "if n < 1:\n    a[y, n] = 1",
        "if n < 1:\n    a[y, x] = b[y, x]",
        "if n < 1:\n    a[y, x] = n\nelse:\n    n = 2",
        "if n < 1 and n < b[y, x]:\n    b[y, x] = n",
        "if 0 < n < b[y, x]:\n    b[y, x] = n",
        "if n < 1:\n    n = 2\n    a[y, x] = n",
        "if n < 1:\n    a[y] = n",
    ],
)
def test_an_item_that_may_not_be_there_is_written_by_a_branch_alone(branch: str) -> None:
    assert written(branch) == ""


@pytest.mark.parametrize(
    "loops",
    [
        "for y in range(h):\n    for x in range(n):",
        "for y in range(w):\n    for x in range(h):",
        "for y in range(h):\n    for x in range(n, w):",
        "for y in range(h):\n    for x in range(max(n, w)):",
        "w = n\nfor y in range(h):\n    for x in range(w):",
        "min = max\nfor y in range(h):\n    for x in range(min(n, w)):",
        "a = b\nfor y in range(h):\n    for x in range(w):",
        "for x in range(n):\n    y = x\nfor y in range(h):\n    for x in range(w):",
    ],
)
def test_loops_that_may_leave_the_array_prove_nothing(loops: str) -> None:
    assert written("if n < 1:\n    a[y, x] = n", loops) == ""


def lowered_into(image: NDArray[Any], depth: NDArray[Any], level: float) -> Iterator[tuple[int, int]]:
    """A text of two arrays of any kinds."""
    height, width = image.shape
    for y in range(height):
        for x in range(min(width, 5)):
            lower_here = 0
            if level < depth[y, x]:
                depth[y, x] = level
                image[y, x] = 7
                lower_here = 1
            yield y - 1, lower_here


@pytest.mark.parametrize(("of_image", "of_depth"), [(np.uint8, np.float32), (np.int64, np.float64)])
@given(level=st.floats(), depths=arrays(np.float64, (3, 6)), seed=st.integers(0, 9))
def test_every_reading_writes_the_same(
    of_image: Any, of_depth: Any, level: float, depths: Any, seed: int
) -> None:
    assert "_chosen" in lower(lowered_into).text
    with np.errstate(all="ignore"):
        depth = depths.astype(of_depth)
        level = float(of_depth(level))
    image = np.random.default_rng(seed).integers(0, 200, (3, 6)).astype(of_image)
    shown = image.copy(), depth.copy()
    emitted = list(lowered_into(*shown, level))
    for flavour in ("interpreted", ""):
        own = image.copy(), depth.copy()
        compiled.paint(lowered_into, own[0], 0, *own, level, flavour=flavour)
        assert [part.tobytes() for part in own] == [part.tobytes() for part in shown]
        collected = compiled.collect(lowered_into, image, depth, level, flavour=flavour)
        assert collected.tolist() == [list(row) for row in emitted]
