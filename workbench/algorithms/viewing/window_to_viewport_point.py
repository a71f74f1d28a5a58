"""One point through the window-to-viewport transformation.

sx, sy                  scale factors: sides of the viewport over sides of the window
x_moved, y_moved        the point when the window's corner is at the origin
x_scaled, y_scaled      the same at the viewport's size
xv, yv                  the point in the viewport
"""

import math
from collections.abc import Iterator
from random import Random

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.transforms.products import factor
from workbench.algorithms.viewing.window_marks import carried, marks


def window_to_viewport_point(
    xw: float, yw: float,
    xwmin: float, ywmin: float, xwmax: float, ywmax: float,
    xvmin: float, yvmin: float, xvmax: float, yvmax: float,
) -> Iterator[tuple[float, float]]:  # fmt: skip
    """Keep a point's relative position: move the window to the origin, scale it, move it to the viewport.

    Args: the point and the window in world coordinates, the viewport in device coordinates. Emits: (xv, yv),
    not rounded. Raises: ValueError for a rectangle without area.
    Source: Hearn and Baker, Computer Graphics, C Version, section 6-3.
    """
    # Divide the sides of the viewport by those of the window
    refuse_rectangle(xwmax - xwmin, ywmax - ywmin)
    refuse_rectangle(xvmax - xvmin, yvmax - yvmin)
    sx = (xvmax - xvmin) / (xwmax - xwmin)
    sy = (yvmax - yvmin) / (ywmax - ywmin)

    # Translate: the window's corner goes to the origin
    x_moved = xw - xwmin
    y_moved = yw - ywmin

    # Scale: the window becomes as large as the viewport
    x_scaled = sx * x_moved
    y_scaled = sy * y_moved

    # Translate: the origin goes to the viewport's corner
    xv = xvmin + x_scaled
    yv = yvmin + y_scaled
    yield xv, yv


def refuse_rectangle(width: float, height: float) -> None:
    """Raise ValueError unless a rectangle with these sides has a finite area."""
    if not (0.0 < width < math.inf and 0.0 < height < math.inf):
        raise ValueError("The window or the viewport has no area; give xmin < xmax and ymin < ymax.")


def alike(sx: float, sy: float) -> bool:
    """Whether both factors are the same, but for rounding."""
    return abs(sx - sy) <= 1e-12 * sx


def _point_and_rectangles(chance: Random) -> tuple[float, ...]:
    """A point in the window, on its edge or outside; now and then a viewport of the window's shape."""
    window, viewport = _rectangle(chance), _rectangle(chance)
    if chance.randint(0, 2) == 0:
        scale = chance.choice((0.5, 1.0, 3.0))
        x, y = viewport[:2]
        viewport = (x, y, x + scale * (window[2] - window[0]), y + scale * (window[3] - window[1]))
    x, y = (
        chance.choice((low, high, (low + high) / 2, chance.uniform(low, high), high + 3.0))
        for low, high in ((window[0], window[2]), (window[1], window[3]))
    )
    return x, y, *window, *viewport


def _rectangle(chance: Random) -> tuple[float, float, float, float]:
    x, y = float(chance.randint(-9, 9)), chance.uniform(-1e2, 1e2)
    return x, y, x + chance.choice((1.0, 4.0, 1e-3, 640.0)), y + chance.choice((1.0, 3.0, 1e-3, 480.0))


def _parameter(name: str, label: str, example: float, meaning: str) -> Parameter:
    return Parameter(name, label, "float", example, -1e9, 1e9, "", meaning)


def _rectangle_parameters(letter: str, name: str, sides: tuple[float, ...]) -> tuple[Parameter, ...]:
    edges = (("x", "min", "left"), ("y", "min", "bottom"), ("x", "max", "right"), ("y", "max", "top"))
    return tuple(
        _parameter(f"{x}{letter}{end}", f"{x}_{{{letter}{end}}}", side, f"{edge} edge of the {name}")
        for (x, end, edge), side in zip(edges, sides, strict=True)
    )


_FACTORS = "Divide the sides of the viewport by those of the window"
_OPTIONS = "('the picture keeps its proportions', 'the picture is distorted')"
_SX = (
    "s_x = ({xvmax} − {factor(xvmin)})/({xwmax} − {factor(xwmin)}) = {sx}, "
    "s_y = ({yvmax} − {factor(yvmin)})/({ywmax} − {factor(ywmin)}) = {sy}: "
)

ENTRY = Entry(
    function=window_to_viewport_point,
    topic="viewing",
    title="Window to viewport",
    summary="A point keeps its relative position: translate, scale by s_x and s_y, translate.",
    parameters=(
        _parameter("xw", "x_w", 3.0, "the point, in the world"),
        _parameter("yw", "y_w", 4.0, "the point, in the world"),
        *_rectangle_parameters("w", "window", (1.0, 1.0, 4.0, 4.0)),
        *_rectangle_parameters("v", "viewport", (3.0, 2.0, 6.0, 6.0)),
    ),
    arguments=_point_and_rectangles,
    emits="points",
    emitted_columns=("x_v", "y_v"),
    source="Hearn and Baker, Computer Graphics, C Version, section 6-3",
    columns=("step", "x", "y"),
    view_functions=(alike, carried, factor),
    views=(
        View(
            block=_FACTORS,
            when="alike(sx, sy)",
            row="('scale factors', sx, sy)",
            options=_OPTIONS,
            answer="'the picture keeps its proportions'",
            sentence=_SX + "both are the same, so the picture keeps its proportions.",
        ),
        View(
            block=_FACTORS,
            row="('scale factors', sx, sy)",
            options=_OPTIONS,
            answer="'the picture is distorted'",
            sentence=_SX + "they differ, so the picture is distorted.",
        ),
        View(
            block="Translate: the window's corner goes to the origin",
            row="('window to the origin', x_moved, y_moved)",
            marks="carried(x_moved, y_moved, xwmax - xwmin, ywmax - ywmin, 'accent')",
            sentence="x_w − x_wmin = {xw} − {factor(xwmin)} = {x_moved}, "
            "y_w − y_wmin = {yw} − {factor(ywmin)} = {y_moved}.",
        ),
        View(
            block="Scale: the window becomes as large as the viewport",
            row="('scaled to its size', x_scaled, y_scaled)",
            marks="carried(x_scaled, y_scaled, xvmax - xvmin, yvmax - yvmin, 'data2')",
            sentence="s_x·{factor(x_moved)} = {x_scaled}, s_y·{factor(y_moved)} = {y_scaled}.",
        ),
        View(
            block="Translate: the origin goes to the viewport's corner",
            row="('to the viewport', xv, yv)",
            sentence="x_v = {xvmin} + {factor(x_scaled)} = {xv}, y_v = {yvmin} + {factor(y_scaled)} = {yv}.",
        ),
    ),
    laws=(
        Law(
            "The point lies as far along the viewport as it lay along the window, but for rounding.",
            "viewing/test_window_to_viewport_point.py::test_the_relative_position_stays",
        ),
        Law(
            "The window's lower left corner goes to the viewport's, to the last digit.",
            "viewing/test_window_to_viewport_point.py::test_the_lower_left_corner_goes_to_the_lower_left_corner",
        ),
        Law(
            "It is the matrix T(x_vmin, y_vmin) S(s_x, s_y) T(−x_wmin, −y_wmin), but for rounding.",
            "viewing/test_window_to_viewport_point.py::test_the_steps_are_the_matrix",
        ),
    ),
    not_laws=(
        "What is mapped lies in the viewport: a point outside the window lands outside it, to be clipped.",
        "Shapes stay as they are: where s_x and s_y differ, a circle becomes an ellipse.",
    ),
    questions=(4,),
    labs=("Window to viewport",),
    frame="world",
    count="1",
    marks=marks,
)
