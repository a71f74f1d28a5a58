"""Gestures on the canvas: whatever the pointer does between press and release is one step of undo.

A gesture keeps the document that it began with and builds every edit from it, so that what the pointer did on
its way leaves no trace, and Escape brings exactly that document back.
"""

from itertools import count

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal

from workbench.document.edits import Edit, move_points, set_attributes
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document
from workbench.geometry.conventions import round_half_up
from workbench.language import _
from workbench.panels.stage.outline import Curve
from workbench.rendering import device_map
from workbench.session.session import Session

Cell = tuple[int, int]
Modifiers = Qt.KeyboardModifier
_tokens = count(1)


def snapped(x: float, y: float) -> Cell:
    """The pixel whose centre is nearest."""
    return round_half_up(x), round_half_up(y)


class Gesture(QObject):
    """One step of undo under way on ``session``. ``failed`` sends the sentence of a refused edit."""

    failed = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self._before: Document | None = None
        self._shown: Document | None = None
        self._merge = ""

    @property
    def busy(self) -> bool:
        """Whether a gesture is under way."""
        return self._before is not None

    def begin(self) -> None:
        """What follows is one step of undo."""
        self.session.end_merge()
        self._before = self._shown = self.session.document
        self._merge = f"gesture {next(_tokens)}"

    def show(self, edit: Edit, name: str) -> bool:
        """Make ``edit`` of the document that the gesture began with. False when it was refused, or when the
        gesture is over because something else was done meanwhile.
        """
        before = self._before
        if before is None:
            return False
        if self.session.document is not self._shown:
            # Made of the document that it began with, it would take back what was done.
            self._before = None
            return False
        try:
            self.session.apply(lambda _document: edit(before), name, self._merge)
        except DocumentError as problem:
            self.failed.emit(str(problem))
            return False
        self._shown = self.session.document
        return True

    def commit(self) -> None:
        """End the gesture, keeping what it made."""
        self._before = None
        self.session.end_merge()

    def cancel(self) -> None:
        """End the gesture as if it had not begun."""
        if self._before is not None:
            self.show(lambda document: document, "")
            self.commit()

    def world(self, cell: Cell) -> tuple[float, float]:
        """World coordinates of a pixel's centre."""
        return device_map(self.session.sheet).world_point(*cell)


class Tool(Gesture):
    """A tool; its methods take device coordinates. ``tag`` is said beside the pointer, at pixel ``snap``."""

    name = ""
    icon = ""
    key = ""
    shape = Qt.CursorShape.CrossCursor

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.tag = ""
        self.band: Curve | None = None
        self.snap: Cell | None = None

    @property
    def title(self) -> str:
        """What it is called."""
        return ""

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
    """Drags one handle: a control point or a radius."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.held = ""
        self.tag = ""

    def press(self, address: str) -> None:
        """Take hold of the handle with this address."""
        self.held = address
        self.begin()

    def drag(self, x: float, y: float) -> Cell:
        """Put it to the nearest pixel, which is returned."""
        cell = snapped(x, y)
        _sheet, figure_id, *rest = self.held.split("/")
        sheet = self.session.sheet
        figure = next((f for f in sheet.figures if f.id == figure_id), None)
        if figure is None:
            return cell
        scale = device_map(sheet)
        if len(rest) == 2:
            self.show(move_points({self.held: self.world(cell)}), _("Move point"))
            self.tag = self._neighbour_text(figure, rest[0], cell)
            return cell
        centre = snapped(*scale.point(figure.points_world[0].x, figure.points_world[0].y))
        if rest[0] == "radius_world":
            radius = radius_between(centre, cell)
            value, self.tag = radius / abs(scale.sx), f"r = {radius}"
        else:
            along_x = rest[0] == "radius_x_world"
            radius = abs(cell[0] - centre[0]) if along_x else abs(cell[1] - centre[1])
            value = radius / abs(scale.sx if along_x else scale.sy)
            self.tag = f"{'rx' if along_x else 'ry'} = {radius}"
        self.show(set_attributes({self.held: value}), _("Change radius"))
        return cell

    def _neighbour_text(self, figure: AnyFigure, point: str, cell: Cell) -> str:
        ids = [p.id for p in figure.points_world]
        if len(ids) < 2 or point not in ids:
            return f"({cell[0]}, {cell[1]})"
        other = figure.points_world[ids.index(point) - 1 if ids.index(point) else 1]
        return span_text(snapped(*device_map(self.session.sheet).point(other.x, other.y)), cell)

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
    return _("({x}, {y})\nlength {length:.1f}, slope {slope}, {angle:.0f}°").format(
        x=end[0], y=end[1], length=length, slope=slope, angle=angle
    )
