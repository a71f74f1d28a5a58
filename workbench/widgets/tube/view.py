"""A cathode-ray tube as a widget: a frame buffer on a raster tube, or a display list on a vector tube.

The tube's time runs from a timer that stops when the widget is hidden, paused, or shows a picture that no
longer changes. With Calm on, refreshes that would be seen as flicker are averaged; slow motion below three
pictures a second shows the beam itself.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display.beam import Beam
from workbench.display.driver import VISIBLE, TubeDriver, must_average
from workbench.display.exposure import Screen
from workbench.display.raster_beam import RasterBeam
from workbench.display.setup import (
    COLOUR_TUBE,
    DeviceStroke,
    TubeSetup,
    area_mm,
    currents_of_image,
    face_mm,
    raster_tube,
    vector_beam,
    vector_tube,
)
from workbench.display.tube import PICOSECOND
from workbench.language import _
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.tube.glass import (
    CORNER,
    cabinet_pixmap,
    fitted,
    glass_path,
    nearest_pixel,
    pixel_at,
    reflection_pixmap,
)
from workbench.widgets.tube.marks import paint_beam, paint_plate, paint_probe

Kind = Literal["raster", "vector"]

_FRAME_MS, _IDLE_MS = 16, 250
_LONGEST_STEP_S = 0.1
_WIDEST_PX = 520
_WIDEST_COLOUR_PX = 380  # three guns with eight terms each: the state is six times as large
_PLATE_PX = 22
_BEAM_SEEN_FROM = 300.0


class TubeView(QWidget):
    """One tube. ``advanced`` comes with each step of its time, ``probed`` with a clicked pixel; ``sight``
    tells whether it is seen: one behind other tabs is not.
    """

    advanced = Signal()
    shown = Signal()
    probed = Signal(int, int)

    def __init__(self, kind: Kind, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self._setup = TubeSetup()
        self._slow = 1.0
        self._paused = False
        self._image: NDArray[np.uint32] = np.zeros((48, 64), dtype=np.uint32)
        self._strokes: tuple[DeviceStroke, ...] = ()
        self._picture = (64, 48)
        self._probe: tuple[int, int] | None = None
        self._seconds = Fraction(0)
        self.driver: TubeDriver | None = None
        self._screen: Screen | None = None
        self._shown: QImage | None = None
        self._cabinet: QPixmap | None = None
        self._reflection: QPixmap | None = None
        self._glass = QRectF()
        self._case = QRectF()
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._clock = QElapsedTimer()
        self._resized = QTimer(self)
        self._resized.setSingleShot(True)
        self._resized.setInterval(80)
        self._resized.timeout.connect(self._rebuild)
        self.sight = InSight(self)
        self.sight.changed.connect(self._come_in_sight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(120, 110)
        self.setAccessibleName(_("Raster tube") if kind == "raster" else _("Vector tube"))
        hint = _("Click a point of the glass to measure its light over time.")
        if kind == "vector":
            hint = _("The beam draws the strokes of the display list one after the other.")
        self.setToolTip(hint)
        theme.changed.connect(self.update)
        comfort.changed.connect(self._wake)

    def sizeHint(self) -> QSize:
        """Room for half a window."""
        return QSize(420, 360)

    def set_image(self, image: NDArray[np.uint32]) -> None:
        """Show a frame buffer (h, w), 0xRRGGBB, row 0 at the bottom; the old picture fades."""
        same_size = image.shape == self._image.shape
        self._image = image
        self._take_size((image.shape[1], image.shape[0]))
        if self.kind != "raster":
            return
        if same_size and self.driver is not None and isinstance(self.driver.beam, RasterBeam):
            drive = currents_of_image(image, len(self.driver.tube.guns), self._setup.gamma)
            self.driver.show(self.driver.beam.with_drive(drive))
            self._wake()
        else:
            self._rebuild()

    def set_strokes(self, strokes: Sequence[DeviceStroke], picture_px: tuple[int, int]) -> None:
        """Show a display list in the device frame of a picture of so many pixels."""
        same_size = picture_px == self._picture
        self._strokes = tuple(strokes)
        self._take_size(picture_px)
        if self.kind != "vector":
            return
        if same_size and self.driver is not None:
            self.driver.show(vector_beam(self.driver.tube, self._strokes, picture_px, self._setup))
            self._wake()
        else:
            self._rebuild()

    def _take_size(self, picture_px: tuple[int, int]) -> None:
        """A picture of so many pixels comes; the probe stays on it."""
        self._picture = picture_px
        self._probe = self._probe and nearest_pixel(*self._probe, picture_px)

    def set_setup(self, setup: TubeSetup) -> None:
        """Another phosphor, refresh rate, persistence or display. Raises LookupError for an unknown name."""
        setup.check()
        if setup != self._setup:
            self._setup = setup
            self._rebuild()

    @property
    def setup(self) -> TubeSetup:
        """What the tube is set to."""
        return self._setup

    def set_slow_motion(self, factor: float) -> None:
        """Run ``factor`` times slower than life, 1 to 1,000,000."""
        self._slow = min(max(factor, 1.0), 1e6)
        self._wake()

    def set_paused(self, paused: bool) -> None:
        """Hold the tube's time, or let it run."""
        self._paused = paused
        self._wake()

    @property
    def averaged(self) -> bool:
        """Whether whole pictures are averaged now, so that neither flicker nor beam is seen."""
        return must_average(self.refresh_hz, self._slow, comfort.calm)

    @property
    def refresh_hz(self) -> float:
        """Pictures per second; a long display list takes longer than the rate asked for."""
        return self._setup.refresh_hz if self.driver is None else 1.0 / float(self.driver.beam.frame_s)

    @property
    def running(self) -> bool:
        """Whether the timer runs."""
        return self._timer.isActive()

    def seconds(self) -> Fraction:
        """Tube time, exact."""
        return self._seconds if self.driver is None else self.driver.tube.seconds

    def set_seconds(self, seconds: Fraction) -> None:
        """Go to another tube time, as when a saved one is opened; the picture is that of long drawing."""
        self._seconds = seconds
        if self.driver is not None:
            self.driver = None
            self._rebuild()

    def step(self, seconds: Fraction) -> None:
        """Advance the tube's time by hand and show the beam where it then is, Calm or not."""
        if self.driver is not None and seconds > 0:
            self.driver.advance(seconds / PICOSECOND, False)
            self._refresh()

    def _wake(self) -> None:
        if self.sight.now and not self._paused and self.driver is not None:
            if not self._timer.isActive():
                self._clock.start()
            self._timer.start(_FRAME_MS)
        else:
            self._timer.stop()

    def _tick(self) -> None:
        if self.driver is None:
            return
        elapsed_ns = self._clock.nsecsElapsed()
        self._clock.restart()
        elapsed = min(Fraction(elapsed_ns, 10**9), Fraction(_LONGEST_STEP_S))
        averaged = self.averaged
        self.driver.advance(elapsed / Fraction(self._slow) / PICOSECOND, averaged)
        self._refresh()
        if averaged and self.driver.steady:
            self._timer.stop()
            return
        # A long tail changes so slowly that few pictures a second show it as well. Where a phosphor of many
        # terms takes long to add up, half of the time is left to the rest of the window.
        slower = VISIBLE / max(self.driver.change, VISIBLE / 100.0) if averaged else 1.0
        wait = max(_FRAME_MS * max(slower, 1.0), 2 * self._clock.elapsed())
        self._timer.setInterval(int(min(wait, _IDLE_MS)))

    def _refresh(self) -> None:
        if self.driver is None or self._screen is None:
            return
        packed = self._screen.picture(self.driver.lights)
        rows, columns = packed.shape
        self._shown = QImage(packed.tobytes(), columns, rows, 4 * columns, QImage.Format.Format_RGB32).copy()
        self.update(self._glass.toAlignedRect())
        self.advanced.emit()

    def _face_px(self) -> tuple[int, int]:
        ratio = self.devicePixelRatioF()
        widest = _WIDEST_COLOUR_PX if self._setup.phosphor == COLOUR_TUBE else _WIDEST_PX
        width = min(round(self._glass.width() * ratio), widest)
        face = face_mm(self._picture)
        return max(width, 16), max(round(width * face[1] / face[0]), 12)

    def _rebuild(self) -> None:
        """Make the tube anew for this size, picture and setup, showing what it would show after a while."""
        self._layout()
        if self._glass.width() < 8:
            return
        size = self._face_px()
        if self.driver is not None:
            self._seconds = self.driver.tube.seconds
        beam: Beam
        if self.kind == "raster":
            tube, beam = raster_tube(self._image, size, self._setup)
        else:
            tube = vector_tube(self._picture, size, self._setup)
            beam = vector_beam(tube, self._strokes, self._picture, self._setup)
        tube.skip(self._seconds / PICOSECOND)
        self.driver = TubeDriver(tube, beam)
        self.driver.settle()
        if not self.averaged:
            self.driver.advance(Fraction(10**6), False)
        self._screen = Screen(size, [rgb for gun in tube.guns for _name, rgb in gun.colours])
        self._cabinet = self._reflection = None
        self._refresh()
        self._wake()
        self.update()

    def _layout(self) -> None:
        face = face_mm(self._picture)
        plate = _PLATE_PX if self.height() > 190 else 0
        self._case, self._glass = fitted(self.width(), self.height(), face[1] / face[0], plate)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay the cabinet out at once, make the tube when the size has come to rest."""
        super().resizeEvent(event)
        self._layout()
        self._cabinet = self._reflection = None
        if self.driver is not None:
            self._resized.start()
        elif self.sight.now:
            self._rebuild()

    def _come_in_sight(self, seen: bool) -> None:
        """Run again, or rest: a tube that nobody sees costs nothing."""
        if seen:
            self.shown.emit()
            if self.driver is None:
                self._rebuild()
        self._wake()

    def _to_widget(self, x_mm: float, y_mm: float) -> QPointF:
        width, height = face_mm(self._picture)
        return QPointF(
            self._glass.left() + x_mm / width * self._glass.width(),
            self._glass.bottom() - y_mm / height * self._glass.height(),
        )

    @property
    def probe(self) -> tuple[int, int] | None:
        """The picture's pixel whose light is measured, in device coordinates."""
        return self._probe

    def set_probe(self, pixel: tuple[int, int] | None) -> None:
        """Measure the light at a pixel of the picture."""
        self._probe = pixel
        self.update()

    def _probe_mm(self, pixel: tuple[int, int]) -> tuple[float, float]:
        left, bottom, right, _top = area_mm(self._picture)
        pitch = (right - left) / self._picture[0]
        return left + (pixel[0] + 0.5) * pitch, bottom + (pixel[1] + 0.5) * pitch

    def lit_pixel(self) -> tuple[int, int] | None:
        """The lit pixel of the frame buffer that is nearest to its middle; None for a dark picture."""
        rows, columns = np.nonzero(self._image)
        if len(rows) == 0:
            return None
        height, width = self._image.shape
        nearest = int(np.argmin((columns - width / 2) ** 2 + (rows - height / 2) ** 2))
        return int(columns[nearest]), int(rows[nearest])

    def probe_mm(self) -> tuple[float, float] | None:
        """Where on the face the probe sits, in millimetres."""
        return None if self._probe is None else self._probe_mm(self._probe)

    def light_at_probe(self) -> float:
        """Luminance at the probed pixel in the last step, 1 for white; 0 without a probe."""
        if self._probe is None or self.driver is None:
            return 0.0
        x_mm, y_mm = self._probe_mm(self._probe)
        width, height = face_mm(self._picture)
        columns, rows = self.driver.tube.size_px
        column, row = int(x_mm / width * columns), int(y_mm / height * rows)
        return float(sum(light[row, column] for light in self.driver.lights))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Put the probe where the glass is clicked."""
        pixel = pixel_at(event.position(), self._glass, self._picture)
        if event.button() == Qt.MouseButton.LeftButton and pixel is not None:
            self.set_probe(pixel)
            self.probed.emit(*pixel)
        super().mousePressEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the probe."""
        if event.key() in ARROWS:
            x, y = self._probe or (self._picture[0] // 2, self._picture[1] // 2)
            dx, dy = ARROWS[Qt.Key(event.key())]
            self._probe = nearest_pixel(x + dx, y + dy, self._picture)
            self.update()
            self.probed.emit(*self._probe)
        else:
            super().keyPressEvent(event)

    @property
    def _beam_is_seen(self) -> bool:
        return self._slow >= _BEAM_SEEN_FROM and (self._paused or not self.averaged)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Cabinet, light, beam, glass."""
        painter = QPainter(self)
        if self._cabinet is None or self._reflection is None:
            size = self.width(), self.height(), self.devicePixelRatioF()
            self._cabinet = cabinet_pixmap(*size, self._case, self._glass)
            self._reflection = reflection_pixmap(*size, self._glass)
        painter.drawPixmap(0, 0, self._cabinet)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.save()
        painter.setClipPath(glass_path(self._glass))
        if self._shown is not None:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Plus)
            painter.drawImage(self._glass, self._shown)
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceOver)
            if self._beam_is_seen and self.driver is not None:
                state = self.driver.state()
                paint_beam(painter, self._to_widget(state.x_mm, state.y_mm), self._glass.width(), state)
            if self._probe is not None:
                paint_probe(painter, self._to_widget(*self._probe_mm(self._probe)))
        painter.restore()
        painter.drawPixmap(0, 0, self._reflection)
        if self._case.bottom() - self._glass.bottom() >= _PLATE_PX:
            name = _("RASTER") if self.kind == "raster" else _("VECTOR")
            rate = f"{self._setup.phosphor}   {self.refresh_hz:.4g} Hz"
            top = self._case.bottom() - _PLATE_PX - 3
            plate = QRectF(self._glass.left(), top, self._glass.width(), _PLATE_PX)
            paint_plate(painter, plate, name, rate)
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            radius = CORNER * self._case.width()
            painter.drawRoundedRect(self._case.adjusted(1, 1, -1, -1), radius, radius)
