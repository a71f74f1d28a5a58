"""A colour tube as a widget: its whole face in a cabinet, or a part of it magnified until the mask is seen.

It rests while its picture is steady. In slow motion, below three pictures a second or without Calm, the three
beams pass over the mask.
"""

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display.colour_tube import ColourSetup, ColourTube
from workbench.display.driver import must_average
from workbench.display.setup import area_mm, face_mm
from workbench.display.tube import PICOSECOND
from workbench.language import _
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.tube.glass import (
    cabinet_pixmap,
    fitted,
    glass_path,
    nearest_pixel,
    pixel_at,
    reflection_pixmap,
)
from workbench.widgets.tube.marks import paint_beam, paint_probe

_WIDEST_PX = 380
_FRAME_MS, _REST_MS, _LONGEST_WAIT_MS = 16, 20, 250
_LONGEST_STEP_S = 0.1
_PITCHES_SHOWN = 6
_ON_GLASS = QColor("#F5F7FA")  # over the glass, which is dark in both themes
_BEHIND = QColor(0, 0, 0, 170)


class ColourView(QWidget):
    """``picked`` sends the pixel of the picture that was clicked, ``shown`` tells that it comes in sight.

    A ``magnified`` view shows ``width_mm`` of the face around the probe, another one all of it and, framed,
    what of it is magnified.
    """

    picked = Signal(int, int)
    shown = Signal()
    advanced = Signal()

    def __init__(self, magnified: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.magnified = magnified
        self.width_mm = 12.0
        self.tube: ColourTube | None = None
        self._image: NDArray[np.uint32] = np.zeros((48, 64), np.uint32)
        self._setup = ColourSetup()
        self._probe: tuple[int, int] = (32, 24)
        self._slow = 1.0
        self._shown: QImage | None = None
        self._case, self._glass = QRectF(), QRectF()
        self._layers: tuple[QPixmap, QPixmap] | None = None
        self._timer = QTimer(self, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._clock = QElapsedTimer()
        self._due = QTimer(self, singleShot=True, interval=_REST_MS)
        self._due.timeout.connect(self.rebuild)
        self.sight = InSight(self)
        self.sight.changed.connect(self._come_in_sight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(100, 60)
        self.setAccessibleName(_("Mask of the colour tube, magnified") if magnified else _("Colour tube"))
        self.setToolTip(
            _("The grains of the face behind the mask: only light of its own colour comes from each.")
            if magnified
            else _("Click or drag to choose the pixel whose colour is worked on and that is magnified.")
        )
        theme.changed.connect(self.update)
        comfort.changed.connect(self._wake)

    def sizeHint(self) -> QSize:
        """Room for half a page."""
        return QSize(360, 300)

    # What is shown

    def show_picture(self, image: NDArray[np.uint32], setup: ColourSetup) -> None:
        """Show a frame buffer (h, w), 0xRRGGBB, row 0 at the bottom, on a tube set up like this."""
        if image is not self._image or setup != self._setup:
            self._image, self._setup = image, setup
            self._probe = nearest_pixel(*self._probe, self._picture)
            self._soon()

    def set_probe(self, pixel: tuple[int, int]) -> None:
        """Magnify around this pixel of the picture."""
        pixel = nearest_pixel(*pixel, self._picture)
        if pixel != self._probe:
            self._probe = pixel
            if self.magnified:
                self._soon()
            self.update()

    @property
    def probe(self) -> tuple[int, int]:
        """The pixel that is worked on."""
        return self._probe

    def set_width(self, width_mm: float) -> None:
        """Show so much of the face from left to right, or frame it."""
        if width_mm != self.width_mm:
            self.width_mm = width_mm
            if self.magnified:
                self._soon()
            self.update()

    def set_slow_motion(self, factor: float) -> None:
        """Run so many times slower than life."""
        self._slow = max(factor, 1.0)
        self._wake()

    @property
    def image(self) -> NDArray[np.uint32]:
        """The frame buffer that is shown."""
        return self._image

    @property
    def averaged(self) -> bool:
        """Whether whole pictures are averaged now, so that no beam is seen."""
        return must_average(self._setup.refresh_hz, self._slow, comfort.calm)

    @property
    def running(self) -> bool:
        """Whether its time runs."""
        return self._timer.isActive()

    @property
    def _picture(self) -> tuple[int, int]:
        return self._image.shape[1], self._image.shape[0]

    def _probe_mm(self) -> tuple[float, float]:
        left, bottom, right, _top = area_mm(self._picture)
        pitch = (right - left) / self._picture[0]
        return left + (self._probe[0] + 0.5) * pitch, bottom + (self._probe[1] + 0.5) * pitch

    @property
    def magnified_mm(self) -> tuple[float, float, float, float]:
        """The part of the face around the probe: left, bottom, right, top."""
        x, y = self._probe_mm()
        half = 0.5 * self.width_mm
        return x - half, y - 0.75 * half, x + half, y + 0.75 * half

    @property
    def window_mm(self) -> tuple[float, float, float, float]:
        """The part of the face that is seen."""
        return self.magnified_mm if self.magnified else (0.0, 0.0, *face_mm(self._picture))

    # Time

    def _soon(self) -> None:
        """Make the tube anew; a quick row of changes makes one."""
        if self.sight.now and not self._due.isActive():
            self._due.start()

    def rebuild(self) -> None:
        """Make the tube for what is to be shown now."""
        self._due.stop()
        self._lay_out()
        if self._glass.width() < 16:
            return
        width = min(round(self._glass.width() * self.devicePixelRatioF()), _WIDEST_PX)
        size = width, max(round(width * self._glass.height() / self._glass.width()), 12)
        self.tube = ColourTube(self._image, self.window_mm, size, self._setup, self.tube)
        self._refresh()
        self._wake()

    def _come_in_sight(self, seen: bool) -> None:
        if seen:
            self.shown.emit()
            self._soon()
        self._wake()

    def _wake(self) -> None:
        if self.sight.now and self.tube is not None and not (self.averaged and self.tube.steady):
            if not self._timer.isActive():
                self._clock.start()
            self._timer.start(_FRAME_MS)
        else:
            self._timer.stop()

    def _tick(self) -> None:
        if self.tube is None:
            return
        elapsed = min(Fraction(self._clock.nsecsElapsed(), 10**9), Fraction(_LONGEST_STEP_S))
        self._clock.restart()
        self.tube.advance(elapsed / Fraction(self._slow) / PICOSECOND, self.averaged)
        self._refresh()
        # Half of the time is left to the rest of the window
        self._timer.setInterval(min(max(_FRAME_MS, 2 * self._clock.elapsed()), _LONGEST_WAIT_MS))
        if self.averaged and self.tube.steady:
            self._timer.stop()

    def _refresh(self) -> None:
        if self.tube is None:
            return
        packed = self.tube.picture()
        rows, columns = packed.shape
        self._shown = QImage(packed.tobytes(), columns, rows, 4 * columns, QImage.Format.Format_RGB32).copy()
        self.update()
        self.advanced.emit()

    # Places

    def _lay_out(self) -> None:
        if self.magnified:
            side = min(self.width() - 4.0, (self.height() - 4.0) / 0.75)
            self._glass = QRectF(0, 0, round(max(side, 16)), round(max(0.75 * side, 12)))
            self._glass.moveCenter(QPointF(self.width() / 2, self.height() / 2))
            self._case = self._glass
        else:
            face = face_mm(self._picture)
            self._case, self._glass = fitted(self.width(), self.height(), face[1] / face[0], 0)

    def _to_widget(self, x_mm: float, y_mm: float) -> QPointF:
        left, bottom, right, top = self.window_mm
        return QPointF(
            self._glass.left() + (x_mm - left) / (right - left) * self._glass.width(),
            self._glass.bottom() - (y_mm - bottom) / (top - bottom) * self._glass.height(),
        )

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay it out, and make the tube when it has come to rest."""
        super().resizeEvent(event)
        self._lay_out()
        self._layers = None
        self._soon()

    # The hand

    def _pick(self, place: QPointF) -> None:
        pixel = None if self.magnified else pixel_at(place, self._glass, self._picture)
        if pixel is not None:
            self.picked.emit(*pixel)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Work on the pixel under the pointer."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pick(event.position())
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with the drag."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._pick(event.position())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows go to the next pixel."""
        if is_plain(event) and event.key() in ARROWS:
            dx, dy = ARROWS[Qt.Key(event.key())]
            self.picked.emit(*nearest_pixel(self._probe[0] + dx, self._probe[1] + dy, self._picture))
        else:
            super().keyPressEvent(event)

    # Painting

    def paintEvent(self, event: QPaintEvent) -> None:
        """Cabinet and glass, or a bare part of the face; the light; the beams, probe and frame over it."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        outline = self._outline()
        if not self.magnified:
            size = self.width(), self.height(), self.devicePixelRatioF()
            if self._layers is None:
                self._layers = (
                    cabinet_pixmap(*size, self._case, self._glass),
                    reflection_pixmap(*size, self._glass),
                )
            painter.drawPixmap(0, 0, self._layers[0])
        else:
            painter.fillPath(outline, QColor("#080B0A"))
        painter.save()
        painter.setClipPath(outline)
        if self._shown is not None:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Plus)
            painter.drawImage(self._glass, self._shown)
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceOver)
        self._paint_over(painter)
        painter.restore()
        if not self.magnified and self._layers is not None:
            painter.drawPixmap(0, 0, self._layers[1])
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(self._case.adjusted(1, 1, -1, -1), RADIUS, RADIUS)

    def _outline(self) -> QPainterPath:
        if not self.magnified:
            return glass_path(self._glass)
        path = QPainterPath()
        path.addRoundedRect(self._glass, RADIUS, RADIUS)
        return path

    def _paint_over(self, painter: QPainter) -> None:
        if self.tube is not None and not self.averaged and self._slow > 1.0:
            x0, y0 = self.window_mm[:2]
            for state in self.tube.states():
                where = self._to_widget(state.x_mm + x0, state.y_mm + y0)
                paint_beam(painter, where, self._glass.width(), state)
        if self.magnified:
            self._paint_scale(painter)
            return
        left, bottom, right, top = self.magnified_mm
        frame = QRectF(self._to_widget(left, top), self._to_widget(right, bottom))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for pen in (QPen(_BEHIND, 3), QPen(_ON_GLASS, 1.2)):
            painter.setPen(pen)
            painter.drawRect(frame)
        paint_probe(painter, self._to_widget(*self._probe_mm()))

    def _paint_scale(self, painter: QPainter) -> None:
        """A bar as long as one pitch, or as some of them, and what that is in millimetres."""
        pitch, across = self._setup.pitch_mm, self._glass.width() / self.width_mm
        count = 1 if pitch * across > 24 else _PITCHES_SHOWN
        length = count * pitch * across
        if self._setup.mask == "none" or length > 0.8 * self._glass.width():
            return
        said = _("pitch {mm:g} mm") if count == 1 else _("{n} pitches of {mm:g} mm")
        font = QFont(painter.font())
        font.setPixelSize(scaled(CAPTION_PX))
        painter.setFont(font)
        text = said.format(n=count, mm=pitch)
        wide = max(length, painter.fontMetrics().horizontalAdvance(text)) + 16
        margin = min(8.0, max(self._glass.width() - wide, 0.0) / 2)
        card = QRectF(self._glass.left() + margin, self._glass.bottom() - 40, wide, 32)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_BEHIND)
        painter.drawRoundedRect(card, RADIUS, RADIUS)
        painter.setPen(QPen(_ON_GLASS, 2))
        left, height = card.left() + 8, card.bottom() - 8
        painter.drawLine(QPointF(left, height), QPointF(left + length, height))
        for end in (left, left + length):
            painter.drawLine(QPointF(end, height - 4), QPointF(end, height + 4))
        painter.drawText(QPointF(left, card.top() + 14), text)
