"""Scenes are lit share by share: the picture is the same, and fine meshes take little memory."""

import tracemalloc

import numpy as np
import pytest
from msgspec.structs import replace

from tests.rendering.scene.test_shaded import SIZE, WINDOW, scene
from workbench.document.model import Rectangle
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Camera, Light, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, MeshSolid
from workbench.geometry.meshes import Faces, Mesh, triangulated
from workbench.rendering.scene import lit_triangles
from workbench.rendering.scene.around import camera_around
from workbench.rendering.scene.lasting import Lasting
from workbench.rendering.scene.lit_triangles import AT_ONCE, lit_shares
from workbench.rendering.scene.shaded import shaded
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.scene.smoothing import MOST_AROUND, CornerNormals
from workbench.rendering.scene.viewpoint import Viewpoint


def hill(side: int) -> Mesh:
    """A grid of ``side`` x ``side`` vertices, two triangles in each of its squares."""
    y, x = np.mgrid[0:side, 0:side]
    vertices = np.stack([x, y, np.sin(x * 0.1) + np.cos(y * 0.1)], axis=-1).reshape(-1, 3).astype(float)
    number = np.arange(side * side).reshape(side, side)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    a, b, c, d = (each.ravel() for each in corners)
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return Mesh(vertices, Faces.of(faces))


def scene_with(mesh: Mesh) -> Scene:
    thing = Object("o1", MeshSolid(blob_of(mesh)), "m1")
    return Scene((thing,), (Material("m1"),), camera=camera_around(mesh.vertices))


@pytest.mark.parametrize("shading", LIT_SHADINGS)
@pytest.mark.parametrize("near", [2.0, 5.5], ids=["whole", "cut"])
def test_share_by_share_the_picture_is_the_same(
    shading: str, near: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = scene(near=near)
    image, depth = shaded(seen, shading, SIZE, WINDOW)
    monkeypatch.setattr(lit_triangles.lit_shares, "__defaults__", (7,))
    assert len(list(lit_shares(seen, SIZE, WINDOW))) > 10
    again, depth_again = shaded(seen, shading, SIZE, WINDOW)
    assert np.array_equal(again, image)
    assert np.array_equal(depth_again, depth)
    assert (depth < 1).any()


def test_a_later_share_may_be_brighter_than_there_is_room_for_at_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    seen = scene()
    dark = Material("m1", colour=0x808080, ambient=0.5, diffuse=0.0, specular=0.0)
    lamp = Light("l1", Point3D(2.0, 2.0, 3.0), intensity=3.9)
    bright = Material("m2", colour=0xFFFFFF, ambient=1.0, diffuse=1.0)
    boxes = seen.objects[0], Object("o2", Box(2.4, 0.6, 2.6), "m2")
    seen = replace(seen, objects=boxes, materials=(dark, bright), lights=(lamp,))
    image, _depth = shaded(seen, "gouraud", SIZE, WINDOW)
    monkeypatch.setattr(lit_triangles.lit_shares, "__defaults__", (20,))
    again, _depth = shaded(seen, "gouraud", SIZE, WINDOW)
    assert np.array_equal(again, image)
    assert (image == 0xFFFFFF).any()


def test_a_fine_mesh_is_lit_in_shares() -> None:
    mesh = hill(200)
    window = Rectangle(-100.0, -100.0, 100.0, 100.0)
    counts = [len(lit.triangles) for lit in lit_shares(scene_with(mesh), SIZE, window)]
    assert sum(counts) == len(mesh.faces)
    assert max(counts) <= AT_ONCE < len(mesh.faces)


def peak_of_normals(mesh: Mesh) -> int:
    """Bytes that are taken at the same time at most."""
    triangles, owners = triangulated(*mesh)
    tracemalloc.start()
    try:
        CornerNormals(mesh, triangles, owners)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_normals_of_a_fine_mesh_take_little_memory() -> None:
    """Once a fine mesh of 42 MB took four gigabytes."""
    mesh = hill(300)
    assert peak_of_normals(mesh) < 500 * len(mesh.faces)


def test_where_very_many_faces_meet_they_are_not_all_held_against_each_other() -> None:
    """Twice as many around one vertex would take four times as much."""
    count = MOST_AROUND + 1
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    rim = np.stack([np.cos(angle), np.sin(angle), np.zeros(count)], axis=1)
    number = np.arange(count)
    faces = np.stack([number, (number + 1) % count, np.full(count, count)], axis=1)
    cone = Mesh(np.concatenate([rim, [[0.0, 0.0, 1.0]]]), Faces.of(faces))
    assert peak_of_normals(cone) < 100_000_000
    at_top = CornerNormals(cone, *triangulated(*cone)).of(0, count)[:, 2]
    outwards = np.stack([np.cos(angle + np.pi / count), np.sin(angle + np.pi / count)], axis=1)
    assert (at_top[:, :2] * outwards).sum(axis=1) == pytest.approx(np.sqrt(0.5), abs=1e-3)


def test_what_the_near_plane_leaves_of_a_fine_mesh_takes_little_memory() -> None:
    """As after an import, whose camera stands before the middle of the mesh."""
    mesh = hill(200)
    triangles, _owners = triangulated(*mesh)
    camera = Camera(
        eye=Point3D(100.0, 100.0, 60.0), look_at=Point3D(100.0, 100.0, 0.0), near=59.0, distance=60.0
    )
    viewpoint = Viewpoint.of(camera, SIZE, Rectangle(-100.0, -100.0, 100.0, 100.0), np.zeros((0, 3)))
    box = Lasting(mesh).box
    viewpoint.drawn(mesh.vertices, triangles, box)  # what is loaded for it
    tracemalloc.start()
    try:
        drawn = viewpoint.drawn(mesh.vertices, triangles, box)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert drawn.owners is not None
    assert 0 < len(drawn.triangles) < len(triangles)
    assert peak < 100 * len(triangles)
