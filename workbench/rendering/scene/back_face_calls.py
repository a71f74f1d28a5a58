"""The test for back faces on a scene: its calls, in which order they tell faces, and which it leaves."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.visibility import back_faces
from workbench.document.scene.model import Camera, Scene
from workbench.geometry.meshes import Array, Mesh
from workbench.rendering.mapping import Call
from workbench.rendering.scene.render import DeviceTriangles, placed

BACK_FACES = back_faces.__name__


def looks_from_a_point(camera: Camera) -> bool:
    """Whether the text can be run for a camera: it looks from a point."""
    return camera.projection == "perspective"


def back_face_calls(scene: Scene) -> list[Call]:
    """Each object's faces, one call for all that have equally many corners."""
    eye, look_at = np.array(scene.camera.eye.xyz), np.array(scene.camera.look_at.xyz)
    entry = catalogue.get(BACK_FACES)
    return [
        Call(entry, (mesh.vertices, faces, eye, look_at))
        for mesh, *_rest in placed(scene)
        for faces in _by_corners(mesh)
    ]


def faces_in_order(scene: Scene) -> list[tuple[int, int]]:
    """The number of its object and its own of each face, in the order in which the calls tell them."""
    return [
        (number, int(face))
        for number, (mesh, *_rest) in enumerate(placed(scene))
        for face in np.argsort(mesh.faces.sizes, kind="stable")
    ]


def triangles_left(scene: Scene, device: DeviceTriangles) -> NDArray[np.bool_]:
    """(t,) whether each device triangle is a part of a face that is turned towards the eye."""
    from workbench.engine.compiled import collect

    told = [
        bool(row[2])
        for call in back_face_calls(scene)
        for row in collect(call.entry.function, *call.arguments, compiling=False)
    ]
    seen = dict(zip(faces_in_order(scene), told, strict=True))
    owners = zip(device.objects.tolist(), device.faces.tolist(), strict=True)
    return np.array([seen[owner] for owner in owners], bool)


def _by_corners(mesh: Mesh) -> list[Array]:
    sizes = mesh.faces.sizes
    return [
        mesh.faces.corners[np.repeat(sizes == size, sizes)].reshape(-1, size) for size in np.unique(sizes)
    ]
