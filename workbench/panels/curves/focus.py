"""What of the active curve is looked at: the points chosen, the parameter u, what is hovered and switched on.

This is state of the view: it is neither saved nor undone.
"""

from collections.abc import Iterable

from PySide6.QtCore import QObject, Signal

from workbench.document.model import Curve
from workbench.geometry.conventions import round_half_up
from workbench.rendering import device_map, figure_map
from workbench.rendering.subjects.curve import at_share, share_of
from workbench.session.session import Session

# Below this size of a cell, in logical pixels, points are put to halves, from it on to tenths of a cell.
FINE_PX = 8


class CurveFocus(QObject):
    """``changed`` comes when anything here did. ``points`` are ids, ``moving`` those that are being dragged.

    ``hovered`` is the number of the point whose basis function is pointed at, -1 for none; ``snaps`` puts
    points to the centres of pixels; ``shown`` has the names of what is switched on.
    """

    changed = Signal()

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self.points: frozenset[str] = frozenset()
        self.moving: tuple[str, ...] = ()
        self.hovered = -1
        self.snaps = False
        self.cell_px = 16.0
        self.probed: tuple[float, float] | None = None
        self.shown: frozenset[str] = frozenset({"polygon", "names", "construction"})

    @property
    def curve(self) -> Curve | None:
        """The active figure in its frame, when it is a curve."""
        active = self.session.frames.figure
        return active if isinstance(active, Curve) else None

    @property
    def selected(self) -> Curve | None:
        """The active curve, when it is the one that is selected, alone or with its group."""
        curve, selection = self.curve, self.session.state.selection
        if curve is None or curve.id not in selection:
            return None
        others = set(selection) - set(self.session.sheet.together((curve.id,)))
        return None if others else curve

    @property
    def u(self) -> float:
        """The share, 0 to 1, of the way through the curve's parameter."""
        return share_of(self.session.state.subject)

    def set_u(self, share: float) -> None:
        """Go to another share of the way."""
        self.session.update_state(subject=at_share(self.session.state.subject, min(1.0, max(0.0, share))))

    def choose(self, points: Iterable[str]) -> None:
        """Select these points of the active curve."""
        chosen = frozenset(points)
        if chosen != self.points:
            self.points = chosen
            self.changed.emit()

    def numbers(self, curve: Curve) -> list[int]:
        """The numbers of the chosen points in the order of the curve."""
        return [k for k, point in enumerate(curve.points_world) if point.id in self.points]

    def hover(self, number: int) -> None:
        """Point at a control point, or, with -1, at none."""
        if number != self.hovered:
            self.hovered = number
            self.changed.emit()

    def switch(self, name: str, on: bool) -> None:
        """Show something, or show it no longer."""
        shown = self.shown | {name} if on else self.shown - {name}
        if shown != self.shown:
            self.shown = shown
            self.changed.emit()

    def placed(self, x: float, y: float) -> tuple[float, float]:
        """Where a device point is put: to a pixel's centre, or to a handy fraction of a cell."""
        if self.snaps:
            return float(round_half_up(x)), float(round_half_up(y))
        step = 10 if self.cell_px >= FINE_PX else 2
        return round(x * step) / step, round(y * step) / step

    def world(self, x: float, y: float, curve: Curve | None = None) -> tuple[float, float]:
        """World coordinates of a device point; of a curve those that its chain takes there."""
        sheet = self.session.sheet
        scale = device_map(sheet) if curve is None else figure_map(sheet, curve)
        return scale.world_point(x, y)
