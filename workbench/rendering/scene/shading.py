"""Quick shading while a scene is looked at: a colour for each face, by Lambert's law, in coded colours.

The shadings of the course, in linear light and with highlights, are those of ``shaded``.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.shading import fast_phong, flat_shading, gouraud, phong
from workbench.document.scene.model import Light, Material
from workbench.geometry.meshes import Array
from workbench.rendering.scene.lasting import FacesOf, Lasting

_AT_ONCE = 1 << 14  # faces: what is worked out on the way to their colours stays small, and in the cache

QUICK = "flat"
LIT_SHADINGS = tuple(text.__name__ for text in (flat_shading, gouraud, phong, fast_phong))
"""Their slugs, in teaching order."""


def flat_colours(
    faces: Lasting, material: Material, lights: Sequence[Light], viewer: Array
) -> NDArray[np.int64]:
    """The colour (m,), 0xRRGGBB, of each face: ambient light, and of each light what its direction leaves.

    A face that is seen from behind is lit on that side. ``viewer`` is as ``Viewpoint.viewer`` has it. Without
    lights one shines from where the viewer is, and from above.
    """
    colours = np.zeros(faces.count, np.int64)
    for start in range(0, faces.count, _AT_ONCE):
        part = slice(start, start + _AT_ONCE)
        colours[part] = _colours(FacesOf(faces, part), material, lights, viewer)
    return colours


def _colours(faces: FacesOf, material: Material, lights: Sequence[Light], viewer: Array) -> NDArray[np.int64]:
    # Seen from in front: N . (eye - P) > 0, or N . direction > 0
    side = np.where(viewer[:3] @ faces.normals > viewer[3] * faces.distances, 1.0, -1.0)
    light_sum = np.full((1, len(side)), material.ambient)
    for colour, cosines in _lit(lights, faces, viewer):
        cosines *= side
        light_sum = light_sum + material.diffuse * colour * np.maximum(cosines, 0.0, out=cosines)
    packed = np.zeros(len(side), np.int64)
    for share, channel in zip(
        np.broadcast_to(light_sum, (3, len(side))), _channels(material.colour), strict=True
    ):
        coded = share * (channel * 255)
        coded += 0.5
        packed = packed << 8 | np.minimum(coded, 255.0, out=coded).astype(np.int64)
    return packed


def _lit(lights: Sequence[Light], faces: FacesOf, viewer: Array) -> list[tuple[Array, Array]]:
    """Of each light its colour times its intensity (3, 1), of a white one (1, 1), and of each face (m,) the
    cosine of the angle between its normal and the way to the light."""
    if not lights:
        return [(np.ones((1, 1)), _from_viewer(faces, viewer))]
    found = []
    for light in lights:
        place, colour = np.array(light.position.xyz), light.intensity * _channels(light.colour)[:, None]
        way = place if light.distant else place[:, None] - faces.middles
        products = way @ faces.normals if light.distant else (faces.normals * way).sum(axis=0)
        lengths = np.sqrt((way * way).sum(axis=0))
        found.append((colour[:1] if np.ptp(colour) == 0 else colour, _ratio(products, lengths)))
    return found


def _from_viewer(faces: FacesOf, viewer: Array) -> Array:
    """The cosines for a light that is above the viewer by six tenths of the way to the face."""
    products = viewer[:3] @ faces.normals - viewer[3] * faces.distances
    if viewer[3] == 0:
        length, height = np.full(1, np.sqrt((viewer * viewer).sum())), viewer[1]
    else:
        # |V - M|^2 = M^2 - 2 V . M + V^2: fewer passes through memory than by the differences
        squares = faces.squares - (2 * viewer[:3]) @ faces.middles
        squares += (viewer[:3] * viewer[:3]).sum()
        length, height = np.sqrt(np.maximum(squares, 0.0, out=squares)), viewer[1] - faces.middles[1]
    products += 0.6 * length * faces.normals[1]
    lengths = np.maximum(length * (1.36 * length + 1.2 * height), 0.0)
    return _ratio(products, np.sqrt(lengths))


def _ratio(products: Array, lengths: Array) -> Array:
    """Their ratios (m,), 0 where a length is."""
    cosines: Array = np.divide(products, lengths, out=np.zeros(len(products)), where=lengths > 0)
    return cosines


def _channels(colour: int) -> Array:
    return np.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255]) / 255
