"""What of a light is worth a word: that it is in a face, or that its coefficients let it not fade."""

import numpy as np

from workbench.document.scene.model import Light, Scene
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.rendering.scene.lit_triangles import blockers_of

_NEAR = 1e-3
_MOST_TRIANGLES = 20_000


def word_of(light: Light, scene: Scene) -> str:
    """One sentence, empty where there is none to say."""
    if light.distant:
        if not any(light.position.xyz):
            return _(
                "The direction of this light is (0, 0, 0), so it lights nothing; change one of the numbers."
            )
        return ""
    if not (light.a0 or light.a1 or light.a2):
        return _(
            "a₀, a₁ and a₂ are all 0, which would divide by 0: the light does not fade. Make one larger."
        )
    corners, _count = blockers_of(scene, _MOST_TRIANGLES)
    if in_a_face(np.array(light.position.xyz), corners.reshape(-1, 3, 3)):
        return _(
            "This light is in a face, which it cannot light: only its other side, or nothing. Move it out."
        )
    return ""


def in_a_face(place: Array, corners: Array) -> bool:
    """Whether a place (3,) is in one of the triangles (t, 3, 3), but for a thousandth of its size."""
    a, along, across = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = np.cross(along, across)
    squares = (normals * normals).sum(axis=1)
    good = squares > 0
    normals, squares, way = normals[good], squares[good], place - a[good]
    above = (way * normals).sum(axis=1) / np.sqrt(squares)
    b = (np.cross(way, across[good]) * normals).sum(axis=1) / squares
    c = (np.cross(along[good], way) * normals).sum(axis=1) / squares
    near = np.abs(above) < _NEAR * np.sqrt(np.sqrt(squares))
    return bool((near & (b >= 0) & (c >= 0) & (b + c <= 1)).any())
