"""Commands that cut, join, turn, convert and smooth curves; each says what it did, and how exactly."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from workbench.document.curves.conversions import CONVERSIONS, TOLERANCE_WORLD, convert, converted
from workbench.document.curves.cutting import insert_on_curve, insertion_note, split
from workbench.document.curves.degrees import lower_degree, lowered, raise_degree
from workbench.document.curves.joining import ALIGNMENTS, align, join, joined, reverse
from workbench.document.curves.knot_removal import knots_fault, remove_knot
from workbench.document.curves.paths import is_path, joint_of, place
from workbench.document.curves.pieces import fault_of, goes_round, knots_of, parameter_at, pieces_of
from workbench.document.curves.shaping import SMOOTHNESS, smooth_joint, smoothed
from workbench.document.edits import add_figure, both, remove_figures
from workbench.document.model import Curve, Polyline, WorldPoint
from workbench.language import _, at_most
from workbench.panels.curves.commands import CurveCommands
from workbench.panels.curves.names import point_name, spline_title
from workbench.panels.stage.actions import PanelCommand
from workbench.rendering import device_map
from workbench.rendering.curves import polyline_of

_EXACT = 1e-9  # world: what is no farther off is off by rounding

_ALIGN_ICONS = {
    "left": "align-left",
    "centre": "align-center-horizontal",
    "right": "align-right",
    "bottom": "align-bottom",
    "middle": "align-center-vertical",
    "top": "align-top",
}


class CurveOperations(CurveCommands):
    """Adds the commands that change a curve as a whole, or make it of another kind."""

    def rows(self) -> list[PanelCommand]:
        """Name, text, icon, key and what it does, for the menu of the canvas and the list of commands."""
        aligning = {
            "left": _("Align to the left"),
            "centre": _("Align to the centre"),
            "right": _("Align to the right"),
            "bottom": _("Align to the bottom"),
            "middle": _("Align to the middle"),
            "top": _("Align to the top"),
        }
        return [
            *super().rows(),
            ("insert", _("Insert a point at u"), "plus-circle", "Ins", self.insert_at_u),
            ("remove_knot", _("Remove the knot at u"), "minus-circle", "", self.remove_knot_at_u),
            ("split", _("Split at u"), "scissors", "X", self.split),
            ("join", _("Join two curves"), "link", "J", self.join),
            ("reverse", _("Reverse the direction"), "swap", "Shift+R", self.reverse),
            ("raise", _("Raise the degree"), "plus", "]", self.raise_degree),
            ("lower", _("Lower the degree"), "minus", "[", self.lower_degree),
            *(
                (f"align_{how}", aligning[how], _ALIGN_ICONS[how], "", partial(self.align, how))
                for how in ALIGNMENTS
            ),
            *(
                (
                    f"make_{kind}",
                    _("Make the joint {kind}").format(kind=kind),
                    "intersect",
                    "",
                    partial(self.smooth_here, kind),
                )
                for kind in SMOOTHNESS
            ),
            *(
                (
                    f"convert_{kind}",
                    _("Convert to {kind}").format(kind=spline_title(kind)),
                    "arrow-bend-up-right",
                    "",
                    partial(self.convert, kind),
                )
                for kind in CONVERSIONS
            ),
            ("flatten", _("Convert to a polyline"), "polygon", "", self.flatten),
        ]

    # Points on the curve

    def parameter(self, curve: Curve, share: float) -> float | None:
        """The parameter at a share of its range; None, and said why, where the points make no curve yet."""
        try:
            return parameter_at(curve, share)
        except ValueError as problem:
            self.said.emit(str(problem))
            return None

    def insert(self, curve: Curve, share: float) -> None:
        """Put a point into the curve at a share of its parameter; what is new is chosen."""
        before = {point.id for point in curve.points_world}
        u = self.parameter(curve, share)
        if u is None or not self.apply(insert_on_curve(curve.id, u), _("Insert a point")):
            return
        now = self.focus.curve
        if now is not None:
            new = [k for k, point in enumerate(now.points_world) if point.id not in before]
            anchors = [k for k in new if now.spline != "bezier_path" or k % 3 == 0]
            self.focus.choose(now.points_world[k].id for k in anchors or new)
            note = insertion_note(curve)
            self.said.emit(note or _("The curve is the same as before, with one more point."))

    def insert_at_u(self) -> None:
        """Put a point into the curve at u."""
        self.with_curve(lambda curve: self.insert(curve, self.focus.u))

    def remove_knot(self, knot: str) -> None:
        """Take a knot, by id or # and its number, out of the curve where that stays nearly as it was."""
        curve = self.focus.curve
        if curve is not None and self.apply(self.knot_edit(curve, knot, remove_knot), _("Remove a knot")):
            sentence = _("The knot is gone, and a point with it; the curve has changed by {most:g} at most.")
            self.said.emit(sentence.format(most=TOLERANCE_WORLD))

    def remove_knot_at_u(self) -> None:
        """Take the knot out that is nearest to u."""

        def remove(curve: Curve) -> None:
            if fault := knots_fault(curve):
                self.said.emit(fault)
            elif (u := self.parameter(curve, self.focus.u)) is not None:
                number = int(np.abs(knots_of(curve) - u).argmin())
                self.remove_knot(curve.knots[number].id if curve.knots else f"#{number}")

        self.with_curve(remove)

    def split(self) -> None:
        """Cut the curve at u; both parts are selected."""

        def cut(curve: Curve) -> None:
            known = {figure.id for figure in self.session.sheet.figures}
            u = self.parameter(curve, self.focus.u)
            if u is not None and self.apply(split(curve.id, u), _("Split the curve")):
                made = [f.id for f in self.session.sheet.figures if f.id not in known]
                self.session.update_state(selection=(curve.id, *made), active=curve.id)
                self.said.emit(_("The curve is cut at u; together the two parts look as before."))

        self.with_curve(cut)

    def join(self) -> None:
        """Join the two selected curves where their ends are nearest."""
        chosen = [
            figure
            for figure in self.session.sheet.figures
            if figure.id in self.session.state.selection and isinstance(figure, Curve)
        ]
        if len(chosen) != 2:
            self.said.emit(_("Select two curves first, the second with Shift."))
            return
        first, second = chosen
        if self.apply(join(first.id, second.id), _("Join curves")):
            self.session.update_state(selection=(first.id,), active=first.id)
            error = joined(first, second)[1]
            off = _("The curves are now one, changed by {error} at most.").format(error=at_most(error))
            self.said.emit(off if error > _EXACT else _("The curves are now one, and look as before."))

    # The whole curve

    def reverse(self) -> None:
        """Let the curve run the other way."""
        self.with_curve(lambda curve: self.apply(reverse(curve.id), _("Reverse the curve")))

    def raise_degree(self) -> None:
        """One degree more; the curve stays as it is."""
        self.with_curve(lambda curve: self.apply(raise_degree(curve.id), _("Raise the degree")))

    def lower_degree(self) -> None:
        """One degree less, with the error said."""

        def lower(curve: Curve) -> None:
            if self.apply(lower_degree(curve.id), _("Lower the degree")):
                text = _("The degree is one lower; the curve has changed by {error} at most.")
                self.said.emit(text.format(error=at_most(lowered(curve)[1])))

        self.with_curve(lower)

    def align(self, how: str) -> None:
        """Put the chosen points under one another, or side by side."""
        self.with_points(
            2,
            lambda curve, points: self.apply(
                align([self.address(curve, point) for point in points], how), _("Align points")
            ),
        )

    def convert(self, spline: str) -> None:
        """Make the curve one of another kind that looks the same, and say how exactly."""

        def make(curve: Curve) -> None:
            if not self.apply(convert(curve.id, spline), _("Convert the curve")):
                return
            error, kind = converted(curve, spline)[1], spline_title(spline)
            if error > _EXACT:
                self.said.emit(
                    _("{kind}, changed by {error} at most.").format(kind=kind, error=at_most(error))
                )
            else:
                self.said.emit(_("{kind}, exactly the same curve.").format(kind=kind))

        self.with_curve(make)

    def flatten(self) -> None:
        """Put the chords that the curve is drawn by in its place, and say how far they are off at most."""

        def replace_by_chords(curve: Curve) -> None:
            sheet = self.session.frames.sheet
            corners = device_map(sheet).world(polyline_of(sheet, curve))
            if len(corners) < 2:
                self.said.emit(fault_of(curve))
                return
            around = goes_round(curve)
            kept = corners[:-1] if around else corners
            points = tuple(WorldPoint("", x, y) for x, y in np.round(kept, 9).tolist())
            line = Polyline(
                "", points, curve.algorithm, curve.colour, curve.name, closed=around, group=curve.group
            )
            place = sheet.place_of(curve.id)
            edit = both(add_figure(sheet.id, line, place), remove_figures([curve.id]))
            if self.apply(edit, _("Convert the curve")):
                made = self.session.sheet.figures[place].id
                self.session.update_state(selection=(made,), active=made)
                text = _("A polyline of {count} corners, {error} px from the curve at most.")
                self.said.emit(text.format(count=len(points), error=at_most(curve.tolerance_px)))

        self.with_curve(replace_by_chords)

    # Joints

    def smooth_here(self, kind: str) -> None:
        """Make the joints smooth that are chosen, or the one nearest to u."""

        def make(curve: Curve) -> None:
            try:
                joints = self._joints_here(curve)
            except ValueError as problem:
                self.said.emit(str(problem))
                return
            self.said.emit(self.smooth(joints, kind))

        self.with_curve(make)

    def smooth(self, joints: Sequence[int], kind: str) -> str:
        """Make joints G1, C1, G2 or C2; the sentence that says which points moved, or why none."""
        curve = self.focus.curve
        if curve is None:
            return _("Select one curve first.")
        smoother = curve
        try:
            for joint in joints:
                smoother = smoothed(smoother, joint, kind)[0]
        except ValueError as problem:
            return str(problem)
        after = {point.id: place(point) for point in smoother.points_world}
        names = [point_name(curve, k) for k, p in enumerate(curve.points_world) if place(p) != after[p.id]]
        if not names:
            return _("The joint is already {kind}.").format(kind=kind)
        edit = both(*(smooth_joint(curve.id, joint, kind) for joint in joints))
        if not self.apply(edit, _("Make it {kind}").format(kind=kind)):
            return ""
        return _("It is {kind} now; moved: {points}.").format(kind=kind, points=", ".join(names))

    def _joints_here(self, curve: Curve) -> list[int]:
        """The joints of the chosen points of a path, their handles' too, or the one nearest to u.

        Raises: ValueError where there is none.
        """
        knots = np.unique(pieces_of(curve).knots)
        count = len(knots) - 1
        around = goes_round(curve)
        if count < 2 and not around:
            raise ValueError(_("This curve has one piece, so it has no joints."))
        chosen = self.focus.numbers(curve) if is_path(curve) else []
        if chosen:
            points = {at // 3 for k in chosen if (at := joint_of(curve, k)) is not None}
            joints = sorted({(k - 1) % count if around else k - 1 for k in points})
            inner = [joint for joint in joints if 0 <= joint < count - 1 or around]
            if not inner:
                raise ValueError(_("An end of the curve is not a joint; choose a point between two pieces."))
            return inner
        u = parameter_at(curve, self.focus.u)
        ends = knots[1:] if around else knots[1:-1]
        return [int(np.abs(ends - u).argmin())]
