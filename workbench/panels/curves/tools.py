"""The tool that selects and shapes curves: points, handles, tangents, the curve itself, the parameter u."""

import numpy as np

from workbench.document.curves.paths import is_path, joint_of
from workbench.document.curves.pieces import parameter_at
from workbench.document.model import AnyFigure, Curve
from workbench.document.transforms.chains import read_only_reason
from workbench.language import _
from workbench.panels.curves.drags import BendDrag, Drag, PointDrag, TangentDrag
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.scene import handles_shown, point_at
from workbench.panels.curves.shape import (
    device_pieces,
    device_points,
    nearest_share,
    smooth_line,
    tangent_ends,
)
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.outline import distance_to
from workbench.panels.stage.tools import SelectTool
from workbench.widgets.canvas.pixel_canvas import TOGETHER

# How near counts as on a grip, in logical pixels.
GRAB_PX = 11
LINE_PX = 7


class CurveSelectTool(SelectTool):
    """Selects curves and their points and moves what it takes hold of.

    ``modifiers`` are those of the last event. Of a curve that is selected its points, handles, tangents and
    the marker of u come first, then the curve itself, which bends; any other figure is selected and moved.
    """

    def __init__(self, focus: CurveFocus) -> None:
        super().__init__(focus.session)
        self.focus = focus
        self.modifiers = Modifiers.NoModifier
        self.drag: Drag | None = None
        self._sliding = False
        self._banding: frozenset[str] | None = None
        self._click: str | None = None
        self._moved = False

    @property
    def held(self) -> bool:
        """Whether something is being dragged, be it only u."""
        return self.busy or self._sliding

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Take hold of what is under the pointer."""
        self.modifiers, self._moved, self._click = modifiers, False, None
        curve = self.focus.selected
        if curve is not None and self._press_on(curve, x, y, bool(modifiers & Modifiers.ShiftModifier)):
            return
        self._banding = None
        before = self.session.state.selection
        super().press(x, y, modifiers, reach)
        if not self.busy and curve is not None and not self.session.state.selection:
            # An empty place beside a curve begins a band round its points; a click there lets go of it.
            self.session.update_state(selection=before)
            adding = modifiers & Modifiers.ShiftModifier
            self._banding = self.focus.points if adding else frozenset()
            self.focus.choose(self._banding)
        elif self.session.state.selection != before:
            self.focus.choose(())

    def _press_on(self, curve: Curve, x: float, y: float, adding: bool) -> bool:
        number, tangent = self.point_at(curve, x, y), self._tangent_at(curve, x, y)
        if number is None and tangent is None and self.on_u(curve, x, y):
            self._sliding = True
            return True
        if tangent is not None:
            self.drag = TangentDrag(self.focus, curve, x, y, tangent)
            self.focus.choose({curve.points_world[tangent].id})
            self._begin(curve, ())
            return True
        if number is None:
            return not adding and self._press_on_line(curve, x, y)
        point = curve.points_world[number].id
        if adding:
            self.focus.choose(self.focus.points ^ {point})
            if point not in self.focus.points:
                return True
        elif point not in self.focus.points:
            self.focus.choose({point})
        else:
            self._click = point
        numbers = self.focus.numbers(curve)
        self.drag = PointDrag(self.focus, curve, x, y, number, numbers)
        self._begin(curve, tuple(curve.points_world[k].id for k in numbers))
        return True

    def _press_on_line(self, curve: Curve, x: float, y: float) -> bool:
        share = self.share_at(curve, x, y)
        if share is None:
            return False
        self.drag = BendDrag(self.focus, curve, x, y, share)
        self._begin(curve, ())
        return True

    def _begin(self, curve: Curve, moving: tuple[str, ...]) -> None:
        if reason := read_only_reason(curve):
            self.failed.emit(reason)
            return
        self.focus.moving = moving
        self.begin()

    # What is under the pointer

    def _far(self, pixels: float) -> float:
        return pixels / self.focus.cell_px

    def point_at(self, curve: Curve, x: float, y: float) -> int | None:
        """The number of the control point there; of several that cannot be told apart the foremost."""
        points = device_points(self.session.sheet, curve)
        visible = handles_shown(curve, self.focus.numbers(curve))
        away = np.where(visible, np.abs(points - (x, y)).max(axis=1), np.inf)
        nearest = int(away.argmin())
        if away[nearest] > self._far(GRAB_PX):
            return None
        together = np.abs(points - points[nearest]).max(axis=1) <= self._far(TOGETHER)
        return self._foremost(curve, np.flatnonzero(together & visible).tolist())

    def _foremost(self, curve: Curve, numbers: list[int]) -> int:
        """Of points in one place the chosen one, or the last; a handle drawn into its point is under it."""
        if is_path(curve):
            free = [k for k in numbers if k % 3 == 0 or joint_of(curve, k) not in numbers]
            numbers = [k for k in free if k % 3 == 0] or free
        chosen = [k for k in numbers if curve.points_world[k].id in self.focus.points]
        return (chosen or numbers)[-1]

    def _tangent_at(self, curve: Curve, x: float, y: float) -> int | None:
        """The number of the point whose tangent ends there, nearer than any point and apart from its own."""
        points = device_points(self.session.sheet, curve)
        ends = {
            k: end
            for k, end in tangent_ends(self.session.sheet, curve).items()
            if np.abs(points[k] - end).max() > self._far(TOGETHER)
        }
        if not ends:
            return None
        away = {k: max(abs(ex - x), abs(ey - y)) for k, (ex, ey) in ends.items()}
        nearest = min(away, key=lambda k: away[k])
        to_point = float(np.abs(points - (x, y)).max(axis=1).min())
        return nearest if away[nearest] <= min(self._far(GRAB_PX), to_point) else None

    def under(self, x: float, y: float, reach: float) -> AnyFigure | None:
        """As everywhere, and curves beyond the sheet, which can be seen here too."""
        there = super().under(x, y, reach)
        if there is not None:
            return there
        sheet = self.session.shown
        away = {
            figure: distance_to((line,), x, y)
            for figure in reversed(sheet.figures)
            if isinstance(figure, Curve) and figure.visible and len(line := smooth_line(sheet, figure)) > 1
        }
        nearest = min(away, key=lambda figure: away[figure], default=None)
        return nearest if nearest is not None and away[nearest] <= self._far(LINE_PX) else None

    def on_grip(self, curve: Curve, x: float, y: float) -> bool:
        """Whether a control point or the end of a tangent is there."""
        return self.point_at(curve, x, y) is not None or self._tangent_at(curve, x, y) is not None

    def on_u(self, curve: Curve, x: float, y: float) -> bool:
        """Whether the marker of u is there, and can be seen."""
        if "construction" not in self.focus.shown:
            return False
        at = point_at(self.session.sheet, curve, self.focus.u)
        return at is not None and max(abs(at[0] - x), abs(at[1] - y)) <= self._far(GRAB_PX)

    def share_at(self, curve: Curve, x: float, y: float) -> float | None:
        """The share of the parameter at which the curve passes there; None where it does not."""
        pieces = device_pieces(self.session.sheet, curve)
        if pieces is None:
            return None
        share, away = nearest_share(pieces, x, y)
        return share if away <= self._far(LINE_PX) else None

    def over(self, x: float, y: float) -> str:
        """What is under the pointer: "grip", "curve" or nothing."""
        curve = self.focus.selected
        if curve is None:
            return ""
        if self.on_grip(curve, x, y) or self.on_u(curve, x, y):
            return "grip"
        return "curve" if self.share_at(curve, x, y) is not None else ""

    # On the way

    def move(self, x: float, y: float) -> None:
        """Move what is held, slide u, or draw the band."""
        if self._sliding:
            self._slide(x, y)
        elif self.drag is not None and self.busy:
            self._moved = True
            edit = self.drag.edit(x, y, bool(self.modifiers & Modifiers.ControlModifier))
            if edit is not None:
                self.show(edit, self.drag.name)
            self.tag = self.drag.tag
        else:
            super().move(x, y)

    def _slide(self, x: float, y: float) -> None:
        curve = self.focus.curve
        pieces = None if curve is None else device_pieces(self.session.sheet, curve)
        if curve is not None and pieces is not None:
            share, _away = nearest_share(pieces, x, y)
            self.focus.set_u(round(share, 4))
            self.tag = f"u = {parameter_at(curve, share):.4g}"

    def _select_inside(self) -> None:
        curve = self.focus.selected
        if self._banding is None or curve is None:
            super()._select_inside()
            return
        assert self.band is not None
        low, high = self.band.min(axis=0), self.band.max(axis=0)
        points = device_points(self.session.sheet, curve)
        inside = ((points >= low) & (points <= high)).all(axis=1)
        inside &= handles_shown(curve, self.focus.numbers(curve))
        self.focus.choose(self._banding | {curve.points_world[k].id for k in np.flatnonzero(inside)})

    def release(self, x: float, y: float) -> None:
        """Let go; a click on one of several chosen points leaves that one."""
        if self._banding is not None and self.band is None and not self._banding:
            self.session.update_state(selection=())
        if self._click is not None and not self._moved:
            self.focus.choose({self._click})
        super().release(x, y)
        self._done()

    def cancel(self) -> None:
        """Bring back what was moved."""
        super().cancel()
        self._done()

    def _done(self) -> None:
        self.drag, self._sliding, self._banding, self._click = None, False, None, None
        self.focus.moving = ()
        self.tag = ""

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Select")
