"""The base of plots on pyqtgraph: axes and colours of the theme, a cursor, zoom, keys, a menu, copies."""

from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QFocusEvent,
    QFont,
    QFontMetrics,
    QGuiApplication,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QShowEvent,
)
from PySide6.QtWidgets import QGraphicsItem, QLabel, QMenu, QVBoxLayout, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tips import plain_tip
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme_changed, tokens
from workbench.widgets.look.type_faces import scaled, type_scale
from workbench.widgets.plots.library import library
from workbench.widgets.tables.table_copies import put_on_clipboard

_ZOOM = 0.8
_GRID = 0.45
_TITLES_PX = 44  # what the axis below takes with its title
_STEPS_TEN = 10
_KEPT = QGraphicsItem.CacheMode.DeviceCoordinateCache


def pen_of(ink: QColor | str, width: float = 0, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> QPen:
    """A pen whose width is in pixels at every zoom; 0 is one pixel."""
    pen = QPen(QColor(ink), width, style)
    pen.setCosmetic(True)
    return pen


class Plot(QWidget):
    """A caption over a plot, which is made when it is first seen. ``shown``: it came into view.

    A plot says in ``_begin`` what it holds, in ``_restyle`` how that looks in the theme, in ``numbers`` what
    is copied; where its x can be chosen, in ``reach`` between which, and in ``_chosen`` what that means. The
    wheel zooms along x, a drag pans, a double click or 0 shows all; arrows (Shift: ten times as far), Home
    and End choose.
    """

    shown = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumHeight(90)
        self.setAccessibleName(name)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._plot: Any = None
        self._cursor_line: Any = None
        self._cursor_x: float | None = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(6, 4, 8, 4)
        self._column.setSpacing(2)
        self.caption = QLabel()
        self.caption.setProperty("role", "caption")
        self.caption.setWordWrap(True)
        self._column.addWidget(self.caption)
        theme_changed.connect(self._take_theme)
        type_scale.changed.connect(self._take_type)
        library.loaded.connect(self._make_in_turn)

    def _begin(self) -> None:
        """Put lines on the new plot."""

    def _restyle(self) -> None:
        """Show everything in the theme's colours."""

    def _chosen(self, x: float) -> None:
        """An x was chosen, by a click or a key."""

    @property
    def reach(self) -> tuple[float, float] | None:
        """The least and the greatest x that can be chosen; None where there is none."""
        return None

    @property
    def nudge(self) -> float:
        """How far an arrow key goes."""
        return 1.0

    def numbers(self) -> Table | None:
        """What is plotted, as a table; None while nothing is."""
        return None

    def say(self, text: str, plain: str = "") -> None:
        """Say what the plot shows, above it and to a screen reader; ``plain`` is the same without markup."""
        if text != self.caption.text():
            self.caption.setText(text)
            self.caption.setToolTip(plain_tip(text))  # a low dock shows only its beginning
            self.setAccessibleDescription(plain or text)

    def place_cursor(self, x: float | None) -> None:
        """Mark an x; None marks none."""
        self._cursor_x = x
        if self._cursor_line is not None:
            self._cursor_line.setVisible(x is not None)
            if x is not None:
                self._cursor_line.setValue(x)

    def showEvent(self, event: QShowEvent) -> None:
        """Ask for the library once the plot stays to be seen, not only while docks are placed."""
        super().showEvent(event)
        if self._plot is None:
            QTimer.singleShot(0, self, self._ask)
        self.shown.emit()

    def _ask(self) -> None:
        if self._plot is None and self.isVisible():
            library.ask()

    def _make_in_turn(self) -> None:
        if self._plot is None and self.isVisible():
            library.queue(self, self._make)

    def _make(self) -> None:
        """The plot, unless another dock has come before it meanwhile."""
        if self._plot is not None or not self.isVisible():
            return
        import pyqtgraph

        self._plot = pyqtgraph.PlotWidget(enableMenu=False)
        self._plot.hideButtons()
        self._plot.setMouseEnabled(x=True, y=False)
        self._plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        for each in (self._plot, self._plot.viewport()):
            each.setAcceptDrops(False)  # Qt's part takes none, and warns of some that leave
        self._plot.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)  # so it is this widget's
        self._plot.scene().sigMouseClicked.connect(self._clicked)
        self._cursor_line = pyqtgraph.InfiniteLine(angle=90)
        for side in ("left", "bottom"):
            axis = self._plot.getAxis(side)
            axis.enableAutoSIPrefix(False)
            axis.setStyle(tickFont=self._font(), tickTextOffset=4, tickLength=-4, autoReduceTextSpace=False)
            axis.setCacheMode(_KEPT)
        self._plot.showGrid(y=True, alpha=_GRID)
        self._begin()
        self._lay(self._cursor_line)
        self._column.insertWidget(self._column.indexOf(self.caption) + 1, self._plot, 1)
        self._take_theme()
        self._plot.getPlotItem().vb.sigResized.connect(self._resized)

    def _lay(self, *items: Any, kept: bool = False) -> None:
        """Lay items on the plot, whatever its range; ``kept`` ones are painted once, not with each cursor."""
        for item in items:
            if kept:
                item.setCacheMode(_KEPT)
            self._plot.addItem(item, ignoreBounds=True)

    def _font(self) -> QFont:
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        return font

    def _take_type(self) -> None:
        if self._plot is not None:
            for side in ("left", "bottom"):
                self._plot.getAxis(side).setStyle(tickFont=self._font())
            self._restyle()

    def _take_theme(self) -> None:
        if self._plot is None:
            return
        now = tokens()
        self._plot.setBackground(QColor(now.surface))
        for side in ("left", "bottom"):
            axis = self._plot.getAxis(side)
            axis.setPen(QPen(QColor(now.grid_strong), 1))
            axis.setTextPen(QPen(QColor(now.muted), 1))
        self._cursor_line.setPen(QPen(QColor(now.text), 0))
        self._restyle()
        self.place_cursor(self._cursor_x)

    def _label_axes(self, left: str, bottom: str) -> None:
        look = {"color": tokens().muted, "font-size": f"{scaled(CAPTION_PX)}px"}
        for side, text in (("left", left), ("bottom", bottom)):
            self._plot.setLabel(side, text, **look)
        self._fit()

    def _fit(self) -> None:
        """A low plot does without the titles of its axes, so that the curve is seen."""
        room, metrics = self._plot.height() - _TITLES_PX, QFontMetrics(self._font())
        left, bottom = (self._plot.getAxis(side) for side in ("left", "bottom"))
        left.showLabel(0 < metrics.horizontalAdvance(left.labelText) <= room)
        bottom.showLabel(bool(bottom.labelText) and room >= _TITLES_PX)

    def _resized(self) -> None:
        """Qt would paint only what a kept axis has grown by: it is kept anew."""
        for side in ("left", "bottom"):
            axis = self._plot.getAxis(side)
            axis.setCacheMode(QGraphicsItem.CacheMode.NoCache)
            axis.setCacheMode(_KEPT)
        self._fit()

    # The hand

    def show_all(self) -> None:
        """Undo every zoom."""
        if self._plot is not None:
            self._plot.enableAutoRange()

    def _clicked(self, event: Any) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() != Qt.MouseButton.LeftButton:
            return
        if event.double():
            self.show_all()
        elif self.reach is not None:
            self._choose(self._plot.getPlotItem().vb.mapSceneToView(event.scenePos()).x())

    def _choose(self, x: float) -> None:
        if self.reach is not None:
            self._chosen(float(np.clip(x, *self.reach)))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows, Home and End choose an x; plus and minus zoom, 0 shows all."""
        low, high = self.reach or (0.0, 0.0)
        key, here = event.key(), low if self._cursor_x is None else self._cursor_x
        ten = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        far = self.nudge * (_STEPS_TEN if ten else 1)
        places = {
            Qt.Key.Key_Left: here - far,
            Qt.Key.Key_Right: here + far,
            Qt.Key.Key_Home: low,
            Qt.Key.Key_End: high,
        }
        zooms = {Qt.Key.Key_Plus: _ZOOM, Qt.Key.Key_Minus: 1 / _ZOOM}
        if not is_plain(event):
            super().keyPressEvent(event)
        elif self.reach is not None and key in places:
            self._choose(places[Qt.Key(key)])
        elif self._plot is not None and key in zooms:
            middle = QPointF(here, 0.0) if self._cursor_x is not None else None
            self._plot.getPlotItem().vb.scaleBy(x=zooms[Qt.Key(key)], center=middle)
        elif self._plot is not None and key == Qt.Key.Key_0:
            self.show_all()
        else:
            super().keyPressEvent(event)

    # What can be taken from it

    def copy(self) -> bool:
        """Put the numbers on the clipboard, as a table; False while there are none."""
        numbers = self.numbers()
        if numbers is None:
            return False
        put_on_clipboard(numbers)
        return True

    def copy_picture(self) -> None:
        """Put the plot with its caption on the clipboard, as a picture."""
        QGuiApplication.clipboard().setPixmap(self.grab())

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Zoom and copies."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for text, act in (
            (_("Show all"), self.show_all),
            (_("Copy numbers"), self.copy),
            (_("Copy picture"), self.copy_picture),
        ):
            action = menu.addAction(text)
            action.setEnabled(self.numbers() is not None)
            action.triggered.connect(act)
        menu.popup(event.globalPos())

    # The focus

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel, and a ring around what has the focus."""
        painter = QPainter(self)
        painter.fillRect(event.rect(), colour(tokens().surface))
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The ring appears."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring goes."""
        super().focusOutEvent(event)
        self.update()
