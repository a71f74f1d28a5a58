"""Keeps the canvas and the card of the Curves panel in step with the session and what is looked at."""

import time
from itertools import chain

import numpy as np

from workbench.document.model import Curve, CurvePoint, Sheet
from workbench.document.state import FIGURES
from workbench.engine.containers import same
from workbench.geometry.conventions import round_half_up
from workbench.panels.curves.card import CurveCard
from workbench.panels.curves.docks import CurveDocks
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.marks import marks
from workbench.panels.curves.scene import (
    CURVE_INK,
    MANY,
    beside,
    control_polygon,
    curve_line,
    handles_shown,
    influence,
    names,
    others,
    place_at,
    region,
)
from workbench.panels.curves.shape import Array, device_points, tangent_ends
from workbench.panels.curves.still import Parting, moving_part, parted, with_handles
from workbench.panels.curves.tools import CurveSelectTool
from workbench.panels.stage.compose import Composition, with_answer, with_asked, with_band
from workbench.panels.stage.gesture import HandleDrag, Tool
from workbench.panels.stage.outline import outlines
from workbench.panels.stage.picture import packed, pale_picture, picture
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.view import FigureView
from workbench.rendering import emitted, figure_map
from workbench.rendering.curve_runs import construction_of, constructions_of, curve_calls
from workbench.rendering.marks import on_device
from workbench.widgets.canvas.drawing import Drawn, Marker, PenStroke, data_ink
from workbench.widgets.canvas.overlay import Cell, GripShape, Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import LIGHT, tokens

# While something is dragged the pixels may take this long; else they follow when it is let go.
PIXELS_MS = 2.0


class CurveView(FigureView):
    """Shows the smooth curves over their pixels, with what is switched on."""

    card: CurveCard

    def __init__(
        self,
        focus: CurveFocus,
        canvas: PixelCanvas,
        second: PixelCanvas,
        card: CurveCard,
        docks: CurveDocks,
    ) -> None:
        super().__init__(focus.session, canvas, second, card)
        self.focus = focus
        self.docks = docks
        self._pixels_ms = 0.0
        self._parted: tuple[tuple[object, ...], Parting | None] | None = None
        self._probe: list[Drawn] = []
        self._influence: tuple[tuple[object, ...], Array] = ((), np.zeros(0))
        self._kept: tuple[tuple[object, ...], list[CurvePoint], list[Handle]] = ((), [], [])

    def refresh(self, tool: Tool, drag: HandleDrag) -> None:
        """Everything anew, from the session alone."""
        session, sheet = self.session, self.sheet
        self.focus.cell_px = self.canvas.view.cell / self.canvas.devicePixelRatioF()
        busy = tool.busy
        parting = self._parting(tool) if busy else None
        if not busy:
            self._parted = None
        if not busy or (parting is None and self._pixels_ms < PIXELS_MS):
            before = time.perf_counter()
            now = tokens()
            shown = picture if "pixels" in self.focus.shown else pale_picture
            self.canvas.set_picture(shown(sheet, now), packed(now.canvas))
            self._pixels_ms = (time.perf_counter() - before) * 1e3
        chosen = set(session.state.selection)
        selected = [figure for figure in session.frames.sheet.figures if figure.id in chosen]
        others = [f for f in sheet.figures if f.visible and not isinstance(f, Curve)]
        marked = [f for f in selected if not isinstance(f, Curve)]
        overlay = Overlay(
            ideal=tuple(chain.from_iterable(outlines(sheet, others))),
            outlined=tuple(chain.from_iterable(outlines(sheet, marked))),
            handles=tuple(self._grips(parting is not None)) if len(selected) == 1 else (),
            drawn=tuple(self.drawn() if parting is None else self._moving(parting)),
            still=None if parting is None else parting.still,
            snap=self._snapped(),
        )
        overlay = with_asked(with_band(overlay, tool.band), session.state.asked(FIGURES))
        overlay = with_answer(overlay, session.run.answered)
        self.canvas.set_overlay(overlay if self.box is None else self.box.over(overlay))
        if not busy or not isinstance(tool, CurveSelectTool):
            self.card.refresh(tool if isinstance(tool, FigureTool) else None, selected, "")
        (self.docks.refresh_soon if busy else self.docks.refresh)()

    def refresh_probe(self, drawn: list[Drawn]) -> None:
        """Show what a tool that only looks has to show, over what is there."""
        self._probe = drawn

    def _parting(self, tool: Tool) -> Parting | None:
        """While points of a long curve are dragged: what stays, painted once, and what moves."""
        curve, moving = self.focus.curve, self.focus.moving
        if curve is None or not moving or not isinstance(tool, CurveSelectTool):
            return None
        if self._parted is None or self._parted[0] != (curve.id, moving, self.canvas.view):
            sheet = self.sheet
            numbers = tuple(k for k, point in enumerate(curve.points_world) if point.id in set(moving))
            self._region(curve, [])
            below = [*others(sheet, curve), *beside(sheet, curve)]
            made = parted(
                sheet,
                curve,
                numbers,
                self._influence[1],
                below,
                self._grips(False),
                "polygon" in self.focus.shown,
            )
            self._parted = (curve.id, moving, self.canvas.view), made
        return self._parted[1]

    def _moving(self, parting: Parting) -> list[Drawn]:
        """What is drawn anew at every step of a drag."""
        curve, shown = self.focus.curve, self.focus.shown
        sheet = self.sheet
        if curve is None:
            return []
        drawn: list[Drawn] = [*self._region(curve, [])]
        if curve.spline == "bezier_path" and "polygon" in shown:
            drawn += control_polygon(sheet, curve, self.focus.numbers(curve))
        drawn += moving_part(sheet, curve, parting)
        if "construction" in shown:
            drawn += self._construction(curve)
        return drawn

    def drawn(self, number: int | None = None, whole: Sheet | None = None) -> list[Drawn]:
        """The curves and what is shown of the one that is worked on, from back to front, now or at a step."""
        curve, shown = self.focus.curve, self.focus.shown
        sheet = whole or self.sheet
        drawn = others(sheet, curve)
        if curve is None or not curve.visible:
            return drawn
        chosen = self.focus.numbers(curve)
        drawn += self._region(curve, chosen)
        drawn += marks(sheet, curve, shown, self.focus.u)
        drawn += beside(sheet, curve)
        if "polygon" in shown:
            drawn += control_polygon(sheet, curve, chosen)
        drawn += curve_line(sheet, curve)
        if "names" in shown and self.focus.selected is not None:
            drawn += names(sheet, curve)
        if "construction" in shown:
            drawn += self._construction(curve, number)
        drawn += self._probe
        if 0 <= self.focus.hovered < len(curve.points_world):
            x, y = device_points(sheet, curve)[self.focus.hovered].tolist()
            drawn.append(Marker(x, y, data_ink(self.focus.hovered), "ring", 17))
        return drawn

    def _construction(self, curve: Curve, number: int | None = None) -> list[Drawn]:
        """What the stepped text draws, now or at a step; before the first the whole construction at u.

        While the run waits, as under a drag, its text is drawn as far as it had come, on the curve as it is.
        """
        sheet, share = self.sheet, self.focus.u
        run = self.stepped_run()
        if run is not None and run.entry is not None and run.entry.slug not in constructions_of(curve):
            run = None
        before = run is not None and number is None and not (run.number or run.detail or run.ask_first)
        reached = None if run is None or before else run.own_call(number)
        text = construction_of(curve, "" if reached is None else self.session.state.subject.entry)
        calls = curve_calls(sheet, curve, text, share)
        if not calls:
            return []
        ((entry, arguments, _limit),) = calls
        everything = emitted(calls[0])
        if reached is None or run is None:
            marks = entry.marks(arguments, {}, everything, True)
        elif run.entry is entry and all(map(same, arguments, run.arguments)):
            marks = run.marks(number)
        else:
            marks = entry.marks(arguments, {}, everything[: len(reached.emitted)], False)
        drawn: list[Drawn] = [*on_device(sheet, entry.frame, marks)]
        arrived = reached is None or len(reached.emitted) == len(everything)
        if arrived or "u" not in entry.parameter_names:
            drawn += place_at(sheet, curve, share)
        return drawn

    def _snapped(self) -> Cell | None:
        """The pixel that a dragged point has snapped to."""
        curve, moving = self.focus.curve, self.focus.moving
        if curve is None or not moving or not self.focus.snaps:
            return None
        held = next((point for point in curve.points_world if point.id == moving[0]), None)
        if held is None:
            return None
        x, y = figure_map(self.sheet, curve).point(held.x, held.y)
        return round_half_up(x), round_half_up(y)

    def _region(self, curve: Curve, chosen: list[int]) -> list[PenStroke]:
        """What follows the points that are dragged, or, where that is switched on, those that are chosen."""
        numbers = tuple(chosen) if "influence" in self.focus.shown else ()
        if self.focus.moving:
            moving = frozenset(self.focus.moving)
            numbers = tuple(k for k, point in enumerate(curve.points_world) if point.id in moving)
        if not numbers:
            self._influence = (), np.zeros(0)
            return []
        # What follows a point hardly changes while it is dragged, and asking for it takes two curves more.
        key = (curve.id, curve.spline, len(curve.points_world), numbers)
        if self._influence[0] != key or not self.focus.moving:
            self._influence = key, influence(curve, numbers)
        return region(self.sheet, curve, self._influence[1])

    def _grips(self, moving: bool) -> list[Handle]:
        """The points, handles and tangents of the selected curve, or only those that are being dragged."""
        curve = self.focus.selected
        if curve is None:
            return []
        sheet, place = self.sheet, f"{self.sheet.id}/{curve.id}"
        shown = np.flatnonzero(handles_shown(curve, self.focus.numbers(curve))).tolist()
        if moving:
            held = frozenset(self.focus.moving)
            numbers = tuple(k for k, point in enumerate(curve.points_world) if point.id in held)
            shown = [k for k in with_handles(curve, numbers) if k in set(shown)]
        points = [curve.points_world[k] for k in shown]
        scale = figure_map(sheet, curve)
        path = curve.spline == "bezier_path"

        def grip(k: int, point: CurvePoint) -> Handle:
            shape: GripShape = (
                "round" if path and k % 3 else "square" if point.joint == "corner" else "diamond"
            )
            x, y = scale.point(point.x, point.y)
            chosen = point.id in self.focus.points
            return Handle(f"{place}/{point.id}/x", "", x, y, chosen, shape if path else "round")

        # Of a thousand points one is dragged: the grips of those that stay are kept.
        key = (place, tuple(shown) if path else len(points), self.focus.points, scale, curve.spline)
        kept, before, made = self._kept
        if kept == key:
            grips = [
                old if was is now else grip(k, now)
                for k, was, now, old in zip(shown, before, points, made, strict=True)
            ]
        else:
            grips = [grip(k, point) for k, point in zip(shown, points, strict=True)]
        self._kept = key, points, grips
        grips = list(grips)
        for k, (x, y) in tangent_ends(sheet, curve).items():
            grips.append(Handle(f"{place}/{curve.points_world[k].id}/tangent_x", "", x, y))
        return grips

    def describe(self, x: int, y: int) -> str:
        """A cell, and what painted it; while something is dragged only the cell, since that is quick."""
        return f"({x}, {y})" if self.focus.moving else super().describe(x, y)

    def on_paper(self, number: int | None = None) -> Composition:
        """What is shown, or one step of the run, in the light theme, with plain spots for the points."""
        sheet, curve = self.session.frames.sheet, self.focus.curve
        shown = picture if "pixels" in self.focus.shown else pale_picture
        drawn = self.drawn(number, sheet)
        if curve is not None and "polygon" in self.focus.shown and len(curve.points_world) < MANY:
            drawn += [Marker(x, y, CURVE_INK, "ring", 7) for x, y in device_points(sheet, curve).tolist()]
        return Composition(shown(sheet, LIGHT), packed(LIGHT.canvas), Overlay(drawn=tuple(drawn)))
