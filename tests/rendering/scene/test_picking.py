"""What is at a place of a picture: the object, its face, the point of it."""

import numpy as np
from msgspec.structs import replace

from workbench.document.model import Rectangle
from workbench.document.samples.examples import example
from workbench.document.scene.model import Scene
from workbench.geometry.meshes import face_planes
from workbench.rendering.scene import render_scene
from workbench.rendering.scene.around import window_of
from workbench.rendering.scene.picking import pick
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Viewpoint

SIZE = (160, 120)


def house() -> Scene:
    scene = example("space-house").document.sheets[0].scene
    assert scene is not None
    return scene


def window(scene: Scene) -> Rectangle:
    return window_of(scene.camera, SIZE, np.concatenate([mesh.vertices for mesh, *_rest in placed(scene)]))


def test_the_object_at_a_pixel_is_the_one_whose_colour_is_there() -> None:
    # Nothing but ambient light: each object has one colour.
    materials = tuple(
        replace(each, colour=1 + number, ambient=1.0, diffuse=0.0)
        for number, each in enumerate(house().materials)
    )
    scene = replace(house(), materials=materials)
    image, depth = render_scene(scene, "depth_buffer", SIZE, window=window(scene))
    named = {0: "", **{1 + number: thing.id for number, thing in enumerate(scene.objects)}}
    wrong = 0
    for y in range(0, SIZE[1], 5):
        for x in range(0, SIZE[0], 5):
            there = named[int(image[y, x])] if depth[y, x] < 1.0 else ""
            at = pick(scene, SIZE, window(scene), x, y)
            wrong += (at.thing if at else "") != there
    assert wrong == 0


def test_the_point_lies_on_the_face_and_comes_to_that_place() -> None:
    scene = house()
    viewpoint = Viewpoint.of(scene.camera, SIZE, window(scene), np.zeros((0, 3)))
    meshes = {thing.id: mesh for thing, (mesh, *_rest) in zip(scene.objects, placed(scene), strict=True)}
    count = 0
    for y in range(0, SIZE[1], 7):
        for x in range(0, SIZE[0], 7):
            at = pick(scene, SIZE, window(scene), x, y)
            if at is None:
                continue
            count += 1
            u, v, _z, w = viewpoint.homogeneous(np.array([at.place]))[0]
            device = viewpoint.device
            assert np.allclose(
                (u / w * device[0, 0] + device[0, 2], v / w * device[1, 1] + device[1, 2]), (x, y)
            )
            A, B, C, D = face_planes(*meshes[at.thing])[at.face]
            away = abs(np.dot((A, B, C), at.place) + D) / np.linalg.norm((A, B, C))
            assert away < 1e-3  # corners on the device are rounded to 1/4096 of a pixel
    assert count > 50
