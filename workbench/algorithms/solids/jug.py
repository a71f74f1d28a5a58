"""A jug of bicubic Bézier patches: a body with a lip, and a handle."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.bernstein import bernstein
from workbench.geometry.meshes import Faces, Mesh

Array = NDArray[np.float64]

_KAPPA = 0.5522847498  # of a quarter circle as a cubic: the farthest it is from the circle is 0.03 %
_QUARTER = np.array([[1, 0], [1, _KAPPA], [_KAPPA, 1], [0, 1]])
# Foot, belly, neck and mouth: cubics from the axis outwards and upwards, points (r, y).
PROFILE = np.array(
    [
        [[0.0, 0.0], [0.2, 0.0], [0.45, 0.0], [0.6, 0.0]],
        [[0.6, 0.0], [1.05, 0.15], [1.15, 0.9], [0.8, 1.35]],
        [[0.8, 1.35], [0.6, 1.6], [0.5, 1.75], [0.6, 2.1]],
    ]
)
_LIP = (0.0, 0.0, 0.08, 0.35)  # how far the points of the neck are drawn out towards +x
# The middle of the handle, cubics of (x, y), and half of its width.
_HANDLE = np.array(
    [
        [[-0.55, 1.95], [-0.95, 2.15], [-1.55, 1.9], [-1.5, 1.4]],
        [[-1.5, 1.4], [-1.45, 0.9], [-1.2, 0.75], [-0.97, 0.75]],
    ]
)
_HALF_WIDTH = 0.09


def jug_nets() -> Array:
    """Its control nets (patches, 4, 4, 3), rows round the body or the handle, columns along it."""
    return np.concatenate([_body(), _handle()])


def jug(height: float = 2.0, steps: int = 6) -> Mesh:
    """The jug on y = 0, each patch in ``steps`` by ``steps`` quadrilaterals, open at its mouth.

    Raises: ValueError for a height that is not above 0, or steps that are not 1 to 64.
    """
    if not (np.isfinite(height) and height > 0 and 1 <= steps <= 64):
        raise ValueError(
            f"The jug is {height:g} high in {steps} steps; choose a height above 0, and 1 to 64."
        )
    weights = bernstein(3, np.linspace(0, 1, steps + 1))
    grids = np.einsum("ui,pijc,vj->puvc", weights, jug_nets() * (height / PROFILE[-1, -1, 1]), weights)
    number = np.arange(grids[..., 0].size).reshape(grids.shape[:3])
    quads = np.stack(
        [number[:, :-1, :-1], number[:, 1:, :-1], number[:, 1:, 1:], number[:, :-1, 1:]], axis=-1
    ).reshape(-1, 4)
    return _welded(grids.reshape(-1, 3), quads)


def _body() -> Array:
    nets = []
    for quarter in range(4):
        turn = np.linalg.matrix_power(np.array([[0.0, -1.0], [1.0, 0.0]]), quarter)
        across, away = (_QUARTER @ turn.T).T
        for piece, (r, y) in enumerate(PROFILE.transpose(0, 2, 1)):
            drawn_out = _LIP if piece == len(PROFILE) - 1 else (0.0,) * 4
            x = across[:, None] * r + np.maximum(across[:, None], 0.0) ** 2 * drawn_out
            nets.append(np.stack([x, np.broadcast_to(y, (4, 4)), -away[:, None] * r], axis=-1))
    return np.array(nets)


def _handle() -> Array:
    """A tube: each cubic of its middle, moved sideways along circles that stand across its ends."""
    nets = []
    for middle in _HANDLE:
        legs = np.array(
            [middle[1] - middle[0], middle[2] - middle[0], middle[3] - middle[1], middle[3] - middle[2]]
        )
        sideways = np.column_stack([-legs[:, 1], legs[:, 0]]) / np.sqrt((legs**2).sum(axis=1))[:, None]
        for quarter in range(4):
            turn = np.linalg.matrix_power(np.array([[0.0, -1.0], [1.0, 0.0]]), quarter)
            out, across = _HALF_WIDTH * (_QUARTER @ turn.T).T
            flat = middle[None] + out[:, None, None] * sideways[None]
            nets.append(np.concatenate([flat, np.broadcast_to(across[:, None, None], (4, 4, 1))], axis=-1))
    return np.array(nets)


def _welded(vertices: Array, quads: NDArray[np.int64]) -> Mesh:
    """The mesh in which vertices of one place are one, and corners that have become one are there once."""
    _places, first, number = np.unique(
        np.round(vertices, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    faces = [list(dict.fromkeys(face)) for face in number.reshape(-1)[quads].tolist()]
    return Mesh(vertices[first], Faces.of([face for face in faces if len(face) > 2]))
