"""The morph of the frame that is shown: which vertex goes where, by the course's numbers and by hand."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from workbench.document.model import THROUGH, AnyFigure, Curve, Sheet
from workbench.document.motion.between import corners, part_of_the_way
from workbench.document.motion.groups import OUTLINE
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import group_moved
from workbench.language import _
from workbench.panels.animate.correspondence import Correspondence, corresponding, dragged, drawn, grips
from workbench.panels.animate.names import label_of
from workbench.panels.animate.track_dock import TrackDock, box_of
from workbench.rendering.subjects.track import Interval
from workbench.widgets.fields.number_field import NumberField


class MorphDock(TrackDock):
    """Both outlines side by side. ``shift_wanted`` sends to which vertex of the second one vertex 0 is to go,
    as a hand, a key or a number says it, ``shift_dropped`` that the hand let go, ``held`` whether it holds.
    """

    shift_wanted = Signal(int)
    shift_dropped = Signal()
    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Correspondence of the two outlines"), parent)
        self._pair: Correspondence | None = None
        self._held = ""
        self._before = 0
        self.shift = NumberField(
            _("Vertex 0 moves to vertex"),
            low=0,
            integer=True,
            meaning=_("The vertex of the second outline that vertex 0 of the first one moves to"),
        )
        self.shift.edited.connect(self._typed)
        self.shift.scrubbed.connect(lambda value: self._want(int(value)))
        self.shift.scrub_ended.connect(self.shift_dropped)
        self.fields.addWidget(self.shift)
        self.picture.setToolTip(
            _("Drag an end on the second outline to another vertex, or shift all of them with the arrow keys")
        )
        self.picture.pressed.connect(self._press)
        self.picture.moved.connect(self._move)
        self.picture.released.connect(self._release)
        self.picture.cancelled.connect(self._cancel)
        self.picture.arrow.connect(self._turn)

    def show_interval(
        self, sheet: Sheet, shown: Sheet, track: Track | None, around: Interval | None, frame: int
    ) -> None:
        """Both outlines of a track of one, and what lies between them in the frame."""
        group = group_moved(sheet, track) if track is not None else None
        self._pair = None
        if track is None or group is None or around is None or not track.target.endswith(f"/{OUTLINE}"):
            self.shift.hide()
            self.show_nothing(
                _("No outline moves here"),
                _("Choose the track of an outline with two keys, or move several corners with auto-key on."),
            )
            return
        first, second = around
        self.key = first
        self.shift.belong_to(first.id)
        figure = next(each for each in sheet.figures if each.id == track.target.split("/")[0])
        title = _("{what}: frame {first} to {second}").format(
            what=label_of(sheet, track.target), first=first.frame, second=second.frame
        )
        inside = first.frame <= frame <= second.frame
        part = part_of_the_way(first, second, frame) if inside else None
        closed = group.kind == "outline" and bool(getattr(figure, "closed", True))
        pair = corresponding(corners(first), corners(second), closed, first.shift)
        box = box_of(pair.start, pair.end + pair.aside)
        self.shift.setVisible(closed)
        if group.kind != "outline":
            self.show_drawn(title, drawn(pair, part), box, [], _of_points(figure))
            return
        self._pair = pair
        self.shift.set_value(pair.shift)
        note = _("The ends of an open outline always move to the ends of the other.") if not closed else ""
        self.show_drawn(title, drawn(pair, part), box, _rule(pair), note, grips(pair))

    # By hand, by number, by key

    def _want(self, shift: int) -> None:
        pair = self._pair
        if pair is not None and pair.closed and shift % len(pair.second) != pair.shift:
            self.shift_wanted.emit(shift % len(pair.second))

    def _typed(self, value: float) -> None:
        self._want(int(value))
        self.shift_dropped.emit()

    def _press(self, _x: float, _y: float, grip: str) -> None:
        if grip and self._pair is not None:
            self._held, self._before = grip, self._pair.shift
            self.held.emit(True)

    def _move(self, x: float, y: float) -> None:
        if self._held and self._pair is not None:
            self._want(dragged(self._pair, self._held, x, y))

    def _release(self, _x: float, _y: float) -> None:
        if self._held:
            self._held = ""
            self.shift_dropped.emit()
            self.held.emit(False)

    def _cancel(self) -> None:
        """As it was when the hand took hold."""
        if self._held:
            self._want(self._before)
            self._release(0.0, 0.0)

    def _turn(self, right: int, up: int, _modifiers: object) -> None:
        if self._pair is not None:
            self._want(self._pair.shift + right + up)
            self.shift_dropped.emit()


def _of_points(figure: AnyFigure) -> str:
    """What becomes of what has as many points in each key."""
    told = _("Each point moves to the point with the same number.")
    if not isinstance(figure, Curve) or figure.spline in THROUGH:
        return told
    more = _(
        "The curve is a sum of its control points with weights that stay, so each of its own points moves on "
        "a straight line too."
    )
    return f"{told} {more}"


def _rule(pair: Correspondence) -> list[str]:
    """The course's numbers."""
    most, fewest = max(pair.edges), min(pair.edges)
    lines = [_("L_max = {most} edges, L_min = {fewest}").format(most=most, fewest=fewest)]
    if most == fewest:
        return [*lines, _("equally many: each vertex has one to move to")]
    extra, pieces = most % fewest, most // fewest
    cut = _("{extra} edges in {more} pieces, {rest} in {pieces}").format(
        extra=extra, more=pieces + 1, rest=fewest - extra, pieces=pieces
    )
    return [
        *lines,
        _("N_e = {most} mod {fewest} = {extra}").format(most=most, fewest=fewest, extra=extra),
        _("N_s = {most} div {fewest} = {pieces}").format(most=most, fewest=fewest, pieces=pieces),
        cut if extra else _("each of {fewest} edges in {pieces} pieces").format(fewest=fewest, pieces=pieces),
    ]
