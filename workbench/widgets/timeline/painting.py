"""How a timeline is painted: the ruler, the tracks, their keys and the frame that is shown."""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFontMetricsF, QLinearGradient, QPainter, QPainterPath, QPen

from workbench.language import _
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.timeline.rows import KeyShown, Pace, TimelineShown, TrackShown
from workbench.widgets.timeline.scale import LABEL_PX, RIGHT_PX, ROW_PX, RULER_PX, Scale

KEY_PX = 6.0
_HATCHED = Qt.BrushStyle.BDiagPattern
_TICKS = (1, 2, 4, 8, 12, 24, 48, 120, 240, 480, 1200, 2400, 12_000, 120_000)
_LEAST_TICK_PX = 36


def nothing_moves() -> str:
    """What a page without tracks says."""
    return _("Nothing moves yet. Turn auto-key on, go to another frame, and move a figure.")


def tick_step(pixels_per_frame: float) -> int:
    """Frames from one number of the ruler to the next."""
    return next((step for step in _TICKS if step * pixels_per_frame >= _LEAST_TICK_PX), _TICKS[-1])


def key_path(centre: QPointF, arriving: Pace, leaving: Pace) -> QPainterPath:
    """The shape of a key: each half is pointed at full speed, round where it is slow, square where held."""
    x, y, r = centre.x(), centre.y(), KEY_PX
    path = QPainterPath(QPointF(x, y - r))
    for side, pace in ((1, leaving), (-1, arriving)):
        top = side  # the right half is drawn downwards, the left one back up
        if pace == "slow":
            path.arcTo(QRectF(x - r, y - r, 2 * r, 2 * r), 90.0 * side, -180.0)
        elif pace == "fast":
            path.lineTo(x + side * r, y)
        else:
            out = r if pace == "held" else 2.0
            path.lineTo(x + side * out, y - top * r)
            path.lineTo(x + side * out, y + top * r)
        path.lineTo(x, y + top * r)
    path.closeSubpath()
    return path


def paint_ruler(painter: QPainter, scale: Scale, shown: TimelineShown, width: float) -> None:
    """Frames as numbers, and how far the ghosts reach."""
    now = tokens()
    painter.fillRect(QRectF(0, 0, width, RULER_PX), colour(now.raised))
    if shown.reach:
        for side, ink in ((-1, now.data[0]), (1, now.data[1])):
            x0, x1 = sorted((scale.x(shown.frame), scale.x(shown.frame + side * shown.reach)))
            x0 = max(x0, LABEL_PX)
            if x1 > x0:
                painter.fillRect(QRectF(x0, 2, x1 - x0, RULER_PX - 4), _faint(ink, 70))
                painter.fillRect(QRectF(x0 if side < 0 else x1 - 3, 2, 3, RULER_PX - 4), colour(ink))
    step = tick_step(scale.pixels)
    metrics = QFontMetricsF(painter.font())
    for frame in range(scale.first // step * step, min(scale.last(width), shown.frames - 1) + 1, step):
        x = scale.x(frame)
        if x < LABEL_PX:
            continue
        painter.setPen(colour(now.field_edge))
        painter.drawLine(QPointF(x, RULER_PX - 5), QPointF(x, RULER_PX))
        painter.setPen(colour(now.muted))
        text = str(frame)
        painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, RULER_PX - 8), text)


def paint_track(
    painter: QPainter,
    scale: Scale,
    track: TrackShown,
    value: str,
    top: float,
    width: float,
    chosen: bool,
    selected: frozenset[str],
) -> None:
    """One row: label, value, the line between its keys, the keys."""
    now = tokens()
    row = QRectF(0, top, width, ROW_PX)
    if chosen:
        painter.fillRect(row, colour(now.selected))
        painter.fillRect(QRectF(0, top, 3, ROW_PX), colour(now.accent))
    painter.setPen(colour(now.line))
    painter.drawLine(QPointF(0, top + ROW_PX - 0.5), QPointF(width, top + ROW_PX - 0.5))
    metrics = QFontMetricsF(painter.font())
    value = track.problem or value
    value_px = metrics.horizontalAdvance(value)
    room = LABEL_PX - 26 - value_px
    painter.setPen(colour(now.text))
    label = metrics.elidedText(track.label, Qt.TextElideMode.ElideRight, max(room, 40.0))
    middle = top + (ROW_PX + metrics.ascent() - metrics.descent()) / 2
    painter.drawText(QPointF(12, middle), label)
    painter.setPen(colour(now.warn if track.problem else now.muted))
    painter.drawText(QPointF(LABEL_PX - 8 - value_px, middle), value)
    if not track.keys:
        return
    painter.save()
    painter.setClipRect(QRectF(LABEL_PX - KEY_PX, top, width, ROW_PX))
    y = top + ROW_PX / 2
    x0, x1 = scale.x(track.keys[0].frame), scale.x(track.keys[-1].frame)
    if track.colours and x1 > x0:
        gradient = QLinearGradient(x0, 0, x1, 0)
        for place, name in enumerate(track.colours):
            gradient.setColorAt(place / max(len(track.colours) - 1, 1), QColor(name))
        painter.fillRect(QRectF(x0, y - 4, x1 - x0, 8), gradient)
    else:
        painter.setPen(QPen(colour(now.muted), 1))
        painter.drawLine(QPointF(x0, y), QPointF(x1, y))
    for key in track.keys:
        if scale.first - 1 <= key.frame <= scale.last(width) + 1:
            _paint_key(painter, scale, key, y, key.id in selected)
    painter.restore()


def _paint_key(painter: QPainter, scale: Scale, key: KeyShown, y: float, selected: bool) -> None:
    now = tokens()
    path = key_path(QPointF(scale.x(key.frame), y), key.arriving, key.leaving)
    painter.setPen(QPen(colour(now.canvas), 1.5))
    painter.setBrush(colour(now.accent if selected else now.text))
    painter.drawPath(path)


def paint_end(painter: QPainter, scale: Scale, shown: TimelineShown, width: float, height: float) -> None:
    """What comes after the last frame is hatched: keys there are kept, and not played."""
    x = max(scale.x(shown.frames - 1) + KEY_PX + 2, LABEL_PX)
    if x < width - RIGHT_PX:
        painter.fillRect(QRectF(x, RULER_PX, width - x, height), QBrush(colour(tokens().line), _HATCHED))


def paint_frame(painter: QPainter, scale: Scale, shown: TimelineShown, height: float) -> None:
    """The frame that is shown, as a line with its number."""
    x = scale.x(shown.frame)
    if x < LABEL_PX - 1:
        return
    now = tokens()
    painter.setPen(QPen(colour(now.text), 1.5))
    painter.drawLine(QPointF(x, RULER_PX), QPointF(x, height))
    metrics = QFontMetricsF(painter.font())
    text = str(shown.frame)
    wide = metrics.horizontalAdvance(text) + 12
    box = QRectF(x - wide / 2, 1, wide, RULER_PX - 4)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour(now.text))
    painter.drawRoundedRect(box, 4, 4)
    painter.setPen(colour(now.canvas))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def _faint(name: str, alpha: int) -> QColor:
    faint = QColor(name)
    faint.setAlpha(alpha)
    return faint
