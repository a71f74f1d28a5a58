"""What the points and radii of a figure can express of a transformation."""

import math

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.transforms import Matrix
from workbench.document.model import AnyFigure, Circle, Curve, Ellipse, WorldPoint
from workbench.language import _

ROUNDING = 1e-12
"""What two numbers that ought to be equal may differ by, as a share of them."""


def expressed(figure: AnyFigure, matrix: Matrix) -> AnyFigure | str:
    """``figure`` with points and radii under ``matrix`` (3, 3), its chain as it is; or the sentence that says
    why they cannot express it.
    """
    if sentence := _beyond(figure, matrix):
        return sentence
    figure = replace(figure, points_world=moved_points(figure.points_world, matrix))
    return figure.with_radii(*radii_under(matrix, *figure.radii_world))


def _beyond(figure: AnyFigure, matrix: Matrix) -> str:
    match figure:
        case Circle() if not stays_circle(matrix, figure.radius_world):
            return _(
                "A circle has one radius and would become an ellipse, so the transform was "
                "added to its chain."
            )
        case Ellipse() if not axes_stay(matrix, figure.radius_x_world, figure.radius_y_world):
            return _(
                "The axes of an ellipse lie along x and y and would turn, so the transform was "
                "added to its chain."
            )
        case Curve(spline="catmull_rom") if figure.alpha != 0.0 and not stays_circle(matrix, 1.0):
            return _(
                "This Catmull-Rom curve follows the distances of its points, which would change unequally, "
                "so its chain got the transform."
            )
    return ""


def moved_points(points: tuple[WorldPoint, ...], matrix: Matrix) -> tuple[WorldPoint, ...]:
    """``points`` under ``matrix``; derivatives of curves only turn and stretch with it."""
    places = [(p.x, p.y) for p in points]
    moved = (np.array(places, np.float64) @ matrix[:2, :2].T + matrix[:2, 2]).tolist()
    return tuple(
        replace(point, x=x, y=y, **_tangent(point, matrix))
        for point, (x, y) in zip(points, moved, strict=True)
    )


def _tangent(point: WorldPoint, matrix: Matrix) -> dict[str, float]:
    tx, ty = getattr(point, "tangent_x", 0.0), getattr(point, "tangent_y", 0.0)
    if tx == 0.0 and ty == 0.0:
        return {}
    x, y = (matrix[:2, :2] @ (tx, ty)).tolist()
    return {"tangent_x": x, "tangent_y": y}


def axes_stay(matrix: Matrix, rx: float, ry: float) -> bool:
    """Whether an ellipse with these radii along x and y has its axes there too under ``matrix``."""
    (a, b), (c, d) = (matrix[:2, :2] * (rx, ry)).tolist()
    # The ellipse is x^T Q^-1 x = 1 with Q the half axes times their transpose, which has to be diagonal.
    return bool(abs(a * c + b * d) <= ROUNDING * math.hypot(a, b) * math.hypot(c, d))


def stays_circle(matrix: Matrix, radius: float) -> bool:
    """Whether a circle stays one under ``matrix``: moved, turned, reflected, scaled equally everywhere."""
    across, up = radii_under(matrix, radius, radius)
    return axes_stay(matrix, radius, radius) and abs(across - up) <= ROUNDING * max(across, up)


def radii_under(matrix: Matrix, rx: float, ry: float) -> tuple[float, float]:
    """Radii along x and y of an ellipse under a ``matrix`` that keeps its axes there."""
    (a, b), (c, d) = (matrix[:2, :2] * (rx, ry)).tolist()
    return math.hypot(a, b), math.hypot(c, d)
