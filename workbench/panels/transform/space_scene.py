"""What is seen of an object in space under its chain: at which stage, from where, its axis, one vertex."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import projection, transforms
from workbench.algorithms.transforms import Matrix
from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.geometry.meshes import edges_of
from workbench.rendering.subjects.space_chain import TURN, acting, last_turn, upto, vertex_of

Points = NDArray[np.float64]
MOST_EDGES = 4_000
STEPS = 7


@dataclass(frozen=True, slots=True, eq=False)
class SpaceScene:
    """Places (n, 3) in the world: of the object as it was made, at the stage that is looked at (None when
    that is the whole chain) and under all of it, with its ``edges`` (e, 2).

    ``every`` (m, 3) are the places of all stages. ``axis`` are two places of the axis of the last rotation as
    this stage has it, (2, 3), or None; ``way`` (k, 3) is where the vertex that is followed has been.
    """

    made: Points
    stage: Points | None
    image: Points
    every: Points
    edges: NDArray[np.int64]
    axis: Points | None
    way: Points


def scene_of(thing: Object, subject: Subject, step: int) -> SpaceScene:
    """An object after ``step`` of the seven steps of its last rotation; 0 and 7 are before and after it."""
    mesh = thing.mesh
    vertex = vertex_of(thing, subject)
    whole = upto(thing, len(acting(thing)))
    image = _placed(whole, mesh.vertices)
    edges = edges_of(mesh)[:MOST_EDGES]
    turn = last_turn(thing)
    if turn is None:
        way = np.array([mesh.vertices[vertex], image[vertex]])
        every = np.concatenate([mesh.vertices, image])
        return SpaceScene(mesh.vertices, None, image, every, edges, None, way)
    at, link = turn
    seven = [np.eye(4)]  # of the rotation alone: its axis is given where it acts
    for part in link.unfolded():
        seven.append(part.matrix @ seven[-1])
    made = [matrix @ upto(thing, at) for matrix in seven]
    axis = _placed(seven[step], np.array([link.pivot, link.second]))
    places = [
        mesh.vertices[vertex],
        *(_placed(matrix, mesh.vertices[vertex : vertex + 1])[0] for matrix in made),
    ]
    stage = _placed(made[step], mesh.vertices) if 0 < step < STEPS else None
    every = np.concatenate([mesh.vertices, image, *(_placed(matrix, mesh.vertices) for matrix in made)])
    return SpaceScene(mesh.vertices, stage, image, every, edges, axis, np.array(places[: step + 2]))


def _placed(matrix: Matrix, points: Points) -> Points:
    return transforms.transform_points(matrix, points)


def seen_from(angle_y: float, angle_x: float) -> Matrix:
    """The parallel projection (4, 4) from these angles, degrees."""
    return projection.axonometric(math.radians(angle_y), math.radians(angle_x))


def stepped_turn(slug: str, step: int) -> int:
    """Which of the seven steps a run is at; 0 where something else is run."""
    return min(step, STEPS) if slug == TURN else 0
