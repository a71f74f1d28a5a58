"""Flat colours beside Lambert's law, face by face."""

import math
import threading
import tracemalloc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.document.scene.model import Light, Material, Point3D
from workbench.engine import compiled
from workbench.geometry.meshes import Faces, Mesh, face_normals
from workbench.rendering import triangles
from workbench.rendering.scene.lasting import Lasting
from workbench.rendering.scene.shading import flat_colours

MATERIAL = Material("m1", "", 0x4080FF, 0.25, 0.6)
FACES = Faces.of([[0, 1, 2], [2, 1, 3], [3, 4, 5], [0, 4, 5], [1, 5, 2]])


def by_hand(mesh, lights, viewer):
    """The channels (m, 3) of each face, 0 to 255, not yet rounded."""
    found = []
    for face, normal in zip(mesh.faces, face_normals(*mesh), strict=True):
        corners = mesh.vertices[face]
        middle = corners.mean(axis=0)
        towards = viewer[:3] - viewer[3] * corners[0]
        if normal @ towards <= 0:
            normal = -normal
        light_sum = np.full(3, MATERIAL.ambient)
        ways = [(np.array(each.position.xyz) - (not each.distant) * middle, each) for each in lights]
        if not lights:
            way = viewer[:3] - viewer[3] * middle
            ways = [(way + np.array([0, 0.6 * math.dist(way, (0, 0, 0)), 0]), Light("l1"))]
        for way, light in ways:
            cosine = (normal @ way) / math.sqrt((normal @ normal) * (way @ way))
            channels = np.array([light.colour >> shift & 255 for shift in (16, 8, 0)]) / 255
            light_sum = light_sum + MATERIAL.diffuse * max(cosine, 0) * light.intensity * channels
        channels = np.array([MATERIAL.colour >> shift & 255 for shift in (16, 8, 0)])
        found.append(np.minimum(light_sum * channels, 255))
    return np.array(found)


@pytest.mark.parametrize(
    "lights",
    [
        (),
        (Light("l1"),),
        (Light("l1", Point3D(1, 2, 3), distant=False, intensity=0.7),),
        (Light("l1", colour=0xFF8000), Light("l2", Point3D(-3, 1, 0), colour=0x20FF40, distant=False)),
    ],
    ids=["viewer", "distant", "near", "two colours"],
)
@given(seed=st.integers(0, 10**6), from_a_point=st.booleans())
def test_each_face_is_lit_by_the_cosine(lights, seed, from_a_point) -> None:
    rng = np.random.default_rng(seed)
    mesh = Mesh(rng.normal(size=(6, 3)), FACES)
    viewer = np.append(rng.normal(size=3) * 5, float(from_a_point))
    colours = flat_colours(Lasting(mesh), MATERIAL, lights, viewer)
    channels = np.stack([colours >> shift & 255 for shift in (16, 8, 0)], axis=1)
    assert np.abs(channels - by_hand(mesh, lights, viewer)).max() <= 0.5 + 1e-6


def test_colours_of_many_faces_take_little_memory_on_the_way() -> None:
    rng = np.random.default_rng(3)
    count = 200_000
    faces = Lasting(Mesh(rng.normal(size=(500, 3)), Faces.of(rng.integers(0, 500, (count, 3)))))
    viewer = np.array([3.0, 4.0, 9.0, 1.0])
    whole = flat_colours(faces, MATERIAL, (), viewer)  # what lasts is made
    tracemalloc.start()
    flat_colours(faces, MATERIAL, (), viewer)
    _now, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 1.5 * whole.nbytes


def test_on_two_threads_each_face_has_the_colour_it_has_on_one(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(4)
    faces = Lasting(Mesh(rng.normal(size=(50, 3)), Faces.of(rng.integers(0, 50, (31, 3)))))
    viewer, lights = np.array([3.0, 4.0, 9.0, 1.0]), (Light("l1"),)
    whole = flat_colours(faces, MATERIAL, lights, viewer)
    threads = set()
    monkeypatch.setattr(triangles, "_FEW_ITEMS", 7)
    monkeypatch.setattr(
        triangles, "paint", lambda *a, **k: threads.add(threading.get_ident()) or compiled.paint(*a, **k)
    )
    assert np.array_equal(flat_colours(faces, MATERIAL, lights, viewer), whole)
    assert len(threads) == 2
    assert threading.get_ident() in threads  # it does not only wait
