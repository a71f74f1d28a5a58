"""A field for one number with label and unit: typed (arithmetic works), stepped, scrubbed by its label."""

import html
import re

from PySide6.QtCore import QEvent, QObject, QPointF, QRect, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QFontMetrics,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPainter,
    QPaintEvent,
)
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QStyle,
    QStyleOptionFrame,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.numerals import with_minus
from workbench.language import _
from workbench.widgets.fields.arithmetic import evaluate
from workbench.widgets.look.type_faces import code_font, keep_code_font, type_scale

SCRUB_PX = 4
_FRAME_PX = 21  # around the digits
_BESIDE_PX = 2
_DOTS = "…"
_OTHER_ROOM = QEvent.Type.Resize, QEvent.Type.FontChange


def with_subscript(name: str) -> str:
    """``x_0`` as rich text with a real subscript; other text unchanged."""
    head, mark, tail = name.partition("_")
    if not mark or not tail:
        return html.escape(name)
    return f"{html.escape(head)}<sub>{html.escape(tail)}</sub>"


def lowered(words: str) -> str:
    """Words with names such as ``V_a`` in them as rich text with real subscripts."""
    return re.sub(r"_(\w+)", r"<sub>\1</sub>", html.escape(words, quote=False))


def complaint_label() -> QLabel:
    """Where a field says what is wrong with its value; several that stand close together may share one."""
    label = QLabel()
    label.setWordWrap(True)
    label.setProperty("role", "error")
    label.hide()
    return label


class _ScrubLabel(QLabel):
    """A label that is dragged sideways to change its number."""

    dragged = Signal(int, bool)
    ended = Signal()

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self._last: QPointF | None = None
        self._rest = 0.0

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to scrub."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._last, self._rest = event.globalPosition(), 0.0

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """One step for every few pixels."""
        if self._last is None:
            return
        self._rest += event.globalPosition().x() - self._last.x()
        self._last = event.globalPosition()
        steps = int(self._rest / SCRUB_PX)
        if steps:
            self._rest -= steps * SCRUB_PX
            self.dragged.emit(steps, bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the scrub."""
        if self._last is not None:
            self._last = None
            self.ended.emit()


class EntryLine(QLineEdit):
    """A line that leaves undo to the picture until something is typed into it.

    What is too long for it shows its beginning and three dots, so that it is not read as another number.
    """

    def setText(self, text: str | None, /) -> None:
        """Show ``text``, its beginning first."""
        super().setText(text or "")
        if not self.hasFocus():
            self.setCursorPosition(0)

    @property
    def overflows(self) -> bool:
        """Whether there is no room for all of its text."""
        return self.fontMetrics().horizontalAdvance(self.text()) > self._inside().width()

    def _inside(self) -> QRect:
        """Where its text stands."""
        option = QStyleOptionFrame()
        self.initStyleOption(option)
        inside = self.style().subElementRect(QStyle.SubElement.SE_LineEditContents, option, self)
        return inside.adjusted(_BESIDE_PX, 0, -_BESIDE_PX, 0)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The beginning is in sight again."""
        super().focusOutEvent(event)
        self.setCursorPosition(0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """With dots where something is cut away."""
        super().paintEvent(event)
        if self.hasFocus() or not self.overflows:
            return
        painter, inside = QPainter(self), self._inside()
        inside.setLeft(inside.right() - self.fontMetrics().horizontalAdvance(_DOTS) - 1)
        painter.fillRect(inside.adjusted(0, 0, _BESIDE_PX, 0), self.palette().base())
        painter.setPen(self.palette().text().color())
        painter.drawText(inside, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, _DOTS)

    def event(self, event: QEvent) -> bool:
        """The keys of undo are the line's own once there is typing to take back."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            keys = QKeySequence.StandardKey
            if (event.matches(keys.Undo) and not self.isUndoAvailable()) or (
                event.matches(keys.Redo) and not self.isRedoAvailable()
            ):
                event.ignore()
                return False
        return super().event(event)


class NumberField(QWidget):
    """``edited`` comes when a value was typed or stepped, ``scrubbed`` while the label is dragged.

    ``scrub_ended`` follows a drag. The unit stays, whatever is typed; a bad value is said under the field and
    is not sent. ``integer`` rounds nothing: a fraction is refused in words. ``digits`` is its room.
    """

    edited = Signal(float)
    scrubbed = Signal(float)
    scrub_ended = Signal()

    def __init__(
        self,
        label: str,
        unit: str = "",
        *,
        low: float | None = None,
        high: float | None = None,
        step: float = 1.0,
        integer: bool = False,
        meaning: str = "",
        complaint: QLabel | None = None,
        digits: int = 5,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._low, self._high, self._step, self._integer, self._unit = low, high, step, integer, unit
        self._value = 0.0
        self._owner: object = None
        self.label = _ScrubLabel(with_subscript(label))
        self.label.setToolTip(_("Drag sideways to change {name}.").format(name=label))
        self.field = EntryLine()
        keep_code_font(self.field)
        self.field.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.field.setAccessibleName(meaning or label)
        self._tip = _("{meaning}: type a number or arithmetic such as 30/2.").format(meaning=meaning or label)
        self.field.setToolTip(self._tip)
        self._digits = digits
        type_scale.changed.connect(self._fit)
        self._fit()
        self.label.setBuddy(self.field)
        self.unit = QLabel(unit, self)
        self.unit.setProperty("role", "muted")
        self.unit.setVisible(bool(unit))
        self.complaint = complaint or complaint_label()
        row = QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        row.addWidget(self.label, 1)
        row.addWidget(self.field)
        row.addWidget(self.unit)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(2)
        whole.addLayout(row)
        if complaint is None:
            whole.addWidget(self.complaint)
        whole.addStretch(1)
        self.setFocusProxy(self.field)
        self.field.returnPressed.connect(self._commit)
        self.field.editingFinished.connect(self._leave)
        self.field.installEventFilter(self)
        self.label.dragged.connect(self._scrub)
        self.label.ended.connect(self.scrub_ended)
        self._show()

    def value(self) -> float:
        """The last good value."""
        return self._value

    def belong_to(self, owner: object) -> None:
        """Be a number of ``owner``, named by its id; what was typed for another one is left out."""
        if owner != self._owner:
            self._owner = owner
            self._show()

    def set_value(self, value: float) -> None:
        """Show ``value``; what is being typed is not disturbed."""
        changed = value != self._value
        self._value = value
        if not (self.field.hasFocus() and self.field.isModified()) and (
            changed or not self.field.property("wrong")
        ):
            self._show()

    def refuse(self, sentence: str, value: float) -> None:
        """What was sent cannot be: ``value`` holds on, what was typed stays, and ``sentence`` says why."""
        self._value = value
        self.complain(sentence)

    def complain(self, sentence: str) -> None:
        """Say what is wrong with its value; empty takes it back."""
        if not sentence and not self.field.property("wrong"):
            return  # another field may be speaking there
        self.complaint.setText(sentence)
        self.complaint.setVisible(bool(sentence))
        self.field.setAccessibleDescription(sentence)
        if self.field.property("wrong") != bool(sentence):
            self.field.setProperty("wrong", bool(sentence))
            self.field.style().polish(self.field)

    def _show(self) -> None:
        self.complain("")
        text = with_minus(f"{self._value:.10g}")
        if text != self.field.text() or self.field.isModified():
            chosen = self.field.selectedText() == self.field.text()
            self.field.setText(text)
            if chosen and self.field.hasFocus():
                self.field.selectAll()  # as it was entered: typing goes on in place of the old number
            self._tell_whole()
        self.field.setModified(False)

    def _tell_whole(self) -> None:
        """What there is no room for is told by the tooltip."""
        tip = f"{self.field.text()}\n{self._tip}" if self.field.overflows else self._tip
        if tip != self.field.toolTip():
            self.field.setToolTip(tip)  # it costs more than all else here, and during a drag most stay

    def _typed(self) -> str:
        text = self.field.text().strip()
        if self._unit:
            text = re.sub(rf"\s*{re.escape(self._unit)}$", "", text)
        return text

    def _checked(self, value: float) -> float:
        told = ""
        if self._integer and not value.is_integer():
            told = _("{value:g} is not whole; type a whole number.").format(value=value)
        elif self._low is not None and value < self._low:
            told = _("{value:g} is too small; the least is {low:g}.").format(value=value, low=self._low)
        elif self._high is not None and value > self._high:
            told = _("{value:g} is too large; the most is {high:g}.").format(value=value, high=self._high)
        if told:
            raise ValueError(with_minus(told))
        return value

    def _commit(self) -> None:
        try:
            value = self._checked(evaluate(self._typed()))
        except ValueError as problem:
            self.complain(str(problem))
            return
        changed = value != self._value
        self._value = value
        self._show()
        if changed:
            self.edited.emit(value)

    def _leave(self) -> None:
        if self.field.isModified() and not self.field.hasFocus():
            self._commit()

    def _bounded(self, value: float) -> float:
        low = value if self._low is None else max(value, self._low)
        return low if self._high is None else min(low, self._high)

    def _stepped(self, steps: int, far: bool) -> float:
        return self._bounded(round(self._value + steps * self._step * (10 if far else 1), 9))

    def _scrub(self, steps: int, far: bool) -> None:
        value = self._stepped(steps, far)
        if value != self._value:
            self._value = value
            self._show()
            self.scrubbed.emit(value)

    def _fit(self) -> None:
        """Its digits have room in the field."""
        wide = QFontMetrics(code_font()).horizontalAdvance("0" * self._digits)
        self.field.setFixedWidth(wide + _FRAME_PX)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Up and down step the value (Shift by ten), Escape brings it back."""
        if event.type() in _OTHER_ROOM:
            self._tell_whole()
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            far = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            if event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down):
                value = self._stepped(1 if event.key() == Qt.Key.Key_Up else -1, far)
                if value != self._value:
                    self._value = value
                    self._show()
                    self.edited.emit(value)
                return True
            if event.key() == Qt.Key.Key_Escape and self.field.isModified():
                self._show()
                return True
        return super().eventFilter(watched, event)
