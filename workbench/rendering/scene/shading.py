"""Flat shading: one colour for each face, by Lambert's law, in coded colours as the course has them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from workbench.document.scene.model import Light, Material
from workbench.geometry.meshes import Array, Faces, face_normals
from workbench.rendering.scene.viewpoint import seen_faces


def flat_colours(
    points_world: Array, faces: Faces, material: Material, lights: Sequence[Light], viewer: Array
) -> NDArray[np.int64]:
    """The colour (m,), 0xRRGGBB, of each face: ambient light, and of each light what its direction leaves.

    A face that is seen from behind is lit on that side. ``viewer`` is as ``Viewpoint.viewer`` has it. Without
    lights one shines from where the viewer is, and from above.
    """
    normals = face_normals(points_world, faces)
    normals = np.where(seen_faces(viewer, points_world, faces, normals)[:, None], normals, -normals)
    middles = np.add.reduceat(points_world[faces.corners], faces.starts, axis=0) / faces.sizes[:, None]
    light_sum = np.full((len(faces), 3), material.ambient)
    for colour, direction in _directions(lights, middles, viewer):
        light_sum += material.diffuse * np.maximum(_cosines(normals, direction), 0.0)[:, None] * colour
    channels = np.clip(np.floor(light_sum * _channels(material.colour) * 255 + 0.5), 0, 255).astype(np.int64)
    packed: NDArray[np.int64] = channels[:, 0] << 16 | channels[:, 1] << 8 | channels[:, 2]
    return packed


def _directions(lights: Sequence[Light], middles: Array, viewer: Array) -> list[tuple[Array, Array]]:
    """Of each light its colour times its intensity, and from each point (m, 3) the way to it."""
    if not lights:
        towards = viewer[:3] - viewer[3] * middles
        lengths = np.sqrt((towards**2).sum(axis=1, keepdims=True))
        return [(np.ones(3), towards + lengths * [0.0, 0.6, 0.0])]
    found = []
    for light in lights:
        place = np.array(light.position.xyz)
        way = np.broadcast_to(place, middles.shape) if light.distant else place - middles
        found.append((light.intensity * _channels(light.colour), way))
    return found


def _cosines(normals: Array, directions: Array) -> Array:
    lengths = np.sqrt((normals**2).sum(axis=1) * (directions**2).sum(axis=1))
    products = (normals * directions).sum(axis=1)
    cosines: Array = np.divide(products, lengths, out=np.zeros(len(normals)), where=lengths > 0)
    return cosines


def _channels(colour: int) -> Array:
    return np.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255]) / 255
