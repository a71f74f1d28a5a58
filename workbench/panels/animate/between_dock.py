"""The in-between of the frame that is shown: its easing as a curve and as a formula, its numbers."""

from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.animation.easing_words import easing_formula, way_text
from workbench.algorithms.animation.easings import BEZIER, LINEAR, NEAREST_HANDLES, eased
from workbench.algorithms.numerals import numeral
from workbench.document.model import Sheet
from workbench.document.motion.groups import value_of
from workbench.document.motion.model import EASINGS, SPLINE, Key, Track
from workbench.document.motion.tracks import group_moved
from workbench.language import _
from workbench.panels.animate.names import easing_titles, label_of
from workbench.rendering.subjects.track import Interval
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.type_faces import keep_code_font
from workbench.widgets.timeline.easing_curve import EasingCurve


class BetweenDock(QScrollArea):
    """One interval of the chosen track. ``easing_wanted`` sends the name of an easing, ``handles_dragged``
    those of a Bézier easing, ``handles_dropped`` that they were let go, ``handles_put_back`` that all
    is wanted as before, ``stepping_wanted`` nothing more.
    """

    easing_wanted = Signal(str)
    handles_dragged = Signal(float, float, float, float)
    handles_dropped = Signal()
    handles_put_back = Signal()
    stepping_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key: Key | None = None
        self.title = QLabel()
        self.title.setProperty("role", "title")
        self.title.setTextFormat(Qt.TextFormat.PlainText)
        self.title.setWordWrap(True)
        self.easing = ChoiceBox(5)
        for name, title in easing_titles().items():
            self.easing.addItem(title, name)
        self.easing.setAccessibleName(_("Easing"))
        self.easing.setToolTip(_("How the value changes from this key to the next one"))
        tell_choice(self.easing)
        self.easing.activated.connect(lambda _index: self.easing_wanted.emit(self.easing.currentData()))
        self.curve = EasingCurve()
        self.curve.handles_dragged.connect(self.handles_dragged)
        self.curve.handles_dropped.connect(self.handles_dropped)
        self.curve.handles_put_back.connect(self.handles_put_back)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        self.sums = QLabel()
        keep_code_font(self.sums, 12)
        self.sums.setWordWrap(True)
        self.sums.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.sums.setAccessibleName(_("Arithmetic of this frame"))
        self.step = QPushButton(_("Step"))
        self.step.setToolTip(_("Work out these frames one by one, in the hand table and the source"))
        self.step.clicked.connect(lambda: self.stepping_wanted.emit())
        row = QHBoxLayout()
        row.addWidget(self.easing, 1)
        row.addWidget(self.step)
        inner = QWidget()
        self.setWidget(inner)
        self.setWidgetResizable(True)
        self.viewport().setAutoFillBackground(False)
        inner.setAutoFillBackground(False)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumSize(220, 180)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        column = QVBoxLayout(inner)
        column.setContentsMargins(12, 8, 12, 8)
        column.setSpacing(6)
        column.addWidget(self.title)
        column.addLayout(row)
        column.addWidget(self.curve, 1)
        for widget in (self.note, self.sums):
            column.addWidget(widget)
        column.addStretch(0)

    def sizeHint(self) -> QSize:
        """As high as all of it, where there is room."""
        return QSize(260, 320)

    def show_interval(
        self, sheet: Sheet, shown: Sheet, track: Track | None, around: Interval | None, frame: int
    ) -> None:
        """Show the keys ``around`` a frame of a track; without a track what to do."""
        self.key = around[0] if around is not None else None
        for widget in (self.easing, self.curve, self.sums, self.step):
            widget.setVisible(around is not None)
        self.note.setVisible(around is None)
        if track is None:
            self.title.setText(_("Nothing moves yet"))
            self.note.setText(_("Turn auto-key on, go to another frame, and move a figure."))
            return
        label = label_of(sheet, track.target)
        if around is None:
            self.title.setText(_("{what}: one key").format(what=label))
            self.note.setText(_("Go to another frame and press K, or change the value there."))
            return
        first, second = around
        self.title.setText(
            _("{what}: frame {first} to {second}").format(what=label, first=first.frame, second=second.frame)
        )
        self.easing.setCurrentIndex(EASINGS.index(first.easing))
        code = EASINGS.index(first.easing) if first.easing != SPLINE else LINEAR
        n = second.frame - first.frame - 1
        t = min(max((frame - first.frame) / (n + 1), 0.0), 1.0)
        handles = first.handles if code == BEZIER else NEAREST_HANDLES[code]
        inside = first.frame <= frame <= second.frame
        self.curve.show_easing(
            partial(eased, code, *first.handles),
            None if first.easing in ("constant", SPLINE) else handles,
            t if inside else None,
        )
        self.curve.setToolTip(_note(first, code))
        self.sums.setText("\n".join(_sums(sheet, shown, track, around, frame)) if inside else "")


def _note(key: Key, code: int) -> str:
    """What is to be known of the curve and its handles."""
    if key.easing == SPLINE:
        return _(
            "A spline: the slope at a key comes from its neighbours in time. Step through it to see how."
        )
    if key.easing == "constant":
        return _("The value is held until the next key.")
    if code == BEZIER:
        return _("Drag the handles to shape it.")
    if code == LINEAR:
        return _("Constant speed. Drag a handle, and it becomes a Bézier easing.")
    return _("The handles are those of the Bézier easing that fits best; drag one, and it becomes that.")


def _squared(key: Key, t: float) -> float | None:
    """What free fall gives in place of a sine easing, speeding up or slowing down."""
    return {"ease_in": t * t, "ease_out": 1.0 - (1.0 - t) ** 2}.get(key.easing)


def _sums(sheet: Sheet, shown: Sheet, track: Track, around: tuple[Key, Key], frame: int) -> list[str]:
    """The arithmetic of a frame, with its numbers."""
    first, second = around
    n, j = second.frame - first.frame - 1, frame - first.frame
    group = group_moved(shown, track)
    if frame in (first.frame, second.frame) or group is None:
        return [_("Frame {frame} is a key: its value is shown as it is.").format(frame=frame)]
    lines = [
        _("j = {j} of n = {n}: t = {j} / {whole} = {t}").format(j=j, n=n, whole=n + 1, t=numeral(j / (n + 1)))
    ]
    if first.easing == SPLINE:
        return lines
    code = EASINGS.index(first.easing)
    part = eased(code, *first.handles, j / (n + 1))
    lines.append(f"{easing_formula(code, j / (n + 1))} = {numeral(part)}")
    if group.kind == "outline":
        return [
            *lines,
            _("Each of the {n} points goes that fraction of its way.").format(n=len(group.slots) // 2),
        ]
    if group.kind == "turn":
        return [*lines, _("It has turned by that fraction of the angle, about one axis.")]
    if len(first.value) == 1 and (square := _squared(first, j / (n + 1))) is not None:
        a, b = first.value[0], second.value[0]
        fallen = numeral(a + square * (b - a))
        lines.append(_("by t²: {way} = {value}").format(way=way_text(a, b, square), value=fallen))
    values = value_of(shown, group)
    for value, a, b in list(zip(values, first.value, second.value, strict=True))[:3]:
        lines.append(f"{way_text(a, b, part)} = {numeral(value)}")
    return lines
