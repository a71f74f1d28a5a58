"""A line that names one stage of a chain; pointed at or in focus, it lights its matrix and its ghost."""

import html
import re

from PySide6.QtCore import QEvent, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QEnterEvent, QFocusEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QWidget

from workbench.language import _
from workbench.widgets.canvas.drawing import PATTERNS, Pattern, ink_of
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme, tokens
from workbench.widgets.look.type_faces import keep_code_font, scaled

_SCRIPT = re.compile(r"_(?:\{([^}]*)\}|(\w))")
_BADGE, _LINE_PX = 20, 22


def rich(formula: str) -> str:
    """A formula of names as rich text, with real subscripts."""
    return _SCRIPT.sub(lambda each: f"<sub>{each[1] or each[2]}</sub>", html.escape(formula))


class Badge(QWidget):
    """The number of a stage in a ring of its ink, and, ``lined``, a piece of its line."""

    def __init__(self, number: int, ink: str, pattern: Pattern, lined: bool = False) -> None:
        super().__init__()
        self._number, self._ink, self._pattern, self._lined = number, ink, pattern, lined
        self.setFixedSize(_BADGE + (_LINE_PX if lined else 0), _BADGE)
        theme.changed.connect(self.update)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The ring and the number."""
        ink = QColor(ink_of(tokens(), self._ink))
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        left = _LINE_PX if self._lined else 0
        if self._lined:
            painter.setPen(QPen(ink, 2, PATTERNS[self._pattern]))
            painter.drawLine(0, _BADGE // 2, left - 2, _BADGE // 2)
        painter.setPen(QPen(ink, 1.5))
        painter.setBrush(QColor(tokens().surface))
        box = QRectF(left + 1.5, 1.5, _BADGE - 3, _BADGE - 3)
        painter.drawEllipse(box)
        painter.setPen(QColor(tokens().text))
        font = self.font()
        font.setPixelSize(scaled(CAPTION_PX))
        font.setBold(True)
        painter.setFont(font)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(self._number))
        painter.end()


class StageRow(QFrame):
    """``pointed`` sends the number of its stage while it is pointed at or in focus, None afterwards."""

    pointed = Signal(object)

    def __init__(self, number: int, badge: Badge, symbols: str, numbers: str, words: str) -> None:
        super().__init__()
        self.number = number
        self._lit = False
        self.symbols, self.numbers, self.words = QLabel(), QLabel(), QLabel()
        keep_code_font(self.numbers, 12)
        self.words.setProperty("role", "muted")
        row = QHBoxLayout(self)
        row.setContentsMargins(4, 1, 4, 1)
        row.setSpacing(6)
        row.addWidget(badge)
        row.addWidget(self.symbols, 5)
        row.addWidget(self.numbers, 5)
        row.addWidget(self.words, 6)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(_("Highlights the matrix and the figure of this stage"))
        self.tell(symbols, numbers, words)

    def tell(self, symbols: str, numbers: str, words: str) -> None:
        """Show other texts."""
        self.symbols.setText(rich(symbols))
        self.symbols.setVisible(bool(symbols))
        self.numbers.setText(numbers)
        self.numbers.setVisible(bool(numbers))
        self.words.setText(words)
        self.setAccessibleName(
            _("Stage {number}: {words} {numbers}").format(number=self.number, words=words, numbers=numbers)
        )

    def set_lit(self, lit: bool) -> None:
        """Mark it, or no longer."""
        if lit != self._lit:
            self._lit = lit
            self.update()

    def enterEvent(self, event: QEnterEvent) -> None:
        """Pointed at."""
        super().enterEvent(event)
        self.pointed.emit(self.number)

    def leaveEvent(self, event: QEvent) -> None:
        """No longer."""
        super().leaveEvent(event)
        self.pointed.emit(None)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The keys are here."""
        super().focusInEvent(event)
        self.pointed.emit(self.number)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The keys are elsewhere."""
        super().focusOutEvent(event)
        self.pointed.emit(None)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """A tint and an edge while it is lit."""
        super().paintEvent(event)
        if self._lit or self.hasFocus():
            now = tokens()
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(QColor(now.accent), 2 if self.hasFocus() else 1.25))
            painter.setBrush(colour(now.accent, 28))
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(1, 1, -1, -1), RADIUS, RADIUS)
            painter.end()
