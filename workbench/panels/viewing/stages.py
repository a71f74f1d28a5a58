"""The stages of the viewing pipeline as planes: world, window, clip, normalise, viewport, device.

All of them show the same sheet: the figures as they are, what the pipeline leaves of them in one view (by the
sheet's own clippers), and where that lies in the frame of the stage.
"""

from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.marks import Mark, Word, closed
from workbench.algorithms.viewing import window_to_normalised
from workbench.document.model import Rectangle, Sheet, View
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.stage.outline import clipped_outlines, outlines
from workbench.panels.stage.picture import picture, themed
from workbench.panels.viewing.rectangles import Named, grips, rectangles
from workbench.rendering.extent import world_extent
from workbench.rendering.mapping import Box, DeviceMap, box, view_map
from workbench.rendering.pipeline import colour_of
from workbench.widgets.canvas.drawing import Drawn, Pattern, PenStroke, Tint
from workbench.widgets.canvas.overlay import Handle
from workbench.widgets.canvas.plane import Plane
from workbench.widgets.look.tokens import DARK, Tokens

Frame = Literal["world", "normalised", "device"]
Points = NDArray[np.float64]

WHOLE_PX = 1024
_ROOM = 0.14
_SAME = DeviceMap(1.0, 1.0, 0.0, 0.0)
_AXES: dict[Frame, tuple[str, str]] = {
    "world": ("x_w", "y_w"),
    "normalised": ("x_n", "y_n"),
    "device": ("x_v", "y_v"),
}


class Stage(NamedTuple):
    """One stage: what it is called in the strip and over its picture, its frame, what can be dragged."""

    slug: str
    title: str
    heading: str
    hint: str
    frame: Frame
    rectangle: str = ""


def stages() -> tuple[Stage, ...]:
    """In the order of the pipeline."""
    drag = _("drag it or its sides")
    return (
        Stage("world", _("World"), _("The world"), _("figures as they are"), "world"),
        Stage("window", _("Window"), _("Window in the world"), drag, "world", "window"),
        Stage("clip", _("Clip"), _("Clipped in the world"), _("what the clippers leave"), "world", "clip"),
        Stage("normalise", _("Normalise"), _("Normalised"), _("the window is the unit square"), "normalised"),
        Stage("viewport", _("Viewport"), _("Viewport on the device"), drag, "device", "viewport"),
        Stage("device", _("Device"), _("The device"), _("pixels, scan converted"), "device"),
    )


class Curve(NamedTuple):
    """A polyline (n, 2) of a figure, in the colour that the figure has in a theme."""

    points: Points
    ink: str


def frame_map(view: View, frame: Frame) -> DeviceMap:
    """The map from the world to the frame of a stage."""
    if frame == "world":
        return _SAME
    if frame == "device":
        return view_map(view)
    matrix = window_to_normalised(box(view.window_world))
    return DeviceMap(*(float(matrix[at]) for at in ((0, 0), (1, 1), (0, 2), (1, 2))))


def world_box(sheet: Sheet, view: View) -> Box:
    """What of the world is shown: the figures, the window and the clip window, with room around them."""
    boxes = [box(view.window_world)]
    boxes += [box(view.clip_world)] if view.clip_world is not None else []
    extent = world_extent(sheet)
    boxes += [] if extent is None else [extent]
    return _around(boxes)


def device_box(sheet: Sheet, view: View) -> Box:
    """What of the device is shown: the sheet and the viewport, with a little room."""
    return _around([(-0.5, -0.5, sheet.width_px - 0.5, sheet.height_px - 0.5), box(view.viewport_device)])


def _around(boxes: Sequence[Box]) -> Box:
    xmin, ymin = (min(each[side] for each in boxes) for side in (0, 1))
    xmax, ymax = (max(each[side] for each in boxes) for side in (2, 3))
    room = _ROOM / 2 * max(xmax - xmin, ymax - ymin)
    return xmin - room, ymin - room, xmax + room, ymax + room


class Geometry:
    """The curves of a sheet in one view; each kind is worked out when it is first asked for."""

    def __init__(self, sheet: Sheet, view: View, shown: Box, now: Tokens) -> None:
        self.sheet, self.view, self.shown, self.now = sheet, view, shown, now
        coloured = themed(sheet, now)
        self._figures = [figure for figure in sheet.figures if figure.visible]
        self._inks = [f"#{colour_of(coloured, figure):06X}" for figure in self._figures]
        self._whole: list[Curve] | None = None
        self._seen: dict[str, list[Curve]] = {}

    @property
    def whole(self) -> list[Curve]:
        """The figures as they are (world), as far as the part that is shown goes."""
        if self._whole is None:
            wide, high = self.shown[2] - self.shown[0], self.shown[3] - self.shown[1]
            scale = WHOLE_PX / max(wide, high)
            paper = Rectangle(0.0, 0.0, wide * scale, high * scale)
            view = View("", Rectangle(*self.shown), paper)
            through = replace(self.sheet, views=(view,), width_px=WHOLE_PX, height_px=WHOLE_PX)
            back = view_map(view)
            self._whole = [
                Curve(back.world(points), ink)
                for curves, ink in zip(outlines(through, self._figures), self._inks, strict=True)
                for points in curves
            ]
        return self._whole

    def seen(self, view: View) -> list[Curve]:
        """What is left of the figures in a view, device coordinates."""
        if view.id not in self._seen:
            alone = replace(self.sheet, views=(view,))
            self._seen[view.id] = [
                Curve(points, ink)
                for curves, ink in zip(clipped_outlines(alone, self._figures), self._inks, strict=True)
                for points in curves
            ]
        return self._seen[view.id]

    def left(self, frame: Frame) -> list[Curve]:
        """What is left of the figures in the view, in the frame of a stage."""
        seen = self.seen(self.view)
        if frame == "device":
            return seen
        back, on = view_map(self.view), frame_map(self.view, frame)
        return [Curve(on.points(back.world(curve.points)), curve.ink) for curve in seen]


def plane_of(
    stage: Stage, geometry: Geometry, marks: Sequence[Mark] = (), held: str = "", small: bool = False
) -> Plane:
    """What a stage shows, with the marks of a step that lie in its frame; ``small`` is without words."""
    sheet, view = geometry.sheet, geometry.view
    drawn: list[Drawn] = []
    handles: list[Handle] = []
    pixels = None
    shown = geometry.shown
    if stage.slug == "normalise":
        shown = (-0.12, -0.12, 1.12, 1.12)
        drawn.append(PenStroke(_ring(Rectangle(0.0, 0.0, 1.0, 1.0)), "muted", 1.25))
        drawn += _strokes(geometry.left("normalised"), 2.0)
    elif stage.frame == "world":
        drawn += _in_the_world(stage, geometry)
    else:
        shown = device_box(sheet, view)
        if stage.slug == "device":
            pixels = picture(sheet, DARK)
        else:
            drawn += _on_the_device(geometry)
    if stage.rectangle:
        named = rectangles()[stage.rectangle]
        rectangle = named.of(view)
        if rectangle is not None:
            drawn += framed(named, rectangle, held.partition("/")[0] == stage.rectangle, small)
            handles += grips(named, rectangle, held)
    return Plane(shown, _AXES[stage.frame], (*drawn, *marks), tuple(handles), pixels, stage.slug == "device")


def _in_the_world(stage: Stage, geometry: Geometry) -> Iterator[Drawn]:
    if stage.slug == "world":
        yield from _strokes(geometry.whole, 2.0)
        return
    view = geometry.view
    if stage.slug == "window":
        yield Tint(_ring(view.window_world)[:4], "data1", 22)
        yield from _strokes(geometry.whole, 1.25, "dot")
    else:
        yield PenStroke(_ring(view.window_world), "muted", 1.0)
    yield from _strokes(geometry.left("world"), 2.0)
    if stage.slug == "window" and view.clip_world is not None:
        yield PenStroke(_ring(view.clip_world), "data4", 1.25, "dash")


def _on_the_device(geometry: Geometry) -> Iterator[Drawn]:
    """The edge of the device, other views pale and in order, then this one."""
    sheet, own = geometry.sheet, geometry.view
    edge = Rectangle(-0.5, -0.5, sheet.width_px - 0.5, sheet.height_px - 0.5)
    yield PenStroke(_ring(edge), "muted", 1.0)
    yield Tint(_ring(own.viewport_device)[:4], "data2", 22)
    for view in sheet.views:
        if view.id != own.id:
            yield PenStroke(_ring(view.viewport_device), "muted", 1.0, "dash")
        yield from _strokes(geometry.seen(view), 2.0 if view.id == own.id else 1.25)


def framed(named: Named, rectangle: Rectangle, held: bool, small: bool) -> Iterator[Drawn]:
    """A rectangle that can be dragged, two of its corners with their coordinates.

    While it is ``held`` they stand beside the pointer, where a corner's name would lie under them.
    """
    solid = named.slug == "window"
    yield PenStroke(_ring(rectangle), named.ink, 3.0 if held else 2.0, "solid" if solid else "dash")
    if small or held:
        return
    for x, y, right, up in ((rectangle.xmin, rectangle.ymin, -1, -1), (rectangle.xmax, rectangle.ymax, 1, 1)):
        yield Word(f"({displayed(x)}, {displayed(y)})", x, y, "text", right, up, True)


def _strokes(curves: Sequence[Curve], width: float, pattern: Pattern = "solid") -> Iterator[Drawn]:
    for curve in sorted(curves, key=lambda curve: curve.ink):  # what is alike is painted at once
        yield PenStroke(curve.points, curve.ink, width, pattern)


def _ring(rectangle: Rectangle) -> Points:
    xmin, ymin, xmax, ymax = box(rectangle)
    return closed(np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)], np.float64))
