"""Pictures in linear light beside the texts, channel by channel, and what the shadings get of a scene."""

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms.shading import gouraud
from workbench.display.exposure import srgb_encoded
from workbench.document.model import Rectangle
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Camera, Light, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, MeshSolid, Sphere
from workbench.engine.stopping import Stop, Stopped
from workbench.geometry.meshes import Faces, Mesh, triangulated
from workbench.rendering.scene import render_scene
from workbench.rendering.scene.lit_triangles import blockers_of, lit_triangles
from workbench.rendering.scene.shaded import Buffers, Model, shaded, shading_call
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.scene.smoothing import CornerNormals

SIZE, WINDOW = (24, 16), Rectangle(-1.5, -1.0, 1.5, 1.0)


def scene(**camera: object) -> Scene:
    objects = Object("o1", Sphere(0.9, 8, 5), "m1"), Object("o2", Box(2.4, 0.6, 0.6), "m2")
    materials = Material("m1", colour=0xD05030, shininess=8.0), Material("m2", colour=0x3060C0, specular=0.0)
    lights = (
        Light("l1", Point3D(2.0, 2.0, 3.0), colour=0xFFD8A0, distant=False, a0=0.5, a1=0.1),
        Light("l2", Point3D(-3.0, 1.0, 2.0), intensity=0.4),
    )
    given = Camera(eye=Point3D(1.0, 2.0, 6.0), near=2.0, far=20.0, distance=6.0)
    return Scene(objects, materials, lights, replace(given, **camera))


@pytest.mark.parametrize("shading", LIT_SHADINGS)
@pytest.mark.parametrize("model", [Model(), Model(by_halfway=True, shadows=True)], ids=["V.R", "N.H"])
def test_each_channel_is_that_of_the_text(shading: str, model: Model) -> None:
    seen = scene()
    image, depth = shaded(seen, shading, SIZE, WINDOW, model)
    lit = lit_triangles(seen, SIZE, WINDOW)
    blockers, _count = blockers_of(seen, 1_000 if model.shadows else 0)
    for channel, shift in enumerate((16, 8, 0)):
        call = shading_call(lit, shading, Buffers.of(SIZE), model, blockers, channel)
        list(call.entry.function(*call.arguments))
        exact = srgb_encoded(call.arguments[0]) * 255
        assert np.abs((image >> shift & 255) - exact).max() <= (1.01 if shading == gouraud.__name__ else 0.51)
        assert np.array_equal(call.arguments[-1], depth)
    assert (depth < 1).any()
    assert (depth == 1).any()


def all_normals(mesh: Mesh) -> np.ndarray:
    triangles, owners = triangulated(*mesh)
    return CornerNormals(mesh, triangles, owners).of(0, len(triangles))


def test_normals_are_smooth_on_a_sphere_and_flat_on_a_box() -> None:
    for solid, expected in ((Sphere(1.0, 24, 12), None), (Box(2.0, 2.0, 2.0), 1)):
        mesh = solid.mesh(())
        triangles, _owners = triangulated(*mesh)
        normals = all_normals(mesh)
        assert np.linalg.norm(normals, axis=2) == pytest.approx(1.0)
        if expected is None:
            assert np.abs(normals - mesh.vertices[triangles]).max() < 0.07
        else:
            assert (np.abs(normals).max(axis=2) == 1).all()
            assert (normals == normals[:, :1]).all()


def test_vertices_in_one_place_are_one_to_the_normals() -> None:
    mesh = Sphere(1.0, 12, 6).mesh(())
    triangles, _owners = triangulated(*mesh)
    apart = Mesh(mesh.vertices[triangles].reshape(-1, 3), Faces.of(np.arange(triangles.size).reshape(-1, 3)))
    loose = all_normals(apart)
    assert np.abs(loose - all_normals(mesh)).max() < 0.2
    of_place: dict[tuple[float, ...], list[np.ndarray]] = {}
    for place, normal in zip(map(tuple, apart.vertices.round(6).tolist()), loose.reshape(-1, 3), strict=True):
        of_place.setdefault(place, []).append(normal)
    assert all(np.ptp(np.array(each), axis=0).max() < 1e-6 for each in of_place.values())


@pytest.mark.parametrize("projection", ["perspective", "orthographic", "cabinet"])
def test_what_the_near_plane_cuts_keeps_its_places_and_normals(projection: str) -> None:
    """A sphere of which half is too near: each corner that is left lies on the sphere's faces."""
    ball = Object("o1", Sphere(1.0, 24, 16), "m1")
    camera = Camera(projection, eye=Point3D(0.0, 0.0, 4.0), near=3.6, far=20.0, distance=4.0)
    seen = Scene((ball,), (Material("m1"),), (Light("l1"),), camera)
    lit = lit_triangles(seen, (64, 64), Rectangle(-2.0, -2.0, 2.0, 2.0))
    away = np.linalg.norm(lit.places, axis=1)
    assert 0.95 < away.min() <= away.max() < 1.01
    assert len(lit.places) > 100
    front = (lit.normals * lit.places).sum(axis=1)
    inside = (lit.corners[:, 2] < 0.01) & (front < 0)  # seen through the hole, from inside
    assert np.abs(np.abs(front[~inside]) - away[~inside]).max() < 0.1


def test_without_lights_it_is_lit_from_above_the_eye() -> None:
    dark = replace(scene(), lights=())
    lit = lit_triangles(dark, SIZE, WINDOW)
    assert lit.lights.shape == (1, 8)
    image, _depth = render_scene(dark, "depth_buffer", SIZE, "phong", WINDOW)
    assert len(np.unique(image)) > 20


def test_a_scene_without_polygons_is_an_empty_picture() -> None:
    nothing = Scene()
    for shading in LIT_SHADINGS:
        image, depth = shaded(nothing, shading, SIZE, WINDOW)
        assert not image.any()
        assert (depth == 1).all()


def test_too_many_blockers_are_said() -> None:
    balls = tuple(Object(f"o{k}", Sphere(1.0, 200, 150), "m1") for k in (1, 2))
    large = replace(scene(), objects=balls)
    with pytest.raises(ValueError, match=r"Shadows are cast by up to 100,000 triangles, but there are .*\.$"):
        shaded(large, "phong", SIZE, WINDOW, Model(shadows=True))


def test_a_mesh_of_one_triangle_from_behind_is_lit_there() -> None:
    mesh = Mesh(np.array([[-1.0, -1, 0], [1, -1, 0], [0, 1, 0]]), Faces.of([[0, 2, 1]]))
    thing = Object("o1", MeshSolid(blob_of(mesh)), "m1")
    material = Material("m1", colour=0xFFFFFF, ambient=0.0, diffuse=1.0, specular=0.0)
    camera = Camera("orthographic", eye=Point3D(0.0, 0.0, 4.0), near=1.0, far=9.0)
    seen = Scene((thing,), (material,), (Light("l1", Point3D(0.0, 0.0, 1.0)),), camera)
    for shading in LIT_SHADINGS:
        image, depth = shaded(seen, shading, SIZE, WINDOW)
        assert set(image[depth < 1].tolist()) == {0xFFFFFF}


def test_light_of_corners_is_stopped_before_anything_is_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """With shadows it takes seconds, for which a program that ends would wait."""
    drawn: list[object] = []
    monkeypatch.setattr(
        "workbench.rendering.scene.shaded.gouraud_drawn", lambda *given: drawn.append([*given[0]()])
    )
    stop = Stop()
    stop.set()
    with pytest.raises(Stopped):
        shaded(scene(), gouraud.__name__, SIZE, WINDOW, Model(shadows=True), stop)
    assert drawn == []
