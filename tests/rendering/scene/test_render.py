"""Meshes and scenes as pictures: against exact arithmetic, laws of clipping, and what is refused."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.scene.scenes import full_scene
from workbench.algorithms import solids
from workbench.document import Camera
from workbench.document.model import Rectangle
from workbench.document.scene.links import Rotate3D, Scale3D, Translate3D
from workbench.document.scene.model import Light, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, Bracket, PiercingPlanes, Sphere
from workbench.geometry.meshes import Faces, Mesh, triangulated
from workbench.rendering import render_mesh, render_scene
from workbench.rendering.scene import wireframe, wireframe_of_mesh
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Viewpoint
from workbench.rendering.scene.volume import DEPTH_PLANES, clip_segments, clip_triangles, side_planes

FRONT = Camera("orthographic", eye=Point3D(0.0, 0.0, 10.0), near=1.0, far=19.0)
WINDOW = Rectangle(-8.0, -6.0, 8.0, 6.0)
SIZE = (16, 12)  # a pixel is a unit of the world


def text(image: Any) -> str:
    return "\n".join("".join("#" if pixel else "." for pixel in row) for row in image[::-1])


def test_a_box_is_where_it_is() -> None:
    image, depth = render_mesh(*solids.box(4.0, 2.0, 6.0), FRONT, "depth_buffer", SIZE, WINDOW)
    assert text(image) == "\n".join(5 * ["." * 16] + 2 * ["......####......"] + 5 * ["." * 16])
    assert image.dtype == np.uint32
    # The front is at z = 3 of the world, 7 from the eye; near is 1, far 19.
    assert depth[image > 0] == pytest.approx((7 - 1) / 18)
    assert (depth[image == 0] == 1.0).all()


def test_perspective_makes_what_is_nearer_larger() -> None:
    camera = replace(FRONT, projection="perspective", distance=5.0)
    square = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    for z, side in ((5.0, 1.0), (0.0, 0.5), (-5.0, 1 / 3)):
        at = square + np.array([0, 0, z])
        image, depth = render_mesh(at, [[0, 1, 2, 3]], camera, "depth_buffer", (160, 120), WINDOW)
        assert (image > 0).sum() == pytest.approx((20 * side) ** 2, rel=0.2)
        away = 10 - z
        assert depth[image > 0] == pytest.approx(19 / 18 * (1 - 1 / away), rel=1e-9)


Triangle = list[tuple[Fraction, ...]]
quarters = st.integers(-32, 32).map(lambda n: Fraction(n, 4))


corners_of = st.lists(st.tuples(quarters, quarters, quarters), min_size=3, max_size=3)


@given(st.lists(corners_of, min_size=1, max_size=4))
def test_at_each_pixel_the_exactly_nearest_triangle_is_seen(
    triangles: list[Triangle],
) -> None:
    corners = np.array([[float(v) for v in corner] for triangle in triangles for corner in triangle])
    _image, depth = render_mesh(
        corners, np.arange(len(corners)).reshape(-1, 3), FRONT, "depth_buffer", SIZE, WINDOW
    )
    for row in range(SIZE[1]):
        for column in range(SIZE[0]):
            x, y = Fraction(2 * column - 15, 2), Fraction(2 * row - 11, 2)
            nearest = min((z for t in triangles if (z := depth_at(t, x, y)) is not None), default=None)
            if nearest is None:
                assert depth[row, column] == 1.0
            else:
                assert depth[row, column] == pytest.approx(float(nearest), abs=1e-12)


def depth_at(triangle: Triangle, x: Fraction, y: Fraction) -> Fraction | None:
    """The depth there by the shares of the corners; None outside (low and left edges count)."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = triangle
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    if area == 0:
        return None
    crossings = []
    for (px, py, _), (qx, qy, _) in zip(triangle, triangle[1:] + triangle[:1], strict=True):
        if min(py, qy) <= y < max(py, qy):
            crossings.append(px + (y - py) * (qx - px) / (qy - py))
    if len(crossings) != 2 or not min(crossings) <= x < max(crossings):
        return None
    b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
    c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
    z = az + b * (bz - az) + c * (cz - az)
    return (10 - z - 1) / 18


@pytest.mark.parametrize("projection", ["orthographic", "isometric", "cabinet", "cavalier", "perspective"])
def test_a_closed_solid_has_no_hole_and_hides_what_is_in_it(projection: str) -> None:
    camera = replace(FRONT, projection=projection, eye=Point3D(3.0, 4.0, 8.0), distance=9.0)
    outer, inner = solids.icosahedron(2.0), solids.icosahedron(1.2)
    both = Mesh(
        np.concatenate([outer.vertices, inner.vertices]),
        Faces.of([*(f.tolist() for f in outer.faces), *((f + 12).tolist() for f in inner.faces)]),
    )
    image, depth = render_mesh(*outer, camera, "depth_buffer", (90, 80), WINDOW)
    covered = image > 0
    assert covered.sum() > 250
    for row in covered:
        columns = np.flatnonzero(row)
        assert len(columns) == 0 or columns[-1] - columns[0] + 1 == len(columns)
    with_core, same_depth = render_mesh(*both, camera, "depth_buffer", (90, 80), WINDOW)
    assert np.array_equal(image, with_core)
    assert np.array_equal(depth, same_depth)


def test_piercing_planes_are_cut_where_they_pierce() -> None:
    scene = Scene(
        (Object("o1", PiercingPlanes(8.0), "m1", transforms=(Rotate3D("t1", angle=45.0),)),),
        (Material("m1"),),
        camera=FRONT,
    )
    _image, depth = render_scene(scene, "depth_buffer", SIZE, window=WINDOW)
    # Of two upright planes at 45 degrees to either side the nearer half is seen: depth grows from the middle.
    row = depth[7, 5:11]
    assert np.argmax(row) in (2, 3)
    assert row[:3] == pytest.approx(row[:2:-1])


def test_what_lies_before_the_near_plane_is_cut_off_and_nothing_behind_the_eye_comes_back() -> None:
    camera = replace(FRONT, projection="perspective", near=2.0, far=30.0, distance=5.0)
    ground = np.array([[-50.0, -2, 50], [50, -2, 50], [50, -2, -15], [-50, -2, -15]])
    image, depth = render_mesh(ground, [[0, 1, 2, 3]], camera, "depth_buffer", (160, 120), WINDOW)
    rows = np.flatnonzero((image > 0).any(axis=1))
    # At depth t the ground is at y = -2 * 5 / t: at the near plane -5, at its far edge -0.4.
    assert (rows[0], rows[-1]) == (10, 55)
    assert (image > 0)[10:55].all()
    assert depth[image > 0].min() >= 0.0


finite = st.floats(-4, 4, allow_nan=False)


@given(st.lists(st.tuples(finite, finite, finite), min_size=3, max_size=3), st.integers(0, 6))
def test_clipping_keeps_area_and_the_part_inside(corners: list[tuple[float, ...]], number: int) -> None:
    points = np.column_stack([np.array(corners), np.ones(3)])
    plane = np.random.default_rng(number).normal(size=4)
    one = np.array([[0, 1, 2]])
    areas = []
    for side in (plane, -plane):
        clipped, triangles, owners = clip_triangles(points, one, side[None])
        assert (clipped[triangles] @ side >= -1e-9).all()
        assert (owners == 0).all()
        areas.append(_normals(clipped, triangles).sum(axis=0))
    whole = _normals(points, one)[0]
    assert areas[0] + areas[1] == pytest.approx(whole, abs=1e-9)


def _normals(points: Any, triangles: Any) -> Any:
    a, b, c = (points[triangles[:, k], :3] for k in range(3))
    return np.cross(b - a, c - a)


def test_neighbours_are_cut_at_the_same_point() -> None:
    points = np.array([[-1.0, 0.3, 0.1, 1], [0.7, 0.9, 0.2, 1], [-0.4, 0.1, 0.7, 1], [0.6, -0.2, 0.3, 1]])
    pair = np.array([[0, 1, 2], [2, 1, 3]])
    clipped, _triangles, _owners = clip_triangles(points, pair, np.array([[1.0, 0, 0, 0]]))
    cuts = [tuple(point) for point in clipped[4:].tolist()]
    assert (len(cuts), len(set(cuts))) == (4, 3)


def test_segments_are_cut_as_triangles_are() -> None:
    points = np.array([[-2.0, 0, 0.5, 1], [2, 1, 0.5, 1], [5, 5, 5, 1]])
    begin, end, owners = clip_segments(
        points, np.array([[0, 1], [1, 2], [2, 2]]), np.concatenate([DEPTH_PLANES, side_planes(-1, -1, 1, 1)])
    )
    assert owners.tolist() == [0]
    assert begin[0, :2].tolist() == [-1, 0.25]
    assert end[0, :2].tolist() == [1, 0.75]


def test_a_mirrored_solid_is_lit_as_its_mirror_image() -> None:
    light = Light("l1", Point3D(0.0, 5.0, 8.0))
    chain = (Translate3D("t2", tx=3.0), Scale3D("t3", sx=-1.0))
    plain = Object("o1", Sphere(2.0, 12, 8), "m1", transforms=(Translate3D("t1", tx=3.0),))
    mirrored = Object("o2", Sphere(2.0, 12, 8), "m1", transforms=chain)
    pictures = [
        render_scene(
            Scene((thing,), (Material("m1"),), (light,), FRONT), "depth_buffer", (160, 120), window=WINDOW
        )[0]
        for thing in (plain, mirrored)
    ]
    assert (pictures[0] > 0).sum() > 500
    assert (pictures[0] == pictures[1][:, ::-1]).mean() > 0.99  # but for pixels on an edge


def test_faces_look_outwards_after_any_mirror() -> None:
    for sx in (-2.0, 2.0):
        thing = Object("o1", Bracket(), "m1", transforms=(Scale3D("t1", sx=sx), Translate3D("t2", ty=3.0)))
        ((mesh, (triangles, owners), *_rest),) = placed(Scene((thing,), (Material("m1"),)))
        for cut in (triangles, triangulated(*mesh)[0]):
            assert trimesh.Trimesh(mesh.vertices, cut, process=False).volume == pytest.approx(2 * 1.75)
        assert np.bincount(owners).tolist() == (mesh.faces.sizes - 2).tolist()


def test_flat_shading_is_lamberts_law() -> None:
    material = Material("m1", colour=0xFF8000, ambient=0.2, diffuse=0.6)
    light = Light("l1", Point3D(0.0, 3.0, 4.0), intensity=1.0)
    scene = Scene((Object("o1", Box(), "m1"),), (material,), (light,), FRONT)
    image, _depth = render_scene(scene, "depth_buffer", SIZE, window=WINDOW)
    share = 0.2 + 0.6 * 4 / 5
    expected = [int(np.floor(255 * share + 0.5)), int(np.floor(128 * share + 0.5)), 0]
    assert [int(image[6, 8]) >> shift & 255 for shift in (16, 8, 0)] == expected
    near = replace(light, position=Point3D(0.0, 0.0, 5.0), distant=False)
    image, _depth = render_scene(replace(scene, lights=(near,)), "depth_buffer", SIZE, window=WINDOW)
    assert int(image[6, 8]) >> 16 == int(np.floor(255 * 0.8 + 0.5))


def test_hidden_objects_are_not_drawn_and_the_lower_number_stays_on_equal_depth() -> None:
    red, green = Material("m1", colour=0xFF0000), Material("m2", colour=0x00FF00)
    objects = (Object("o1", Box(), "m1"), Object("o2", Box(), "m2"))
    scene = Scene(objects, (red, green), camera=FRONT)
    first = render_scene(scene, "depth_buffer", SIZE, window=WINDOW)[0]
    assert int(first[6, 8]) >> 8 & 255 == 0
    hidden = replace(scene, objects=(replace(objects[0], visible=False), objects[1]))
    assert int(render_scene(hidden, "depth_buffer", SIZE, window=WINDOW)[0][6, 8]) >> 16 == 0
    image, depth = render_scene(Scene(), "depth_buffer", SIZE)
    assert not image.any()
    assert (depth == 1.0).all()


@pytest.mark.parametrize("projection", ["orthographic", "isometric", "axonometric", "oblique", "perspective"])
def test_everything_is_drawn_inside_the_window_that_fits_it(projection: str) -> None:
    scene = full_scene()
    scene = replace(scene, camera=replace(scene.camera, projection=projection))
    image, _depth = render_scene(scene, "depth_buffer", (120, 90))
    drawn = image > 0
    assert drawn.sum() > 500
    edges = wireframe(scene)
    assert np.isfinite(edges).all()
    assert len(edges) > 1000


def test_the_wireframe_of_a_cube_has_each_edge_once() -> None:
    edges = wireframe_of_mesh(solids.cube(), FRONT)
    assert len(edges) == 12
    assert sorted({tuple(abs(edge).tolist()) for edge in edges}) == [(1.0, 1.0, 1.0, 1.0)]


def test_device_corners_lie_on_the_grid() -> None:
    mesh = solids.sphere(3.0)
    view = Viewpoint.of(Camera(), (640, 480), None, mesh.vertices)
    drawn = view.drawn(mesh.vertices, np.concatenate([f[:3][None] for f in mesh.faces]), mesh.vertices)
    scaled = drawn.corners[:, :2] * 4096
    assert np.array_equal(scaled, np.round(scaled))
    assert 0 <= drawn.corners[:, 2].min() <= drawn.corners[:, 2].max() <= 1


SQUARE: Any = ([[0.0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 1, 2]])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {"camera": replace(FRONT, near=9.0, far=3.0)},
            "near plane is at 9 and the far plane at 3; give near < far",
        ),
        ({"camera": replace(FRONT, look_at=FRONT.eye)}, "The eye is at the point it looks at"),
        (
            {"camera": replace(FRONT, projection="matrix", entries=(0.0,) * 16)},
            "matrix of the camera is singular",
        ),
        ({"method": "guessing"}, "no method for hidden surfaces 'guessing'; choose one of depth_buffer"),
        ({"size": (0, 5)}, "0 x 5 pixels cannot be drawn; give sides from 1"),
        ({"size": (10**6, 5)}, "cannot be drawn"),
        ({"vertices": [[0.0, 0], [1, 1], [2, 2]]}, "not rows of x, y and z"),
        ({"vertices": [[np.nan, 0, 0], [1, 1, 1], [2, 2, 2]]}, "three finite numbers"),
        ({"faces": []}, "has no face"),
        ({"faces": [[0, 1]]}, "fewer than three corners"),
        ({"faces": [[0, 1, 3]]}, "a vertex that does not exist"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_one_sentence(change: dict[str, Any], said: str) -> None:
    given_ = {
        "vertices": SQUARE[0],
        "faces": SQUARE[1],
        "camera": FRONT,
        "method": "depth_buffer",
        "size": SIZE,
    }
    with pytest.raises(ValueError, match=said) as refusal:
        render_mesh(**{**given_, **change})
    assert str(refusal.value).endswith(".")


def test_a_shading_has_a_name_and_goes_through_the_depth_buffer() -> None:
    with pytest.raises(ValueError, match="There is no shading 'cel'; choose one of flat, flat_shading"):
        render_scene(full_scene(), "depth_buffer", SIZE, "cel")
    with pytest.raises(ValueError, match="'phong' needs the depth buffer"):
        render_scene(full_scene(), "painter", SIZE, "phong")


def test_a_matrix_may_take_the_place_of_the_projection() -> None:
    mesh = solids.house()
    camera = replace(FRONT, projection="perspective", distance=4.0)
    scale = camera.far / ((camera.far - camera.near) * 4.0)
    rows = [[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, scale, -camera.near * scale], [0, 0, 0.25, 0]]
    given_ = replace(camera, projection="matrix", entries=tuple(float(v) for row in rows for v in row))
    pictures = [render_mesh(*mesh, each, "depth_buffer", (80, 60), WINDOW) for each in (camera, given_)]
    assert np.array_equal(pictures[0][0], pictures[1][0])
    assert np.array_equal(pictures[0][1], pictures[1][1])
