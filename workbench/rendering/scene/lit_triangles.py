"""A scene as the shadings get it: device triangles with places and normals, materials, lights and the eye."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from workbench.algorithms.visibility.whole_scene import FROM_ABOVE
from workbench.display.phosphor import linear_from_srgb
from workbench.document.model import Rectangle
from workbench.document.scene.model import Camera, Light, Scene
from workbench.geometry.meshes import Array, Index
from workbench.rendering.scene.render import Part, placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint

AT_ONCE = 1 << 15
"""So many triangles of a scene are lit at a time: all of a fine mesh would take gigabytes."""


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
    (whole,) = lit_shares(scene, size, window, sum(_counts(scene)))
    return whole


def lit_shares(
    scene: Scene, size: Size, window: Rectangle | None, at_once: int = AT_ONCE
) -> Iterator[LitTriangles]:
    """The same in shares of at most ``at_once`` of the scene's triangles, at least one share."""
    parts = placed(scene)
    meshes = [] if window else [mesh.vertices for mesh, *_rest in parts]
    viewpoint = Viewpoint.of(scene.camera, size, window, np.concatenate([np.zeros((0, 3)), *meshes]))
    rows, colours = light_rows(scene.lights, scene.camera)
    place, number = np.zeros((0, 3)), np.zeros(0, np.int64)
    nothing = place, place, place, number, number, place, np.zeros((0, 4))
    for share in _spans(_counts(scene), at_once):
        pieces = [_piece(parts[number], viewpoint, number, first, end) for number, first, end in share]
        columns: Any = [np.concatenate(column) for column in zip(nothing, *pieces, strict=True)]
        yield LitTriangles._make((*columns, viewpoint.viewer, rows, colours))


def _counts(scene: Scene) -> list[int]:
    """How many triangles each visible object has."""
    return [len(cut) for _mesh, (cut, _faces), *_rest in placed(scene)]


def _spans(counts: Sequence[int], at_once: int) -> list[list[tuple[int, int, int]]]:
    """Shares of at most ``at_once`` triangles, at least one share: of each object in it the number, and its
    first triangle and the end."""
    shares: list[list[tuple[int, int, int]]] = [[]]
    room = at_once
    for number, count in enumerate(counts):
        first = 0
        while first < count:
            if room == 0:
                shares.append([])
                room = at_once
            end = min(first + room, count)
            shares[-1].append((number, first, end))
            room -= end - first
            first = end
    return shares


def _piece(part: Part, viewpoint: Viewpoint, number: int, first: int, end: int) -> tuple[Array | Index, ...]:
    """What of some triangles of an object is drawn, in the order of ``LitTriangles``."""
    mesh, (every_cut, every_face), material, lasting = part
    cut, face_of, vertices = every_cut[first:end], every_face[first:end], mesh.vertices
    normals = lasting.corner_normals(every_cut, every_face).of(first, end)
    if end - first < len(every_cut):  # the others' vertices are not looked at
        used = np.zeros(len(vertices), bool)
        used[cut] = True
        vertices, cut = vertices[used], (np.cumsum(used) - 1)[cut]
    drawn = viewpoint.drawn(vertices, cut, lasting.box)
    places, normals = drawn.of_owners(vertices[cut]), drawn.of_owners(normals)
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


def blockers_of(scene: Scene, most: int) -> tuple[Array, int]:
    """Corners (3 k, 3) of the triangles of all visible objects, three for each, none where more than ``most``
    are there; and how many triangles there are."""
    count = sum(_counts(scene))
    parts = placed(scene) if count <= most else ()
    corners = [mesh.vertices[cut].reshape(-1, 3) for mesh, (cut, _faces), *_rest in parts]
    return np.concatenate([np.zeros((0, 3)), *corners]), count
