"""Generated arguments for every entry of the catalogue, near-degenerate ones among them."""

from typing import Any

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from tests.curves.made_curves import BEZIER_RUNS, CURVE_RUNS, DE_BOOR_RUNS, FLATTENING_RUNS, RATIONAL_RUNS
from tests.curves.rational_curves import CLOSEST_RUNS
from workbench.algorithms.entry import Entry

near = st.integers(-9, 9)
radius = st.integers(0, 9)

_lines = st.tuples(near, near, near, near)
_pictures = st.tuples(st.integers(1, 6), st.integers(1, 6)).flatmap(
    lambda shape: arrays(np.int64, shape, elements=st.integers(0, 3))
)
_fills = st.tuples(_pictures, st.integers(-1, 6), st.integers(-1, 6), st.just(2), st.just(1))
_floods = st.tuples(_pictures, st.integers(-1, 6), st.integers(-1, 6), st.just(2))


def _with_floats(found: tuple[Any, ...]) -> tuple[float, ...]:
    *numbers, window = found
    return (*map(float, numbers), *map(float, window))


@st.composite
def _scenes(draw: st.DrawFn) -> tuple[Any, ...]:
    corner = st.tuples(st.integers(-8, 40), st.integers(-8, 32), st.integers(0, 15))
    triangles = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=2))
    vertices = np.array(triangles, float).reshape(-1, 3) / (4, 4, 16)
    faces = np.arange(len(vertices)).reshape(-1, 3)
    colours = np.arange(1, len(faces) + 1)
    return np.zeros((6, 8), np.int64), np.ones((6, 8)), vertices, faces, colours, 0, 6


_windows = st.tuples(near, near, st.integers(0, 12), st.integers(0, 12)).map(
    lambda found: (found[0], found[1], found[0] + found[2], found[1] + found[3])
)
_places = st.one_of(near, near.map(lambda quarters: quarters / 4))
_clipped_lines = st.tuples(_places, _places, _places, _places, _windows).map(_with_floats)
_clipped_points = st.tuples(_places, _places, _windows).map(_with_floats)
_clipped_polygons = st.tuples(st.lists(st.tuples(_places, _places), max_size=7), _windows).map(
    lambda found: (np.array(found[0], float).reshape(-1, 2), *map(float, found[1]))
)


STRATEGIES: dict[str, st.SearchStrategy[tuple[Any, ...]]] = {
    "dda_line": _lines,
    "dda_line_single": _lines,
    "dda_line_fixed": st.tuples(near, near, near, near, st.integers(1, 24)),
    "bresenham_line": _lines,
    "midpoint_line": _lines,
    "wu_line": _lines,
    "midpoint_circle": st.tuples(near, near, radius),
    "midpoint_ellipse": st.tuples(near, near, radius, radius),
    "boundary_fill_4": _fills,
    "boundary_fill_8": _fills,
    "boundary_fill_recursive": _fills,
    "boundary_fill_spans": _fills,
    "flood_fill_4": _floods,
    "flood_fill_8": _floods,
    "clip_point": _clipped_points,
    "cohen_sutherland": _clipped_lines,
    "liang_barsky": _clipped_lines,
    "sutherland_hodgman": _clipped_polygons,
    "depth_buffer": _scenes(),
    "de_casteljau": BEZIER_RUNS,
    "de_boor": DE_BOOR_RUNS,
    "de_boor_rational": RATIONAL_RUNS,
    "b_spline_curve": CURVE_RUNS,
    "flatten_bezier": FLATTENING_RUNS,
    "closest_point": CLOSEST_RUNS,
}


def arguments(entry: Entry) -> st.SearchStrategy[tuple[Any, ...]]:
    """Generated arguments for this entry; its own example where nothing more is known of it."""
    return STRATEGIES.get(entry.slug, st.builds(lambda: entry.example))
