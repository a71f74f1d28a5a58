"""The face of a tube steered by its voltages: what its inputs draw, and a spot that can be dragged."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.algorithms.scanning.electron_optics import FACE_MM
from workbench.display.beam import Beam
from workbench.display.gun import Gun, Place
from workbench.display.steered_beam import SteeredBeam, steered_tube
from workbench.display.tube import Tube
from workbench.language import _
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.tube.live_tube import LiveTube

_WIDEST_PX = 340
_SQUARE_MM = 10.0
_STEP_MM, _FAR_MM = 1.0, 10.0
_LINE = QColor(220, 235, 228, 30)
_AXIS = QColor(220, 235, 228, 62)
_RING = QColor(245, 247, 250, 190)


class SteeredTube(LiveTube):
    """``moved``: the spot was dragged to a place (mm from the middle of the face), or moved by a key;
    ``held`` tells whether it is being dragged.
    """

    moved = Signal(float, float)
    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._gun = Gun()
        self._spot: Place | None = None
        self._dragging = False
        self.setAccessibleName(_("Screen of the tube"))
        self.setToolTip(_("Drag on the screen, or use the arrow keys, to put the spot there."))

    @property
    def face_mm(self) -> tuple[float, float]:
        """Width and height of the face."""
        return FACE_MM

    @property
    def asked_hz(self) -> float:
        """How often the inputs begin anew."""
        return float(1 / self._gun.period)

    @property
    def widest_px(self) -> int:
        """Few enough for a figure to follow the hand."""
        return _WIDEST_PX

    @property
    def lettering(self) -> tuple[str, str]:
        """How large the squares are, and how long the phosphor glows."""
        phosphor = self._gun.phosphors[0]
        time = phosphor.t10_s
        glow = f"{1e3 * time:.3g} ms" if time < 1.0 else f"{time:.3g} s"
        glow = f"{1e6 * time:.3g} µs" if time < 1e-3 else glow
        told = _("{name}, 10 % in {time}").format(name=self._gun.phosphor, time=glow)
        return _("10 mm a square"), told + (_(" (uncertain)") if phosphor.uncertain else "")

    def _maker(self, size_px: tuple[int, int]) -> Callable[[], tuple[Tube, Beam]]:
        """Of the tube of the gun, and its beam."""
        return partial(steered_tube, self._gun, size_px)

    def show_gun(self, gun: Gun, spot: Place | None) -> None:
        """Draw what the inputs of ``gun`` make; ``spot`` is where its beam is, None where it is caught."""
        same_face = gun.phosphor == self._gun.phosphor
        steered, self._gun, self._spot = self._steering(gun) != self._steering(self._gun), gun, spot
        if not steered:
            self.update()
        elif same_face and self.driver is not None:
            self.driver.show(SteeredBeam(self.driver.tube, gun))
            if not gun.swings:
                self.driver.settle()
            self._refresh()
            if not (self.averaged and self.driver.steady):
                self._wake()
        else:
            self._rebuild()

    @staticmethod
    def _steering(gun: Gun) -> tuple[object, ...]:
        """What of a gun makes another picture."""
        return tuple(getattr(gun, name) for name in gun.__slots__ if name not in ("moment",))

    def _paint_over(self, painter: QPainter) -> None:
        """The squares of the face, and a ring where the beam is now."""
        self._paint_squares(painter)
        if self._spot is None:
            return
        _z, x, y, _r = self._spot
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(_RING, 1.4))
        painter.drawEllipse(self._at(x, y), 7.0, 7.0)

    def _paint_squares(self, painter: QPainter) -> None:
        half_x, half_y = FACE_MM[0] / 2.0, FACE_MM[1] / 2.0
        for along in range(-int(half_x // _SQUARE_MM), int(half_x // _SQUARE_MM) + 1):
            painter.setPen(QPen(_LINE if along else _AXIS, 1))
            x = along * _SQUARE_MM
            painter.drawLine(self._at(x, -half_y), self._at(x, half_y))
            if abs(x) <= half_y:
                painter.drawLine(self._at(-half_x, x), self._at(half_x, x))

    def _at(self, x: float, y: float) -> QPointF:
        return self._to_widget(x + FACE_MM[0] / 2.0, y + FACE_MM[1] / 2.0)

    def _place(self, at: QPointF) -> tuple[float, float]:
        """A place of the widget in mm from the middle of the face, kept on it."""
        x = ((at.x() - self._glass.left()) / self._glass.width() - 0.5) * FACE_MM[0]
        y = (0.5 - (at.y() - self._glass.top()) / self._glass.height()) * FACE_MM[1]
        return _kept(x, FACE_MM[0] / 2.0), _kept(y, FACE_MM[1] / 2.0)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Put the spot where the glass is pressed."""
        if event.button() == Qt.MouseButton.LeftButton and self._glass.contains(event.position()):
            self._dragging = True
            self.held.emit(True)
            self.moved.emit(*self._place(event.position()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the spot."""
        if self._dragging:
            self.moved.emit(*self._place(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go of it."""
        if self._dragging:
            self._dragging = False
            self.held.emit(False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the spot, with Shift farther."""
        if event.key() not in ARROWS or self._spot is None or not is_plain(event):
            super().keyPressEvent(event)
            return
        dx, dy = ARROWS[Qt.Key(event.key())]
        far = _FAR_MM if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else _STEP_MM
        _z, x, y, _r = self._spot
        self.moved.emit(_kept(x + dx * far, FACE_MM[0] / 2.0), _kept(y + dy * far, FACE_MM[1] / 2.0))


def _kept(value: float, most: float) -> float:
    return min(max(value, -most), most)
