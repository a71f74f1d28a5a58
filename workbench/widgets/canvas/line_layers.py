"""Thousands of lines painted once, as layers that stay while the view does: only changes are painted anew.

Where there are too many for one frame, a layer grows from frame to frame, and meanwhile the one before it is
shown, moved to where it belongs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter, QPen

from workbench.widgets.canvas.lines import paint_lines
from workbench.widgets.canvas.view import Area, CanvasView

if TYPE_CHECKING:
    from workbench.widgets.canvas.painter import Scene

Line = NDArray[np.float64]
Lines = dict[int, Line]
"""By identity; they are held so that it stays theirs."""

MANY = 1000
CORNERS_A_FRAME = 30_000
_MOST_BESIDE = 500
_MOST_PENS = 3  # each has layers as large as the canvas


@dataclass(eq=False)
class _Layer:
    """Some lines in one view, on transparent ground."""

    view: CanvasView
    area: Area
    lines: Lines = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._image = QImage(self.area.right, self.area.bottom, QImage.Format.Format_ARGB32_Premultiplied)
        self._image.fill(0)

    def add(self, lines: Lines, scene: Scene, pen: QPen) -> None:
        """Paint some more, of this view."""
        painter = QPainter(self._image)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        paint_lines(painter, scene, list(lines.values()), pen)
        painter.end()
        self.lines = self.lines | lines

    def put(self, painter: QPainter, view: CanvasView) -> None:
        """Show it in its own view, or, larger or smaller, in another one."""
        if view == self.view:
            painter.drawImage(0, 0, self._image)
            return
        scale = view.cell / self.view.cell
        left, top = view.left - scale * self.view.left, view.bottom - scale * self.view.bottom
        box = QRectF(left, top, scale * self._image.width(), scale * self._image.height())
        painter.drawImage(box, self._image)


class _Layers:
    """What is kept of one pen: the layer that is whole, and the next one while it grows."""

    def __init__(self) -> None:
        self._whole: _Layer | None = None
        self.growing: _Layer | None = None

    def paint(self, painter: QPainter, scene: Scene, lines: Lines, pen: QPen, room: int) -> int:
        """Show lines; of one colour, so that what is new may lie over what stays.

        ``room`` is how many corners a layer may grow by now; what is left of it is given back.
        """
        before = self._whole if self._whole and self._whole.area == scene.area else None
        stay: Lines = {}
        if before is not None and before.view == scene.view:
            stay = {number: line for number, line in lines.items() if number in before.lines}
        few_new = len(lines) - len(stay) <= _MOST_BESIDE
        if before is not None and few_new and len(stay) == len(before.lines):
            self.growing = None
        else:
            room = self._grow(scene, stay if few_new else lines, pen, room)
            before = before if self.growing else self._whole
        shown = before or self.growing
        if shown is not None:
            shown.put(painter, scene.view)
        if few_new:
            beside = [line for number, line in lines.items() if number not in stay]
            paint_lines(painter, scene, beside, pen)
        return room

    def _grow(self, scene: Scene, lines: Lines, pen: QPen, room: int) -> int:
        """Paint as much of the next layer as there is room for; once it is whole, it takes its place."""
        layer = self.growing
        if (
            layer is None
            or (layer.view, layer.area) != (scene.view, scene.area)
            or layer.lines.keys() - lines.keys()
        ):
            layer = _Layer(scene.view, scene.area)
        some: Lines = {}
        for number, line in lines.items():
            if number not in layer.lines and room > 0:
                some[number] = line
                room -= len(line)
        layer.add(some, scene, pen)
        if len(layer.lines) < len(lines):
            self.growing = layer
        else:
            self._whole, self.growing = layer, None
        return room


class LineLayers:
    """The layers of one canvas, of the pens that its last frame was made with."""

    def __init__(self) -> None:
        self._before: dict[tuple[object, ...], _Layers] = {}
        self._now: dict[tuple[object, ...], _Layers] = {}
        self._room = CORNERS_A_FRAME

    def paint(self, painter: QPainter, scene: Scene, lines: Sequence[Line], pen: QPen) -> None:
        """As ``paint_lines``, but nothing that was painted before in this view and with this pen."""
        key = pen.color().rgba(), pen.widthF(), pen.style()
        if key in self._now or len(self._now) == _MOST_PENS:
            paint_lines(painter, scene, lines, pen)
            return
        layers = self._now[key] = self._before.get(key) or _Layers()
        lines_by_id = {id(line): line for line in lines}
        self._room = layers.paint(painter, scene, lines_by_id, pen, self._room)

    def end_frame(self) -> bool:
        """Let go of what this frame had no use for; whether another frame is needed, since a layer grows."""
        self._before, self._now, self._room = self._now, {}, CORNERS_A_FRAME
        return any(layers.growing for layers in self._before.values())


def paint_many(painter: QPainter, scene: Scene, lines: Sequence[Line], pen: QPen) -> None:
    """As ``paint_lines``; of thousands of lines the canvas keeps layers."""
    if scene.layers is None or scene.vector or len(lines) < MANY:
        paint_lines(painter, scene, lines, pen)
    else:
        scene.layers.paint(painter, scene, lines, pen)
