"""Gestures on the canvas: whatever the pointer does between press and release is one step of undo.

A gesture keeps the document that it began with and builds every edit from it, so that what the pointer did on
its way leaves no trace, and Escape brings exactly that document back.
"""

import math
from itertools import count

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from workbench.algorithms.numerals import with_minus
from workbench.document.edits import Edit, move_points, set_attributes
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document
from workbench.document.transforms.chains import read_only_reason
from workbench.geometry.conventions import round_half_up
from workbench.language import _
from workbench.panels.stage.outline import Curve
from workbench.rendering import device_map, figure_map
from workbench.rendering.mapping import FigureMap
from workbench.session.session import Session

Cell = tuple[int, int]
Modifiers = Qt.KeyboardModifier
_tokens = count(1)


def snapped(x: float, y: float) -> Cell:
    """The pixel whose centre is nearest."""
    return round_half_up(x), round_half_up(y)


class Gesture(QObject):
    """One step of undo under way on ``session``. ``failed`` sends the sentence of a refused edit.

    ``tag`` is said beside the pointer meanwhile.
    """

    failed = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self._before: Document | None = None
        self._shown: Document | None = None
        self._merge = ""
        self._begun = False
        self.tag = ""

    @property
    def overtaken(self) -> bool:
        """Whether something else was done meanwhile, such as an undo: then it is over."""
        return self._before is not None and self.session.document is not self._shown

    @property
    def busy(self) -> bool:
        """Whether a gesture is under way."""
        return self._before is not None

    @property
    def begun(self) -> bool:
        """Whether the hand has not let go yet, be the gesture over or not."""
        return self._begun

    def begin(self) -> None:
        """What follows is one step of undo."""
        self.session.end_merge()
        self._begun = True
        self._before = self._shown = self.session.document
        self._merge = f"gesture {next(_tokens)}"

    def show(self, edit: Edit, name: str) -> bool:
        """Make ``edit`` of the document that the gesture began with. False when it was refused, or when the
        gesture is over because something else was done meanwhile.
        """
        before = self._before
        if before is None:
            return False
        if self.overtaken:
            # Made of the document that it began with, it would take back what was done.
            self._before, self.tag = None, ""
            return False
        try:
            self.session.apply(edit, name, self._merge, on=before)
        except DocumentError as problem:
            self.failed.emit(problem.short)
            return False
        self._shown = self.session.document
        return True

    def commit(self) -> None:
        """End the gesture, keeping what it made."""
        self._before, self._begun = None, False
        self.session.end_merge()

    def cancel(self) -> None:
        """End the gesture as if it had not begun."""
        if self._begun:
            self.show(lambda document: document, "")
            self.commit()

    def world(self, cell: Cell) -> tuple[float, float]:
        """World coordinates of a pixel's centre."""
        return device_map(self.session.sheet).world_point(*cell)


class Tool(Gesture):
    """A tool; its methods take device coordinates. ``tag`` is said at pixel ``snap``."""

    name = ""
    icon = ""
    key = ""
    shape = Qt.CursorShape.CrossCursor

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.band: Curve | None = None
        self.snap: Cell | None = None

    @property
    def title(self) -> str:
        """What it is called."""
        return ""

    @property
    def invitation(self) -> str:
        """How to draw with it on an empty sheet; with one that draws nothing, what to do instead."""
        return _("Choose a tool on the left to draw something.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """The left button came down; ``reach`` is how near counts as on a figure."""

    def move(self, x: float, y: float) -> None:
        """The pointer moved, button down or not."""

    def release(self, x: float, y: float) -> None:
        """The left button came up."""

    def finish(self) -> None:
        """Enter: end a gesture of several clicks."""

    def cancel(self) -> None:
        """Escape."""
        super().cancel()
        self.tag, self.band = "", None


class HandleDrag(Gesture):
    """Drags one handle, a control point or a radius, and writes it through the inverse of the figure's chain.

    Where there is none the handle stays, and ``failed`` says why.
    """

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.held = ""

    def press(self, address: str) -> None:
        """Take hold of the handle with this address."""
        self.held = address
        figure = self._figure()
        if figure is not None and (reason := read_only_reason(figure)):
            self.failed.emit(reason)
        else:
            self.begin()

    def _figure(self) -> AnyFigure | None:
        """The figure whose handle is held."""
        identity = self.held.split("/")[1]
        return next((figure for figure in self.session.frames.sheet.figures if figure.id == identity), None)

    def drag(self, x: float, y: float) -> Cell:
        """Put it to the nearest pixel, which is returned."""
        cell = snapped(x, y)
        if not self.busy:  # Escape let go of it, and the button is still down
            return cell
        sheet, figure = self.session.frames.sheet, self._figure()
        if figure is None:
            return cell
        _sheet, _figure, *rest = self.held.split("/")
        if len(rest) == 2:
            place = figure_map(sheet, figure).world_point(*cell)
            self.show(move_points({self.held: place}), _("Move point"))
            if self.busy:
                self.tag = self._neighbour_text(figure, rest[0], cell)
            return cell
        value = self._radius(figure, rest[0], cell)
        self.show(set_attributes({self.held: value}), _("Change radius"))
        return cell

    def _radius(self, figure: AnyFigure, name: str, cell: Cell) -> float:
        """The radius of this name, world, that reaches ``cell``: a whole number of pixels without a chain."""
        scale = figure_map(self.session.frames.sheet, figure)
        middle = figure.points_world[0]
        label = {"radius_x_world": "rx", "radius_y_world": "ry"}.get(name, "r")
        if isinstance(scale, FigureMap):
            x, y = scale.world_point(*cell)
            dx, dy = x - middle.x, y - middle.y
            radius = {"rx": abs(dx), "ry": abs(dy), "r": math.hypot(dx, dy)}[label]
            self.tag = f"{label} = {radius:.4g}"
            return radius
        centre = snapped(*scale.point(middle.x, middle.y))
        across, up = abs(cell[0] - centre[0]), abs(cell[1] - centre[1])
        pixels = {"rx": across, "ry": up, "r": radius_between(centre, cell)}[label]
        self.tag = f"{label} = {pixels}"
        return pixels / abs(scale.sy if label == "ry" else scale.sx)

    def _neighbour_text(self, figure: AnyFigure, point: str, cell: Cell) -> str:
        ids = [p.id for p in figure.points_world]
        if len(ids) < 2 or point not in ids:
            return f"({cell[0]}, {cell[1]})"
        other = figure.points_world[ids.index(point) - 1 if ids.index(point) else 1]
        return span_text(
            snapped(*figure_map(self.session.frames.sheet, figure).point(other.x, other.y)), cell
        )

    def release(self) -> None:
        """Let go of it."""
        self.held = self.tag = ""
        if self.busy:
            self.commit()

    def cancel(self) -> None:
        """Bring it back."""
        super().cancel()
        self.held = self.tag = ""


def radius_between(centre: Cell, at: Cell) -> int:
    return round_half_up(float(np.hypot(at[0] - centre[0], at[1] - centre[1])))


def span_text(start: Cell, end: Cell) -> str:
    """Where ``end`` is, how long and how steep the way there is."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = float(np.hypot(dx, dy))
    slope = f"{dy / dx:.3g}" if dx else (_("upright") if dy else "0")
    angle = float(np.degrees(np.arctan2(dy, dx)))
    told = _("({x}, {y})\nlength {length:.1f}, slope {slope}, {angle:.0f}°")
    return with_minus(told.format(x=end[0], y=end[1], length=length, slope=slope, angle=angle))
