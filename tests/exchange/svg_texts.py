"""Short drawings in SVG, and what becomes of them."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.document.curves.pieces import pieces_of
from workbench.document.model import Curve, Rectangle, Sheet, View, whole_sheet
from workbench.exchange.svg_paths import read_svg

Array = NDArray[np.float64]

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -100 100 100">'

SHEET = Sheet(
    "s1",
    "sheet",
    100,
    100,
    (View("v1", Rectangle(0, 0, 100, 100), whole_sheet(100, 100)),),
    (0xFFFFFF, 0, 0xFF0000),
)


def svg(body: str) -> str:
    return f"{HEAD}{body}</svg>"


def path(data: str, tolerance: float | None = None) -> list[Any]:
    return list(read_svg(svg(f'<path fill="none" stroke="red" d="{data}"/>'), SHEET, tolerance).figures)


def seen(figure: Any) -> Array:
    """The control points under the figure's chain in the coordinates of the SVG, y downwards."""
    points = np.array([(p.x, p.y, 1.0) for p in figure.points_world])
    return (points @ figure.matrix.T)[:, :2] * [1.0, -1.0]


def cubics(figure: Any) -> Array:
    """The cubic pieces in the coordinates of the SVG, y downwards."""
    assert isinstance(figure, Curve)
    assert figure.spline == "bezier_path"
    return pieces_of(figure).controls * [1.0, -1.0]
