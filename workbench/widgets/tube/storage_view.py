"""A direct-view storage tube as a widget: written once, seen until it is erased as a whole."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QElapsedTimer, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QMouseEvent, QPainter, QPaintEvent, QPen, QPixmap, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display.exposure import Screen
from workbench.display.phosphor import Phosphor
from workbench.display.setup import DeviceStroke, face_mm, mm_of
from workbench.display.storage_tube import STORAGE_PHOSPHOR, StorageTube
from workbench.language import _
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.tube.glass import CORNER, cabinet_pixmap, fitted, glass_path, reflection_pixmap
from workbench.widgets.tube.marks import paint_plate
from workbench.widgets.tube.stroke_picking import nearest_stroke

_FRAME_MS, _PLATE_PX, _WIDEST_PX = 33, 22, 520

Ends = NDArray[np.float64]
MmStrokes = list[tuple[tuple[float, float], tuple[float, float], float]]


class StorageView(QWidget):
    """``stroke_clicked`` sends the number of the stroke nearest to a click; ``changed`` comes when what is on
    the face is other than before, or is no longer.
    """

    stroke_clicked = Signal(int)
    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._picture = (64, 48)
        self._strokes: tuple[DeviceStroke, ...] = ()
        self._written: tuple[DeviceStroke, ...] | None = None
        self._ends: Ends = np.empty((0, 2, 2))
        self._through = False
        self._flashes = False
        self.tube: StorageTube | None = None
        self._screen: Screen | None = None
        self._shown: QImage | None = None
        self._cabinet: QPixmap | None = None
        self._reflection: QPixmap | None = None
        self._glass = self._case = QRectF()
        self._clock = QElapsedTimer()
        self._timer = QTimer(self)
        self._timer.setInterval(_FRAME_MS)
        self._timer.timeout.connect(self._tick)
        self.sight = InSight(self)
        self.sight.changed.connect(lambda _seen: self._wake())
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(100, 60)
        self.setAccessibleName(_("Storage tube"))
        self.setToolTip(_("What is written stays on the face, without any refresh, until all is erased."))

    def sizeHint(self) -> QSize:
        """Room for half a window."""
        return QSize(420, 360)

    def set_ends(self, ends: Ends) -> None:
        """The strokes (n, 2, 2) that can be clicked, device coordinates."""
        self._ends = ends

    def take_list(self, strokes: NDArray[np.float64], picture_px: tuple[int, int]) -> None:
        """The strokes (n, 5) that are written when it is asked for; what is on the face stays. The first are
        written at once.
        """
        if picture_px != self._picture or self.tube is None:
            self._picture = picture_px
            self._build()
        self._strokes = tuple((x0, y0, x1, y1, int(packed)) for x0, y0, x1, y1, packed in strokes.tolist())
        if self._written is None and self.tube is not None:
            self.write()

    @property
    def differs(self) -> bool:
        """Whether the face shows strokes that the list has no longer."""
        return bool(set(self._written or ()) - set(self._strokes))

    @property
    def lacks(self) -> bool:
        """Whether the list has strokes that are not written yet."""
        return bool(set(self._strokes) - set(self._written or ()))

    @property
    def erasing(self) -> bool:
        """Whether it is being erased."""
        return self.tube is not None and self.tube.erasing

    def write(self) -> int:
        """Draw the whole list once; how many more pixels are stored."""
        if self.tube is None or self.tube.erasing:
            return 0
        stored = self.tube.write(self._in_mm(self._strokes))
        self._written = (*dict.fromkeys((*(self._written or ()), *self._strokes)),)
        self._refresh()
        self._wake()
        self.changed.emit()
        return stored

    def erase(self, flashes: bool) -> None:
        """Erase all of it, with the flash of a real tube or without."""
        if self.tube is None:
            return
        self._flashes = flashes
        self._written = ()
        self.tube.erase()
        self._wake()
        self.changed.emit()

    def set_write_through(self, on: bool) -> None:
        """Show the list by a beam too weak to store it, as long as this is on."""
        self._through = on
        self._wake()

    # The tube

    def _in_mm(self, strokes: Sequence[DeviceStroke]) -> MmStrokes:
        """Places on the face; the beam is on or off, since what is stored has one brightness."""
        size = self._picture
        return [
            (mm_of(x0, y0, size), mm_of(x1, y1, size), 1.0 if packed else 0.0)
            for x0, y0, x1, y1, packed in strokes
        ]

    def _layout(self) -> None:
        face = face_mm(self._picture)
        plate = _PLATE_PX if self.height() > 190 else 0
        self._case, self._glass = fitted(self.width(), self.height(), face[1] / face[0], plate)
        self._cabinet = self._reflection = None

    def _build(self) -> None:
        """The tube for this size; what was written is written again, since the face is another."""
        self._layout()
        if self._glass.width() < 16:
            return
        width = min(round(self._glass.width() * self.devicePixelRatioF()), _WIDEST_PX)
        face = face_mm(self._picture)
        size = max(width, 16), max(round(width * face[1] / face[0]), 12)
        before = self.tube
        self.tube = StorageTube(size, face, spot_mm=max(0.5, 0.7 * face[0] / size[0]))
        self._screen = Screen(size, [rgb for _name, rgb in Phosphor.named(STORAGE_PHOSPHOR).colours])
        if self._written:
            self.tube.write(self._in_mm(self._written))
            self.tube.advance(1.0)
        if before is not None:
            self.tube.continue_from(before)
        self._refresh()

    def _wake(self) -> None:
        if self.tube is not None and self.sight.now and (self._through or not self.tube.still):
            if not self._timer.isActive():
                self._clock.start()
                self._timer.start()
        else:
            self._timer.stop()

    def _tick(self) -> None:
        if self.tube is None:
            return
        seconds = min(self._clock.restart() / 1000.0, 0.1)
        erased = self.tube.erasing
        self.tube.advance(seconds)
        if self._through:
            self.tube.write_through(self._in_mm(self._strokes))
        self._refresh()
        if erased and not self.tube.erasing:
            self.changed.emit()
        self._wake()

    def _refresh(self) -> None:
        if self.tube is None or self._screen is None:
            return
        packed = self._screen.picture([self.tube.light(self._flashes).astype(np.float32)])
        rows, columns = packed.shape
        self._shown = QImage(packed.tobytes(), columns, rows, 4 * columns, QImage.Format.Format_RGB32).copy()
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another face."""
        super().resizeEvent(event)
        self._build()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A click on a stroke chooses it."""
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        face, (x_mm, y_mm) = face_mm(self._picture), mm_of(0.0, 0.0, self._picture)
        per_mm = self._glass.width() / face[0]
        scale = (mm_of(1.0, 0.0, self._picture)[0] - x_mm) * per_mm
        origin = self._glass.left() + x_mm * per_mm, self._glass.bottom() - y_mm * per_mm
        positions = self._ends * (scale, -scale) + origin
        stroke = nearest_stroke(positions, event.position())
        if stroke is not None:
            self.stroke_clicked.emit(stroke)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Cabinet, light, glass."""
        painter = QPainter(self)
        if self._cabinet is None or self._reflection is None:
            size = self.width(), self.height(), self.devicePixelRatioF()
            self._cabinet = cabinet_pixmap(*size, self._case, self._glass)
            self._reflection = reflection_pixmap(*size, self._glass)
        painter.drawPixmap(0, 0, self._cabinet)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._shown is not None:
            painter.save()
            painter.setClipPath(glass_path(self._glass))
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Plus)
            painter.drawImage(self._glass, self._shown)
            painter.restore()
        painter.drawPixmap(0, 0, self._reflection)
        if self._case.bottom() - self._glass.bottom() >= _PLATE_PX:
            top = self._case.bottom() - _PLATE_PX - 3
            plate = QRectF(self._glass.left(), top, self._glass.width(), _PLATE_PX)
            paint_plate(
                painter, plate, _("STORAGE"), _("{phosphor}   no refresh").format(phosphor=STORAGE_PHOSPHOR)
            )
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            radius = CORNER * self._case.width()
            painter.drawRoundedRect(self._case.adjusted(1, 1, -1, -1), radius, radius)
        painter.end()
