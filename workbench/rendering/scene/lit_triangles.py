"""A scene as the shadings get it: device triangles with places and normals, materials, lights and the eye."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from workbench.algorithms.visibility.whole_scene import FROM_ABOVE
from workbench.display.phosphor import linear_from_srgb
from workbench.document.model import Rectangle
from workbench.document.scene.model import Camera, Light, Scene
from workbench.geometry.meshes import Array, Index
from workbench.rendering.scene.render import Part, placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint


class LitTriangles(NamedTuple):
    """Device corners (3 t, 3), three for each triangle, x and y on a grid of 1/4096 px; the same in the
    world; unit normals (3 t, 3), on the side that is seen; of each triangle (t,) its object's number among
    the visible ones and its face there, its linear colour (t, 3) and the numbers k_a, k_d, k_s, n (t, 4);
    the eye (4,); rows of lights (k, 8) as of ``illuminate``, and their linear colours (k, 3)."""

    corners: Array
    places: Array
    normals: Array
    objects: Index
    faces: Index
    colours: Array
    materials: Array
    eye: Array
    lights: Array
    light_colours: Array

    @property
    def triangles(self) -> Index:
        """(t, 3) numbers of corners."""
        return np.arange(len(self.corners)).reshape(-1, 3)

    def in_channel(self, channel: int) -> tuple[Array, Array]:
        """Materials (t, 4) and lights (k, 8) of red, green or blue: the model is applied to each alone.

        What is mirrored has the light's colour, not the surface's.
        """
        materials, lights = self.materials.copy(), self.lights.copy()
        materials[:, :2] *= self.colours[:, channel, None]
        lights[:, 4] *= self.light_colours[:, channel]
        return materials, lights


def lit_triangles(scene: Scene, size: Size, window: Rectangle | None) -> LitTriangles:
    """What of ``scene`` lies before its camera, on a picture of ``size``. Raises: ValueError, a sentence."""
    parts = placed(scene)
    meshes = [] if window else [mesh.vertices for mesh, *_rest in parts]
    viewpoint = Viewpoint.of(scene.camera, size, window, np.concatenate([np.zeros((0, 3)), *meshes]))
    pieces = [_piece(part, viewpoint, number) for number, part in enumerate(parts)]
    place, number = np.zeros((0, 3)), np.zeros(0, np.int64)
    nothing = place, place, place, number, number, place, np.zeros((0, 4))
    columns: Any = [np.concatenate(column) for column in zip(nothing, *pieces, strict=True)]
    rows, colours = light_rows(scene.lights, scene.camera)
    return LitTriangles._make((*columns, viewpoint.viewer, rows, colours))


def _piece(part: Part, viewpoint: Viewpoint, number: int) -> tuple[Array | Index, ...]:
    """What of an object is drawn, in the order of ``LitTriangles``."""
    mesh, (cut, face_of), material, lasting = part
    drawn = viewpoint.drawn(mesh.vertices, cut, lasting.box)
    places = drawn.of_owners(mesh.vertices[cut])
    normals = drawn.of_owners(lasting.corner_normals(cut, face_of))
    if drawn.owners is not None:
        whole, places = places, _in_world(viewpoint, drawn.corners[drawn.triangles])
        normals = _shares(places, whole) @ normals
    flat = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
    viewer = viewpoint.viewer
    towards = viewer[:3] - viewer[3] * places[:, 0]
    side = np.where((flat * towards).sum(axis=1) < 0, -1.0, 1.0)
    count = len(drawn.triangles)
    shares = material.ambient, material.diffuse, material.specular, material.shininess
    return (
        drawn.corners[drawn.triangles].reshape(-1, 3),
        places.reshape(-1, 3),
        (normals * side[:, None, None]).reshape(-1, 3),
        np.full(count, number),
        drawn.of_owners(face_of),
        np.tile(linear_from_srgb(material.colour), (count, 1)),
        np.tile(shares, (count, 1)),
    )


def _in_world(viewpoint: Viewpoint, device: Array) -> Array:
    """Device corners (t, 3, 3) in the world."""
    across = np.linalg.inv(viewpoint.device)
    flat = device[..., :2] * across.diagonal()[:2] + across[:2, 2]
    homogeneous = np.concatenate([flat, device[..., 2:], np.ones((*device.shape[:2], 1))], axis=2)
    world = homogeneous @ np.linalg.pinv(viewpoint.matrix).T
    places: Array = world[..., :3] / world[..., 3:]
    return places


def _shares(places: Array, whole: Array) -> Array:
    """Barycentric coordinates (t, 3, 3) of three places each in a triangle of the world."""
    origin, b, c = whole[:, 0], whole[:, 1] - whole[:, 0], whole[:, 2] - whole[:, 0]
    bb, bc, cc = ((first * second).sum(axis=1) for first, second in ((b, b), (b, c), (c, c)))
    from_origin = places - origin[:, None]
    to_b, to_c = (np.einsum("tij,tj->ti", from_origin, side) for side in (b, c))
    area = np.maximum(bb * cc - bc * bc, np.finfo(np.float64).tiny)[:, None]
    share_b = (cc[:, None] * to_b - bc[:, None] * to_c) / area
    share_c = (bb[:, None] * to_c - bc[:, None] * to_b) / area
    return np.stack([1.0 - share_b - share_c, share_b, share_c], axis=2)


def light_rows(lights: Sequence[Light], camera: Camera) -> tuple[Array, Array]:
    """Rows (k, 8) of lights, and their linear colours (k, 3); one above the eye where a scene has none."""
    if not lights:
        eye, middle = np.array(camera.eye.xyz), np.array(camera.look_at.xyz)
        above = eye + FROM_ABOVE * float(np.linalg.norm(eye - middle)) * np.array([0.0, 1.0, 0.0])
        return np.array([[*above, 1.0, 1.0, 1.0, 0.0, 0.0]]), np.ones((1, 3))
    rows = [
        (*each.position.xyz, float(not each.distant), each.intensity, each.a0, each.a1, each.a2)
        for each in lights
    ]
    return np.array(rows), np.array([linear_from_srgb(each.colour) for each in lights])


def blockers_of(scene: Scene) -> Array:
    """Corners (3 k, 3) of the triangles of all visible objects, three for each."""
    corners = [mesh.vertices[cut].reshape(-1, 3) for mesh, (cut, _faces), *_rest in placed(scene)]
    return np.concatenate([np.zeros((0, 3)), *corners])
