"""Refresh rate against persistence: where a tube flickers, where it is steady, where it smears."""

import math
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QColor,
    QFontMetrics,
    QKeyEvent,
    QMouseEvent,
    QPolygonF,
)
from PySide6.QtWidgets import QGraphicsPolygonItem, QSizePolicy, QWidget

from workbench.display.flicker import Zones
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.spans import span_text
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot, pen_of

_LEAST_HZ, _MOST_HZ = 10.0, 120.0
_TINT = 46
_SPOT_PX = 13
_FACTOR = 1.1
_FAR = 10.0
_AXIS_PX = 64  # of times with their units


class FlickerMap(Plot):
    """``moved`` sends the refresh rate (Hz) and the persistence (seconds to 10 %) that a hand asks for.

    ``held`` tells that the point is taken hold of, and that it is let go.
    """

    moved = Signal(float, float)
    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Map of refresh rate and persistence"), parent)
        self._zones = Zones((), (), math.inf)
        self._point: tuple[float, float] | None = None
        self._items: dict[str, Any] = {}
        self._words: list[Any] = []
        self._dragging = False
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setToolTip(
            _(
                "Drag the point, or use the arrows (Shift: ten times as far): it sets the tube beside it. "
                "Persistence is the time in which the light falls to 10 %."
            )
        )

    def sizeHint(self) -> QSize:
        """About a square."""
        return QSize(320, 260)

    def show_map(self, zones: Zones, refresh_hz: float, seconds: float, words: str) -> None:
        """Show the zones of a phosphor at a luminance, and where the tube is among them."""
        anew, self._zones = zones != self._zones, zones
        self._point = refresh_hz, seconds
        self.say(words)
        if self.hasFocus():
            QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))
        if anew:
            self._draw()
        self._mark()

    def numbers(self) -> Table | None:
        """Seconds to 10 %, and the rate from which that is steady."""
        rows = [(f"{s:.4g}", f"{hz:.4g}") for s, hz in zip(*self._zones[:2], strict=True)]
        return Table((_("seconds to 10 %"), _("steady from, Hz")), rows, formulas=False) if rows else None

    # Drawing

    def _begin(self) -> None:
        import pyqtgraph

        self._plot.setMouseEnabled(x=False, y=False)
        self._items = {name: QGraphicsPolygonItem() for name in ("flickers", "smears")}
        self._items["fusion"] = pyqtgraph.PlotCurveItem(antialias=True)
        self._items["smear"] = pyqtgraph.InfiniteLine(0.0, angle=0)
        self._items["point"] = pyqtgraph.ScatterPlotItem(size=_SPOT_PX)
        self._items["point"].setZValue(3)
        self._words = [pyqtgraph.TextItem(anchor=(0.5, 0.5)) for _zone in range(3)]
        zones = [item for name, item in self._items.items() if name != "point"]
        self._lay(*zones, *self._words, kept=True)
        self._lay(self._items["point"])
        self._plot.viewport().installEventFilter(self)
        self._plot.getAxis("left").setStyle(hideOverlappingLabels=True)
        self._plot.getAxis("left").setWidth(_AXIS_PX)
        self._plot.showGrid(x=False, y=False)

    def _restyle(self) -> None:
        now, items = tokens(), self._items
        for name, ink in (("flickers", now.data[1]), ("smears", now.data[0])):
            tint = QColor(ink)
            tint.setAlpha(_TINT)
            items[name].setBrush(tint)
            items[name].setPen(QColor(0, 0, 0, 0))
        items["fusion"].setPen(pen_of(now.data[1], 2))
        items["smear"].setPen(pen_of(now.data[0], 2, Qt.PenStyle.DashLine))
        items["point"].setPen(pen_of(now.surface, 2))
        items["point"].setBrush(QColor(now.text))
        for item in self._words:
            item.setColor(now.text)
            item.setFont(self._font())
        self._label_axes(_("persistence"), _("refresh, Hz"))
        self._draw()
        self._mark()

    def _heights(self) -> tuple[float, float]:
        """The least and the greatest persistence, as powers of ten."""
        seconds = self._zones.seconds
        return math.log10(seconds[0]), math.log10(seconds[-1])

    def _draw(self) -> None:
        if self._plot is None or not self._items or not self._zones.seconds:
            return
        low, high = self._heights()
        ys, xs = np.log10(self._zones.seconds), np.array(self._zones.fusion_hz)
        self._items["fusion"].setData(xs, ys)
        left = [QPointF(x, y) for x, y in zip(xs.tolist(), ys.tolist(), strict=True)]
        corners = [QPointF(_LEAST_HZ, low), *left, QPointF(_LEAST_HZ, high)]
        self._items["flickers"].setPolygon(QPolygonF([self._held(corner) for corner in corners]))
        there = math.isfinite(self._zones.smear_s) and self._zones.smear_s < self._zones.seconds[-1]
        smear = max(math.log10(self._zones.smear_s), low) if there else high
        self._items["smear"].setVisible(there)
        self._items["smear"].setValue(smear)
        box = [(_LEAST_HZ, smear), (_MOST_HZ, smear), (_MOST_HZ, high), (_LEAST_HZ, high)]
        self._items["smears"].setPolygon(QPolygonF([QPointF(x, y) for x, y in box]))
        self._say_zones(low, smear, high, float(np.interp(0.5 * (low + smear), ys, xs)))
        self._plot.setRange(xRange=(_LEAST_HZ, _MOST_HZ), yRange=(low, high), padding=0)
        powers = range(math.ceil(low), math.floor(high) + 1)
        every = math.ceil(len(powers) * self._line_px / max(self._room_px, self._line_px))
        self._plot.getAxis("left").setTicks([[(p, span_text(10.0**p)) for p in powers[::every]]])

    @property
    def _line_px(self) -> int:
        return QFontMetrics(self._font()).height()

    @property
    def _room_px(self) -> float:
        """How high the map is without what stands below it."""
        return float(self._plot.height() - self._plot.getAxis("bottom").height())

    def _fit(self) -> None:
        """A lower map names fewer times and zones."""
        super()._fit()
        self._draw()

    def _say_zones(self, low: float, smear: float, high: float, fusion: float) -> None:
        line = self._line_px * (high - low) / max(self._room_px, 1.0)
        below, wide = 0.5 * (low + smear), smear - low > line
        places: Sequence[tuple[str, float, float, bool]] = (
            (
                _("flickers"),
                0.5 * (_LEAST_HZ + fusion),
                below,
                fusion > _LEAST_HZ + 10 and wide,
            ),
            (_("steady"), 0.5 * (_MOST_HZ + fusion), below, fusion < _MOST_HZ - 10 and wide),
            (_("smears"), 0.5 * (_LEAST_HZ + _MOST_HZ) + 12, 0.5 * (smear + high), high - smear > line),
        )
        for item, (word, x, y, there) in zip(self._words, places, strict=True):
            item.setText(word)
            item.setPos(max(x, _LEAST_HZ + 12), y)
            item.setVisible(there)

    @staticmethod
    def _held(place: QPointF) -> QPointF:
        return QPointF(min(max(place.x(), _LEAST_HZ), _MOST_HZ), place.y())

    def _mark(self) -> None:
        if self._items and self._point is not None:
            x, seconds = self._point
            self._items["point"].setData([x], [math.log10(seconds)])

    def show_all(self) -> None:
        """The map is always seen as a whole."""
        self._draw()

    # The hand

    def _ask_for(self, refresh_hz: float, seconds: float) -> None:
        if self._zones.seconds:
            low, high = self._zones.seconds[0], self._zones.seconds[-1]
            self._point = min(max(refresh_hz, 1.0), 240.0), min(max(seconds, low), high)
            self._mark()
            self.moved.emit(*self._point)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A left press or drag takes the point there."""
        if not isinstance(event, QMouseEvent) or self._plot is None:
            return False
        kinds = QEvent.Type
        if event.type() == kinds.MouseButtonPress and event.button() == Qt.MouseButton.LeftButton:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            self._dragging = True
            self.held.emit(True)
        elif event.type() == kinds.MouseButtonRelease and self._dragging:
            self._dragging = False
            self.held.emit(False)
            return True
        if not self._dragging:
            return False
        place = self._plot.getPlotItem().vb.mapSceneToView(self._plot.mapToScene(event.position().toPoint()))
        power = min(place.y(), sys.float_info.max_10_exp)  # the pointer may be anywhere
        self._ask_for(float(np.clip(round(place.x()), _LEAST_HZ, _MOST_HZ)), 10.0**power)
        return True

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the point: sideways by 1 Hz, up and down by a tenth; with Shift ten times as far."""
        ways = {
            Qt.Key.Key_Left: (-1.0, 0),
            Qt.Key.Key_Right: (1.0, 0),
            Qt.Key.Key_Up: (0.0, 1),
            Qt.Key.Key_Down: (0.0, -1),
        }
        way = ways.get(Qt.Key(event.key()))
        if way is None or self._point is None or not is_plain(event):
            super().keyPressEvent(event)
            return
        far = _FAR if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        refresh, seconds = self._point
        self._ask_for(refresh + way[0] * far, seconds * _FACTOR ** (way[1] * far))
