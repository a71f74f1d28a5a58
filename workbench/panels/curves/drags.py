"""What is dragged on a curve, each as a function from the pointer's way to an edit."""

import math
from collections.abc import Sequence

from workbench.algorithms.numerals import with_minus
from workbench.document.curves.pieces import parameter_at
from workbench.document.curves.shaping import drag_curve
from workbench.document.edits import Edit, move_points, set_attributes
from workbench.document.model import Curve
from workbench.language import _
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.names import point_name
from workbench.panels.curves.shape import TANGENT_SHARE, device_points, tangent_ends
from workbench.rendering import figure_map

_DIRECTIONS = 8


def constrained(dx: float, dy: float) -> tuple[float, float]:
    """The way (dx, dy) along the nearest of eight directions."""
    angle = round(math.atan2(dy, dx) * _DIRECTIONS / math.tau) * math.tau / _DIRECTIONS
    length = dx * math.cos(angle) + dy * math.sin(angle)
    return round(length * math.cos(angle), 9), round(length * math.sin(angle), 9)


class Drag:
    """One thing taken hold of at (x, y), device; ``name`` is the step of undo, ``tag`` what is said of it."""

    name = ""

    def __init__(self, focus: CurveFocus, curve: Curve, x: float, y: float) -> None:
        self.focus, self.curve, self.start = focus, curve, (x, y)
        self.tag = ""

    def edit(self, x: float, y: float, constrain: bool) -> Edit | None:
        """What the pointer at (x, y) makes of the document that the drag began with."""
        raise NotImplementedError

    def address(self, point: str, attribute: str) -> str:
        """The address of an attribute of one of the curve's points."""
        return f"{self.focus.session.sheet.id}/{self.curve.id}/{point}/{attribute}"


class PointDrag(Drag):
    """Moves control points; the one under the pointer, ``held``, is put to a handy place."""

    def __init__(
        self, focus: CurveFocus, curve: Curve, x: float, y: float, held: int, numbers: Sequence[int]
    ) -> None:
        super().__init__(focus, curve, x, y)
        self.name = _("Move point") if len(numbers) == 1 else _("Move points")
        self.held, self.numbers = held, tuple(numbers)
        self._points = device_points(focus.session.sheet, curve)

    def edit(self, x: float, y: float, constrain: bool) -> Edit | None:
        """The points moved as far as the held one."""
        hx, hy = self._points[self.held].tolist()
        dx, dy = x - self.start[0], y - self.start[1]
        if constrain:
            dx, dy = constrained(dx, dy)
        px, py = self.focus.placed(hx + dx, hy + dy)
        dx, dy = (px - hx if dx else 0.0), (py - hy if dy else 0.0)
        told = _("{name} ({x:g}, {y:g})\nby ({dx:g}, {dy:g})").format(
            name=point_name(self.curve, self.held),
            x=round(hx + dx, 4),
            y=round(hy + dy, 4),
            dx=round(dx, 4),
            dy=round(dy, 4),
        )
        self.tag = with_minus(told)
        places = {}
        for k in self.numbers:
            at = self._points[k]
            places[self.curve.points_world[k].id] = self.focus.world(at[0] + dx, at[1] + dy, self.curve)
        return move_points({self.address(point, "x"): place for point, place in places.items()})


class TangentDrag(Drag):
    """Turns and stretches the tangent of one point."""

    def __init__(self, focus: CurveFocus, curve: Curve, x: float, y: float, held: int) -> None:
        super().__init__(focus, curve, x, y)
        self.name = _("Change tangent")
        self.held = held
        self._at = device_points(focus.session.sheet, curve)[held].tolist()
        self._end = tangent_ends(focus.session.sheet, curve)[held]

    def edit(self, x: float, y: float, constrain: bool) -> Edit | None:
        """The tangent that ends where the pointer has brought it."""
        px, py = self._end[0] + x - self.start[0], self._end[1] + y - self.start[1]
        dx, dy = px - self._at[0], py - self._at[1]
        if constrain:
            dx, dy = constrained(dx, dy)
        way = figure_map(self.focus.session.sheet, self.curve).world_way(
            dx / TANGENT_SHARE, dy / TANGENT_SHARE
        )
        tx, ty = (round(part, 4) for part in way)
        told = _("tangent ({x:g}, {y:g})\nlength {length:.4g}")
        self.tag = with_minus(told.format(x=tx, y=ty, length=math.hypot(tx, ty)))
        point = self.curve.points_world[self.held].id
        return set_attributes({self.address(point, "tangent_x"): tx, self.address(point, "tangent_y"): ty})


class BendDrag(Drag):
    """Pulls the curve itself at one place, with the least change of its points."""

    def __init__(self, focus: CurveFocus, curve: Curve, x: float, y: float, share: float) -> None:
        super().__init__(focus, curve, x, y)
        self.name = _("Bend the curve")
        self._u = parameter_at(curve, share)

    def edit(self, x: float, y: float, constrain: bool) -> Edit | None:
        """The curve that passes where the pointer has come to."""
        dx, dy = x - self.start[0], y - self.start[1]
        if constrain:
            dx, dy = constrained(dx, dy)
        way = figure_map(self.focus.session.sheet, self.curve).world_way(dx, dy)
        self.tag = with_minus(_("u = {u:.4g}\nby ({dx:.3g}, {dy:.3g})").format(u=self._u, dx=dx, dy=dy))
        return drag_curve(self.curve.id, self._u, *way)
