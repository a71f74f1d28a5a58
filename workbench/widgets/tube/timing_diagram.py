"""One line and one frame of a raster mode over time: picture, porches, sync, and where the beam is now."""

from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetricsF, QHelpEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from workbench.display.beam_path import KINDS, Segment, frame_segments, line_segments
from workbench.display.timings import RasterTiming
from workbench.language import _
from workbench.widgets.look.spans import time_text
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled

_TITLE_PX = 132
_MARGIN_PX, _GAP_PX, _LEAST_PX = 8, 6, 2.0
_FILLS = {"active": 0, "front_porch": 4, "sync": 1, "back_porch": 3}
"""Data inks; the height of the signal stands beside each colour."""

_LEVELS = {"active": 1.0, "front_porch": 0.36, "sync": 0.0, "back_porch": 0.36}


def kind_title(kind: str) -> str:
    """What a part of a line or a frame is called."""
    return {
        "active": _("picture"),
        "front_porch": _("front porch"),
        "sync": _("sync"),
        "back_porch": _("back porch"),
    }[kind]


class _Strip(NamedTuple):
    """One of the two: title, unit of its counts, seconds for one of them, parts, and where the beam is."""

    title: str
    unit: str
    each_s: float
    segments: Sequence[Segment]
    now: float | None

    @property
    def total(self) -> float:
        return sum(segment.length for segment in self.segments)

    def says(self, segment: Segment) -> str:
        """A part in words."""
        return _("{kind}: {count:g} {unit}, {time}").format(
            kind=kind_title(segment.kind),
            count=segment.length,
            unit=self.unit,
            time=time_text(segment.length * self.each_s),
        )

    def place(self, now: float) -> Segment:
        """The part in which the beam is."""
        inside = [s for s in self.segments if s.start <= now < s.start + s.length]
        return inside[0] if inside else self.segments[-1]


class TimingDiagram(QWidget):
    """Two strips to scale, the parts with their counts below; a rule shows the beam."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._timing: RasterTiming | None = None
        self._now: tuple[float, float] | None = None
        self._low = False
        self.strips: tuple[_Strip, ...] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self.setAccessibleName(_("Timing of a line and of a frame"))
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Two strips with their words."""
        return QSize(640, 2 * (self._row_px() + _GAP_PX))

    def minimumSizeHint(self) -> QSize:
        """So narrow that the tubes may be narrower still."""
        return QSize(240, self.sizeHint().height())

    def _row_px(self) -> int:
        return round((1.6 if self._low else 2.9) * self.fontMetrics().height())

    def be_low(self, on: bool) -> None:
        """Do without the words below the strips; a tip tells them."""
        self._low = on
        self.updateGeometry()
        self.update()

    def show_timing(self, timing: RasterTiming | None) -> None:
        """Show a mode, None: nothing."""
        if timing != self._timing:
            self._timing = timing
            self._lay_out()

    def show_beam(self, line: int, clock: float) -> None:
        """The beam is in this line of the frame, and so many clocks into it."""
        if (line, clock) != self._now:
            self._now = line, clock
            self._lay_out()

    def hide_beam(self) -> None:
        """The beam is everywhere: pictures are averaged."""
        if self._now is not None:
            self._now = None
            self._lay_out()

    def _lay_out(self) -> None:
        timing, now = self._timing, self._now
        if timing is None:
            self.strips = ()
        else:
            across = None if now is None else now[1]
            down = None if now is None else now[0] + now[1] / timing.h_total
            line = _Strip(_("Line"), _("clocks"), float(timing.pixel_s), line_segments(timing), across)
            title = _("Frame, two fields") if timing.interlaced else _("Frame")
            frame = _Strip(title, _("lines"), float(timing.line_s), frame_segments(timing), down)
            self.strips = (line, frame)
        said = []
        for strip in self.strips:
            said.append(f"{strip.title}: {time_text(strip.total * strip.each_s)}")
            said += [strip.says(segment) for segment in strip.segments]
            if strip.now is not None:
                said.append(_("the beam is in: {kind}").format(kind=kind_title(strip.place(strip.now).kind)))
        self.setAccessibleDescription("; ".join(said))
        self.update()

    def _bar(self, number: int) -> QRectF:
        """Where the signal of a strip is drawn."""
        top = number * (self._row_px() + _GAP_PX) + 3
        left = min(_TITLE_PX, self.width() // 4)
        return QRectF(left, top, self.width() - left - _MARGIN_PX, self.fontMetrics().height() * 1.5)

    def _edges(self, strip: _Strip, bar: QRectF) -> list[tuple[float, float]]:
        """Left and right of each part: to scale, but for parts too thin to be seen."""
        scale = bar.width() / max(strip.total, 1.0)
        ends = []
        for s in strip.segments:
            left = bar.left() + s.start * scale
            ends.append((left, left + max(s.length * scale, _LEAST_PX if s.length else 0.0)))
        return ends

    def paintEvent(self, event: QPaintEvent) -> None:
        """Both strips."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = painter.font()
        font.setPixelSize(scaled(CAPTION_PX))
        small = QFontMetricsF(font)
        for number, strip in enumerate(self.strips):
            bar = self._bar(number)
            painter.setFont(self.font())
            painter.setPen(colour(tokens().text))
            titles = QRectF(4, bar.top() - 2, bar.left() - 8, bar.height())
            elide = self.fontMetrics().elidedText(
                strip.title, Qt.TextElideMode.ElideRight, int(titles.width())
            )
            painter.drawText(titles, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, elide)
            painter.setFont(font)
            painter.setPen(colour(tokens().muted))
            if self._low:
                self._paint_signal(painter, strip, bar)
                self._paint_beam(painter, strip, bar)
                continue
            below = QRectF(4, bar.bottom() + 1, bar.left() - 8, small.height())
            painter.drawText(below, Qt.AlignmentFlag.AlignLeft, time_text(strip.total * strip.each_s))
            self._paint_signal(painter, strip, bar)
            self._paint_legend(painter, strip, bar, small)
            self._paint_beam(painter, strip, bar)

    @staticmethod
    def _paint_beam(painter: QPainter, strip: _Strip, bar: QRectF) -> None:
        if strip.now is not None:
            x = bar.left() + strip.now / max(strip.total, 1.0) * bar.width()
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.drawLine(QPointF(x, bar.top() - 2), QPointF(x, bar.bottom() + 1))

    def _paint_signal(self, painter: QPainter, strip: _Strip, bar: QRectF) -> None:
        """The signal: high for the picture, at the level of black in the porches, below it in sync."""
        base = bar.bottom()
        for segment, (left, right) in zip(strip.segments, self._edges(strip, bar), strict=True):
            ink = tokens().data[_FILLS[segment.kind]]
            top = base - max(_LEVELS[segment.kind], 0.1) * bar.height()
            box = QRectF(left, top, right - left, base - top)
            painter.fillRect(box, colour(ink, 90 if segment.kind == "active" else 170))
            painter.setPen(QPen(colour(ink), 1.2))
            painter.drawLine(QPointF(left, top), QPointF(right, top))
        painter.setPen(QPen(colour(tokens().field_edge), 1))
        painter.drawLine(bar.bottomLeft(), bar.bottomRight())

    def _paint_legend(self, painter: QPainter, strip: _Strip, bar: QRectF, metrics: QFontMetricsF) -> None:
        """The parts of a line, or of a field, with their counts, as many as there is room for."""
        x, y = bar.left(), bar.bottom() + 2
        for segment in strip.segments[: len(KINDS)]:
            words = f"{kind_title(segment.kind)} {segment.length:g}"
            longer = f"{words} = {time_text(segment.length * strip.each_s)}"
            if bar.width() > 4 * metrics.horizontalAdvance(longer):
                words = longer
            width = metrics.horizontalAdvance(words)
            if x + 12 + width > bar.right():
                return
            ink = colour(tokens().data[_FILLS[segment.kind]])
            painter.fillRect(QRectF(x, y + metrics.ascent() - 8, 8, 8), ink)
            painter.setPen(colour(tokens().muted))
            painter.drawText(QPointF(x + 12, y + metrics.ascent()), words)
            x += 12 + width + 14

    def told_at(self, place: QPointF) -> str:
        """What is said of a place of the diagram."""
        for number, strip in enumerate(self.strips):
            bar = self._bar(number)
            if not bar.top() - 2 <= place.y() <= bar.bottom() + 2:
                continue
            for segment, (left, right) in zip(strip.segments, self._edges(strip, bar), strict=True):
                if left - 1 <= place.x() <= right + 1:
                    return strip.says(segment)
        return ""

    def event(self, event: QEvent) -> bool:
        """The part under the pointer tells its numbers."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.told_at(QPointF(event.pos())), self)
            return True
        return super().event(event)
