"""A point and its image as homogeneous coordinates: the line through the origin of space, cut by w = 1."""

import math

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.panels.transform.told import place_text
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.look.tokens import colour, theme, tokens

_SLANT = math.radians(30)
_BEYOND = 1.75
_MARGIN = 14.0
_LEAST_PX = 100


class HomogeneousView(QWidget):
    """Space with x to the right, y into it and w upwards; every point of a line through the origin is one
    point of the plane w = 1.
    """

    def __init__(self) -> None:
        super().__init__()
        self._points: list[tuple[str, float, float, str]] = []
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumHeight(_LEAST_PX)
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Wide rather than high."""
        return QSize(280, 170)

    def show_points(self, point: tuple[float, float] | None, image: tuple[float, float] | None) -> None:
        """Show a point and what the chain makes of it."""
        self._points = [
            (name, *place, ink)
            for name, place, ink in (("P", point, "muted"), ("P′", image, "data1"))
            if place is not None and all(map(math.isfinite, place))
        ]
        listed = "; ".join(f"{name} {place_text(x, y)}" for name, x, y, _ink in self._points)
        self.setAccessibleName(_("Homogeneous coordinates: {points}").format(points=listed))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Axes, the plane, and each point's line."""
        now, painter = tokens(), QPainter(self)
        painter.fillRect(self.rect(), QColor(now.canvas))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        reach = max((max(abs(x), abs(y)) for _name, x, y, _ink in self._points), default=1.0) * 1.15 or 1.0
        wide = self.width() / 2 - _MARGIN
        unit = wide / (reach * (1 + 0.5 * math.cos(_SLANT)) * _BEYOND)
        up = (self.height() - 2 * _MARGIN) / 2 / _BEYOND
        origin = QPointF(self.width() / 2, self.height() - _MARGIN - 0.5 * math.sin(_SLANT) * reach * unit)

        def at(x: float, y: float, w: float) -> QPointF:
            across = unit * (x + 0.5 * math.cos(_SLANT) * y)
            return origin + QPointF(across, -0.5 * math.sin(_SLANT) * unit * y - up * w)

        painter.setPen(QPen(QColor(now.muted), 1))
        for name, end in (("x", at(reach, 0, 0)), ("y", at(0, reach, 0)), ("w", at(0, 0, _BEYOND))):
            painter.drawLine(origin, end)
            painter.drawText(end + QPointF(4, 4), name)
        corners = [at(reach * x, reach * y, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        painter.setBrush(colour(now.accent, 24))
        painter.setPen(QPen(QColor(now.accent), 1))
        painter.drawPolygon(QPolygonF(corners))
        painter.drawText(corners[0] + QPointF(2, 14), "w = 1")
        for name, x, y, ink in self._points:
            pen = QPen(QColor(ink_of(now, ink)), 1.75)
            painter.setPen(QPen(pen.color(), 1.25, Qt.PenStyle.DashLine))
            painter.drawLine(at(x, y, 1), at(x * _BEYOND, y * _BEYOND, _BEYOND))
            painter.setPen(pen)
            painter.drawLine(origin, at(x, y, 1))
            painter.setBrush(pen.color())
            spot = at(x, y, 1)
            painter.drawEllipse(QRectF(spot.x() - 4, spot.y() - 4, 8, 8))
            painter.setPen(QColor(now.text))
            painter.drawText(spot + QPointF(7, -5), name)
        painter.end()
