"""What is found once of a mesh is right, and is not found again while only the camera moves."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.document.samples.examples import example
from workbench.document.scene.looking import orbited
from workbench.geometry import meshes
from workbench.geometry.meshes import Faces, Mesh, face_normals, face_planes
from workbench.rendering.scene import lasting, render_scene
from workbench.rendering.scene.around import camera_around, window_of
from workbench.rendering.scene.edge_picture import MOST_EDGES, edge_picture
from workbench.rendering.scene.lasting import Lasting
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Viewpoint

SIZE = 64, 48


def cloud(count: int, seed: int = 1) -> Mesh:
    """A mesh of ``count`` vertices anywhere, and of twice as many triangles."""
    rng = np.random.default_rng(seed)
    points = rng.normal(0, (3.0, 1.0, 2.0), (count, 3))
    return Mesh(points, Faces.of(rng.integers(0, count, (2 * count, 3))))


def the_scene():
    sheets = example("overlapping-triangles").document.sheets
    return next(sheet.scene for sheet in sheets if sheet.scene is not None)


def test_normals_distances_and_middles_are_those_of_the_planes() -> None:
    mesh = Mesh(cloud(40).vertices, Faces.of([[0, 1, 2], [3, 4, 5, 6], [7, 8, 9], [1, 1, 2]]))
    faces = Lasting(mesh)
    lengths = np.sqrt((face_normals(*mesh) ** 2).sum(axis=1))
    assert lengths[3] == 0
    assert faces.normals[:, 3].tolist() == [0, 0, 0]
    planes = face_planes(*mesh)[:3] / lengths[:3, None]
    np.testing.assert_allclose(faces.normals[:, :3].T, planes[:, :3])
    np.testing.assert_allclose(faces.distances[[0, 2]], -planes[[0, 2], 3], atol=1e-12)
    np.testing.assert_allclose(faces.middles[:, 1], mesh.vertices[3:7].mean(axis=0))


def test_of_few_vertices_all_are_outermost_and_of_many_those_between_which_the_others_lie() -> None:
    few, many = cloud(100), cloud(5_000)
    assert Lasting(few).outermost is few.vertices
    outermost = Lasting(many).outermost
    assert len(outermost) < 300
    for low_or_high in (np.min, np.max):
        np.testing.assert_allclose(low_or_high(outermost, axis=0), low_or_high(many.vertices, axis=0), 1e-6)
    for direction in np.random.default_rng(2).normal(size=(50, 3)):
        reach = (many.vertices @ direction).max()
        assert reach * 0.9 <= (outermost @ direction).max() <= reach


def test_the_box_holds_all_and_touches_them() -> None:
    mesh = cloud(50)
    box = Lasting(mesh).box
    assert box.shape == (8, 3)
    assert (box.min(axis=0) == mesh.vertices.min(axis=0)).all()
    assert (box.max(axis=0) == mesh.vertices.max(axis=0)).all()
    assert Lasting(Mesh(np.zeros((0, 3)), Faces.of([]))).box.shape == (0, 3)


def test_nothing_of_a_mesh_is_found_twice_while_the_camera_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = []
    monkeypatch.setattr(lasting, "face_normals", lambda *mesh: calls.append(1) or face_normals(*mesh))
    scene = replace(
        the_scene(), objects=tuple(replace(o, name=f"{o.name} again") for o in the_scene().objects)
    )
    for turn in range(4):
        render_scene(replace(scene, camera=orbited(scene.camera, 0.1 * turn, 0.0)), "depth_buffer", SIZE)
    assert len(calls) == len(placed(scene))
    moved = replace(scene, objects=scene.objects[:-1])
    assert placed(moved) is not placed(scene)
    assert len(placed(moved)) == len(placed(scene)) - 1


def test_triangles_before_the_camera_are_those_given_and_a_box_decides_as_the_points_do() -> None:
    mesh = cloud(60)
    triangles = mesh.faces.corners.reshape(-1, 3)
    camera = camera_around(mesh.vertices)
    for near, whole in ((camera.near, True), ((camera.near + camera.far) / 2, False)):
        seen = replace(camera, near=near)
        view = Viewpoint.of(seen, SIZE, window_of(camera, SIZE, mesh.vertices), mesh.vertices)
        by_box, by_points = (
            view.drawn(mesh.vertices, triangles, around) for around in (Lasting(mesh).box, mesh.vertices)
        )
        assert (by_box.triangles is triangles) == (by_points.triangles is triangles) == whole
        corners, others = (each.corners[each.triangles] for each in (by_box, by_points))
        assert np.array_equal(corners, others)
        numbers = by_box.of_owners(np.arange(len(triangles)))
        assert numbers.tolist() == by_points.of_owners(np.arange(len(triangles))).tolist()
        assert len(numbers) == len(by_box.triangles)
        assert whole == (numbers.tolist() == [*range(len(triangles))])


def test_edges_too_many_to_be_drawn_are_not_told_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = the_scene()
    assert len(edge_picture(scene, SIZE, window_of(scene.camera, SIZE, np.eye(3))).seen)
    monkeypatch.setattr("workbench.rendering.scene.edge_picture.MOST_EDGES", 0)
    monkeypatch.setattr(Lasting, "edges", property(lambda _self: pytest.fail("edges were told apart")))
    picture = edge_picture(scene, SIZE, window_of(scene.camera, SIZE, np.eye(3)))
    assert MOST_EDGES > 0
    assert not len(picture.seen)
    assert picture.pixels is not None


def test_what_lasts_is_the_same_however_many_faces_are_taken_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(5)
    faces = Faces.of([rng.integers(0, 40, size).tolist() for size in rng.integers(3, 7, 31)])
    mesh = Mesh(rng.normal(size=(40, 3)), faces)
    whole = Lasting(mesh)
    whole_normals, whole_middles = whole.normals, whole.middles
    for module in (lasting, meshes):
        monkeypatch.setattr(module, "_AT_ONCE", 4)
    few = Lasting(mesh)
    assert np.array_equal(few.middles, whole_middles)
    assert np.array_equal(few.normals, whole_normals)
    assert np.allclose(few.middles.T, [mesh.vertices[face].mean(axis=0) for face in faces])
