"""Says things in place: a bar at the top of the window instead of a box in front of it."""

from collections.abc import Callable, Sequence
from typing import ClassVar

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QGuiApplication, QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from workbench.language import _
from workbench.widgets.look.borrowed_focus import BorrowedFocus
from workbench.widgets.look.tokens import theme, tokens

Button = tuple[str, Callable[[], object]]


class _Mark(QWidget):
    """A round mark with a letter: what kind of message this is, without relying on its colour."""

    LETTERS: ClassVar = {"info": "i", "question": "?", "warn": "!", "error": "!"}

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.kind = "info"
        self.setFixedSize(20, 20)
        theme.changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:
        now = tokens()
        ink = QColor({"warn": now.warn, "error": now.error}.get(self.kind, now.accent))
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(ink, 1.5))
        painter.drawEllipse(self.rect().adjusted(2, 2, -2, -2))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.LETTERS[self.kind])


class MessageBar(QFrame):
    """One message at a time. A question stays until it is answered, work until it ends; remarks wait.

    ``postponed`` sends what has to wait, so that it is said elsewhere meanwhile.
    """

    postponed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("messageBar")
        self._mark = _Mark(self)
        self._text = QLabel(self)
        self._text.setWordWrap(True)
        self._text.setTextFormat(Qt.TextFormat.PlainText)  # names of files are in it
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._offered: list[QPushButton] = []
        self._buttons = QHBoxLayout()
        self._buttons.setSpacing(8)
        self._close = QToolButton(self)
        self._close.setText("\u00d7")
        self._close.setToolTip(_("Close this message"))
        self._close.setAccessibleName(_("Close this message"))
        self._close.clicked.connect(self.dismiss)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 8, 6)
        row.setSpacing(8)
        row.addWidget(self._mark)
        row.addWidget(self._text, 1)
        row.addLayout(self._buttons)
        row.addWidget(self._close)
        self._focus = BorrowedFocus(self)
        self._asking = self._working = False
        self._waiting: list[tuple[str, str, str, Sequence[Button]]] = []
        self._refuse: Callable[[], object] | None = None
        self.hide()

    @property
    def text(self) -> str:
        """What is said now, empty when nothing is."""
        return "" if self.isHidden() else self._text.text()

    def buttons(self) -> list[QPushButton]:
        """The buttons of the message now shown."""
        return list(self._offered)

    def say(self, text: str, kind: str = "info", details: str = "", buttons: Sequence[Button] = ()) -> None:
        """Say one sentence; ``details`` can then be copied."""
        if self._asking or self._working:
            self._waiting.append((text, kind, details, buttons))
            self.postponed.emit(text)
            return
        offered = list(buttons)
        if details:
            offered.append((_("Copy details"), lambda: QGuiApplication.clipboard().setText(details)))
        self._show(text, kind, offered, closes=not details)

    def ask(self, text: str, buttons: Sequence[Button], refuse: Callable[[], object] | None = None) -> None:
        """Ask; the first button is the one proposed. Closing the bar, or Esc, is ``refuse``."""
        self._asking = False
        self._show(text, "question", buttons, closes=True)
        self._asking = True
        self._refuse = refuse
        offered = self.buttons()
        if offered:
            self._focus.take(offered[0])

    def work(self, text: str, stop: Button) -> None:
        """Say what is being done, or how far it is, with the button that ends it; a question goes before."""
        if self._asking:
            return
        if self._working and not self.isHidden():
            self._text.setText(text)
            self.setAccessibleName(text)
            return
        self._show(text, "info", [stop], closes=True)
        self._working = True
        self._refuse = stop[1]

    def end_work(self) -> None:
        """What was being done has ended."""
        if self._working:
            self._end()

    def withdraw(self, text: str) -> None:
        """What is true no longer is not said any longer, nor later; a question is not answered."""
        self._waiting = [each for each in self._waiting if each[0] != text]
        if text and self.text == text:
            self._end()

    def leave(self) -> None:
        """What was remarked of a picture goes with it; warnings, questions and work stay."""
        if self._mark.kind == "info" and not (self._asking or self._working):
            self._end()

    def dismiss(self) -> None:
        """Close the message; a question is then answered with no, and work is ended."""
        refuse = self._refuse
        self._end()
        if refuse:
            refuse()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.dismiss()
        else:
            super().keyPressEvent(event)

    def _end(self) -> None:
        self._asking = self._working = False
        self._refuse = None
        self._focus.give_back()
        self.hide()
        if self._waiting:
            self.say(*self._waiting.pop(0))

    def _show(self, text: str, kind: str, buttons: Sequence[Button], closes: bool) -> None:
        self._working = False
        self._refuse = None
        self._focus.remember()
        self._mark.kind = kind
        self._mark.update()
        self._mark.setAccessibleName({"warn": _("Warning"), "error": _("Error")}.get(kind, _("Message")))
        self._text.setText(text)
        self.setAccessibleName(text)
        offered, self._offered = self._offered, []
        for old in offered:
            self._buttons.removeWidget(old)
            old.hide()
            old.deleteLater()
        for number, (label, act) in enumerate(buttons):
            button = QPushButton(label, self)
            button.setProperty("primary", number == 0 and kind == "question")
            button.clicked.connect(self._answer(act, closes))
            self._buttons.addWidget(button)
            self._offered.append(button)
        self.show()

    def _answer(self, act: Callable[[], object], closes: bool) -> Callable[[], None]:
        def answered() -> None:
            if closes:
                self._end()
            act()

        return answered
