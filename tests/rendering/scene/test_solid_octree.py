"""Solids of a scene as octrees: their equations beside their meshes, and cells in the order of a painter."""

import numpy as np
import pytest

from workbench.algorithms.solids.implicit import EMPTY, FULL
from workbench.algorithms.solids.octree_pairs import DIFFERENCE, INTERSECTION, UNION
from workbench.document.model import Rectangle
from workbench.document.scene.links import Rotate3D, Scale3D, Translate3D
from workbench.document.scene.model import Camera, Object, Point3D
from workbench.document.scene.solids import (
    AnySolid,
    Blobs,
    Box,
    Cone,
    Cylinder,
    Ellipsoid,
    PiercingPlanes,
    Sphere,
    Torus,
)
from workbench.rendering.scene.solid_octree import (
    CUT,
    Cutting,
    combined_call,
    cube_edges,
    octree_call,
    placed_solid,
    sides_seen,
)
from workbench.rendering.scene.viewpoint import Viewpoint

SOLIDS: list[AnySolid] = [
    Sphere(0.8, 60, 60),
    Ellipsoid(1.5, 1.0, 0.75, 60, 60),
    Torus(1.5, 0.5, 60, 60),
    Cylinder(0.7, 1.5, 60),
    Cone(0.7, 1.5, 60),
    Box(1.0, 2.0, 3.0),
    Blobs(3, 0.8),
]
MOVED = Scale3D(id="t1", sx=1.5, sy=0.5, sz=1.0), Rotate3D(id="t2", angle=30.0), Translate3D(id="t3", tx=0.5)


def cells_of(things: tuple[Object, ...], depth: int) -> np.ndarray:
    call = octree_call(things, depth)
    return np.array(list(call.entry.function(*call.arguments)))


@pytest.mark.parametrize("transforms", [(), MOVED], ids=["as it is", "moved"])
@pytest.mark.parametrize("solid", SOLIDS, ids=lambda solid: type(solid).__name__)
def test_no_corner_of_the_mesh_is_in_an_empty_cell(solid: AnySolid, transforms: tuple[object, ...]) -> None:
    """Vertices lie on the surface: in cells that are partial, or at the border of others."""
    thing = Object("o1", solid, "m1", transforms=transforms)  # type: ignore[arg-type]
    rows = cells_of((thing,), 3)
    matrix = np.eye(4) if thing.matrix is None else thing.matrix
    points = thing.mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3]
    inside = (rows[:, None, :3] + 1e-4 < points) & (points < rows[:, None, :3] + rows[:, None, 3:4] - 1e-4)
    held = inside.all(axis=2)
    assert not transforms or held.any(axis=0).mean() > 0.2  # unmoved ones have corners between cells
    assert not held[rows[:, 4] == EMPTY].any()
    if not isinstance(solid, Blobs):  # whose mesh is as fine as its grid
        assert not held[rows[:, 4] == FULL].any()


def test_what_has_no_equation_or_is_flat_has_no_octree() -> None:
    assert placed_solid(Object("o1", PiercingPlanes(), "m1")) is None
    flat = Object("o1", Sphere(), "m1", transforms=(Scale3D(id="t1", sx=1.0, sy=0.0, sz=1.0),))
    assert placed_solid(flat) is None


def test_two_balls_are_combined_and_one_is_cut() -> None:
    balls = (
        Object("o1", Sphere(1.0), "m1"),
        Object("o2", Sphere(1.0), "m1", transforms=(Translate3D(id="t1", tx=1.0),)),
    )

    def bounds(cutting: Cutting, things: tuple[Object, ...]) -> tuple[float, float]:
        call = combined_call(things, cutting)
        rows = np.array(list(call.entry.function(*call.arguments)))
        cubes = rows[:, 3] ** 3
        return cubes[rows[:, 4] == FULL].sum(), cubes[rows[:, 4] != EMPTY].sum()

    lens = np.pi * 5 / 12  # two caps of height 1/2: 2 pi h^2 (3 - h) / 3
    ball = 4 / 3 * np.pi
    for operation, volume in ((UNION, 2 * ball - lens), (INTERSECTION, lens), (DIFFERENCE, ball - lens)):
        least, most = bounds(Cutting(4, operation), balls)
        assert least <= volume <= most
    for axis in range(3):
        least, most = bounds(Cutting(4, CUT, axis, 0.5), balls[:1])
        assert least <= ball / 2 <= most
        assert most < ball


@pytest.mark.parametrize("projection", ["perspective", "orthographic", "cabinet"])
@pytest.mark.parametrize("eye", [(4.0, 3.0, 6.0), (-5.0, 0.4, 3.0), (0.3, -6.0, -4.0)])
def test_the_side_painted_last_over_a_place_is_the_nearest(projection: str, eye: tuple[float, ...]) -> None:
    """Beside rays that are tried on every cell."""
    thing = Object("o1", Torus(1.0, 0.4), "m1")
    rows, call = cells_of((thing,), 4), octree_call((thing,), 4)
    rows = rows[np.random.default_rng(3).random(len(rows)) < 0.7]  # with gaps between
    corner, size = call.arguments[3:5]
    camera = Camera(projection, eye=Point3D(*eye), near=1.0, far=20.0, distance=5.0)
    viewpoint = Viewpoint.of(camera, (60, 40), Rectangle(-3.0, -2.0, 3.0, 2.0), np.zeros((0, 3)))
    sides = sides_seen(rows, corner, size, viewpoint)
    solid = rows[rows[:, 4] != EMPTY]
    back = np.linalg.inv(viewpoint.matrix) if projection == "perspective" else None
    viewer, compared = viewpoint.viewer, 0
    chance = np.random.default_rng(1)
    for pixel in chance.uniform((18, 12), (42, 28), (150, 2)):
        over = [k for k, ring in enumerate(sides.rings) if within(pixel, ring)]
        flat = (pixel - viewpoint.device[:2, 2]) / viewpoint.device.diagonal()[:2]
        if back is not None:
            place = back @ [*flat, 0.5, 1.0]
            start, way = viewer[:3], place[:3] / place[3] - viewer[:3]
        else:
            matrix = viewpoint.matrix
            start, way = np.linalg.solve(matrix[:3, :3], [*flat, 0.0] - matrix[:3, 3]), -viewer[:3]
        with np.errstate(divide="ignore"):
            ends = np.stack([(solid[:, :3] - start) / way, (solid[:, :3] + solid[:, 3:4] - start) / way])
        enters, leaves = ends.min(axis=0).max(axis=1), ends.max(axis=0).min(axis=1)
        met = np.flatnonzero(enters < leaves - 1e-9)
        assert bool(len(met)) == bool(over)
        if len(met):
            compared += 1
            nearest = solid[met[enters[met].argmin()]]
            edges = cube_edges(nearest[:3], nearest[3], viewpoint).reshape(-1, 2)
            gaps = np.abs(sides.rings[over[-1]][:, None] - edges).sum(axis=2).min(axis=1)
            assert gaps.max() < 1e-6
    assert compared > 40


def within(place: np.ndarray, ring: np.ndarray) -> bool:
    """Whether a convex polygon holds a place."""
    after = np.roll(ring, -1, axis=0)
    turns = (after[:, 0] - ring[:, 0]) * (place[1] - ring[:, 1]) - (after[:, 1] - ring[:, 1]) * (
        place[0] - ring[:, 0]
    )
    return bool((turns > 0).all() or (turns < 0).all())
