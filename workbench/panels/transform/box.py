"""The box around the figure that is worked on: what a drag does becomes a link of its chain."""

import math

import numpy as np
from PySide6.QtCore import QObject, QPointF, QRectF, Signal

from workbench.algorithms.transforms import Matrix
from workbench.document.building import Edit
from workbench.document.edits import set_attributes
from workbench.document.model import AnyFigure
from workbench.document.transforms.chains import inverse_of, is_singular, matrix_of
from workbench.document.transforms.edits import extend
from workbench.document.transforms.links import AboutPivot, AnyLink, Rotate, Scale, Shear, Translate
from workbench.document.transforms.names import title
from workbench.geometry.transform_box import MOVE, Box, Motion
from workbench.language import _
from workbench.panels.stage.gesture import Gesture
from workbench.panels.transform.scene import curves_of, on_device, placed
from workbench.rendering.mapping import device_map
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.transform_box import TransformBox
from workbench.widgets.canvas.transform_words import described, pivot_at

_DECIMALS = 2
_OF_DEGREES = 1


class _PointsFirst(TransformBox):
    """A box that leaves the points of the figure, as it was drawn, to the canvas."""

    def handle_at(self, position: QPointF) -> str:
        """As everywhere, but a point inside the box is the canvas's."""
        handle = super().handle_at(position)
        if handle == MOVE:
            grip = self._canvas.handle_at(position)
            if grip is not None and "/" in grip.id and not grip.id.startswith("box/"):
                return ""
        return handle


class ChainBox(QObject):
    """Keeps the box in step with the figure, and writes what is dragged. ``failed`` sends a sentence.

    A drag is rounded: moves and factors to hundredths, turns to tenths of a degree.
    """

    failed = Signal(str)
    looks_changed = Signal()
    held = Signal(bool)

    def __init__(self, session: Session, canvas: PixelCanvas) -> None:
        super().__init__(canvas)
        self._session, self._canvas = session, canvas
        self._figure: AnyFigure | None = None
        self._pivots: dict[str, tuple[float, float]] = {}  # before the chain, which carries them
        self._gesture = Gesture(session)
        self._gesture.failed.connect(self.failed)
        self._moving_pivot = self._following = False
        self.box = _PointsFirst(canvas)
        self.box.words, self.box.pivot_words = self._words, self._pivot_words
        self.box.began.connect(self._begin)
        self.box.changed.connect(self._change)
        self.box.ended.connect(self._end)
        self.box.cancelled.connect(self._cancel)
        self.box.pivot_moved.connect(self._move_pivot)
        self.box.looks_changed.connect(self._look)

    @property
    def busy(self) -> bool:
        """Whether something is being dragged."""
        return self.box.dragging

    @property
    def pivot(self) -> tuple[float, float]:
        """Where the next turn is about, world."""
        figure = self._figure
        if figure is None:
            return 0.0, 0.0
        if isinstance(_last_of(figure), AboutPivot) or figure.id not in self._pivots:
            return _carried(figure)
        return _through(figure.matrix, self._pivots[figure.id])

    def follow(self, figure: AnyFigure | None) -> None:
        """Lay the box round a figure as it is seen; none where there is none or its chain is singular."""
        self._figure = figure
        if self.box.dragging and figure is not None:
            return
        box = None if figure is None or is_singular(figure.matrix) else self._around(figure)
        scale = device_map(self._session.sheet)
        self._following = True  # whoever asked for it paints it
        self.box.set_box(box, scale.point(*self.pivot) if box is not None else None)
        self._following = False

    def _around(self, figure: AnyFigure) -> Box | None:
        sheet = self._session.sheet
        curves = placed(curves_of(sheet, figure), on_device(device_map(sheet), figure.matrix))
        if not curves:
            return None
        points = np.concatenate(curves)
        low, high = points.min(axis=0), points.max(axis=0)
        if not (np.isfinite(low).all() and np.isfinite(high).all()):
            return None
        (x0, y0), (x1, y1) = low.tolist(), high.tolist()
        return Box((x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0)

    def rectangle(self, figure: AnyFigure) -> QRectF:
        """Where a figure is on the canvas now, logical pixels; empty where it cannot be told."""
        box = self._around(figure)
        if box is None:
            return QRectF()
        corners = box.corners()
        return QRectF(self._canvas.widget_position(*corners[3]), self._canvas.widget_position(*corners[1]))

    def over(self, overlay: Overlay) -> Overlay:
        """The marks with the box on top."""
        return self.box.over(overlay)

    def _begin(self, _handle: str) -> None:
        self._gesture.begin()
        self.held.emit(True)

    def _change(self, _matrix: object, kind: str, numbers: dict[str, float]) -> None:
        if self._figure is not None:
            link = self._link(kind, numbers)
            self._gesture.show(extend([self._figure.id], link), title(link))

    def _link(self, kind: str, numbers: dict[str, float]) -> AnyLink:
        """What a motion of the device is in the world."""
        scale = device_map(self._session.sheet)
        if kind == "move":
            dx, dy = scale.world_way(numbers["dx"], numbers["dy"])
            return Translate("", tx=round(dx, _DECIMALS), ty=round(dy, _DECIMALS))
        if kind == "rotate":
            turned = numbers["angle"] * math.copysign(1.0, scale.sx * scale.sy)
            x, y = self.pivot
            return Rotate("", angle=round(math.degrees(turned), _OF_DEGREES), x_pivot=x, y_pivot=y)
        x, y = scale.world_point(numbers["x"], numbers["y"])
        if kind == "scale":
            sx, sy = (_factor(numbers[name]) for name in ("sx", "sy"))
            return Scale("", sx=sx, sy=sy, x_pivot=x, y_pivot=y)
        ratio = abs(scale.sy / scale.sx) * math.copysign(1.0, scale.sx * scale.sy)
        if numbers["across"]:
            return Shear("", sh_x=round(numbers["factor"] * ratio, _DECIMALS), x_ref=x, y_ref=y)
        return Shear("", sh_y=round(numbers["factor"] / ratio, _DECIMALS), x_ref=x, y_ref=y)

    def _words(self, motion: Motion) -> str:
        """What a drag does, with the numbers of the link that it becomes."""
        link = self._link(motion.kind, motion.numbers)
        numbers: dict[str, float] = {}
        match link:
            case Translate():
                numbers = {"dx": link.tx, "dy": link.ty}
            case Rotate():
                numbers = {"angle": math.radians(link.angle), "x": link.x_pivot, "y": link.y_pivot}
            case Scale():
                numbers = {"sx": link.sx, "sy": link.sy, "x": link.x_pivot, "y": link.y_pivot}
            case Shear():
                factor = link.sh_x or link.sh_y
                numbers = {"factor": factor, "angle": math.atan(factor), "x": link.x_ref, "y": link.y_ref}
        return described(motion._replace(numbers=numbers))

    def _pivot_words(self, x: float, y: float) -> str:
        return pivot_at(*device_map(self._session.sheet).world_point(x, y))

    def _end(self) -> None:
        self._gesture.commit()
        self.held.emit(False)

    def _cancel(self) -> None:
        self._gesture.cancel()
        self.held.emit(False)

    def _move_pivot(self, x: float, y: float) -> None:
        """The cross moves the pivot of the last link where that has one, else that of the next turn."""
        figure = self._figure
        if figure is None:
            return
        place = device_map(self._session.sheet).world_point(x, y)
        at = round(place[0], _DECIMALS), round(place[1], _DECIMALS)
        last = _last_of(figure)
        if not isinstance(last, AboutPivot):
            self._pivots[figure.id] = at if figure.matrix is None else _through(inverse_of(figure.matrix), at)
            return
        if not self._moving_pivot:
            self._gesture.begin()
            self._moving_pivot = True
            self.held.emit(True)
        address = f"{self._session.sheet.id}/{figure.id}/{last.id}"
        edit: Edit = set_attributes({f"{address}/x_pivot": at[0], f"{address}/y_pivot": at[1]})
        self._gesture.show(edit, _("Move pivot"))

    def _look(self) -> None:
        if self._moving_pivot and not self.box.dragging:
            self._moving_pivot = False
            self._end()
        if not self._following:
            self.looks_changed.emit()


def _last_of(figure: AnyFigure) -> AnyLink | None:
    """The last link that acts."""
    return next((link for link in reversed(figure.transforms) if link.on), None)


def _carried(figure: AnyFigure) -> tuple[float, float]:
    """Where the last pivot of a chain is after the links that follow it; the origin without one."""
    acting = [link for link in figure.transforms if link.on]
    for number, link in reversed([*enumerate(acting)]):
        if isinstance(link, AboutPivot):
            return _through(matrix_of(tuple(acting[number + 1 :])), (link.x_pivot, link.y_pivot))
    return 0.0, 0.0


def _through(matrix: Matrix | None, point: tuple[float, float]) -> tuple[float, float]:
    if matrix is None:
        return point
    x, y, w = (matrix @ (*point, 1.0)).tolist()
    return round(x / w, 9), round(y / w, 9)


def _factor(value: float) -> float:
    rounded = round(value, _DECIMALS)
    return rounded if rounded else math.copysign(10**-_DECIMALS, value)
