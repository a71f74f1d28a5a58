"""The commands on curves: each one step of undo, and what cannot be done is said."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QObject, Signal

from workbench.document.addresses import Address
from workbench.document.curves.edits import (
    curve_with,
    remove_points,
    set_beside,
    set_curve_closed,
    set_joint,
    set_knot,
    set_knot_rule,
    set_weights,
)
from workbench.document.curves.pieces import goes_round, may_be_closed
from workbench.document.edits import Edit, move_points
from workbench.document.errors import DocumentError
from workbench.document.model import B_SPLINES, Curve, Document
from workbench.document.transforms.chains import read_only_reason
from workbench.language import _, ngettext
from workbench.panels.curves.basis import knot_names
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.gesture import Gesture
from workbench.rendering import figure_map

NUDGE = "nudge points"


class CurveCommands(QObject):
    """Does commands on the selected curve and its chosen points. ``said`` sends a sentence of what became."""

    said = Signal(str)

    def __init__(self, focus: CurveFocus, parent: QObject) -> None:
        super().__init__(parent)
        self.focus = focus
        self.session = focus.session
        self._pull = Gesture(self.session)
        self._pull.failed.connect(self.said)
        self._pulled: Curve

    def rows(self) -> list[PanelCommand]:
        """Name, text, icon, key and what it does, for the menu of the canvas and the list of commands."""
        return [
            ("corner", _("Make the joint a corner"), "caret-up", "Shift+C", partial(self.joint, "corner")),
            ("smooth", _("Make the joint smooth"), "waves", "Shift+S", partial(self.joint, "smooth")),
            (
                "symmetric",
                _("Make the joint symmetric"),
                "equals",
                "Shift+Y",
                partial(self.joint, "symmetric"),
            ),
            ("closed", _("Close or open the curve"), "circle-dashed", "Shift+O", self.toggle_closed),
        ]

    # What is worked on

    def address(self, curve: Curve, point: str, attribute: str = "x") -> str:
        """The address of an attribute of a point or knot."""
        return f"{self.session.sheet.id}/{curve.id}/{point}/{attribute}"

    def chosen(self, curve: Curve) -> list[str]:
        """The ids of the chosen points in the order of the curve."""
        return [curve.points_world[k].id for k in self.focus.numbers(curve)]

    def apply(self, edit: Edit, name: str, merge: str = "") -> bool:
        """Do an edit; False when it was refused, which is said."""
        try:
            self.session.apply(edit, name, merge)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return False
        return True

    def with_curve(self, act: Callable[[Curve], object]) -> None:
        """Do something with the selected curve, or say that there is none."""
        curve = self.focus.selected
        if curve is None:
            self.said.emit(_("Select one curve first."))
        else:
            act(curve)

    def with_points(self, least: int, act: Callable[[Curve, list[str]], object]) -> None:
        """Do something with the chosen points, or say how many are needed."""

        def with_those(curve: Curve) -> None:
            points = self.chosen(curve)
            if len(points) < least:
                text = ngettext(
                    "Choose a point of the curve first.", "Choose {least} points of the curve first.", least
                )
                self.said.emit(text.format(least=least))
            else:
                act(curve, points)

        self.with_curve(with_those)

    # Points

    def remove(self) -> bool:
        """Remove the chosen points; False when none is chosen."""
        curve = self.focus.selected
        if curve is None or not (points := self.chosen(curve)):
            return False
        self.apply(remove_points([self.address(curve, point) for point in points]), _("Delete points"))
        return True

    def nudge(self, dx: float, dy: float) -> bool:
        """Move the chosen points by pixels; False when none is chosen."""
        curve = self.focus.selected
        if curve is None or not (numbers := self.focus.numbers(curve)):
            return False
        if reason := read_only_reason(curve):
            self.said.emit(reason)
            return True
        right, up = figure_map(self.session.sheet, curve).world_way(dx, dy)
        places: dict[Address | str, tuple[float, float]] = {}
        for k in numbers:
            point = curve.points_world[k]
            at = round(point.x + right, 9), round(point.y + up, 9)
            places[self.address(curve, point.id)] = at
        self.apply(move_points(places), _("Nudge points"), NUDGE)
        return True

    def joint(self, kind: str) -> None:
        """Make the chosen points corners, smooth or symmetric."""

        def make(curve: Curve, points: Sequence[str]) -> None:
            if curve.spline != "bezier_path":
                self.said.emit(_("Only the points of a Bézier path have handles; convert the curve first."))
                return
            self.apply(set_joint([self.address(curve, point) for point in points], kind), _("Change joint"))

        self.with_points(1, make)

    def show_beside(self, kind: str) -> None:
        """Show another kind beside the curve, or show it no longer."""
        curve = self.focus.curve
        if curve is not None and kind != curve.spline:
            shown = curve.beside
            kinds = tuple(k for k in shown if k != kind) if kind in shown else (*shown, kind)
            self.apply(set_beside(curve.id, kinds), _("Kinds shown beside"))

    def toggle_closed(self) -> None:
        """Close the curve, or open it, where its kind leaves that open."""

        def toggle(curve: Curve) -> None:
            if may_be_closed(curve):
                name = _("Open the curve") if curve.closed else _("Close the curve")
                self.apply(set_curve_closed(curve.id, not curve.closed), name)
            elif goes_round(curve):
                self.said.emit(_("A curve of this kind is always closed; choose another kind to open it."))
            else:
                self.said.emit(_("A curve of this kind has two ends; choose another kind to close it."))

        self.with_curve(toggle)

    # Knots and weights, pulled in their plots

    def pull_knot(self, knot: str, u: float) -> None:
        """Put a knot to u; knots that a rule makes become free with it."""
        curve = self.focus.curve
        if curve is None or curve.spline not in B_SPLINES:
            return
        names = knot_names(curve)
        if knot not in names and not (self._pull.busy and knot in knot_names(self._pulled)):
            return  # it went while it was held, as by an undo
        if not self._holds(curve):
            return
        if knot not in {each.id for each in self._pulled.knots} and not knot.startswith("#"):
            # It became free by this pull, which does all it does to the curve as it was.
            knot = f"#{[each.id for each in curve.knots].index(knot)}"
        edit = self.knot_edit(self._pulled, knot, lambda address: set_knot(address, u))
        self._pull.show(edit, _("Move knot"))

    def knot_edit(self, curve: Curve, knot: str, change: Callable[[str], Edit]) -> Edit:
        """What is done to a knot, by id, or by # and its number where a rule makes it; these become free."""
        if not knot.startswith("#"):
            return change(self.address(curve, knot, "u"))

        def edit(document: Document) -> Document:
            freed = set_knot_rule(curve.id, "free")(document)
            name = curve_with(freed, curve.id).knots[int(knot[1:])].id
            return change(self.address(curve, name, "u"))(freed)

        return edit

    def pull_weight(self, number: int, weight: float) -> None:
        """Give a point another weight."""
        curve = self.focus.curve
        if curve is None or not 0 <= number < len(curve.points_world):
            return
        if not self._holds(curve):
            return
        address = self.address(curve, curve.points_world[number].id, "weight")
        self._pull.show(set_weights({address: float(f"{weight:.4g}")}), _("Change weight"))

    def _holds(self, curve: Curve) -> bool:
        """Take hold of a curve; False while another one is held, as when the focus went meanwhile."""
        if not self._pull.begun:
            self._pull.begin()
            self._pulled = curve
        return curve.id == self._pulled.id

    def let_go(self) -> None:
        """End a pull, as one step of undo."""
        if self._pull.begun:
            self._pull.commit()
