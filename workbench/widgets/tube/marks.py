"""What is drawn over the light of a tube: the beam itself, the probe, and the lettering of the cabinet."""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFont, QPainter, QPen, QRadialGradient

from workbench.display.beam import BeamState
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.tube.glass import LETTERING

# Over the glass, which is dark in both themes.
_LIGHT = QColor("#F5F7FA")
_SHADE = QColor(0, 0, 0, 160)


def _faint(alpha: int) -> QColor:
    made = QColor(_LIGHT)
    made.setAlpha(alpha)
    return made


def paint_beam(painter: QPainter, place: QPointF, glass_width: float, state: BeamState) -> None:
    """Where the beam points: a glow while it is on, a small ring while it is dark."""
    radius = max(5.0, 0.012 * glass_width)
    if state.lit and any(state.currents):
        glow = QRadialGradient(place, 2.2 * radius)
        for stop, alpha in ((0.0, 190), (0.25, 70), (1.0, 0)):
            glow.setColorAt(stop, _faint(alpha))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QBrush(glow))
        painter.drawEllipse(place, 2.2 * radius, 2.2 * radius)
        return
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(_faint(120 if state.lit else 70), 1.2))
    painter.drawEllipse(place, 0.6 * radius, 0.6 * radius)


def paint_probe(painter: QPainter, place: QPointF) -> None:
    """Cross hairs around the probed pixel, seen on light and on dark."""
    radius, arm = 7.0, 4.0
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(_SHADE, 3.2), QPen(_LIGHT, 1.4)):
        painter.setPen(pen)
        painter.drawEllipse(place, radius, radius)
        for way in (QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)):
            painter.drawLine(place + way * radius, place + way * (radius + arm))


def paint_plate(painter: QPainter, plate: QRectF, name: str, rate: str) -> None:
    """The lettering below the glass; where there is no room for both, what stands at the right."""
    font = QFont(painter.font())
    font.setPixelSize(scaled(CAPTION_PX))
    painter.setFont(font)
    painter.setPen(LETTERING)
    inset = 0.06 * plate.width()
    inner = plate.adjusted(inset, 0, -inset, 0)
    wide = painter.fontMetrics().horizontalAdvance
    if wide(f"{name}  {rate}") < inner.width():
        painter.drawText(inner, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, name)
    painter.drawText(inner, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, rate)
