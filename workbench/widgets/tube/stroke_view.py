"""A vector tube on which the run of its display list is seen: what is drawn, what is to come, the beam."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from workbench.algorithms.scanning.operations import DRAW
from workbench.rendering.display_program import DisplayProgram
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import scaled
from workbench.widgets.tube.glass import glass_path
from workbench.widgets.tube.stroke_picking import nearest_stroke
from workbench.widgets.tube.view import TubeView

# Over the glass, which is dark in both themes.
_COMING = QColor(160, 170, 180, 90)
_JUMP = QColor("#E3B341")
_CHOSEN = QColor("#5AA9FF")
_BEAM = QColor("#F5F7FA")
_MOST_COMING = 4000
_BESIDE_PX = 8.0

Floats = NDArray[np.float64]
Point = tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """Where a run stands. Ends (n, 2, 2) of the strokes to come, the jump or stroke of this instruction from
    one place to another, whether it is lit, and its address; device coordinates in pixels.
    """

    coming: Floats
    begin: Point
    end: Point
    lit: bool
    address: int

    @staticmethod
    def at(program: DisplayProgram, address: int) -> "Trace":
        """Where the run of a display list stands once this instruction was run."""
        (_before, x0, y0, _dim), (operation, x1, y1, _bright) = program.rows[[address - 1, address]].tolist()
        coming = program.strokes.ends[program.drawn_by(address) :]
        return Trace(coming, (x0, y0), (x1, y1), int(operation) == DRAW, address)


class StrokeView(TubeView):
    """``stroke_clicked`` sends the number of the stroke nearest to a click, of those set by ``set_ends``."""

    stroke_clicked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("vector", parent)
        self._trace: Trace | None = None
        self._ends: Floats = np.empty((0, 2, 2))

    def set_trace(self, trace: Trace | None) -> None:
        """Show where a run stands; None: nothing is stepped."""
        if trace is not self._trace:
            self._trace = trace
            self.update()

    def set_ends(self, ends: Floats) -> None:
        """The strokes (n, 2, 2) that can be clicked, device coordinates."""
        self._ends = ends

    def _positions(self, places: Floats) -> Floats:
        """As ``position`` for places (..., 2)."""
        origin, unit = self.position(0.0, 0.0), self.position(1.0, 1.0)
        scale = np.array([unit.x() - origin.x(), unit.y() - origin.y()])
        found: Floats = places * scale + (origin.x(), origin.y())
        return found

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A click on a stroke chooses it; elsewhere nothing is measured."""
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        stroke = nearest_stroke(self._positions(self._ends), event.position())
        if event.button() == Qt.MouseButton.LeftButton and stroke is not None:
            self.stroke_clicked.emit(stroke)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The tube, and over it the run."""
        super().paintEvent(event)
        if self._trace is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setClipPath(glass_path(self._glass))
        self._paint_trace(painter, self._trace)
        painter.end()

    def _paint_trace(self, painter: QPainter, trace: Trace) -> None:
        painter.setPen(QPen(_COMING, 1.0, Qt.PenStyle.DotLine))
        painter.drawLines(_lines(self._positions(trace.coming[:_MOST_COMING])))
        begin, end = self.position(*trace.begin), self.position(*trace.end)
        style = Qt.PenStyle.SolidLine if trace.lit else Qt.PenStyle.DashLine
        painter.setPen(QPen(_CHOSEN if trace.lit else _JUMP, 2.0, style))
        painter.drawLine(begin, end)
        painter.setPen(QPen(_BEAM, 1.6))
        painter.setBrush(_BEAM if trace.lit else Qt.BrushStyle.NoBrush)
        painter.drawEllipse(end, 4.5, 4.5)
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        painter.setFont(font)
        said = f"PC {trace.address}"
        size = painter.fontMetrics().boundingRect(said).size()
        painter.drawText(beside(end, size, self._glass), said)


def beside(end: QPointF, size: QSize, glass: QRectF) -> QPointF:
    """Where a word of this ``size`` begins, on its base line: to the right of a point and above it, or on the
    other side where it would come too near to the edge of the glass.
    """
    to_left = end.x() + size.width() + 2 * _BESIDE_PX > glass.right()
    below = end.y() - size.height() - 2 * _BESIDE_PX < glass.top()
    return end + QPointF(
        -_BESIDE_PX - size.width() if to_left else _BESIDE_PX, _BESIDE_PX + size.height() if below else -6.0
    )


def _lines(ends: Floats) -> Sequence[QLineF]:
    return [QLineF(*points) for points in ends.reshape(-1, 4).tolist()]
