"""A labelled drawing as a widget, in the colours of the theme, as large as there is room."""

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QEvent, QSize, QSizeF, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPixmap, Qt
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.algorithms.marks import INKS
from workbench.engine.containers import same
from workbench.exchange.diagrams import MARGIN_PT, Derivation, Drawing, lay_out_derivation
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.formulas.typesetting import paint_primitives, typesetter_of
from workbench.widgets.look.tokens import colour, theme, tokens

_LEAST_WIDE, _LEAST_HIGH = 450.0, 200.0

T = TypeVar("T")


class DrawingView(QWidget):
    """Shows a drawing made for the height there is, in points; ``clicked`` comes with a click."""

    clicked = Signal()

    def __init__(self, name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(name)
        self.setToolTip(tip)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._shown: object = None
        self._drawn: Callable[[float], Drawing] | None = None
        self._picture = QPixmap()
        theme.changed.connect(self._paint_anew)

    def minimumSizeHint(self) -> QSize:
        """Room in which it can be read."""
        return QSize(160, 110)

    def sizeHint(self) -> QSize:
        """Room for an overview."""
        return QSize(420, 220)

    def show_drawing(self, drawn: Callable[[T, float], Drawing], shown: T, said: str) -> None:
        """Show what ``drawn`` makes of ``shown`` from now on; ``said`` tells of it to who does not see it."""
        self.setAccessibleDescription(said)
        if not same(self._shown, shown):
            self._shown, self._drawn = shown, partial(drawn, shown)
            self._paint_anew()

    def _paint_anew(self) -> None:
        self._picture = QPixmap()
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        """In another type it is laid out anew."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._paint_anew()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The drawing in the middle, on the ground of a panel."""
        if self._drawn is not None:
            self._keep_picture(self._drawn)
        painter = QPainter(self)
        if self._drawn is None:
            painter.fillRect(event.rect(), colour(tokens().surface))
            return
        painter.drawPixmap(0, 0, self._picture)
        if self.hasFocus():
            painter.setPen(colour(tokens().accent))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()

    def _keep_picture(self, drawn: Callable[[float], Drawing]) -> None:
        """Paint the picture, unless there is one of this size; it stays until something else is shown."""
        unit = self.devicePixelRatioF()
        size = (QSizeF(self.size()) * unit).toSize()
        if self._picture.size() == size:
            return
        now = tokens()
        inks = {name: ink_of(now, name) for name in INKS} | {"canvas": now.surface}
        # Where there is little room all of it is smaller, the words too, so that none lies on another
        shrunk = min(self.width() / _LEAST_WIDE, self.height() / _LEAST_HIGH, 1.0)
        height = self.height() / shrunk - 2 * MARGIN_PT
        setter = typesetter_of(self.font())
        laid = lay_out_derivation(Derivation("", [drawn(height)], inks, self.width() / shrunk), setter)
        self._picture = QPixmap(size)
        self._picture.setDevicePixelRatio(unit)
        self._picture.fill(colour(now.surface))
        painter = QPainter(self._picture)
        painter.scale(shrunk, shrunk)
        painter.translate(0.0, max((self.height() / shrunk - laid.height) / 2, 0.0))
        paint_primitives(painter, laid.primitives, setter.metrics, inks.__getitem__)  # type: ignore[arg-type]
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Tell of a click."""
        self.clicked.emit()
        super().mousePressEvent(event)
