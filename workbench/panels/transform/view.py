"""Keeps canvas, card, chain and matrices of the Transform panel in step with the session and its run."""

from dataclasses import replace as with_fields
from functools import lru_cache

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QRectF, QTimer

from workbench.algorithms.marks import Word
from workbench.document.model import AnyFigure, Sheet, WorldPoint
from workbench.document.transforms.stages import Stage, stages
from workbench.language import _
from workbench.panels.stage.compose import Composition, with_band
from workbench.panels.stage.gesture import HandleDrag, Tool
from workbench.panels.stage.labels import clear_of
from workbench.panels.stage.picture import packed
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.view import FigureView
from workbench.panels.transform.box import ChainBox
from workbench.panels.transform.card import TransformCard
from workbench.panels.transform.chain_dock import ChainDock
from workbench.panels.transform.legend import Legend
from workbench.panels.transform.matrices import Matrices
from workbench.panels.transform.rows import Progress, rows
from workbench.panels.transform.scene import (
    Area,
    Shows,
    figure_at_stages,
    moved_axes,
    others,
    plane,
    reach,
)
from workbench.panels.transform.told import place_text
from workbench.panels.transform.whole import WholeDock
from workbench.rendering.mapping import DeviceMap, device_map
from workbench.rendering.subjects.chain import PRODUCT, vertex_of
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.canvas.overlay import Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import LIGHT, tokens

LEISURE_MS = 40
_PAPER_PX = 760.0


class TransformView(FigureView):
    """Shows the figure that is worked on at every stage of its chain, and the matrices of the stages.

    ``lit`` is the stage that is pointed at anywhere; ``asked`` the element whose number is asked for.
    """

    card: TransformCard

    def __init__(
        self,
        session: Session,
        canvas: PixelCanvas,
        second: PixelCanvas,
        card: TransformCard,
        chain: ChainDock,
        matrices: Matrices,
        whole: WholeDock,
    ) -> None:
        super().__init__(session, canvas, second, card)
        self.chain, self.matrices, self.whole = chain, matrices, whole
        self.chain_box = ChainBox(session, canvas)
        self.legend = Legend(canvas)
        self.lit: int | None = None
        self.asked: tuple[int, int] | None = None
        # What a drag makes of the matrices, and of the dock beside it, need not be seen in the same frame.
        self._leisure = QTimer(self.legend)
        self._leisure.setSingleShot(True)
        self._leisure.setInterval(LEISURE_MS)
        self._leisure.timeout.connect(self._show_beneath)
        self._busy = False
        for each in (canvas, second):
            each.set_overlay(Overlay(plane=True))

    @property
    def vertex(self) -> int:
        """The number of the point that is followed through the chain."""
        figure, subject = self.active, self.session.subject
        return 0 if figure is None or not figure.points_world else vertex_of(figure, subject)

    def refresh(self, tool: Tool, drag: HandleDrag) -> None:
        """Everything anew, from the session alone."""
        session, sheet, active = self.session, self.sheet, self.active
        drawing = tool if isinstance(tool, FigureTool) else None
        selected = [figure for figure in sheet.figures if figure.id in set(session.state.selection)]
        acting = () if active is None else stages(active.transforms)
        unit = _unit(self.canvas)
        drawn = self._drawn(sheet, active, _seen(self.canvas), unit)
        works = active is not None and not tool.busy and not self.card.axes.isChecked()
        chosen = works and drawing is None and active is not None and active.id in session.state.selection
        self.chain_box.follow(active if chosen else None)
        grips = [*self.chain_box.box.places().values()] if chosen else []
        overlay = Overlay(drawn=(*clear_of(drawn, grips, unit),), plane=True)
        if chosen and active is not None:
            place = f"{sheet.id}/{active.id}"
            points = _points(device_map(sheet), active.points_world, place, drag.held)
            overlay = with_fields(overlay, handles=points)
        overlay = with_band(self.chain_box.over(overlay), tool.band)
        self.canvas.cells_per_unit = abs(device_map(sheet).sx)
        self.canvas.set_picture(_blank(sheet), packed(tokens().canvas))
        self.canvas.set_overlay(with_fields(overlay, snap=drawing.snap if drawing else None))
        self._show_beside(sheet, active)
        if not self.chain_box.busy:  # which changes the chain, and no number of the card
            self.card.refresh(drawing, selected, "")
        self.chain.follow(active, self.lit)
        around = self.chain_box.rectangle(active) if works and active is not None else QRectF()
        self.legend.follow(acting if works else (), self.card.ghosts.isChecked(), self.lit, around)
        self._busy = busy = tool.busy or drag.busy or self.chain_box.busy
        if not busy:
            self.canvas.set_reach(reach(sheet, active))
            self._leisure.stop()
            self._show_beneath()
        elif not self._leisure.isActive():
            self._leisure.start()

    def _show_beneath(self) -> None:
        """Bring the matrices and the dock of the whole up to date."""
        active = self.active
        self._show_whole()
        self._show_matrices(active, [] if active is None else stages(active.transforms), self._busy)

    def _show_whole(self) -> None:
        """Bring the dock up to date, if it is seen."""
        if not self.whole.isVisible():
            return
        active, point = self.active, None
        chain = () if active is None else stages(active.transforms)
        if active is not None and active.points_world:
            vertex = active.points_world[self.vertex]
            point = vertex.x, vertex.y
        self.whole.follow(chain, point)

    def _drawn(
        self,
        sheet: Sheet,
        active: AnyFigure | None,
        area: Area,
        unit: float,
        lit: bool = True,
        axes: bool | None = None,
    ) -> list[Drawn]:
        """The plane with its figures; ``axes`` moves them instead of the points, by default as is chosen."""
        drawn: list[Drawn] = [*plane(device_map(sheet), area, unit), *others(sheet, active)]
        if active is not None:
            shows = Shows(
                self.card.ghosts.isChecked(),
                self.card.axes.isChecked() if axes is None else axes,
                self.vertex,
                self.lit if lit else None,
            )
            draw = moved_axes if shows.axes else figure_at_stages
            drawn += draw(sheet, active, shows, unit)
        return drawn

    def _show_beside(self, sheet: Sheet, active: AnyFigure | None) -> None:
        """The chain in the opposite order, or the axes moved where the first picture moves the points."""
        chain = () if active is None else active.transforms
        self.card.reversed.setVisible(len(chain) > 1)
        swapped = self.card.reversed.isChecked() and len(chain) > 1
        other = self.card.both.isChecked() and bool(chain)
        self.second.setVisible(swapped or other)
        if active is None or not (swapped or other):
            return
        area = _seen(self.second)
        if other:
            words = _("the axes moved: new coordinates")
        else:
            active = replace(active, transforms=tuple(reversed(chain)))
            words = _("in the opposite order")
        drawn = self._drawn(sheet, active, area, _unit(self.second), axes=other or None)
        title = Word(words, (area[0] + area[2]) / 2, area[3], "data2", 0, -1, True, True)
        self.second.set_picture(_blank(sheet), packed(tokens().canvas))
        self.second.set_overlay(Overlay(drawn=(*drawn, title), plane=True))

    def _show_matrices(self, active: AnyFigure | None, chain: list[Stage], busy: bool) -> None:
        if active is None or not chain:
            self.matrices.show_rows([])
            return
        progress = None if busy else self.chain_progress()
        run = self.stepped_run()
        point = None
        if (
            run is not None
            and run.entry is not None
            and run.entry.slug != PRODUCT
            and len(active.points_world)
        ):
            vertex = active.points_world[self.vertex]
            point = vertex.x, vertex.y
        notes = not self.matrices.narrow
        self.matrices.show_rows(rows(chain, progress, point, notes), self.lit)

    def chain_progress(self, number: int | None = None) -> Progress | None:
        """How far the run has come; None before its first step, when everything is shown."""
        run = self.stepped_run()
        if run is None or run.entry is None or (number is None and run.number == 0 and not run.ask_first):
            return None
        call = run.own_call(number)
        if call is None:
            return None
        if run.entry.slug != PRODUCT:
            step = run.step_number if number is None else number
            return Progress(0, min(step, 3), (min(step, 3) - 1, 0) if step else None, point=True)
        known = len(call.emitted)
        if run.waiting and known == 9:  # what is asked next is in the next product
            return Progress(call.number + 1, 0, None, self.asked)
        current = None
        if known:
            row, column, _value = call.emitted[-1].tolist()
            current = int(row), int(column)
        return Progress(call.number, known, current, self.asked if run.waiting else None)

    def on_paper(self, number: int | None = None) -> Composition:
        """What is shown in the light theme and without handles; the steps are those of the matrices."""
        frames = self.session.frames
        sheet = frames.sheet
        area = -0.5, -0.5, sheet.width_px - 0.5, sheet.height_px - 0.5
        drawn = self._drawn(sheet, frames.figure, area, sheet.width_px / _PAPER_PX, lit=False)
        return Composition(_blank(sheet), packed(LIGHT.canvas), Overlay(drawn=(*drawn,), plane=True))

    def describe(self, x: int, y: int) -> str:
        """A place in the world."""
        return place_text(*device_map(self.sheet).world_point(x, y))


def _blank(sheet: Sheet) -> np.ndarray:
    return np.full((sheet.height_px, sheet.width_px), packed(tokens().canvas), np.uint32)


def _unit(canvas: PixelCanvas) -> float:
    """Device units of one logical pixel."""
    return canvas.devicePixelRatioF() / canvas.view.cell


def _seen(canvas: PixelCanvas) -> Area:
    """The part of the plane that is seen, device."""
    area, view = canvas.area, canvas.view
    left, top = view.to_device(area.left, area.top)
    right, bottom = view.to_device(area.right, area.bottom)
    return left, bottom, right, top


@lru_cache(maxsize=4)
def _points(scale: DeviceMap, points: tuple[WorldPoint, ...], place: str, held: str) -> tuple[Handle, ...]:
    """The points of a figure at an address, as it was drawn, to be grabbed."""
    made = []
    for point in points:
        address = f"{place}/{point.id}/x"
        made.append(Handle(address, "", *scale.point(point.x, point.y), address == held, "round", "muted"))
    return tuple(made)
