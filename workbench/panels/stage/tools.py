"""The tools of the Draw panel: select, line, circle, ellipse, polyline."""

import numpy as np
from PySide6.QtCore import Qt

from workbench.document.edits import add_figure, move_figures
from workbench.document.model import AnyFigure, Circle, Ellipse, Line, Polygon, Polyline, WorldPoint
from workbench.geometry.conventions import round_half_up
from workbench.language import _
from workbench.panels.stage.gesture import Cell, Modifiers, Tool, radius_between, snapped, span_text
from workbench.panels.stage.outline import figure_at, outlines
from workbench.rendering import device_map
from workbench.session.session import Session


class SelectTool(Tool):
    """Selects figures, moves them, or draws a band around several."""

    name, icon, key, shape = "select", "cursor", "V", Qt.CursorShape.ArrowCursor

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._start: tuple[float, float] | None = None
        self._kept: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Select")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Select what is under the pointer, with its group, or with Alt alone; Shift adds to the selection or
        takes from it.
        """
        figure = self.under(x, y, reach)
        selection = self.session.state.selection
        adding = bool(modifiers & Modifiers.ShiftModifier)
        self._start = (x, y)
        if figure is None:
            self._kept = selection if adding else ()
            self.session.update_state(selection=self._kept)
            return
        alone = bool(modifiers & Modifiers.AltModifier)
        picked = (figure.id,) if alone else self.session.sheet.together((figure.id,))
        if adding and figure.id in selection:
            chosen = tuple(i for i in selection if i not in picked)
        elif adding:
            chosen = tuple(dict.fromkeys((*selection, *picked)))
        else:
            chosen = selection if figure.id in selection and not alone else picked
        self.session.update_state(selection=chosen, active=figure.id)
        if figure.id in chosen:
            self.begin()

    def under(self, x: float, y: float, reach: float) -> AnyFigure | None:
        """The figure at a device point, if any is within ``reach`` pixels."""
        return figure_at(self.session.shown, x, y, reach)

    def move(self, x: float, y: float) -> None:
        """Move the selection, or draw the band."""
        if self._start is None:
            return
        if not self.busy:
            (x0, y0), (x1, y1) = self._start, (x, y)
            self.band = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], np.float64)
            self._select_inside()
            return
        right, up = round_half_up(x - self._start[0]), round_half_up(y - self._start[1])
        scale = device_map(self.session.sheet)
        edit = move_figures(self.session.state.selection, right / scale.sx, up / scale.sy)
        self.show(edit, _("Move"))
        self.tag = _("moved by ({right}, {up})").format(right=right, up=up)

    def _select_inside(self) -> None:
        assert self.band is not None
        low, high = self.band.min(axis=0), self.band.max(axis=0)
        figures = self.session.shown.figures
        there = {figure.id for figure in figures}
        self._kept = tuple(kept for kept in self._kept if kept in there)
        inside, outside = [], set()
        for figure, curves in zip(figures, outlines(self.session.frames.sheet, figures), strict=True):
            points = np.concatenate(curves) if curves else np.empty((0, 2))
            if len(points) and ((points >= low) & (points <= high)).all():
                inside.append(figure)
            elif len(points):
                outside.add(figure.group)
        whole = [figure.id for figure in inside if not figure.group or figure.group not in outside]
        chosen = tuple(dict.fromkeys((*self._kept, *self.session.sheet.together(whole))))
        self.session.update_state(
            selection=chosen, active=chosen[-1] if chosen else self.session.state.active
        )

    def release(self, x: float, y: float) -> None:
        """End the move or the band."""
        self._start, self.band, self.tag = None, None, ""
        if self.busy:
            self.commit()

    def cancel(self) -> None:
        """Let go."""
        super().cancel()
        self._start = None


class FigureTool(Tool):
    """Draws a figure by dragging, or by two clicks; ``algorithm`` is what new figures are drawn by."""

    kind: type[AnyFigure] = Line

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.algorithm = self.kind.algorithms[0]
        self._cells: list[Cell] = []
        self._pressed_at: Cell | None = None

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """The figure that these cells make, the last of them under the pointer; None while they make none."""
        raise NotImplementedError

    def measure(self, start: Cell, end: Cell) -> str:
        """What is said beside the pointer."""
        return span_text(start, end)

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """The first point, or the second of two clicks."""
        cell = self._pressed_at = snapped(x, y)
        if not self.busy:
            self._cells = [cell]
            self.begin()
        else:
            self._draw(cell)

    def move(self, x: float, y: float) -> None:
        """The figure follows the pointer."""
        cell = snapped(x, y)
        self.snap = cell
        if self.busy and self._cells:
            self._draw(cell)

    def release(self, x: float, y: float) -> None:
        """The figure is made, unless the button comes up in place: then a second click ends it."""
        cell = snapped(x, y)
        if self.busy and cell != self._cells[0]:
            self._draw(cell)
            self._end()

    def _draw(self, cell: Cell) -> None:
        self.tag = self.measure(self._cells[-1], cell)
        self._make([*self._cells, cell])

    def _make(self, cells: list[Cell]) -> None:
        figure = self.figure(cells)
        if figure is None:
            self.show(lambda document: document, "")
        elif self.show(add_figure(self.session.sheet.id, figure), _("Draw {what}").format(what=self.title)):
            made = self.session.sheet.figures[-1].id
            self.session.update_state(selection=(made,), active=made, step=0)

    def _end(self) -> None:
        self._cells, self.tag = [], ""
        self.commit()

    def cancel(self) -> None:
        """Take back what was begun."""
        super().cancel()
        self._cells = []

    def points(self, cells: list[Cell]) -> tuple[WorldPoint, ...]:
        """Control points at these cells, to be given ids by the edit."""
        return tuple(WorldPoint("", *self.world(cell)) for cell in cells)

    def next_colour(self) -> int:
        """The palette index of a new figure: that of the front one, or the first that is not the paper."""
        sheet = self.session.sheet
        if sheet.figures:
            return sheet.figures[-1].colour
        return next((k for k in range(len(sheet.palette)) if k != sheet.background), 0)


class LineTool(FigureTool):
    """Draws lines."""

    name, icon, key, kind = "line", "line-segment", "L", Line

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Line")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas to draw a line.")

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """A line between the first and the last cell."""
        ends = [cells[0], cells[-1]]
        return Line("", self.points(ends), self.algorithm, self.next_colour()) if ends[0] != ends[1] else None


class CircleTool(FigureTool):
    """Draws circles from their centre."""

    name, icon, key, kind = "circle", "circle", "O", Circle

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Circle")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas from the centre of a circle outwards.")

    def measure(self, start: Cell, end: Cell) -> str:
        """The radius."""
        return f"r = {radius_between(start, end)}"

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """A circle about the first cell, as far as the last."""
        radius = radius_between(cells[0], cells[-1])
        if radius == 0:
            return None
        scale = device_map(self.session.sheet)
        centre = self.points(cells[:1])
        return Circle("", centre, self.algorithm, self.next_colour(), radius_world=radius / abs(scale.sx))


class EllipseTool(FigureTool):
    """Draws ellipses from their centre."""

    name, icon, key, kind = "ellipse", "ellipse", "E", Ellipse

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Ellipse")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas from the centre of an ellipse outwards.")

    def measure(self, start: Cell, end: Cell) -> str:
        """Both radii."""
        return f"rx = {abs(end[0] - start[0])}, ry = {abs(end[1] - start[1])}"

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """An ellipse about the first cell, with the last at a corner of its box."""
        rx, ry = abs(cells[-1][0] - cells[0][0]), abs(cells[-1][1] - cells[0][1])
        if rx == 0 or ry == 0:
            return None
        scale = device_map(self.session.sheet)
        return Ellipse(
            "",
            self.points(cells[:1]),
            self.algorithm,
            self.next_colour(),
            radius_x_world=rx / abs(scale.sx),
            radius_y_world=ry / abs(scale.sy),
        )


class PolylineTool(FigureTool):
    """Draws polylines click by click; a click on the first point closes, one on the last or Enter ends."""

    name, icon, key = "polyline", "path", "P"
    kind: type[Polyline] | type[Polygon] = Polyline

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._closed = False

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Polyline")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Click the points of a polyline one after another; Enter ends it.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Another point."""
        cell = self._pressed_at = snapped(x, y)
        if not self.busy:
            self._closed, self._cells = False, [cell]
            self.begin()
        elif cell == self._cells[-1]:
            self.finish()
        elif cell == self._cells[0] and len(self._cells) > 2:
            self._closed = True
            self.finish()
        else:
            self._cells.append(cell)
            self._make(self._cells)

    def release(self, x: float, y: float) -> None:
        """Where a drag ends is a point too."""
        cell = snapped(x, y)
        if self.busy and cell != self._pressed_at and cell != self._cells[-1]:
            self._cells.append(cell)
            self._make(self._cells)

    def finish(self) -> None:
        """End the polyline with the points so far."""
        if not self.busy:
            return
        if len(self._cells) < 2:
            self.cancel()
        else:
            self._make(self._cells)
            self._end()

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """A polyline through the cells, none twice running."""
        kept = [cell for k, cell in enumerate(cells) if k == 0 or cell != cells[k - 1]]
        if len(kept) < 2:
            return None
        return Polyline("", self.points(kept), self.algorithm, self.next_colour(), closed=self._closed)


class PolygonTool(PolylineTool):
    """Draws polygons corner by corner; a click on the first or the last corner, or Enter, ends."""

    name, icon, key = "polygon", "polygon", "G"
    kind = Polygon

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Polygon")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Click the corners of a polygon one after another; Enter closes it.")

    def _make(self, cells: list[Cell]) -> None:
        scale = device_map(self.session.sheet)
        ends = [scale.point(*self.world(cell)) for cell in cells]
        self.band = np.array(ends, np.float64) if len(set(cells)) < 3 else None
        super()._make(cells)

    def finish(self) -> None:
        """End the polygon with the corners so far; fewer than three make none."""
        if self.busy and len(set(self._cells)) < 3:
            self.cancel()
            self.failed.emit(_("A polygon needs three corners; click at least three places."))
        else:
            super().finish()

    def _end(self) -> None:
        self.band = None
        super()._end()

    def figure(self, cells: list[Cell]) -> AnyFigure | None:
        """A polygon with the cells as corners, none twice running."""
        kept = [cell for k, cell in enumerate(cells) if k == 0 or cell != cells[k - 1]]
        if len(set(kept)) < 3:
            return None
        return Polygon("", self.points(kept), self.algorithm, self.next_colour())
