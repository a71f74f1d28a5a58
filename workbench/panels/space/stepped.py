"""What of the run on a scene is drawn in its pictures: a vertex on its way, or a polygon being clipped."""

from typing import NamedTuple

import numpy as np

from workbench.algorithms.projection.view_volume_views import HANDED_ON, TAKEN
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.strokes import short
from workbench.rendering.emissions import emitted
from workbench.rendering.subjects.projection import clips, is_of_a_vertex, vertex_of
from workbench.rendering.subjects.registry import calls_of
from workbench.session.session import Session

DIVIDED = 4
"""The stage at which a vertex has been divided by w, and has a place in the picture."""
_NOTHING = np.zeros((0, 4))


class Vertex(NamedTuple):
    """A corner of an object: its id, the number of the corner, and where it is in the world.

    ``rows`` are the coordinates (x, y, z, w) that it has had so far: in the world, in view coordinates, after
    the projection, after the division, on the device.
    """

    thing: str
    number: int
    place: tuple[float, float, float]
    rows: tuple[tuple[float, ...], ...] = ()

    @property
    def stage(self) -> int:
        """How many of the five it has."""
        return len(self.rows)


class Clipped(NamedTuple):
    """A polygon as a plane takes it (n, 4) and as far as it hands it on, and the rings done, homogeneous."""

    taken: Array = _NOTHING
    handed_on: Array = _NOTHING
    done: tuple[Array, ...] = ()


def vertex_on_its_way(session: Session) -> Vertex | None:
    """The vertex that is stepped, where it is in the world; None where it is none, or hidden."""
    sheet, subject = session.sheet, session.subject
    if not is_of_a_vertex(subject) or clips(subject):
        return None
    vertex = _vertex(sheet, subject)
    if vertex is None:
        return None
    (call,) = calls_of(sheet, subject)
    rows = emitted(call)[: session.run.step_number]
    return vertex._replace(rows=tuple(map(tuple, rows.tolist())))


def _vertex(sheet: Sheet, subject: Subject) -> Vertex | None:
    chosen = vertex_of(sheet, subject)
    if chosen is None or not chosen[0].visible:
        return None
    thing, number = chosen
    matrix = np.eye(4) if thing.matrix is None else thing.matrix
    x, y, z, _w = matrix @ [*thing.mesh.vertices[number], 1.0]
    return Vertex(thing.id, number, (float(x), float(y), float(z)))


def clipped_so_far(session: Session) -> Clipped | None:
    """How far the faces of an object have been clipped; None where something else is stepped."""
    if not is_of_a_vertex(session.subject) or not clips(session.subject):
        return None
    step, calls = session.run.step, calls_of(session.sheet, session.subject)
    if step is None or not session.run.runs(calls):
        return Clipped()
    rows = np.array(emitted(calls[0])[: step.emitted_to], np.float64).reshape(-1, 5)
    rings = tuple(rows[rows[:, 0] == ring, 1:] for ring in np.unique(rows[:, 0]))
    taken, handed_on = (
        np.array(list(step.tables[title][1]) if title in step.tables else (), np.float64).reshape(-1, 4)
        for title in (TAKEN, HANDED_ON)
    )
    return Clipped(taken, handed_on, rings)


def way_text(vertex: Vertex) -> str:
    """The coordinates that a vertex has now, by name."""
    name, stage = f"R{vertex.number}", vertex.stage
    if not stage:
        return name
    x, y, z, w = (short(value, 4) for value in vertex.rows[-1])
    written = {1: f"({x}, {y}, {z})", 2: f"({x}, {y}, {z})", 3: f"w = {w}", 4: f"({x}, {y})"}
    return f"{name} {written.get(stage, _('pixel ({x}, {y})').format(x=x, y=y))}"
