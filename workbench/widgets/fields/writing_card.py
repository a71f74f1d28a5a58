"""The card of what is being written: how a run is to be written, how far that is, and a way to end it."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from workbench.exchange.writing import FileFormat
from workbench.language import _
from workbench.widgets.look.borrowed_focus import BorrowedFocus

WIDTH_PX, GAP_PX = 296, 12
WIDTHS = (480, 800, 1200, 1600)


class Pictures(NamedTuple):
    """What is offered to be written: as one of ``formats``, called so; ``speeds``, called so, in seconds a
    picture, of which ``usual`` is chosen at first; ``note`` says what a format will write.

    ``then(file_format, width, seconds)`` follows.
    """

    title: str
    formats: Sequence[tuple[FileFormat, str]]
    speeds: Sequence[tuple[str, float]]
    usual: float
    note: Callable[[FileFormat], str]
    then: Callable[[FileFormat, int, float], object]


class WritingCard(QFrame):
    """Floats in ``owner`` at the lower right of ``beside``. ``cancelled``: no, or no longer."""

    cancelled = Signal()

    def __init__(self, owner: QWidget, beside: QWidget) -> None:
        super().__init__(owner)
        self._owner, self._beside = owner, beside
        self._pictures: Pictures | None = None
        self._focus = BorrowedFocus(self)
        self.setObjectName("card")
        self.setFixedWidth(WIDTH_PX)
        self._title, self.note = QLabel(), QLabel()
        self._title.setProperty("role", "title")
        self._title.setWordWrap(True)
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        self.kind, self.width_px, self.speed = QComboBox(), QComboBox(), QComboBox()
        for side in WIDTHS:
            self.width_px.addItem(_("{n} pixels wide").format(n=side), side)
        self.width_px.setCurrentIndex(WIDTHS.index(800))
        self._choices = QWidget()
        form = QFormLayout(self._choices)
        form.setContentsMargins(0, 0, 0, 0)
        for label, field in (
            (_("As"), self.kind),
            (_("Size"), self.width_px),
            (_("Speed"), self.speed),
        ):
            form.addRow(label, field)
            field.setAccessibleName(label)
        self._form = form
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(_("How much is to be written"))
        self.go, self.cancel = QPushButton(_("Write...")), QPushButton(_("Cancel"))
        self.go.setProperty("primary", True)
        self.go.clicked.connect(self._go)
        self.cancel.clicked.connect(self.cancelled)
        self.kind.currentIndexChanged.connect(self._follow)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(self.cancel)
        buttons.addWidget(self.go)
        column = QVBoxLayout(self)
        column.setContentsMargins(12, 10, 12, 10)
        column.setSpacing(8)
        for part in (self._title, self._choices, self.note, self.bar):
            column.addWidget(part)
        column.addLayout(buttons)
        beside.installEventFilter(self)
        self.hide()

    def offer(self, pictures: Pictures) -> None:
        """Let the person choose a format, size and speed."""
        before = self.speed.currentData()
        self._pictures = pictures
        self.kind.blockSignals(True)
        for field, rows in ((self.kind, pictures.formats), (self.speed, pictures.speeds)):
            field.clear()
            for row in rows:
                data, text = (row[0], row[1]) if field is self.kind else (row[1], row[0])
                field.addItem(str(text), data)
        self.kind.blockSignals(False)
        chosen = self.speed.findData(before)
        self.speed.setCurrentIndex(chosen if chosen >= 0 else self.speed.findData(pictures.usual))
        self._dress(pictures.title, "", choosing=True)
        self._follow()
        self._focus.take(self.kind)

    def progress(self, title: str) -> None:
        """Something is being written."""
        self._dress(title, _("Preparing ..."), choosing=False)
        self.bar.setRange(0, 0)

    def tell(self, done: int, parts: int) -> None:
        """So much of it is done."""
        if not self.cancel.isEnabled():
            return
        self.bar.setRange(0, parts)
        self.bar.setValue(done)
        self.note.setText(_("{done} of {parts}").format(done=done, parts=parts))

    def stop(self) -> None:
        """It was cancelled, and ends soon."""
        self._focus.give_back()
        self.cancel.setEnabled(False)
        self.note.setText(_("Cancelling ..."))

    def put_away(self) -> None:
        """Hide it; the focus goes back where it was."""
        self._focus.give_back()
        self.hide()

    def _dress(self, title: str, note: str, choosing: bool) -> None:
        self._focus.remember()
        self._title.setText(title)
        self.setAccessibleName(title)
        self.note.setText(note)
        self.cancel.setEnabled(True)
        if self._focus.here and not choosing:
            self.cancel.setFocus(Qt.FocusReason.OtherFocusReason)
        self._choices.setVisible(choosing)
        self.go.setVisible(choosing)
        self.bar.setVisible(not choosing)
        self.show()
        self.raise_()
        self._place()

    def _follow(self, *_index: int) -> None:
        """A PDF has no size in pixels, and only a GIF moves."""
        assert self._pictures is not None
        file_format = self.kind.currentData()
        suffix = file_format.suffix
        self._form.setRowVisible(self.width_px, suffix != ".pdf")
        self._form.setRowVisible(self.speed, suffix == ".gif")
        self.note.setText(self._pictures.note(file_format))
        self._place()

    def _go(self) -> None:
        if self._pictures is not None:
            self._pictures.then(
                self.kind.currentData(), self.width_px.currentData(), self.speed.currentData()
            )

    def _place(self) -> None:
        self.adjustSize()
        corner = self._beside.mapTo(self._owner, self._beside.rect().bottomRight())
        self.move(corner.x() - self.width() - GAP_PX, corner.y() - self.height() - GAP_PX)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape cancels."""
        if event.key() == Qt.Key.Key_Escape:
            self.cancelled.emit()
        else:
            super().keyPressEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in its corner."""
        if event.type() == QEvent.Type.Resize and self.isVisible():
            self._place()
        return super().eventFilter(watched, event)
