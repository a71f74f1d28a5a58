"""The solids are closed, look outwards and have the volumes that geometry gives them."""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import solids
from workbench.algorithms.solids.jug import PROFILE
from workbench.geometry.curves.bernstein import bernstein
from workbench.geometry.meshes import Faces, Mesh, face_normals, face_planes, triangulated

Case = tuple[Callable[[], Mesh], float | None, int]
PI = math.pi


def regular(n: int) -> float:
    """The area of a regular polygon whose corners are 1 away from its middle."""
    return n / 2 * math.sin(2 * PI / n)


def turned_volume(profile: list[tuple[float, float]], slices: int) -> float:
    """Of a profile from axis to axis: frustums of pyramids over regular polygons."""
    pairs = pairwise(profile)
    return regular(slices) * sum(
        (y1 - y0) * (r0 * r0 + r0 * r1 + r1 * r1) / 3 for (r0, y0), (r1, y1) in pairs
    )


# What the volume is by formula, and the Euler characteristic.
CLOSED: dict[str, Case] = {
    "box": (lambda: solids.box(1.0, 2.0, 3.0), 6.0, 2),
    "cube": (lambda: solids.cube(3.0), 27.0, 2),
    "tetrahedron": (lambda: solids.tetrahedron(2.0), 8 * 8 * math.sqrt(3) / 27, 2),
    "octahedron": (lambda: solids.octahedron(2.0), 8 * 4 / 3, 2),
    "dodecahedron": (
        lambda: solids.dodecahedron(1.0),
        (15 + 7 * math.sqrt(5)) / 4 * (4 / (math.sqrt(3) * (1 + math.sqrt(5)))) ** 3,
        2,
    ),
    "icosahedron": (
        lambda: solids.icosahedron(1.0),
        5 * (3 + math.sqrt(5)) / 12 / math.sin(2 * PI / 5) ** 3,
        2,
    ),
    "prism": (lambda: solids.prism(5, 2.0, 3.0), regular(5) * 4 * 3, 2),
    "pyramid": (lambda: solids.pyramid(7, 2.0, 3.0), regular(7) * 4, 2),
    "cylinder": (lambda: solids.cylinder(2.0, 3.0, 40), regular(40) * 12, 2),
    "cone": (lambda: solids.cone(2.0, 3.0, 40), regular(40) * 4, 2),
    "sphere": (
        lambda: solids.sphere(2.0, 20, 10),
        turned_volume(
            [(2 * math.cos(a), 2 * math.sin(a)) for a in (PI * (k / 10 - 0.5) for k in range(11))], 20
        ),
        2,
    ),
    "torus": (lambda: solids.torus(3.0, 1.0, 24, 12), regular(24) * 2 * 3 * regular(12), 0),
    "house": (lambda: solids.house(2.0, 1.5, 3.0, 1.0), (3.0 + 1.0) * 3, 2),
    "bracket": (lambda: solids.bracket(2.0, 3.0, 4.0, 0.5), (1.0 + 1.25) * 4, 2),
    "star": (
        lambda: solids.extruded(
            [((1 + k % 2) * math.cos(PI * k / 5), (1 + k % 2) * math.sin(PI * k / 5)) for k in range(10)], 2.0
        ),
        10 * 0.5 * 2 * math.sin(PI / 5) * 2,
        2,
    ),
    "vase": (
        lambda: solids.turned([(0.5, 0.0), (2.0, 1.0), (0.0, 3.0)], 9),
        turned_volume([(0.5, 0.0), (2.0, 1.0), (0.0, 3.0)], 9),
        2,
    ),
}


@pytest.mark.parametrize("name", CLOSED)
def test_a_solid_is_closed_looks_outwards_and_has_its_volume(name: str) -> None:
    make, volume, euler = CLOSED[name]
    mesh = make()
    tables = solids.polygon_tables(mesh)
    assert tables.closed
    assert len(mesh.vertices) - len(tables.edges) + len(mesh.faces) == euler
    triangles, owners = triangulated(*mesh)
    judge = trimesh.Trimesh(mesh.vertices, triangles, process=False)
    assert judge.is_watertight
    assert judge.is_winding_consistent
    assert judge.volume == pytest.approx(volume, rel=1e-12)
    # All triangles of a face lie in its plane and turn as it does, and their areas add up to its own.
    normals = face_normals(*mesh)
    assert ((judge.face_normals * normals[owners]).sum(axis=1) > 0).all()
    areas = np.bincount(owners, judge.area_faces)
    assert areas == pytest.approx(np.sqrt((normals**2).sum(axis=1)) / 2, rel=1e-9)


@pytest.mark.parametrize("name", [name for name in CLOSED if name not in ("torus", "bracket", "star")])
def test_of_a_solid_without_dents_every_vertex_lies_behind_every_plane(name: str) -> None:
    mesh = CLOSED[name][0]()
    planes = face_planes(*mesh)
    sides = planes[:, :3] @ mesh.vertices.T + planes[:, 3:]
    assert sides.max() < 1e-9 * np.abs(planes).max()


@pytest.mark.parametrize(
    ("make", "faces", "corners"),
    [
        (solids.tetrahedron, 4, 3),
        (solids.cube, 6, 4),
        (solids.octahedron, 8, 3),
        (solids.dodecahedron, 12, 5),
        (solids.icosahedron, 20, 3),
    ],
)
def test_a_regular_solid_has_equal_edges_and_equal_faces(
    make: Callable[[float], Mesh], faces: int, corners: int
) -> None:
    mesh = make(3.0)
    assert mesh.faces.sizes.tolist() == [corners] * faces
    a, b = mesh.vertices[solids.polygon_tables(mesh).edges].transpose(1, 0, 2)
    assert np.ptp(np.linalg.norm(a - b, axis=1)) < 1e-12
    assert np.ptp(np.linalg.norm(mesh.vertices, axis=1)) < 1e-12


def test_the_plane_of_the_course() -> None:
    triangle = np.array([[0.0, 0, 10], [10, 0, 20], [0, 10, 40]])
    (plane,) = face_planes(triangle, Faces.of([[0, 1, 2]]))
    assert plane == pytest.approx([-100, -300, 100, -1000], rel=1e-14)


def test_the_tables_of_a_pyramid_by_hand() -> None:
    tables = solids.polygon_tables(Mesh(np.eye(4, 3), Faces.of([[0, 1, 2], [0, 3, 1]])))
    assert tables.edges.tolist() == [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3]]
    assert tables.sides.tolist() == [0, 3, 1, 2, 4, 0]
    assert tables.edge_faces.tolist() == [[0, 1], [-1, 0], [1, -1], [0, -1], [-1, 1]]
    assert not tables.closed


def test_the_jug_is_whole_but_for_its_mouth_and_looks_outwards() -> None:
    height, steps = 2.1, 5
    mesh = solids.jug(height, steps)
    tables = solids.polygon_tables(mesh)
    rims = mesh.vertices[tables.edges[(tables.edge_faces < 0).any(axis=1)]]
    at_mouth = (np.abs(rims[..., 1] - height) < 1e-9).all(axis=1)
    # The mouth is a ring of four patches; the handle is a tube, open at both ends, inside the body there.
    assert at_mouth.sum() == 4 * steps
    assert (~at_mouth).sum() == 2 * 4 * steps
    # Seen from a point in the plane of the mouth, the rest encloses the whole volume of the body.
    triangles, _owners = triangulated(*mesh)
    judge = trimesh.Trimesh(mesh.vertices - [0.0, height, 0.0], triangles, process=False)
    body, handle = (
        np.linalg.det(part.vertices[part.faces]).sum() / 6 for part in judge.split(only_watertight=False)
    )
    r, y = np.concatenate([bernstein(3, np.linspace(0, 1, 1001)) @ piece for piece in PROFILE]).T
    round_one = PI * float((np.diff(y) * (r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2)).sum() / 3)
    assert 0.9 * round_one < body < 1.1 * round_one
    assert 0.0 < handle < 0.1


@given(st.integers(3, 9), st.integers(0, 2**32 - 1))
def test_a_polygon_is_cut_into_triangles_that_cover_it_once(corners: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    angles = np.sort(random.uniform(0, 2 * PI, corners))
    if np.diff(angles, append=angles[0] + 2 * PI).max() > 3:
        return  # not a star around its middle
    flat = random.uniform(0.1, 1.0, corners)[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    frame = np.linalg.qr(random.normal(size=(3, 3)))[0]
    points = np.column_stack([flat, np.full(corners, 0.5)]) @ frame
    triangles, owners = triangulated(points, Faces.of([list(range(corners))]))
    assert owners.tolist() == [0] * (corners - 2)
    normal = face_normals(points, Faces.of([list(range(corners))]))[0]
    parts = [np.cross(points[b] - points[a], points[c] - points[a]) for a, b, c in triangles]
    assert min(part @ normal for part in parts) > -1e-9
    assert sum(math.sqrt(part @ part) for part in parts) == pytest.approx(
        math.sqrt(normal @ normal), rel=1e-9
    )


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: solids.box(0.0), "is 0; choose a finite number above 0"),
        (lambda: solids.torus(1.0, 0.0), "is 0; choose"),
        (lambda: solids.torus(1.0, 1.5), "thickness of the ring is 1.5 and its radius 1; make"),
        (lambda: solids.torus(1.0, 1.0), "smaller than the radius"),
        (lambda: solids.prism(2), "2 slices; choose 3 to 2000"),
        (lambda: solids.sphere(1.0, 10**7), "10000000 slices"),
        (lambda: solids.turned([(-1.0, 0.0), (1.0, 1.0)]), "beyond the axis"),
        (lambda: solids.extruded([(0, 0), (1, 1), (2, 2)]), "has no area"),
        (lambda: solids.extruded([(0, 0), (1, math.nan), (2, 2)]), "two finite numbers"),
        (lambda: solids.jug(math.inf), "the jug is inf high"),
        (lambda: solids.bracket(thickness=180.0), "is 180, its width 2 and its height 2; make the thickness"),
        (lambda: solids.bracket(3.0, 2.0, thickness=2.0), "smaller than either"),
    ],
)
def test_what_is_no_solid_is_refused(call: Callable[[], Mesh], said: str) -> None:
    with pytest.raises(ValueError, match=f"(?i){said}"):
        call()
