"""The light of all corners of a scene at once, for a picture that cannot wait until a kernel is there."""

import numpy as np

from workbench.geometry.meshes import Array


def corner_light(
    places: Array, normals: Array, materials: Array, eye: Array, lights: Array, by_halfway: bool
) -> Array:
    """The light (n,) of points (n, 3) with normals (n, 3) and materials (n, 4), nothing in its way.

    What ``corner_lights`` gives without blockers, by the same model, one light after the other.
    """
    N, V = _unit(normals), _unit(eye[:3] - eye[3] * places)
    total = materials[:, 0].astype(np.float64)
    for light in lights:
        way = light[:3] - light[3] * places
        d = np.sqrt((way * way).sum(axis=1))
        f = 1.0 / np.maximum(light[5] + light[6] * d + light[7] * d * d, 1.0) if light[3] else 1.0
        L = _unit(way)
        cosine = (N * L).sum(axis=1)
        R = 2 * cosine[:, None] * N - L
        mirror = (N * _unit(L + V)).sum(axis=1) if by_halfway else (V * R).sum(axis=1)
        scattered = materials[:, 1] * cosine
        mirrored = materials[:, 2] * np.power(np.maximum(mirror, 0.0), materials[:, 3])
        total += np.where((N * way).sum(axis=1) > 0, f * light[4] * (scattered + mirrored), 0.0)
    return total


def _unit(vectors: Array) -> Array:
    sizes = np.sqrt((vectors * vectors).sum(axis=1, keepdims=True))
    unit: Array = vectors / np.where(sizes == 0, 1.0, sizes)
    return unit
