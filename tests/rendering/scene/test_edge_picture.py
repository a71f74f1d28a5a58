"""Edges that are seen and hidden, and which object is at a pixel."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms.solids.tables import polygon_tables
from workbench.document.model import Rectangle
from workbench.document.scene.looking import turned_to
from workbench.document.scene.model import Camera, Material, Object, Scene
from workbench.document.scene.solids import AnySolid, Box, House, Prism, Regular, Torus
from workbench.geometry.conventions import top_row_first
from workbench.geometry.meshes import Array
from workbench.rendering.scene import render_scene
from workbench.rendering.scene.around import window_of
from workbench.rendering.scene.edge_picture import MOST_EDGES, edge_picture
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Viewpoint

SIZE = (160, 120)
FINE = (800, 600)


def scene_of(*solids: AnySolid, camera: Camera | None = None) -> Scene:
    objects = tuple(Object(f"o{k}", solid, "m1") for k, solid in enumerate(solids, 1))
    return Scene(objects, (Material("m1"),), camera=camera or Camera())


def window(scene: Scene, size: tuple[int, int] = SIZE) -> Rectangle:
    return window_of(scene.camera, size, np.concatenate([mesh.vertices for mesh, *_rest in placed(scene)]))


def length(segments: Array) -> float:
    return float(np.hypot(*(segments[:, 2:] - segments[:, :2]).T).sum())


@pytest.mark.parametrize("solid", [Box(), House(), Prism(5), Regular("dodecahedron")])
@pytest.mark.parametrize("turn", [(0.3, 0.4), (2.0, -0.7), (-1.1, 0.9)])
def test_an_edge_of_a_convex_solid_is_seen_where_one_of_its_faces_is(
    solid: AnySolid, turn: tuple[float, float]
) -> None:
    """By the planes of the faces, which know nothing of a depth buffer."""
    scene = scene_of(solid, camera=turned_to(Camera(projection="perspective"), *turn))
    picture = edge_picture(scene, FINE, window(scene, FINE))
    tables = polygon_tables(placed(scene)[0][0])
    eye = np.array([*scene.camera.eye.xyz, 1.0])
    front = tables.planes @ eye > 0
    view = Viewpoint.of(scene.camera, FINE, window(scene, FINE), np.zeros((0, 3)))
    places = view.homogeneous(tables.vertices)
    flat = places[:, :2] / places[:, 3:] * np.diag(view.device)[:2] + view.device[:2, 2]
    expected = np.hypot(*(flat[tables.edges[:, 0]] - flat[tables.edges[:, 1]]).T)
    seen = front[tables.edge_faces].any(axis=1)
    # Within a pixel of an outline what is behind it counts as seen.
    assert length(picture.seen) == pytest.approx(expected[seen].sum(), rel=0.06)
    assert length(picture.hidden) == pytest.approx(expected[~seen].sum(), rel=0.06)
    assert length(picture.seen) + length(picture.hidden) == pytest.approx(expected.sum())


def test_faces_are_those_of_the_depth_buffer_and_nothing_lies_elsewhere() -> None:
    scene = scene_of(House())
    picture = edge_picture(scene, SIZE, window(scene))
    image, depth = render_scene(scene, "depth_buffer", SIZE, window=window(scene))
    assert picture.pixels is not None
    assert np.array_equal(picture.pixels != 0, depth < 1.0)
    assert np.array_equal(picture.pixels[depth < 1.0] & 0xFFFFFF, image[depth < 1.0])
    assert top_row_first(picture.pixels).flags.c_contiguous  # shown without a copy


def test_without_faces_every_edge_is_there_once() -> None:
    scene = scene_of(Box(), House())
    picture = edge_picture(scene, SIZE, window(scene), faces=False)
    assert picture.pixels is None
    assert np.bincount(picture.seen_of).tolist() == [12, 15]
    assert not len(picture.hidden)


def test_a_hidden_object_has_no_edges_and_a_huge_one_no_lines() -> None:
    scene = scene_of(Box(), House())
    half = replace(scene, objects=(replace(scene.objects[0], visible=False), scene.objects[1]))
    assert set(edge_picture(half, SIZE, window(half)).seen_of.tolist()) == {1}
    huge = scene_of(Torus(slices=200, sections=MOST_EDGES // 300))
    assert not len(edge_picture(huge, SIZE, window(huge)).seen)
