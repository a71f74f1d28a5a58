"""A drag that comes to the edge of a canvas scrolls there what of the picture lies beyond it."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

if TYPE_CHECKING:
    from workbench.widgets.canvas.surface import CanvasSurface

EDGE_PX = 16
TICK_MS = 30
_FASTEST_PX = 24


class EdgeScroll(QObject):
    """Scrolls ``canvas`` while the pointer of a drag is held at its edge, and goes on with the drag there."""

    def __init__(self, canvas: "CanvasSurface") -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._position = QPointF()
        self._modifiers = Qt.KeyboardModifier.NoModifier
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self._tick)

    def follow(self, event: QMouseEvent) -> None:
        """The pointer that drags something has moved."""
        self._position, self._modifiers = event.position(), event.modifiers()
        if self._way() == (0, 0):
            self._timer.stop()
        elif not self._timer.isActive():
            self._timer.start()

    def stop(self) -> None:
        """The drag has ended."""
        self._timer.stop()

    def _way(self) -> tuple[int, int]:
        """How far the picture goes right and down in one tick, screen pixels."""
        canvas = self._canvas
        unit, area = canvas.devicePixelRatioF(), canvas.area
        x, y = self._position.x() * unit, self._position.y() * unit
        left, top, right, bottom = canvas.beyond

        def step(into: float, hidden: float) -> int:
            """Towards one side: faster the farther the pointer is into its edge, as far as there is more."""
            return round(max(0.0, min(into / 2 + unit, hidden, _FASTEST_PX * unit))) if into > 0 else 0

        edge = EDGE_PX * unit
        return (
            step(area.left + edge - x, left) - step(x - area.right + edge, right),
            step(area.top + edge - y, top) - step(y - area.bottom + edge, bottom),
        )

    def _tick(self) -> None:
        right, down = self._way()
        if (right, down) == (0, 0) or not self._canvas.isVisible():
            self._timer.stop()
            return
        self._canvas.pan(right, down)
        left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
        place = self._canvas.mapToGlobal(self._position)
        QApplication.sendEvent(
            self._canvas,
            QMouseEvent(QEvent.Type.MouseMove, self._position, place, none, left, self._modifiers),
        )
