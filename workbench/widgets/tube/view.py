"""A frame buffer on a raster tube, or a display list on a vector tube, with a probe for one pixel."""

from collections.abc import Callable
from functools import partial
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QWidget

from workbench.display.beam import Beam
from workbench.display.many_strokes import strokes_ready
from workbench.display.raster_beam import RasterBeam
from workbench.display.setup import (
    COLOUR_TUBE,
    DeviceStrokes,
    TubeSetup,
    currents_of_image,
    drawing_tube,
    face_mm,
    mm_of,
    raster_tube,
    vector_beam,
)
from workbench.display.tube import Tube
from workbench.display.vector_beam import VectorBeam
from workbench.language import _
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.tube.glass import lit_near_the_middle, nearest_pixel, pixel_at
from workbench.widgets.tube.live_tube import LiveTube
from workbench.widgets.tube.marks import paint_beam, paint_probe

Kind = Literal["raster", "vector"]

_WIDEST_COLOUR_PX = 380  # three guns with eight terms each: the state is six times as large
_BEAM_SEEN_FROM = 300.0
_SHARPER_MS = 500
_LARGE_PX, _MANY_STROKES = 100_000, 500


class TubeView(LiveTube):
    """One tube that shows a picture; ``scans``: of the raster kind. ``probed`` comes with a clicked pixel."""

    probed = Signal(int, int)

    def __init__(self, kind: Kind, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind, self.scans = kind, kind == "raster"
        self._setup = TubeSetup()
        self._image: NDArray[np.uint32] = np.zeros((48, 64), dtype=np.uint32)
        self._strokes: DeviceStrokes = ()
        self._picture = (64, 48)
        self._fed = False
        self._probe: tuple[int, int] | None = None
        self._sharpening = QTimer(self, interval=_SHARPER_MS)
        self._sharpening.timeout.connect(self._sharpen)
        self.setAccessibleName(_("Raster tube") if kind == "raster" else _("Vector tube"))
        hint = _("Click a point of the glass to measure its light over time.")
        if kind == "vector":
            hint = _("The beam draws the strokes of the display list one after the other.")
        self.setToolTip(hint)

    # What is shown

    @property
    def face_mm(self) -> tuple[float, float]:
        """Width and height of the face."""
        return face_mm(self._picture)

    @property
    def asked_hz(self) -> float:
        """The refresh rate that is asked for."""
        return self._setup.refresh_hz

    @property
    def widest_px(self) -> int:
        """Fewer for a colour tube."""
        return _WIDEST_COLOUR_PX if self._setup.phosphor == COLOUR_TUBE else super().widest_px

    @property
    def lettering(self) -> tuple[str, str]:
        """The kind of tube, its phosphor and its refresh rate."""
        name = _("RASTER") if self.scans else _("VECTOR")
        return name, f"{self._setup.phosphor}   {self.refresh_hz:.4g} Hz"

    @property
    def _is_fed(self) -> bool:
        return self._fed

    @property
    def _is_large(self) -> bool:
        return self._image.size > _LARGE_PX if self.scans else len(self._strokes) > _MANY_STROKES

    def _maker(self, size_px: tuple[int, int]) -> Callable[[], tuple[Tube, Beam]]:
        """Of a tube for the picture, and the beam that draws it."""
        if self.scans:
            return partial(raster_tube, self._image, size_px, self._setup)
        return partial(drawing_tube, self._strokes, self._picture, size_px, self._setup)

    def _sharpen(self) -> None:
        """Draw anew what was blurred, once the compiled text is there."""
        beam = None if self.driver is None else self.driver.beam
        if not (isinstance(beam, VectorBeam) and beam.blurred):
            self._sharpening.stop()
        elif strokes_ready():
            self._rebuild()

    def set_image(self, image: NDArray[np.uint32]) -> None:
        """Show a frame buffer (h, w), 0xRRGGBB, row 0 at the bottom; the old picture fades."""
        same_size = image.shape == self._image.shape
        self._image = image
        self._take_size((image.shape[1], image.shape[0]))
        if not self.scans:
            return
        driver = self.standing
        if same_size and driver is not None and isinstance(driver.beam, RasterBeam):
            drive = currents_of_image(image, len(driver.tube.guns), self._setup)
            driver.show(driver.beam.with_drive(drive))
            self._wake()
        else:
            self._rebuild()

    def set_strokes(self, strokes: DeviceStrokes, picture_px: tuple[int, int]) -> None:
        """Show a display list in the device frame of a picture of so many pixels."""
        same_size = picture_px == self._picture
        self._strokes = strokes
        self._take_size(picture_px)
        if self.scans:
            return
        self._sharpening.start()
        driver = self.standing
        if same_size and driver is not None:
            driver.show(vector_beam(driver.tube, self._strokes, picture_px, self._setup))
            self._wake()
        else:
            self._rebuild()

    def _take_size(self, picture_px: tuple[int, int]) -> None:
        """A picture of so many pixels comes; the probe stays on it."""
        self._picture, self._fed = picture_px, True
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

    # Places of the picture

    def position(self, x: float, y: float) -> QPointF:
        """Where in the widget a place of the picture lies."""
        return self._to_widget(*mm_of(x, y, self._picture))

    def pixel_under(self, position: QPointF) -> tuple[int, int] | None:
        """The pixel of the picture at a position of the widget; None beside the picture."""
        return pixel_at(position, self._glass, self._picture)

    # The probe

    @property
    def probe(self) -> tuple[int, int] | None:
        """The picture's pixel whose light is measured, in device coordinates."""
        return self._probe

    def set_probe(self, pixel: tuple[int, int] | None) -> None:
        """Measure the light at a pixel of the picture."""
        self._probe = pixel
        self.update()

    def lit_pixel(self) -> tuple[int, int] | None:
        """The lit pixel of the frame buffer that is nearest to its middle; None for a dark picture."""
        return lit_near_the_middle(self._image)

    def probe_mm(self) -> tuple[float, float] | None:
        """Where on the face the probe sits, in millimetres."""
        return None if self._probe is None else mm_of(*self._probe, self._picture)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Put the probe where the glass is clicked."""
        pixel = pixel_at(event.position(), self._glass, self._picture)
        if event.button() == Qt.MouseButton.LeftButton and pixel is not None:
            self.set_probe(pixel)
            self.probed.emit(*pixel)
        super().mousePressEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the probe."""
        if is_plain(event) and event.key() in ARROWS:
            x, y = self._probe or (self._picture[0] // 2, self._picture[1] // 2)
            dx, dy = ARROWS[Qt.Key(event.key())]
            self._probe = nearest_pixel(x + dx, y + dy, self._picture)
            self.update()
            self.probed.emit(*self._probe)
        else:
            super().keyPressEvent(event)

    @property
    def beam_is_seen(self) -> bool:
        """Whether it runs so slowly that the beam is somewhere."""
        return self._slow >= _BEAM_SEEN_FROM and (self._paused or not self.averaged)

    def _paint_over(self, painter: QPainter) -> None:
        """The beam, where it is seen, and the probe."""
        if self.beam_is_seen and self.driver is not None:
            state = self.driver.state()
            paint_beam(painter, self._to_widget(state.x_mm, state.y_mm), self._glass.width(), state)
        if self._probe is not None:
            paint_probe(painter, self.position(*self._probe))
