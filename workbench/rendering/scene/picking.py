"""What of a scene is at a place of its picture: the object, its face, and the point of it that is seen."""

from typing import NamedTuple

import numpy as np

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.geometry.meshes import Array
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint


class Pick(NamedTuple):
    """The id of an object, the number of its face, and the point of that which is seen, in the world."""

    thing: str
    face: int
    place: tuple[float, float, float]


def pick(scene: Scene, size: Size, window: Rectangle, x: float, y: float) -> Pick | None:
    """What is nearest at a place of the picture, pixels, y upwards; None where nothing is."""
    viewpoint = Viewpoint.of(scene.camera, size, window, np.zeros((0, 3)))
    nearest, best = np.inf, None
    visible = [thing for thing in scene.objects if thing.visible]
    for thing, (mesh, (triangles, faces), _material, lasting) in zip(visible, placed(scene), strict=True):
        drawn = viewpoint.drawn(mesh.vertices, triangles, lasting.box)
        a, b, c = drawn.corners[drawn.triangles].transpose(1, 0, 2)
        area = _cross(a, b, c[:, 0], c[:, 1])
        shares = np.stack([_cross(b, c, x, y), _cross(c, a, x, y), _cross(a, b, x, y)])
        inside = np.flatnonzero(((shares * np.sign(area)) >= 0).all(axis=0) & (area != 0))
        if len(inside):
            depths = np.stack([a[inside, 2], b[inside, 2], c[inside, 2]])
            depth = (shares[:, inside] * depths).sum(axis=0) / area[inside]
            first = int(depth.argmin())
            if depth[first] < nearest:
                nearest = float(depth[first])
                best = thing.id, int(drawn.of_owners(faces)[inside[first]])
    return None if best is None else Pick(*best, _in_space(viewpoint, x, y, nearest))


def _in_space(viewpoint: Viewpoint, x: float, y: float, depth: float) -> tuple[float, float, float]:
    """The point of the world that comes to a place of the picture, pixels, at this depth."""
    device = viewpoint.device
    flat = (x - device[0, 2]) / device[0, 0], (y - device[1, 2]) / device[1, 1]
    place = np.linalg.solve(viewpoint.matrix, [*flat, depth, 1.0])
    at_x, at_y, at_z = (place[:3] / place[3]).tolist()
    return at_x, at_y, at_z


def _cross(a: Array, b: Array, x: Array | float, y: Array | float) -> Array:
    turn: Array = (b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (b[:, 1] - a[:, 1]) * (x - a[:, 0])
    return turn
