"""Gestures on the clip window, dragged by its sides, its corners or as a whole; points put on the sheet."""

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.numerals import with_minus
from workbench.document.edits import set_clip
from workbench.document.model import AnyFigure, Circle, Rectangle, Sheet
from workbench.language import _
from workbench.panels.stage.extent import GRIPS, SIDE_OF
from workbench.panels.stage.gesture import Cell, HandleDrag, Modifiers, Tool, snapped
from workbench.panels.stage.outline import distance_to, figure_at
from workbench.panels.stage.tools import FigureTool, SelectTool
from workbench.rendering.clipping import clip_box
from workbench.rendering.mapping import device_map
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Handle

PREFIX = "clip/"
_PLACES = {**GRIPS, "whole": (0.5, 0.5)}


def usual_window(sheet: Sheet) -> Rectangle:
    """A window over the middle of the sheet, in world coordinates, its sides on pixel centres."""
    scale = device_map(sheet)
    w, h = sheet.width_px, sheet.height_px
    x0, y0, x1, y1 = w // 4, h // 4, max(w - 1 - w // 4, w // 4 + 1), max(h - 1 - h // 4, h // 4 + 1)
    return Rectangle(*scale.world_point(x0, y0), *scale.world_point(x1, y1))


def extent_text(window: Rectangle) -> str:
    """From where to where a window reaches."""
    told = _("x {xmin:g} to {xmax:g}\ny {ymin:g} to {ymax:g}").format(
        xmin=window.xmin, xmax=window.xmax, ymin=window.ymin, ymax=window.ymax
    )
    return with_minus(told)


def window_handles(sheet: Sheet, held: str = "") -> list[Handle]:
    """The grips of the clip window: corners, sides, and its middle for the whole."""
    window = clip_box(sheet)
    if window is None:
        return []
    x0, y0, x1, y1 = window
    return [
        Handle(PREFIX + name, "", x0 + u * (x1 - x0), y0 + v * (y1 - y0), PREFIX + name == held, "square")
        for name, (u, v) in _PLACES.items()
    ]


class ClipDrag(HandleDrag):
    """Drags a handle of a figure, or a grip of the clip window, whose sides stay a pixel apart."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._window: Rectangle | None = None
        self._middle = (0.0, 0.0)

    def press(self, address: str) -> None:
        """Take hold of it."""
        super().press(address)
        self._window = self.session.sheet.first_view.clip_world
        if self._window is not None:
            w = self._window
            self._middle = (w.xmin + w.xmax) / 2, (w.ymin + w.ymax) / 2

    def drag(self, x: float, y: float) -> Cell:
        """Put it to the nearest pixel, which is returned."""
        if not self.held.startswith(PREFIX):
            return super().drag(x, y)
        cell = snapped(x, y)
        window, name = self._window, self.held.removeprefix(PREFIX)
        if window is None:
            return cell
        if name == "whole":
            new = self._moved(window, x, y)
        else:
            new = self._stretched(window, name.split(), self.world(cell))
        if self.show(set_clip(self.session.sheet.first_view.id, new), _("Change the clip window")):
            self.tag = extent_text(new)
        return cell

    def _moved(self, window: Rectangle, x: float, y: float) -> Rectangle:
        """The window as a whole, by whole pixels."""
        scale = device_map(self.session.sheet)
        middle_x, middle_y = scale.point(*self._middle)
        right, up = snapped(x - middle_x, y - middle_y)
        dx, dy = right / scale.sx, up / scale.sy
        return Rectangle(window.xmin + dx, window.ymin + dy, window.xmax + dx, window.ymax + dy)

    def _stretched(self, window: Rectangle, sides: list[str], at: tuple[float, float]) -> Rectangle:
        scale = device_map(self.session.sheet)
        for side in sides:
            across = side in ("left", "right")
            value, pixel = (at[0], 1 / abs(scale.sx)) if across else (at[1], 1 / abs(scale.sy))
            if side in ("left", "bottom"):
                value = min(value, (window.xmax if across else window.ymax) - pixel)
            else:
                value = max(value, (window.xmin if across else window.ymin) + pixel)
            window = replace(window, **{SIDE_OF[side]: round(value, 9)})
        return window


class ClipSelectTool(SelectTool):
    """Selects and moves figures; on a side of the clip window, drags that side."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.side = ClipDrag(session)
        self.side.failed.connect(self.failed)

    @property
    def busy(self) -> bool:
        """Whether a figure or a side is being dragged."""
        return super().busy or self.side.busy

    @property
    def overtaken(self) -> bool:
        """Whether something else was done while a figure or a side is dragged."""
        return super().overtaken or self.side.overtaken

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """A figure, else a side of the window, else a band."""
        side = self._side_at(x, y, reach)
        if side and figure_at(self.session.shown, x, y, reach) is None:
            self.side.press(PREFIX + side)
        else:
            super().press(x, y, modifiers, reach)

    def _side_at(self, x: float, y: float, reach: float) -> str:
        window = clip_box(self.session.sheet)
        if window is None:
            return ""
        x0, y0, x1, y1 = window
        ends = {
            "left": ((x0, y0), (x0, y1)),
            "right": ((x1, y0), (x1, y1)),
            "bottom": ((x0, y0), (x1, y0)),
            "top": ((x0, y1), (x1, y1)),
        }
        away = {side: distance_to((np.array(both),), x, y) for side, both in ends.items()}
        nearest = min(away, key=lambda side: away[side])
        return nearest if away[nearest] <= reach else ""

    def move(self, x: float, y: float) -> None:
        """Drag it."""
        if self.side.busy:
            self.side.drag(x, y)
            self.tag = self.side.tag
        else:
            super().move(x, y)

    def release(self, x: float, y: float) -> None:
        """Let go of it."""
        if self.side.busy:
            self.side.release()
            self.tag = ""
        else:
            super().release(x, y)

    def cancel(self) -> None:
        """Bring it back."""
        self.side.cancel()
        super().cancel()


class WindowTool(Tool):
    """Draws the clip window, in place of the one there is, from one corner to the other."""

    name, icon, key = "window", "crop", "W"

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._corner: Cell = (0, 0)

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Clip window")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas to draw the clip window.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """One corner."""
        self._corner = snapped(x, y)
        self.begin()

    def move(self, x: float, y: float) -> None:
        """The other corner follows the pointer."""
        cell = snapped(x, y)
        if not self.busy or 0 in (cell[0] - self._corner[0], cell[1] - self._corner[1]):
            return
        (x0, y0), (x1, y1) = self.world(self._corner), self.world(cell)
        new = Rectangle(min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))
        if self.show(set_clip(self.session.sheet.first_view.id, new), _("Draw the clip window")):
            self.tag = extent_text(new)

    def release(self, x: float, y: float) -> None:
        """It stays."""
        self.tag = ""
        if self.busy:
            self.commit()


class PointTool(FigureTool):
    """Puts single points, which are circles of radius 0."""

    name, icon, key, kind = "point", "push-pin", "K", Circle

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Point")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Click on the canvas to place a point.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """The point is there at once, and follows until the button comes up."""
        self._cells = [snapped(x, y)]
        self.begin()
        self._make(self._cells)

    def move(self, x: float, y: float) -> None:
        """The point follows the pointer."""
        self.snap = snapped(x, y)
        if self.busy:
            self._cells = [self.snap]
            self._make(self._cells)
            self.tag = f"({self.snap[0]}, {self.snap[1]})"

    def release(self, x: float, y: float) -> None:
        """It stays."""
        if self.busy:
            self._end()

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """A point on the last cell."""
        return Circle("", self.points(cells[-1:]), Circle.algorithms[0], self.next_colour(), radius_world=0.0)
