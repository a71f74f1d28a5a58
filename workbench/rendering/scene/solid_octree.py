"""Octrees of solids of a scene that have an equation: their calls, and their cells as the eye sees them."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.solids import implicit
from workbench.algorithms.solids.blobs import blob_middles
from workbench.algorithms.solids.implicit import EMPTY
from workbench.algorithms.solids.octree_cells import nodes_of
from workbench.algorithms.solids.octree_combined import octree_combined
from workbench.algorithms.solids.octree_of_solid import octree_of_solid
from workbench.algorithms.solids.octree_pairs import INTERSECTION
from workbench.document.scene import solids
from workbench.document.scene.model import Object, Scene
from workbench.geometry.meshes import Array, Index
from workbench.rendering.mapping import Call
from workbench.rendering.scene.viewpoint import Viewpoint

OCTREE, COMBINED = octree_of_solid.__name__, octree_combined.__name__
CUT = 3
"""Beside the operations on two solids: one is cut by a plane."""
LEAST_VOLUME = 1e-12


class Placed(NamedTuple):
    """A solid by its equation: the number of its shape and its measures, the matrix (3, 4) from the world
    into its coordinates, and the box (2, 3) around it in the world."""

    shape: int
    numbers: Array
    inverse: Array
    box: Array


class Cutting(NamedTuple):
    """What is done to an octree of this depth: an operation with another solid, or CUT, across an axis at a
    share of the cube's side."""

    depth: int
    operation: int = CUT
    axis: int = 2
    share: float = 0.5


def placed_solid(thing: Object) -> Placed | None:
    """An object by the equation of its solid; None where it has none, or is squeezed flat."""
    own = _equation(thing.solid)
    matrix = np.eye(4) if thing.matrix is None else thing.matrix
    if own is None or abs(np.linalg.det(matrix[:3, :3])) < LEAST_VOLUME:
        return None
    shape, numbers, (low, high) = own
    corners = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1).T
    world = corners @ matrix[:3, :3].T + matrix[:3, 3]
    box = np.stack([world.min(axis=0), world.max(axis=0)])
    inverse = np.asarray(np.linalg.inv(matrix)[:3], np.float64)
    return Placed(shape, np.array(numbers, np.float64), inverse, box)


def _equation(solid: solids.Solid) -> tuple[int, list[float], tuple[list[float], list[float]]] | None:
    """The shape and the numbers of a solid, and the box that it is in."""
    match solid:
        case solids.Sphere(radius=r):
            return implicit.ELLIPSOID, [r] * 3, ([-r] * 3, [r] * 3)
        case solids.Ellipsoid(r_x=a, r_y=b, r_z=c):
            return implicit.ELLIPSOID, [a, b, c], ([-a, -b, -c], [a, b, c])
        case solids.Torus(radius=R, thickness=r):
            return implicit.TORUS, [R, r], ([-R - r, -r, -R - r], [R + r, r, R + r])
        case solids.Cylinder(radius=r, height=h):
            return implicit.CYLINDER, [r, h], ([-r, 0.0, -r], [r, h, r])
        case solids.Cone(radius=r, height=h):
            return implicit.CONE, [r, h], ([-r, 0.0, -r], [r, h, r])
        case solids.Box(width=w, height=h, depth=d):
            half = [w / 2, h / 2, d / 2]
            return implicit.BLOCK, half, ([-each for each in half], half)
        case solids.Blobs(balls=n, spread=spread, tightness=a, threshold=T):
            middles = blob_middles(n, spread)
            reach = float(np.sqrt(np.log(n / T) / a))
            low, high = middles.min(axis=0) - reach, middles.max(axis=0) + reach
            return implicit.BLOBS, [a, T, *middles.ravel().tolist()], (low.tolist(), high.tolist())
    return None


def octree_things(scene: Scene) -> tuple[Object, ...]:
    """The visible objects that have an octree."""
    return tuple(thing for thing in scene.objects if thing.visible and placed_solid(thing) is not None)


def octree_call(things: tuple[Object, ...], depth: int) -> Call:
    """The call that makes the octree of the first of some objects, in a cube around all of them."""
    return Call(catalogue.get(OCTREE), _arguments(things, 0, depth))


def combined_call(things: tuple[Object, ...], cutting: Cutting) -> Call:
    """The call that combines the octree of the first of some objects with that of the second, or cuts it."""
    _shape, _numbers, _inverse, corner, size, _depth = _arguments(things, 0, cutting.depth)
    first = _nodes(things, 0, cutting.depth)
    if cutting.operation == CUT:
        at = float(corner[cutting.axis]) + cutting.share * size
        second, operation = _half_space(tuple(corner.tolist()), size, cutting, at), INTERSECTION
    else:
        second, operation = _nodes(things, 1, cutting.depth), cutting.operation
    return Call(catalogue.get(COMBINED), (first, second, operation, corner, size))


@lru_cache(maxsize=16)
def _arguments(
    things: tuple[Object, ...], number: int, depth: int
) -> tuple[int, Array, Array, Array, float, int]:
    placed = [each for each in map(placed_solid, things) if each is not None]
    low = np.min([each.box[0] for each in placed], axis=0)
    high = np.max([each.box[1] for each in placed], axis=0)
    size = float((high - low).max())
    shape, numbers, inverse, _box = placed[number]
    return shape, numbers, inverse, (low + high - size) / 2, size, depth


@lru_cache(maxsize=16)
def _nodes(things: tuple[Object, ...], number: int, depth: int) -> Index:
    arguments = _arguments(things, number, depth)
    return nodes_of(np.array(list(octree_of_solid(*arguments))), arguments[3], arguments[4])


@lru_cache(maxsize=16)
def _half_space(corner: tuple[float, ...], size: float, cutting: Cutting, at: float) -> Index:
    """What of a cube is below a place on an axis."""
    plane = np.append(np.eye(3)[cutting.axis], -at)
    low = np.array(corner)
    cells = octree_of_solid(implicit.HALF_SPACE, plane, np.eye(3, 4), low, size, cutting.depth)
    return nodes_of(np.array(list(cells)), low, size)


# As the eye sees them


class Faces(NamedTuple):
    """Sides of cells in the order to paint them: corners on the device (n, 4, 2), the state of the cell that
    each is of (n,), and the axis that it is across (n,)."""

    rings: Array
    states: Index
    axes: Index


_AROUND = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])


def sides_seen(cells: Array, corner: Array, size: float, viewpoint: Viewpoint) -> Faces:
    """The sides of cells (n, 5) that are turned to the viewer, those of the farthest first.

    The order is that of the octree: of eight octants the one in which the eye is comes last, those that it
    sees through one side before it. Sides between two cells of one size are left out, and what is not before
    the camera.
    """
    solid = cells[cells[:, 4] != EMPTY]
    solid = solid[_far_to_near(solid, corner, size, viewpoint.viewer)]
    rings, numbers, axes = [], [], []
    low, side = solid[:, :3], solid[:, 3:4]
    viewer = viewpoint.viewer
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        for upper in (0, 1):
            at = low[:, axis] + upper * side[:, 0]
            ahead = viewer[axis] - viewer[3] * at
            seen = np.flatnonzero(
                (ahead > 0 if upper else ahead < 0) & ~_covered(low, side[:, 0], axis, upper)
            )
            ring = np.zeros((len(seen), 4, 3))
            ring[:, :, axis] = at[seen, None]
            ring[:, :, others] = low[seen][:, None, others] + side[seen][:, None] * _AROUND
            rings.append(ring)
            numbers.append(seen)
            axes.append(np.full(len(seen), axis))
    number = np.concatenate(numbers)
    order = np.argsort(number, kind="stable")
    flat = viewpoint.homogeneous(np.concatenate(rings)[order].reshape(-1, 3)).reshape(-1, 4, 4)
    before = (flat[..., 3] > 0).all(axis=1) & (flat[..., 2] >= 0).all(axis=1)
    flat, kept = flat[before], number[order][before]
    device = viewpoint.device
    places = flat[..., :2] / flat[..., 3:] * device.diagonal()[:2] + device[:2, 2]
    return Faces(places, solid[kept, 4].astype(np.int64), np.concatenate(axes)[order][before])


def _far_to_near(cells: Array, corner: Array, size: float, viewer: Array) -> Index:
    """The order (n,) of cells from the farthest on: at each level by how many sides of the middle away from
    the eye's octant they are."""
    middles = cells[:, :3] + cells[:, 3:4] / 2
    keys: list[NDArray[np.int64]] = []
    side = size
    while side > cells[:, 3].min(initial=size) * 1.5:
        node = corner + side * np.floor((middles - corner) / side)
        inner = cells[:, 3] < side * 0.75
        of_eye = viewer[:3] - viewer[3] * (node + side / 2) > 0
        away = ((middles > node + side / 2) != of_eye).sum(axis=1)
        keys.append(np.where(inner, -away, 0))
        side /= 2
    return np.lexsort(keys[::-1]) if keys else np.arange(len(cells))


def _covered(low: Array, side: Array, axis: int, upper: int) -> NDArray[np.bool_]:
    """Which cells (n,) have a cell of their size beyond one of their sides."""
    step = side if upper else -side
    here = {(*place, width) for place, width in zip(map(tuple, low.tolist()), side.tolist(), strict=True)}
    beyond = low.copy()
    beyond[:, axis] += step
    return np.array(
        [
            (*place, width) in here
            for place, width in zip(map(tuple, beyond.tolist()), side.tolist(), strict=True)
        ],
        bool,
    )


def cube_edges(low: Array, side: float, viewpoint: Viewpoint) -> Array:
    """The edges (12, 2, 2) of a cube on the device; none where it is not before the camera as a whole."""
    corners = np.array([[k >> 2 & 1, k >> 1 & 1, k & 1] for k in range(8)]) * side + low
    flat = viewpoint.homogeneous(corners)
    if (flat[:, 3] <= 0).any():
        return np.zeros((0, 2, 2))
    device = viewpoint.device
    places = flat[:, :2] / flat[:, 3:] * device.diagonal()[:2] + device[:2, 2]
    pairs = [(a, a | bit) for a in range(8) for bit in (4, 2, 1) if not a & bit]
    edges: Array = places[np.array(pairs)]
    return edges
