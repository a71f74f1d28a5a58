"""Filled circles and ellipses: the midpoint outlines and all that they enclose."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.ndimage import binary_fill_holes

from workbench.algorithms.circles import midpoint_circle, midpoint_ellipse
from workbench.algorithms.polygons import circle_fill, ellipse_fill

radii = st.integers(0, 40)
centres = st.integers(-60, 60)


def enclosed(outline: list[tuple[int, int]]) -> set[tuple[int, int]]:
    """The outline's pixels and every pixel that four steps sideways cannot leave it from."""
    xy: NDArray[np.int64] = np.array(outline) - np.min(outline, axis=0)
    picture = np.zeros((xy[:, 1].max() + 1, xy[:, 0].max() + 1), bool)
    picture[xy[:, 1], xy[:, 0]] = True
    left, bottom = np.min(outline, axis=0).tolist()
    return {(left + x, bottom + y) for y, x in np.argwhere(binary_fill_holes(picture)).tolist()}


def spread(spans: list[tuple[int, int, int]]) -> set[tuple[int, int]]:
    return {(x, y) for y, left, right in spans for x in range(left, right + 1)}


@given(centres, centres, radii)
def test_a_filled_circle_is_what_its_outline_encloses(xc: int, yc: int, r: int) -> None:
    spans = list(circle_fill(xc, yc, r))
    assert spread(spans) == enclosed(list(midpoint_circle(xc, yc, r)))
    assert [y for y, _left, _right in spans] == list(range(yc - r, yc + r + 1))


@given(radii)
def test_a_filled_circle_is_the_same_in_all_its_mirrors(r: int) -> None:
    inside = spread(list(circle_fill(0, 0, r)))
    assert (
        inside == {(-x, y) for x, y in inside} == {(x, -y) for x, y in inside} == {(y, x) for x, y in inside}
    )


@given(centres, centres, radii, radii)
def test_a_filled_ellipse_is_what_its_outline_encloses(xc: int, yc: int, rx: int, ry: int) -> None:
    spans = list(ellipse_fill(xc, yc, rx, ry))
    assert spread(spans) == enclosed(list(midpoint_ellipse(xc, yc, rx, ry)))
    rows = [y for y, _left, _right in spans]
    assert sorted(rows) == list(range(yc - ry, yc + ry + 1))


@given(radii)
def test_an_ellipse_of_equal_radii_is_filled_as_the_circle(r: int) -> None:
    assert sorted(ellipse_fill(0, 0, r, r)) == sorted(circle_fill(0, 0, r))
