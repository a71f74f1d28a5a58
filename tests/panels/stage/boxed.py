"""Figures in the box that transforms them, and a hand that drags it."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from workbench.document.model import (
    Circle,
    Curve,
    CurvePoint,
    Ellipse,
    Line,
    Polygon,
    SeedFill,
    WorldPoint,
)
from workbench.document.transforms.links import Rotate
from workbench.rendering import figure_map
from workbench.rendering.rounds import pieces_of_round

LEFT, SHIFT = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier


def at(*places):
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


LINE = Line("", at((20, 10), (35, 18)), "bresenham_line", 1)
CIRCLE = Circle("", at((40, 30)), "midpoint_circle", 2, radius_world=6.0)
ELLIPSE = Ellipse("", at((28, 30)), "midpoint_ellipse", 3, radius_x_world=8.0, radius_y_world=4.0)
TURNED = Ellipse(
    "",
    at((30, 34)),
    "midpoint_ellipse",
    3,
    radius_x_world=8.0,
    radius_y_world=3.0,
    transforms=(Rotate("", angle=30.0, x_pivot=30.0, y_pivot=34.0),),
)
POLYGON = Polygon("", at((22, 22), (34, 22), (28, 29)), "scan_line_exact", 1)
CURVE = Curve(
    "",
    tuple(CurvePoint("", *place) for place in ((20.0, 40.0), (26.0, 44.0), (36.0, 38.0))),
    "bresenham_line",
    1,
    spline="bezier",
)
SEED = SeedFill("", at((45, 12)), "boundary_fill_4", 2, boundary=1)
MIXED = (LINE, CIRCLE, TURNED, SEED, CURVE, POLYGON)


def settle():
    for _turn in range(4):
        QApplication.processEvents()


def ids(panel):
    return [figure.id for figure in panel.session.sheet.figures]


def choose(panel, number):
    identity = ids(panel)[number]
    panel.session.update_state(selection=(identity,), active=identity)
    settle()


def press(qtbot, panel, handle, way, modifiers=Qt.KeyboardModifier.NoModifier):
    """Drag a handle, or the inside, by ``way`` device units, without letting go."""
    box, canvas = panel.boxing.box, panel.canvas
    start = box.places().get(handle) or (box.box.x + 2.0, box.box.y + 2.0)
    begin, end = (canvas.widget_position(*place) for place in (start, np.add(start, way).tolist()))
    qtbot.mousePress(canvas, LEFT, modifiers, begin.toPoint())
    for share in (0.3, 0.7, 1.0):
        qtbot.mouseMove(canvas, (begin + (end - begin) * share).toPoint())
        settle()
    return (begin + (end - begin)).toPoint()


def drag(qtbot, panel, handle, way, modifiers=Qt.KeyboardModifier.NoModifier):
    end = press(qtbot, panel, handle, way, modifiers)
    qtbot.mouseRelease(panel.canvas, LEFT, modifiers, end)
    settle()


def watch(panel):
    """The matrices, device, that the box tells."""
    matrices = []
    panel.boxing.box.changed.connect(lambda matrix, _kind, _numbers: matrices.append(matrix))
    return matrices


def seen(sheet, figure):
    """Points (n, 2) where the first view shows them; of a circle or ellipse of its exact curve."""
    if isinstance(figure, Circle | Ellipse):
        local = pieces_of_round(figure).controls[:, ::2].reshape(-1, 2)
    else:
        local = np.array([(point.x, point.y) for point in figure.points_world])
    return figure_map(sheet, figure).points(local)


def moved(matrix, points):
    return points @ matrix[:2, :2].T + matrix[:2, 2]


def same_places(figure, one, other):
    """Whether two sets of points are one; of round figures, which may begin elsewhere, as ellipses."""
    if isinstance(figure, Circle | Ellipse):
        one, other = (each - each.mean(axis=0) for each in (one, other))
        return np.allclose(one.T @ one, other.T @ other, atol=1e-6)
    return np.allclose(one, other, atol=1e-6)
