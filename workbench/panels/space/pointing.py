"""What a click, a double click and the beginning of a turn mean: the vertex or the point that is there."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QObject, QPointF, Signal

from workbench.document.edits import set_attributes
from workbench.document.errors import DocumentError
from workbench.document.scene.edits import set_transforms
from workbench.document.scene.model import Object, Point3D
from workbench.document.subjects import Subject
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.control_net import NetPoint, coordinates
from workbench.panels.space.eye_view import EyeView
from workbench.panels.space.looking import Looking
from workbench.panels.space.object_handles import Handle, Handles, title_of_mode, with_drag
from workbench.panels.space.outside_view import OutsideView
from workbench.panels.space.solids_offered import title_of
from workbench.panels.space.stepped import Vertex
from workbench.rendering.scene.picking import Pick, pick
from workbench.rendering.subjects.projection import KIND

_MOST_FACES, _MOST_TURNED = 5_000, 200_000
_FLAT = _("The transforms of the object flatten it; change one of them first.")


class Pointing(QObject):
    """Over both views of a scene. ``stepped``: a vertex was chosen; ``said`` sends a sentence; ``pointed``,
    while ``follows``, the vertex (or -1) and the face (or -1) of the chosen object under the pointer."""

    stepped = Signal()
    pointed = Signal(int, int)
    said = Signal(str)

    def __init__(self, looking: Looking, eye: EyeView, outside: OutsideView, parent: QObject) -> None:
        super().__init__(parent)
        self._looking = looking
        self._eye = eye
        self._about: Point3D | None = None
        self._held: Object | None = None
        eye.turn_began.connect(self._begin_turn)
        eye.turned.connect(self._turn)
        eye.turn_ended.connect(self._end_turn)
        eye.framed.connect(self._centre)
        eye.clicked.connect(self._choose_in_picture)
        eye.hovered.connect(self._point)
        self.follows = False
        eye.handle_moved.connect(self._move)
        eye.point_moved.connect(self._move_point)
        eye.handle_left.connect(self._leave)
        outside.clicked.connect(lambda position: self._choose(outside, position))
        outside.framed.connect(lambda _position: outside.fit())

    def _point(self, position: QPointF) -> None:
        """Tell which part of the chosen object is there; of a large scene it would take too long."""
        by_keys = self._eye.cursor_at is not None
        if not (self.follows or by_keys):
            return
        if sum(len(thing.mesh.faces) for thing in self._eye.scene.objects) > _MOST_FACES:
            return
        chosen = self._looking.session.state.thing
        vertex, there = self._eye.vertex_at(position), at(self._eye, position)
        if by_keys:
            self.said.emit(self._named(vertex, there))
        self.pointed.emit(
            vertex.number if vertex is not None and vertex.thing == chosen else -1,
            there.face if there is not None and there.thing == chosen else -1,
        )

    def _named(self, vertex: Vertex | None, there: Pick | None) -> str:
        """What is at the cursor, in words."""
        names = {thing.id: title_of(thing) for thing in self._eye.scene.objects}
        if vertex is not None:
            return _("{name}, vertex {n}: Enter steps it").format(name=names[vertex.thing], n=vertex.number)
        if there is not None:
            return _("{name}, face {n}: Enter chooses it").format(name=names[there.thing], n=there.face)
        return _("nothing")

    # Turning

    def _begin_turn(self, position: QPointF) -> None:
        """A turn is about the point of the scene under the pointer; in a huge one about what is looked at."""
        faces = sum(len(thing.mesh.faces) for thing in self._eye.scene.objects if thing.visible)
        there = at(self._eye, position) if faces <= _MOST_TURNED else None
        self._about = None if there is None else Point3D(*there.place)

    def _turn(self, theta: float, phi: float) -> None:
        self.said.emit(self._looking.orbit(theta, phi, self._about))

    def _end_turn(self) -> None:
        self._about = None

    def _centre(self, position: QPointF) -> None:
        """Look at the point of the scene that is there, and bring it into the middle."""
        there = at(self._eye, position)
        if there is None:
            self._eye.fit()
        else:
            self._eye.middle, self._eye.keeps_fit = (0.0, 0.0), False
            self.said.emit(self._looking.centre(Point3D(*there.place)))
            self._eye.redraw()

    # Handles

    def _move(self, begun: Handles, handle: Handle, amount: float, every: bool) -> None:
        """Move, turn or scale the object that is held, as it was when the drag began; one step of undo."""
        session = self._looking.session
        scene = session.sheet.scene
        now = next((thing for thing in scene.objects if thing.id == begun.thing), None) if scene else None
        if now is None:
            return
        if self._held is None or self._held.id != now.id:
            self._held = now
        chain = with_drag(self._held, handle, amount, begun.centre, every).transforms
        if not chain[-1].id and len(now.transforms) == len(chain):  # the link of this drag is there already
            chain = (*chain[:-1], replace(chain[-1], id=now.transforms[-1].id))
        edit = set_transforms(now.id, chain)
        try:
            session.apply(edit, title_of_mode(handle.mode), f"handle {now.id}")
        except DocumentError as problem:
            self.said.emit(problem.short)

    def _move_point(self, point: NetPoint, place: Array) -> None:
        """Move a point of the chosen object, in its own coordinates."""
        session = self._looking.session
        scene = session.sheet.scene
        thing = next((each for each in scene.objects if each.id == point.thing), None) if scene else None
        if thing is None:
            return
        at_point = f"{session.sheet.id}/{thing.id}/{point.point}"
        try:
            values = coordinates(thing, place)
            edit = set_attributes({f"{at_point}/{name}": value for name, value in values.items()})
            session.apply(edit, _("Move a point"), f"point {point.point}")
        except (DocumentError, np.linalg.LinAlgError) as problem:
            self.said.emit(problem.short if isinstance(problem, DocumentError) else _FLAT)

    def _leave(self) -> None:
        self._held = None
        self._looking.session.end_merge()

    # Choosing

    def _choose_in_picture(self, position: QPointF) -> None:
        """A vertex of the picture is stepped; else the object there is chosen."""
        vertex = self._eye.vertex_at(position)
        if vertex is None:
            self._choose(self._eye, position)
            return
        subject = Subject(KIND, (vertex.thing,), arguments={"vertex": vertex.number})
        self._looking.session.update_state(thing=vertex.thing, subject=subject, step=0)
        self.stepped.emit()

    def _choose(self, view: EyeView | OutsideView, position: QPointF) -> None:
        there = at(view, position)
        self._looking.session.update_state(thing=there.thing if there else "")


def at(view: EyeView | OutsideView, position: QPointF) -> Pick | None:
    """What of the scene is at a place of a view, logical pixels."""
    ratio = view.devicePixelRatioF()
    x, y = position.x() * ratio - 0.5, view.device_size[1] - 0.5 - position.y() * ratio
    try:
        return pick(view.scene, view.device_size, view.window_world, x, y)
    except ValueError:  # what cannot be seen cannot be picked, and why is said already
        return None
