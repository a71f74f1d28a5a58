"""A raster tube whose beam is seen at work: under any mode, held at any clock, with its path."""

from collections.abc import Callable
from fractions import Fraction
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.display.beam import Beam
from workbench.display.beam_path import Kind, beam_path
from workbench.display.raster_beam import RasterBeam
from workbench.display.setup import area_mm, currents_of_image, raster_tube
from workbench.display.timings import RasterTiming
from workbench.display.tube import Tube
from workbench.language import _
from workbench.widgets.look.tokens import DARK, colour
from workbench.widgets.tube.view import TubeView

# Over the glass, which is dark in both themes; a pattern stands beside each colour.
_PENS: dict[Kind, tuple[str, Qt.PenStyle]] = {
    "line": (DARK.data[0], Qt.PenStyle.SolidLine),
    "horizontal": (DARK.data[1], Qt.PenStyle.DashLine),
    "vertical": (DARK.data[4], Qt.PenStyle.DotLine),
}
_SECOND_FIELD = DARK.data[3]
_ALPHA = 170
_APART_PX = 6
"""Lines that are nearer to each other than this cannot be told apart."""


class RasterView(TubeView):
    """``show_scan`` takes the place of ``set_image``."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("raster", parent)
        self.timing: RasterTiming | None = None
        self._held: Fraction | None = None
        self._path_shown = False
        self._row: int | None = None
        self.setToolTip(_("Click the picture to go to the line that the beam scans there."))

    def show_scan(self, image: NDArray[np.uint32], timing: RasterTiming, picture_px: tuple[int, int]) -> None:
        """Scan ``image``, which has the size of ``timing``, onto the place of a picture of so many pixels."""
        same = (timing, picture_px) == (self.timing, self._picture) and image.shape == self._image.shape
        self._image, self.timing = image, timing
        self._take_size(picture_px)
        driver = self.standing
        if same and driver is not None and isinstance(driver.beam, RasterBeam):
            drive = currents_of_image(image, len(driver.tube.guns), self._setup)
            driver.show(driver.beam.with_drive(drive))
            self._hold()
        else:
            self._rebuild()

    def hold_at(self, phase: Fraction | None, row: int | None = None) -> None:
        """Stop at a time since the start of a frame, and mark the ``row`` of the scan; None: run on."""
        if (phase, row) != (self._held, self._row):
            self._held, self._row = phase, row
            self._hold()

    @property
    def held(self) -> bool:
        """Whether it stands at one instant."""
        return self._held is not None

    def show_path(self, on: bool) -> None:
        """Draw the way of the beam over the picture, or not."""
        self._path_shown = on
        self.update()

    def _hold(self) -> None:
        """Show the instant at which it is held."""
        if self._making is not None:
            self._rebuild()
        elif self._held is not None and self.driver is not None:
            self.driver.hold_at(self._held)
            self._refresh()
        self._wake()

    def _wake(self) -> None:
        if self._held is None:
            super()._wake()
        else:
            self._timer.stop()

    def _maker(self, size_px: tuple[int, int]) -> Callable[[], tuple[Tube, Beam]]:
        return partial(
            raster_tube, self._image, size_px, self._setup, timing=self.timing, picture_px=self._picture
        )

    @property
    def _held_at(self) -> Fraction | None:
        return self._held

    @property
    def beam_is_seen(self) -> bool:
        """Whether the beam is somewhere: it is held, or runs slowly enough."""
        return self.held or super().beam_is_seen

    def _place(self, column: float, row: float) -> QPointF:
        """Where a place of the picture is, in pixels of the scan from its upper left corner."""
        left, bottom, right, top = area_mm(self._picture)
        rows, columns = self._image.shape
        return self._to_widget(left + (right - left) * column / columns, top - (top - bottom) * row / rows)

    def _paint_over(self, painter: QPainter) -> None:
        """The path of the beam, and the line that is stepped."""
        super()._paint_over(painter)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self._path_shown and self.timing is not None:
            self._paint_path(painter, self.timing)
        if self._row is not None:
            rows, columns = self._image.shape
            top = rows - 1 - self._row
            painter.setPen(QPen(colour(DARK.accent, _ALPHA), 1))
            painter.drawRect(QRectF(self._place(0, top), self._place(columns, top + 1)))

    def _paint_path(self, painter: QPainter, timing: RasterTiming) -> None:
        lines: dict[tuple[str, Qt.PenStyle], list[QLineF]] = {}
        most = int(self._glass.height()) // (_APART_PX * timing.fields)
        for stretch in beam_path(timing, max(most, 2)):
            ink, style = _PENS[stretch.kind]
            if stretch.kind == "line" and stretch.field:
                ink, style = _SECOND_FIELD, Qt.PenStyle.DashDotLine
            way = QLineF(self._place(*stretch.begin), self._place(*stretch.end))
            lines.setdefault((ink, style), []).append(way)
        for (ink, style), ways in lines.items():
            painter.setPen(QPen(colour(ink, _ALPHA), 1, style))
            painter.drawLines(ways)
