"""The runs whose words are approved: every entry's own example, and what that does not show."""

import copy
from typing import Any

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.algorithms.projection import cavalier
from workbench.algorithms.visibility.surface_scene import cycle

Run = tuple[Any, ...]

STEEP_LEFTWARDS = (4, 9, 1, 3)  # dx = -3, dy = -6: every second choice is a tie
WINDOW = (0.0, 0.0, 30.0, 20.0)
BOWL = np.array([[1, 1, 1, 1, 1], [1, 0, 1, 0, 1], [1, 0, 0, 0, 1], [1, 0, 1, 0, 1], [1, 1, 1, 1, 1]])
WIDENING = np.array([[0, 0, 0, 0, 0, 0], [1, 1, 0, 1, 1, 0], [1, 0, 0, 0, 1, 0], [1, 1, 1, 1, 1, 0]])
CORNER = np.array([[0, 1], [1, 2]])
CUP = np.array([[0, 0, 0], [1, 2, 1]])
LETTER_M = np.array([[1.0, 1], [9, 1], [9, 7], [7, 7], [5, 3], [3, 7], [1, 7]])
STAR = np.array([[1.0, 5], [9, 5], [2, 0], [5, 8], [8, 0]])
SLIVER = np.array([[1.3, 1.0], [1.7, 1.0], [1.5, 4.0]])
BETWEEN_ROWS = np.array([[1.0, 1.2], [6.0, 1.2], [3.0, 1.8]])
THIRDS = np.array([[1.0, 1], [1, 3], [3, 7]])
PEAKS = np.array([[1.0, 1], [9, 1], [7, 7], [5, 2], [3, 5]])
FLAT = np.array([[1.0, 2], [6, 2], [3, 2]])
BETWEEN_CENTRES = np.array([[1.0, 0.5], [6, 0.5], [3, 3.5]])
TWO_RINGS = np.array([[1.0, 1], [5, 1], [3, 2], [1, 4], [3, 5], [5, 4]])
LOOPED = np.array([[0.0, 0], [10, 8], [-2, 8], [8, 0], [8, 0], [30, 0], [30, 9], [40, 9]])
STEPPED = np.array([[1.0, 1], [6, 1], [8, 3], [6, 5], [4, 5], [4, 8], [1, 8]])


def _inside(vertices: np.ndarray, x: float, y: float, nonzero: bool) -> Run:
    return vertices, np.array([len(vertices)]), x, y, nonzero


def _filled(vertices: np.ndarray, closed: bool, nonzero: bool) -> Run:
    return vertices, np.array([len(vertices)]), closed, nonzero


_TRIANGLES = np.array(
    [
        [1.0, 0.5, 0.5],
        [3, 0.5, 0.5],
        [2, 0.8, 0.5],
        [1, 1, 0.2],
        [5, 3, 0.2],
        [3, 2, 0.2],
        [0, 0, 0],
        [3, 0, 0],
        [0, 3, 0],
    ]
)

_SEEN_FROM_FRONT = catalogue.get("project_point").example


def _surfaces(*corners: tuple[float, float, float]) -> Run:
    """A small picture, and three corners for each triangle."""
    count = len(corners) // 3
    faces = np.arange(3 * count).reshape(count, 3)
    return np.zeros((6, 8), np.int64), np.array(corners), faces, np.arange(1, count + 1)


_LAYERS = _surfaces(
    *((0.0, 0, 0.2), (5, 0, 0.2), (0, 4, 0.2)),
    *((1.0, 1, 0.5), (1, 5, 0.5), (6, 1, 0.5)),
    *((2.0, 2, 0.8), (7, 2, 0.8), (2, 5, 0.8)),
)
_CYCLE = _surfaces(*cycle())
_ONE_PLANE = _surfaces(
    *((0.0, 0, 0.5), (6, 0, 0.5), (0, 5, 0.5)),
    *((1.0, 1, 0.5), (7, 1, 0.5), (1, 5, 0.5)),
    *((0.0, 0, 0.2), (6, 4, 0.9), (6, 5, 0.9)),
    *((5.0, 4, 0.3), (7, 4, 0.3), (7, 5, 0.3)),
)

_EDGES_ON_CENTRES = _surfaces(
    *((0.0, 2, 0.2), (2, 0, 0.2), (2, 4, 0.2)),
    *((0.0, 2, 0.5), (2, 0, 0.5), (2, 4, 0.1)),
)


def _beam(number: int, value: object) -> Run:
    """The electron beam of the example with another argument."""
    return tuple(
        value if k == number else each for k, each in enumerate(catalogue.get("electron_beam").example)
    )


# In the picture's corner, outside it, and on what is filled already
_CORNERED = tuple((CORNER, x, y, 2, 1) for x, y in ((0, 0), (-1, 0), (1, 1)))
_CORNER_FLOODED = tuple((CORNER, x, 0, 3) for x in (0, -1))

FURTHER: dict[str, tuple[Run, ...]] = {
    "electron_beam": (
        _beam(0, -60.0),
        _beam(1, 300.0),
        _beam(1, 500.0),
        _beam(4, np.array([0.0, 700.0])),
        _beam(4, np.array([0.0, 600.0])),
        (*_beam(3, True)[:4], np.array([0.5, 1.0]), *_beam(0, 0.0)[5:]),
        (*_beam(3, True)[:4], np.array([0.0, 5.0]), *_beam(0, 0.0)[5:]),
    ),
    "dda_line": (STEEP_LEFTWARDS,),
    "dda_line_single": (STEEP_LEFTWARDS,),
    "dda_line_fixed": ((*STEEP_LEFTWARDS, 3),),
    "bresenham_line": (STEEP_LEFTWARDS,),
    "bresenham_line_two_ends": (STEEP_LEFTWARDS, (0, 0, 8, 4)),
    "midpoint_line": (STEEP_LEFTWARDS,),
    "wu_line": (STEEP_LEFTWARDS,),
    "midpoint_circle": ((5, 5, 1),),
    "midpoint_ellipse": ((20, 4, 9, 1),),
    "inside_outside": (
        _inside(STEPPED, 3.0, 5.0, False),
        _inside(STEPPED, 0.0, 4.0, False),
        _inside(STEPPED, 4.0, 6.0, False),
        _inside(STAR, 5.0, 4.0, False),
        _inside(STAR, 5.0, 4.0, True),
    ),
    "scan_line_crossings": (
        _filled(STEPPED, False, False),
        _filled(LETTER_M, False, False),
        _filled(STAR, True, True),
        _filled(SLIVER, False, False),
        _filled(BETWEEN_ROWS, True, False),
        (TWO_RINGS, np.array([3, 6]), True, False),
        _filled(FLAT, True, False),
    ),
    "scan_line_fill": (
        _filled(STEPPED, False, False),
        _filled(LETTER_M, True, False),
        _filled(STAR, True, True),
        _filled(SLIVER, False, False),
        _filled(THIRDS, True, False),
        (TWO_RINGS, np.array([3, 6]), True, False),
        _filled(PEAKS, False, False),
        _filled(FLAT, True, False),
        _filled(BETWEEN_CENTRES, True, False),
    ),
    "scan_line_integer": (
        _filled(STEPPED, False, False),
        _filled(LETTER_M, True, False),
        _filled(STAR, True, True),
        _filled(SLIVER, False, False),
        _filled(THIRDS, True, False),
        _filled(PEAKS, False, False),
        _filled(FLAT, True, False),
        _filled(BETWEEN_CENTRES, True, False),
        (TWO_RINGS, np.array([3, 6]), True, False),
    ),
    "scan_line_exact": (
        _filled(PEAKS, False, False),
        _filled(FLAT, True, False),
        _filled(BETWEEN_CENTRES, True, False),
        _filled(STEPPED, False, False),
        _filled(LETTER_M, False, False),
        _filled(STAR, True, True),
        _filled(SLIVER, False, False),
    ),
    "ellipse_fill": ((9, 9, 1, 6),),
    "boundary_fill_recursive": ((CORNER, 0, 0, 2, 1),),
    "boundary_fill_4": ((BOWL, 0, 0, 2, 1), *_CORNERED),
    "boundary_fill_8": ((BOWL, 0, 0, 2, 1), *_CORNERED),
    "flood_fill_4": ((BOWL, 1, 1, 0), *_CORNER_FLOODED),
    "flood_fill_8": ((BOWL, 1, 1, 0), *_CORNER_FLOODED),
    "boundary_fill_spans": ((BOWL, 0, 0, 2, 1), (WIDENING, 2, 2, 2, 1), (CUP, 1, 0, 2, 1), *_CORNERED[1:]),
    "clip_point": ((31.0, 5.0, *WINDOW), (5.0, -1.0, *WINDOW)),
    "cohen_sutherland": (
        (-5.0, -1.0, -2.0, 9.0, *WINDOW),
        (5.0, -5.0, 35.0, 22.0, *WINDOW),
        (-5.0, 4.0, 9.0, 9.0, *WINDOW),
    ),
    "liang_barsky": (
        (-5.0, 4.0, -5.0, 9.0, *WINDOW),
        (5.0, 4.0, 5.0, 9.0, *WINDOW),
        (-9.0, 4.0, 4.0, -9.0, *WINDOW),
    ),
    "sutherland_hodgman": ((np.array([[-9.0, 2], [-5, 2], [-6, 9]]), *WINDOW),),
    "matrix_product": (
        (np.array([[1.0, 0, 3], [0, 1, 3], [0, 0, 1]]), np.array([[0.0, -1, 3], [1, 0, -3], [0, 0, 1]])),
        (np.array([[0.0, -1, 6], [1, 0, 0], [0, 0, 1]]), np.array([[5.0], [6], [1]])),
        (
            np.array([[1.0, 0, 0, 3], [0, 1, 0, 4], [0, 0, 1, -2], [0, 0, 0.5, 0]]),
            np.array([[2.0], [3], [4], [1]]),
        ),
    ),
    "transform_point": (
        (np.array([[1.0, 0, 2], [0, 1, 3], [0, 0, 2]]), np.array([5.0, 6])),
        (np.array([[1.0, 0, 0], [0, 1, 0], [0, 0.5, 0]]), np.array([3.0, 0])),
    ),
    "rotate_about_axis": ((np.pi / 6, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -2.0, 0.0, 0.0),),
    "window_to_viewport_point": ((5.0, 1.0, 0.0, 0.0, 4.0, 3.0, 100.0, 50.0, 180.0, 110.0),),
    "b_spline_curve": (
        (np.array([[1.0, 1], [2, 5], [5, 6], [7, 2], [10, 1]]), np.array([0.0, 0, 0, 1, 1, 2, 2, 2]), 2, 5),
    ),
    "closest_point": tuple((np.array([0.0, 1, 2]), LOOPED, np.ones(8), 3, x, 3.5) for x in (4.0, 3.5)),
    "raster_scan": ((np.array([[0, 9], [9, 0], [9, 9]]), np.array([0]), 1, 2, 2, 4.0, 6.0),),
    "random_scan": ((*catalogue.get("random_scan").example[:-1], 10.0),),
    "beam_spot": ((1.0, 1.0, 3.0, 2.0, 1.0, 0.4),),
    "project_point": (
        (*_SEEN_FROM_FRONT[:2], cavalier(0.5), *_SEEN_FROM_FRONT[3:]),
        (*_SEEN_FROM_FRONT[:4], np.array([3.0, 4, 0])),
        (*_SEEN_FROM_FRONT[:4], np.array([3.0, 4, 2])),
    ),
    "clip_to_view_volume": (
        (np.array([[0.0, 0, -1, 1], [1, 0, -1, 1], [0, 1, -1, -2]]), np.array([3]), -1.0, -1.0, 1.0, 1.0),
    ),
    "tween": (
        (0, 4, 2.0, -6.0, 0, 0.0, 0.0, 1.0, 1.0),
        (0, 4, -2.0, 6.0, 1, 0.0, 0.0, 1.0, 1.0),
        (0, 4, 0.0, 8.0, 7, 0.0, 0.0, 1.0, 1.0),
        (0, 4, 0.0, 8.0, 8, 0.25, 0.1, 0.25, 1.0),
    ),
    "spline_tween": (
        (
            np.array([0, 2, 8]),
            np.array([0.0, 4, 4]),
            np.array([0.0, 0.5, 0]),
            np.array([0.0, -0.5, 0]),
            np.zeros(3),
        ),
    ),
    "morph": (
        (np.array([[0.0, 0], [4, 0], [2, 3]]), np.array([[0.0, 0], [4, 0], [2, -3]]), True, 1, 0.25),
        (np.array([[0.0, 0], [4, 0]]), np.array([[0.0, 2], [1, 3], [4, 2]]), False, 0, 1.0),
    ),
    "slerp": (
        (np.array([1.0, 0, 0, 0]), np.array([-0.6, 0.8, 0, 0]), 1),
        (np.array([1.0, 0, 0, 0]), np.array([2.0, 0, 0, 0]), 1),
    ),
    "illuminate": (
        (
            np.zeros(3),
            np.array([0.0, 0, 1]),
            np.array([0.0, 0, 5, 1]),
            # Before, behind, in the point itself, behind a blocker
            np.array(
                [
                    [1.0, 2, 2, 1, 1, 0.5, 0.25, 0],
                    [1, 2, -2, 1, 1, 1, 0, 0],
                    np.eye(8)[3] + np.eye(8)[4],
                    [0, 0, 4, 0, 1, 1, 0, 0],
                ]
            ),
            np.array([0.1, 0.6, 0.3, 10]),
            True,
            np.array([[-1.0, -1, 3], [1, -1, 3], [0, 1, 3]]),
        ),
    ),
    "painter": (_LAYERS,),
    "depth_sort": (_LAYERS, _CYCLE, _ONE_PLANE),
    "bsp_tree": (_LAYERS, _ONE_PLANE),
    "area_subdivision": (_LAYERS, _EDGES_ON_CENTRES),
    "octree": (_LAYERS,),
    # Five in one place
    "ray_casting_boxes": (
        (np.zeros((2, 2), np.int64), _TRIANGLES[:3], np.array([[0, 1, 2]] * 5), np.arange(1, 6)),
    ),
    "depth_buffer": (
        (
            np.zeros((4, 6), np.int64),
            np.ones((4, 6)),
            _TRIANGLES,
            np.arange(9).reshape(3, 3),
            np.array([1, 2, 3]),
        ),
    ),
    "rgb_to_hsv": ((0.0, 0.0, 0.0), (0.9, 0.1, 0.5), (0.2, 0.3, 0.8)),
}


def telling_runs(entry: Entry) -> tuple[Run, ...]:
    """The runs of an entry whose words are approved."""
    return (entry.example, *copy.deepcopy(FURTHER.get(entry.slug, ())))
