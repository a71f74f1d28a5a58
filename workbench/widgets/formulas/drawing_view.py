"""A labelled drawing as a widget, in the colours of the theme, as large as there is room."""

from collections.abc import Callable

from PySide6.QtCore import QSize, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, Qt
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.algorithms.marks import INKS
from workbench.exchange.diagrams import MARGIN_PT, Derivation, Drawing, lay_out_derivation
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.formulas.typesetting import paint_primitives, typesetter_of
from workbench.widgets.look.tokens import colour, theme, tokens

_LEAST_WIDE, _LEAST_HIGH = 450.0, 200.0


class DrawingView(QWidget):
    """Shows what ``drawn`` gives for the height there is, in points; ``clicked`` comes with a click."""

    clicked = Signal()

    def __init__(self, name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(name)
        self.setToolTip(tip)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._drawn: Callable[[float], Drawing] | None = None
        theme.changed.connect(self.update)

    def minimumSizeHint(self) -> QSize:
        """Room in which it can be read."""
        return QSize(160, 110)

    def sizeHint(self) -> QSize:
        """Room for an overview."""
        return QSize(420, 220)

    def show_drawing(self, drawn: Callable[[float], Drawing], said: str) -> None:
        """Show this from now on; ``said`` tells of it to who does not see it."""
        self._drawn = drawn
        self.setAccessibleDescription(said)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The drawing in the middle, on the ground of a panel."""
        painter, now = QPainter(self), tokens()
        painter.fillRect(event.rect(), colour(now.surface))
        if self._drawn is None:
            return
        inks = {name: ink_of(now, name) for name in INKS} | {"canvas": now.surface}
        # Where there is little room all of it is smaller, the words too, so that none lies on another
        shrunk = min(self.width() / _LEAST_WIDE, self.height() / _LEAST_HIGH, 1.0)
        height = self.height() / shrunk - 2 * MARGIN_PT
        page = Derivation("", [self._drawn(height)], inks, self.width() / shrunk)
        setter = typesetter_of(self.font())
        laid = lay_out_derivation(page, setter)
        painter.scale(shrunk, shrunk)
        painter.translate(0.0, max((self.height() / shrunk - laid.height) / 2, 0.0))
        paint_primitives(painter, laid.primitives, setter.metrics, inks.__getitem__)  # type: ignore[arg-type]
        if self.hasFocus():
            painter.resetTransform()
            painter.setPen(colour(now.accent))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Tell of a click."""
        self.clicked.emit()
        super().mousePressEvent(event)
