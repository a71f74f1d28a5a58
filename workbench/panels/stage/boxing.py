"""The box around what is selected on a panel's canvas: what it does becomes edits, one step of undo each."""

import math
from collections.abc import Callable, Sequence
from itertools import chain

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from workbench.algorithms.transforms import Matrix, rotation_about, scaling_about, shear, translation
from workbench.document.model import AnyFigure, Document
from workbench.document.transforms.edits import Applied, applied, baked, remove_transforms
from workbench.document.transforms.names import undo_names
from workbench.geometry.transform_box import Box, Point
from workbench.language import _
from workbench.panels.stage.gesture import Gesture
from workbench.panels.stage.outline import Curve, outlines
from workbench.rendering import device_map
from workbench.rendering.extents import extent_of
from workbench.rendering.mapping import Box as Extent
from workbench.rendering.mapping import DeviceMap
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.transform_box import TransformBox

_HALF_TURN = np.diag([-1.0, -1.0])
LIVE_WEIGHT = 80
"""Up to so many points and figures, in their weight, each step of a drag changes the document at once."""
REST_MS = 80
_OF_A_FIGURE = 6
QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
"""A quarter turn to the left, exactly."""


def step_name(kind: str, mirrored: bool = False) -> str:
    """The step of undo of a drag of this kind."""
    if mirrored:
        return _("Mirror and scale")
    return {"move": _("Move"), "rotate": _("Rotate"), "scale": _("Scale"), "shear": _("Shear")}[kind]


class Boxing(QObject):
    """Shows ``box`` around what is selected while it is ``on``, and does what box, form or commands ask for.

    ``gesture`` is that of the tool that selects, so that whoever asks whether something is being dragged
    sees these drags too. ``began`` and ``ended`` enclose a drag; ``said`` sends what an edit has to say.
    """

    began = Signal()
    ended = Signal()
    said = Signal(str)

    def __init__(self, session: Session, canvas: PixelCanvas, gesture: Gesture, whole_moves: bool) -> None:
        super().__init__(canvas)
        self.session, self.gesture = session, gesture
        self.on = False
        self.box = TransformBox(canvas, whole_moves)
        self._of: tuple[str, ...] = ()
        self._pivot: Point | None = None
        self._placed = False
        self._known: Document | None = None
        self._pivot_before: Point | None = None
        self._start_pivot: Point = (0.0, 0.0)
        self._told: tuple[tuple[str, str], ...] = ()
        self._outlines: list[Curve] | None = None
        self._waiting: tuple[Matrix, str] | None = None
        # Where the hand rests the picture follows, of however much.
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self._catch_up)
        self.box.began.connect(self._begin)
        self.box.changed.connect(self._drag)
        self.box.ended.connect(self._end)
        self.box.cancelled.connect(self._cancel)
        self.box.pivot_moved.connect(self._place_pivot)

    # What is boxed

    def selected(self) -> list[AnyFigure]:
        """The selected figures of the sheet, from back to front."""
        chosen = set(self.session.state.selection)
        return [figure for figure in self.session.frames.sheet.figures if figure.id in chosen]

    def boxed(self) -> tuple[str, ...]:
        """The ids of what the box is around."""
        return tuple(figure.id for figure in self.selected())

    def extent(self) -> Extent | None:
        """How far that reaches, device; None where there is nothing to be seen."""
        return extent_of(self.session.frames.sheet, self.selected())

    def outlines(self) -> list[Curve]:
        """That as polylines (n, 2), where the first view shows them, device."""
        first = replace(self.session.frames.sheet, views=self.session.sheet.views[:1])
        seen = [figure for figure in self.selected() if figure.visible]
        return list(chain.from_iterable(outlines(first, seen)))

    def weight(self) -> int:
        """How much is to be changed at each step of a drag, and drawn anew."""
        return sum(len(figure.points_world) + _OF_A_FIGURE for figure in self.selected())

    def transformed(self, document: Document, matrix: Matrix) -> Applied:
        """The document with that under a matrix (3, 3), world. Raises: DocumentError."""
        return applied(document, self.boxed(), matrix)

    # The box

    def switch(self, on: bool) -> None:
        """Show the box, or show it no longer."""
        self.on = on
        if not on:
            self._let_go()
            self._forget_pivot()
        self.follow()

    def follow(self) -> None:
        """Put the box around what is selected now."""
        if self.box.dragging:
            return
        of = self.boxed()
        if of != self._of or (not self._placed and self.session.document is not self._known):
            self._forget_pivot()
        self._of = of
        extent = self.extent() if self.on else None
        if extent is None:
            if self.box.box is not None:
                self.box.set_box(None)
            return
        xmin, ymin, xmax, ymax = extent
        box = Box((xmin + xmax) / 2, (ymin + ymax) / 2, xmax - xmin, ymax - ymin)
        pivot = self._pivot or box.centre
        if (box, pivot) != (self.box.box, self.box.pivot):
            self.box.set_box(box, pivot)

    def _forget_pivot(self) -> None:
        self._pivot, self._placed = None, False

    def _place_pivot(self, x: float, y: float) -> None:
        self._pivot, self._placed = (x, y), True

    @property
    def pivot_world(self) -> Point | None:
        """What is turned and scaled about, world; None without a box."""
        if self.box.box is None:
            return None
        return device_map(self.session.sheet).world_point(*self.box.pivot)

    def put_pivot(self, x: float, y: float) -> None:
        """Turn and scale about another point, world."""
        self._place_pivot(*device_map(self.session.sheet).point(x, y))
        self.follow()

    def _begin(self, _handle: str) -> None:
        self._start()
        if self.weight() > LIVE_WEIGHT:
            self._outlines = self.outlines()
        self.began.emit()

    def _start(self) -> None:
        self._told, self._start_pivot, self._pivot_before = (), self.box.pivot, self._pivot
        self.gesture.begin()

    def _drag(self, matrix: Matrix, kind: str, numbers: dict[str, float]) -> None:
        mirrored = kind == "scale" and min(numbers["sx"], numbers["sy"]) < 0
        name = step_name(kind, mirrored)
        if self._outlines is None:
            self._transform(matrix, name)
        else:
            self._waiting = matrix, name
            self._rest.start()

    def _catch_up(self) -> None:
        """Let the document come to where the outlines are, in the midst of a drag."""
        waiting, self._waiting = self._waiting, None
        if waiting is not None:
            self._transform(*waiting)

    @property
    def moving(self) -> list[Curve] | None:
        """Where the outlines of what is boxed have come to, device, in a drag of so much that the document
        only follows when the hand rests; None while it has followed, and else."""
        if self._outlines is None or self._waiting is None:
            return None
        matrix = self._waiting[0]
        return [line @ matrix[:2, :2].T + matrix[:2, 2] for line in self._outlines]

    def _transform(self, matrix: Matrix, name: str) -> None:
        """Show what was boxed when the gesture began under a matrix, device; the pivot goes with it."""
        device = _matrix_of(device_map(self.session.sheet))
        world = np.linalg.inv(device) @ matrix @ device
        world[2] = 0.0, 0.0, 1.0
        if self._show(lambda document: self.transformed(document, world), name):
            x, y, _one = (matrix @ [*self._start_pivot, 1.0]).tolist()
            self._pivot, self._known = (x, y), self.session.document

    def _show(self, change: Callable[[Document], Applied], name: str) -> bool:
        def edit(document: Document) -> Document:
            made = change(document)
            self._told = made.told
            return made.document

        return self.gesture.show(edit, name)

    def _end(self) -> None:
        waiting = self._let_go()
        if waiting is not None:
            self._transform(*waiting)
        self._finish()
        self.ended.emit()

    def _let_go(self) -> tuple[Matrix, str] | None:
        """What the document has still to follow, which nothing waits for any longer."""
        self._rest.stop()
        waiting, self._waiting, self._outlines = self._waiting, None, None
        return waiting

    def _finish(self) -> None:
        """Keep what the gesture made, and say what of it went into chains."""
        if self.gesture.busy:
            self.gesture.commit()
        if sentences := dict.fromkeys(sentence for _figure, sentence in self._told):
            self.said.emit(" ".join(sentences))

    def _cancel(self) -> None:
        self._let_go()
        self.gesture.cancel()
        self._pivot, self._known = self._pivot_before, self.session.document
        self.ended.emit()

    # Numbers that are typed, and commands

    def typed(self, kind: str, first: float, second: float, scrubbing: bool = False) -> None:
        """Do what a form says, about the pivot: "move" by (first, second), "rotate" by ``first`` degrees,
        "scale" by factors, "shear" by sh_x and sh_y; world. More comes while ``scrubbing``.
        """
        if self.box.box is None:
            return
        if not self.gesture.busy:
            self._start()
        scale = device_map(self.session.sheet)
        x, y = scale.world_point(*self._start_pivot)
        match kind:
            case "move":
                matrix = translation(first, second)
            case "rotate":
                matrix = rotation_about(math.radians(first), x, y)
            case "scale":
                matrix = scaling_about(first, second, x, y)
            case _:
                matrix = shear(first, second, x, y)
        device = _matrix_of(scale)
        name = step_name(kind, kind == "scale" and min(first, second) < 0)
        self._transform(device @ matrix @ np.linalg.inv(device), name)
        if not scrubbing:
            self._finish()

    def end_scrub(self) -> None:
        """What was scrubbed stays, as one step of undo."""
        self._finish()

    def turn(self, left: bool) -> None:
        """A quarter turn about the pivot, or about the middle; pixels come to lie on pixels."""
        self._at_once(QUARTER if left else _HALF_TURN @ QUARTER, _("Rotate 90°"), True)

    def flip(self, axis: str) -> None:
        """Mirror left to right, axis "x", or upside down, "y", at the pivot, or in the middle."""
        across = axis == "x"
        name = _("Flip horizontally") if across else _("Flip vertically")
        self._at_once(np.diag([-1.0, 1.0] if across else [1.0, -1.0]), name, False)

    def _at_once(self, linear: Matrix, name: str, on_pixels: bool) -> None:
        """Do ``linear`` (2, 2) about the pivot on the device."""
        extent = self.extent()
        if extent is None:
            self.said.emit(_("Select something visible first."))
            return
        self.follow()
        pivot = self._pivot or ((extent[0] + extent[2]) / 2, (extent[1] + extent[3]) / 2)
        if on_pixels and (pivot[0] - pivot[1]) % 1.0:
            pivot = math.floor(pivot[0]), math.floor(pivot[1])
        matrix = np.eye(3)
        matrix[:2, :2] = linear
        matrix[:2, 2] = np.asarray(pivot) - linear @ np.asarray(pivot)
        self._start()
        self._start_pivot = pivot
        self._transform(matrix, name)
        self._finish()

    def bake(self) -> None:
        """Let the points of what is selected be where their chains take them."""
        self._chained(baked, undo_names()["bake"])

    def remove(self) -> None:
        """Take what is selected out of its chains."""
        self._chained(_without_chains, undo_names()["remove_transforms"])

    def _chained(self, change: Callable[[Document, Sequence[str]], Applied], name: str) -> None:
        """Change those of the selected figures that have chains."""
        figures = [figure.id for figure in self.selected() if figure.transforms]
        if not figures:
            self.said.emit(_("Nothing that is selected has transforms."))
            return
        self._start()
        self._show(lambda document: change(document, figures), name)
        self._finish()


def _without_chains(document: Document, figures: Sequence[str]) -> Applied:
    return Applied(remove_transforms(figures)(document), ())


def _matrix_of(scale: DeviceMap) -> Matrix:
    return np.array([(scale.sx, 0.0, scale.tx), (0.0, scale.sy, scale.ty), (0.0, 0.0, 1.0)])
