"""The tools of the Fill panel beside those that all panels have: rings, areas, brush, seed, one point."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt

from workbench.algorithms import catalogue
from workbench.document.edits import add_figure, add_ring
from workbench.document.model import Polygon, SeedFill
from workbench.document.transforms.chains import read_only_reason
from workbench.language import _
from workbench.panels.stage.gesture import Cell, Modifiers, Tool, snapped
from workbench.panels.stage.tools import (
    CircleTool,
    EllipseTool,
    FigureTool,
    LineTool,
    PolygonTool,
    PolylineTool,
)
from workbench.rendering import device_map, figure_map, frame_buffer
from workbench.session.session import Session

BOUNDARY, FILL = 1, 2


class FillPolygonTool(PolygonTool):
    """Draws polygons; begun with Shift, another ring of the active polygon."""

    colour = BOUNDARY

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._of = ""

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """A corner; with Shift the first one of a further ring."""
        if not self.busy:
            active = self.session.active_figure
            adding = bool(modifiers & Modifiers.ShiftModifier)
            self._of = active.id if adding and isinstance(active, Polygon) else ""
        super().press(x, y, modifiers, reach)

    def _make(self, cells: list[Cell]) -> None:
        if not self._of:
            super()._make(cells)
            return
        corners = [cell for k, cell in enumerate(cells) if k == 0 or cell != cells[k - 1]]
        sheet = self.session.sheet
        polygon = next((figure for figure in sheet.figures if figure.id == self._of), None)
        if polygon is not None and (reason := read_only_reason(polygon)):
            self.failed.emit(reason)
            return
        scale = device_map(sheet) if polygon is None else figure_map(sheet, polygon)
        places = [scale.world_point(*cell) for cell in corners]
        if len(set(corners)) < 3:
            self.band = np.array([scale.point(*place) for place in places], np.float64)
            self.show(lambda document: document, "")
        else:
            self.band = None
            self.show(add_ring(self._of, places), _("Draw ring"))

    def next_colour(self) -> int:
        """The colour chosen in the card."""
        return self.colour


class AreaCircleTool(CircleTool):
    """Draws circles, filled ones unless the card says otherwise."""

    colour = BOUNDARY

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.algorithm = catalogue.filling(self.kind.algorithms)[0]

    def next_colour(self) -> int:
        """The colour chosen in the card."""
        return self.colour


class AreaEllipseTool(EllipseTool):
    """Draws ellipses, filled ones unless the card says otherwise."""

    colour = BOUNDARY

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.algorithm = catalogue.filling(self.kind.algorithms)[0]

    def next_colour(self) -> int:
        """The colour chosen in the card."""
        return self.colour


class BoundaryLineTool(LineTool):
    """Draws lines for a boundary."""

    colour = BOUNDARY

    def next_colour(self) -> int:
        """The colour chosen in the card."""
        return self.colour


class BrushTool(PolylineTool):
    """Draws freehand: every pixel that the pointer passes while it is pressed."""

    name, icon, key = "brush", "paint-brush", "B"
    colour = BOUNDARY

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Brush")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas to paint freehand.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Begin a stroke."""
        self._closed, self._cells = False, [snapped(x, y)]
        self.begin()

    def move(self, x: float, y: float) -> None:
        """Go on with it."""
        self.snap = cell = snapped(x, y)
        if self.busy and self._cells and cell != self._cells[-1]:
            self._cells.append(cell)
            self._make(_straightened(self._cells))

    def release(self, x: float, y: float) -> None:
        """End it; a stroke of one pixel is none. One that ends beside its start is closed."""
        self.move(x, y)
        if not self.busy:
            return
        (x0, y0), (x1, y1) = self._cells[0], self._cells[-1]
        self._closed = len(self._cells) > 4 and max(abs(x1 - x0), abs(y1 - y0)) <= 2
        if len(self._cells) < 2:
            self.cancel()
        else:
            self._make(_straightened(self._cells))
            self._end()

    def finish(self) -> None:
        """A stroke ends when the button comes up."""

    def next_colour(self) -> int:
        """The colour chosen in the card."""
        return self.colour


def _straightened(cells: list[Cell]) -> list[Cell]:
    """``cells`` without those in the middle of a straight step."""
    kept = cells[:1]
    for before, here, after in zip(cells, cells[1:], cells[2:], strict=False):
        if (here[0] - before[0], here[1] - before[1]) != (after[0] - here[0], after[1] - here[1]):
            kept.append(here)
    return [*kept, cells[-1]] if len(cells) > 1 else kept


class SeedTool(FigureTool):
    """A click puts a seed fill in front of all that is there."""

    name, icon, key = "seed", "paint-bucket", "S"
    kind = SeedFill
    colour = FILL

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.algorithm = SeedFill.algorithms[0]
        self.boundary = BOUNDARY
        self.recursion_limit = 1000

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Seed fill")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Draw a boundary, then click inside it; without one the whole sheet is filled.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Fill from here, or say why not."""
        cell = snapped(x, y)
        self.tag = ""
        problem = seed_problem(self.session, cell, self.algorithm, self.colour, self.boundary)
        if problem:
            self.tag = problem
            self.failed.emit(problem)
            return
        fill = SeedFill(
            "",
            self.points([cell]),
            self.algorithm,
            self.colour,
            boundary=self.boundary,
            recursion_limit=self.recursion_limit,
        )
        self.begin()
        if self.show(add_figure(self.session.sheet.id, fill), _("Seed fill")):
            made = self.session.sheet.figures[-1].id
            self.session.update_state(selection=(made,), active=made, step=0)
        self.commit()

    def move(self, x: float, y: float) -> None:
        """Show the pixel that would be the seed."""
        cell = snapped(x, y)
        if cell != self.snap:
            self.tag = ""
        self.snap = cell

    def release(self, x: float, y: float) -> None:
        """All is done."""


def stops_at_boundary(algorithm: str) -> bool:
    """Whether a seed fill asks for the colour of a boundary."""
    return "boundary" in catalogue.get(algorithm).parameter_names


def seed_problem(
    session: Session, cell: Cell, algorithm: str, fill: int, boundary: int, below: int | None = None
) -> str:
    """Why a fill from ``cell`` would colour nothing, in one sentence; empty when it would colour something.

    ``below`` figures of the sheet lie beneath the fill, by default all of them.
    """
    sheet = session.sheet
    if below is not None:
        sheet = replace(sheet, figures=sheet.figures[:below])
    (x, y), size = cell, (sheet.width_px, sheet.height_px)
    if not (0 <= x < size[0] and 0 <= y < size[1]):
        text = _("The seed ({x}, {y}) is outside the picture of {w} by {h} pixels: put it inside.")
        return text.format(x=x, y=y, w=size[0], h=size[1])
    found = int(frame_buffer(sheet)[y, x])
    if stops_at_boundary(algorithm) and found == sheet.palette[boundary]:
        return _("The seed ({x}, {y}) is on the boundary: put it inside the region.").format(x=x, y=y)
    if found == sheet.palette[fill]:
        text = _("The seed ({x}, {y}) already has the fill colour: choose another colour or place.")
        return text.format(x=x, y=y)
    return ""


class InsideTool(Tool):
    """A click asks whether a point is inside the active polygon."""

    name, icon, key, shape = "inside", "target", "I", Qt.CursorShape.CrossCursor

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.point: tuple[float, float] | None = None
        self._held = False

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Inside or outside?")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Draw a polygon first; then click a point to ask whether it is inside.")

    def polygon(self) -> Polygon | None:
        """The polygon that is asked about: the active one, or else the front one."""
        active = self.session.active_figure
        if isinstance(active, Polygon):
            return active
        polygons = [f for f in self.session.sheet.figures if isinstance(f, Polygon) and f.visible]
        return polygons[-1] if polygons else None

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Ask about this point: to a tenth of a pixel, with Shift the nearest centre."""
        if self.polygon() is None:
            self.tag = _("There is no polygon here; draw one first.")
            self.failed.emit(self.tag)
            return
        self._held = True
        near = snapped(x, y)
        whole = bool(modifiers & Modifiers.ShiftModifier) or max(abs(x - near[0]), abs(y - near[1])) < 0.2
        self.point = (float(near[0]), float(near[1])) if whole else (round(x, 1), round(y, 1))

    def move(self, x: float, y: float) -> None:
        """The point follows while the button is down."""
        if self._held:
            self.press(x, y, Modifiers.NoModifier, 0.0)

    def release(self, x: float, y: float) -> None:
        """The point stays."""
        self._held = False

    def cancel(self) -> None:
        """Ask no more."""
        super().cancel()
        self.point, self._held = None, False
