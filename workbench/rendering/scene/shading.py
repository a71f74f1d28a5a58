"""Flat shading: one colour for each face, by Lambert's law, in coded colours as the course has them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from workbench.document.scene.model import Light, Material
from workbench.geometry.meshes import Array
from workbench.rendering.scene.lasting import Lasting


def flat_colours(
    faces: Lasting, material: Material, lights: Sequence[Light], viewer: Array
) -> NDArray[np.int64]:
    """The colour (m,), 0xRRGGBB, of each face: ambient light, and of each light what its direction leaves.

    A face that is seen from behind is lit on that side. ``viewer`` is as ``Viewpoint.viewer`` has it. Without
    lights one shines from where the viewer is, and from above.
    """
    normals = faces.normals
    # Seen from in front: N . (eye - P) > 0, or N . direction > 0
    side = np.where(viewer[:3] @ normals > viewer[3] * faces.distances, 1.0, -1.0)
    light_sum = np.full((1, normals.shape[1]), material.ambient)
    for colour, way in _directions(lights, faces, viewer):
        light_sum = light_sum + material.diffuse * colour * np.maximum(side * _cosines(normals, way), 0.0)
    channels = np.minimum(light_sum * (_channels(material.colour) * 255)[:, None] + 0.5, 255.0)
    red, green, blue = channels.astype(np.int64)
    packed: NDArray[np.int64] = red << 16 | green << 8 | blue
    return packed


def _directions(lights: Sequence[Light], faces: Lasting, viewer: Array) -> list[tuple[Array, Array]]:
    """Of each light its colour times its intensity (3, 1), of a white one (1, 1), and the way to it, (3,) for
    all faces or (3, m)."""
    if not lights:
        towards = viewer[:3] if viewer[3] == 0 else viewer[:3, None] - viewer[3] * faces.middles
        above = np.array([0.0, 0.6, 0.0]).reshape(3, *[1] * (towards.ndim - 1))
        return [(np.ones((1, 1)), towards + np.sqrt((towards * towards).sum(axis=0)) * above)]
    found = []
    for light in lights:
        place, colour = np.array(light.position.xyz), light.intensity * _channels(light.colour)[:, None]
        way = place if light.distant else place[:, None] - faces.middles
        found.append((colour[:1] if np.ptp(colour) == 0 else colour, way))
    return found


def _cosines(normals: Array, way: Array) -> Array:
    """Of the angles between unit normals (3, m) and a way or ways; 0 where there is none."""
    lengths = np.sqrt((way * way).sum(axis=0))
    products = way @ normals if way.ndim == 1 else (normals * way).sum(axis=0)
    cosines: Array = np.divide(products, lengths, out=np.zeros(normals.shape[1]), where=lengths > 0)
    return cosines


def _channels(colour: int) -> Array:
    return np.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255]) / 255
