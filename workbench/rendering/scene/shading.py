"""Quick shading while a scene is looked at: a colour for each face, by Lambert's law, in coded colours.

The shadings of the course, in linear light and with highlights, are those of ``shaded``.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.shading import fast_phong, flat_shading, gouraud, phong
from workbench.algorithms.visibility.whole_scene import face_colours
from workbench.document.scene.model import Light, Material
from workbench.geometry.meshes import Array
from workbench.rendering.scene.lasting import Lasting
from workbench.rendering.triangles import written_in_shares

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
    colours = np.empty(faces.count, np.int64)
    rows = [(*e.position.xyz, not e.distant, *(e.intensity * _channels(e.colour))) for e in lights]
    lasting = faces.normals, faces.distances, faces.middles
    lamps = np.array(rows, np.float64).reshape(-1, 7)
    surface = np.array([material.ambient, material.diffuse, *_channels(material.colour)])

    def share(first: int, end: int) -> tuple[Any, ...]:
        return colours, first, end, *lasting, viewer, lamps, surface

    written_in_shares(faces.count, face_colours, share)
    return colours


def _channels(colour: int) -> Array:
    return np.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255]) / 255
