"""How the curve of a track is painted: its numbers as lines, their keys, and the handles of easings."""

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_axis import number_text, tick_text, ticks
from workbench.widgets.timeline.painting import key_path
from workbench.widgets.timeline.rows import CurveShown, KeyShown
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX, Scale
from workbench.widgets.timeline.value_scale import ValueScale

_STEP_PX = 2.0
_TICK_PX = 34
_BEFORE = 1e-6
_PATTERNS = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine, Qt.PenStyle.DashDotLine)


def ink_of(number: int) -> QColor:
    """The colour of a number's curve."""
    data = tokens().data
    return colour(data[number % len(data)])


def paint_values(painter: QPainter, values: ValueScale, width: float, height: float) -> None:
    """Round values, and a line at each."""
    now, metrics = tokens(), QFontMetricsF(painter.font())
    most = max(int((height - RULER_PX) / _TICK_PX), 2)
    for value in ticks(values.value(height - 4), values.value(RULER_PX + 4), most):
        y = values.y(value)
        painter.setPen(colour(now.grid))
        painter.drawLine(QPointF(LABEL_PX, y), QPointF(width, y))
        text = tick_text(value)
        painter.setPen(colour(now.muted))
        painter.drawText(QPointF(LABEL_PX - 6 - metrics.horizontalAdvance(text), y + 4), text)


def paint_title(painter: QPainter, label: str) -> None:
    """What moves, beside the ruler."""
    painter.setPen(colour(tokens().text))
    elided = QFontMetricsF(painter.font()).elidedText(label, Qt.TextElideMode.ElideRight, LABEL_PX - 20)
    room = QRectF(12, 0, LABEL_PX - 20, RULER_PX)
    painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, elided)


def paint_numbers(painter: QPainter, curve: CurveShown, now_values: tuple[float, ...], chosen: int) -> None:
    """Which numbers there are, how each is drawn, and its value in the frame that is shown."""
    now, metrics = tokens(), QFontMetricsF(painter.font())
    for number, (name, value) in enumerate(zip(curve.names, now_values, strict=True)):
        row = QRectF(0, RULER_PX + number * ROW_PX, LABEL_PX - 48, ROW_PX)
        if number == chosen:
            painter.fillRect(row, colour(now.selected))
            painter.fillRect(QRectF(0, row.top(), 3, ROW_PX), colour(now.accent))
        painter.setPen(QPen(ink_of(number), 2, _PATTERNS[number % len(_PATTERNS)]))
        painter.drawLine(QPointF(10, row.center().y()), QPointF(34, row.center().y()))
        text = number_text(value, 6)
        room = row.width() - 40 - metrics.horizontalAdvance(text) - 12
        painter.setPen(colour(now.text))
        middle = row.top() + (ROW_PX + metrics.ascent() - metrics.descent()) / 2
        painter.drawText(QPointF(40, middle), metrics.elidedText(name, Qt.TextElideMode.ElideRight, room))
        painter.setPen(colour(now.muted))
        painter.drawText(QPointF(row.right() - metrics.horizontalAdvance(text), middle), text)


def paint_curves(
    painter: QPainter, scale: Scale, values: ValueScale, curve: CurveShown, width: float, chosen: int
) -> None:
    """The line of each number over the frames that are seen, the chosen one last and strongest."""
    x = np.arange(max(scale.x(0), LABEL_PX), width + _STEP_PX, _STEP_PX)
    if not len(x):  # a strip so narrow that the names take all of it
        return
    seen = scale.first + (x - scale.x(scale.first)) / scale.pixels
    own = np.array([key.frame for key in curve.keys], np.float64)
    own = own[(own >= seen[0]) & (own <= seen[-1])]
    frames = np.unique(np.concatenate([seen, own, own - _BEFORE]))
    heights = curve.sampled(frames)
    places = [scale.x(frame) for frame in frames.tolist()]
    for number in sorted(range(len(curve.names)), key=lambda each: each == chosen):
        points = zip(places, heights[:, number].tolist(), strict=True)
        line = QPolygonF([QPointF(place, values.y(height)) for place, height in points])
        wide = 2.0 if number == chosen else 1.0
        painter.setPen(QPen(ink_of(number), wide, _PATTERNS[number % len(_PATTERNS)]))
        painter.drawPolyline(line)


def paint_key(painter: QPainter, key: KeyShown, place: QPointF, selected: bool, faint: bool) -> None:
    """A key on a curve, in the shape that it has on the timeline; ``faint``: on a number not chosen."""
    now = tokens()
    painter.setPen(QPen(colour(now.canvas), 1.5))
    painter.setBrush(colour(now.muted if faint else now.accent if selected else now.text))
    painter.drawPath(key_path(place, key.arriving, key.leaving))


def paint_handles(
    painter: QPainter,
    grips: Mapping[tuple[str, int], tuple[QPointF, QPointF]],
    held: tuple[str, int] | None,
) -> None:
    """The handles of easings, each with the line to its key."""
    now = tokens()
    for name, (key, handle) in grips.items():
        painter.setPen(QPen(colour(now.accent), 1))
        painter.drawLine(key, handle)
        painter.setPen(QPen(colour(now.accent), 2))
        painter.setBrush(colour(now.accent if name == held else now.surface))
        painter.drawEllipse(handle, 4.5, 4.5)
