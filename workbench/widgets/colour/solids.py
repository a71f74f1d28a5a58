"""The solids of colour models: patches of colour in space, and where a colour lies in them.

The cube of red, green and blue has its black corner at the origin, that of cyan, magenta and yellow the white
one; the hexcone stands on its black tip, value upwards, red at the right. Places are (x, y, z), z upwards,
about the middle of the solid; colours are coded, 0 to 1.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.colour.hexagon import hexagon, place

Floats = NDArray[np.float64]
Triple = tuple[float, float, float]
Model = Literal["rgb", "cmy", "hsv"]

_CELLS = 9
_HEIGHT = 1.15
"""Of the hexcone, whose hexagon has the radius 0.8."""

_RADIUS = 0.8


@dataclass(frozen=True, slots=True)
class Solid:
    """Cells (n, 4, 3) of its surface, anticlockwise seen from outside, with their colours (n, 3).

    ``axes`` are lines from one place to another, with a letter at the end. ``place_of`` tells where a colour
    (r, g, b) lies, ``lines_to`` gives the way to it along the coordinates (m, 3).
    """

    cells: Floats
    colours: Floats
    axes: tuple[tuple[Triple, Triple, str], ...]
    place_of: Callable[[Triple], Triple]
    lines_to: Callable[[Triple], Floats]


def solid(model: Model) -> Solid:
    """The solid of a model."""
    return _hexcone() if model == "hsv" else _cube(model == "cmy")


def _grid(corners: Floats, colours: Floats) -> tuple[Floats, Floats]:
    """Cells of a patch (4, 3) and the colour (4, 3) in the middle of each."""
    steps = np.linspace(0.0, 1.0, _CELLS + 1)

    def at(values: Floats, u: Floats, v: Floats) -> Floats:
        u, v = u[..., None], v[..., None]
        a, b, c, d = values
        blended: Floats = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        return blended

    u, v = np.meshgrid(steps[:-1], steps[:-1], indexing="ij")
    du = 1.0 / _CELLS
    rings = [at(corners, u + i * du, v + j * du) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    cells = np.stack(rings, axis=2).reshape(-1, 4, 3)
    return cells, at(colours, u + 0.5 * du, v + 0.5 * du).reshape(-1, 3)


def _joined(patches: list[tuple[Floats, Floats]]) -> tuple[Floats, Floats]:
    grids = [_grid(corners, colours) for corners, colours in patches]
    return np.concatenate([cells for cells, _ in grids]), np.concatenate([colours for _, colours in grids])


def _cube(inks: bool) -> Solid:
    """From black with light added, or from white with light taken away."""

    def coordinates(colour: Floats) -> Floats:
        return 1.0 - colour if inks else colour

    patches = []
    for axis in range(3):
        for side in (0.0, 1.0):
            square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            ring = np.array([np.insert(np.array(corner), axis, side) for corner in square])
            if (side == 1.0) == (axis == 1):
                ring = ring[::-1]
            patches.append((ring - 0.5, coordinates(ring)))
    cells, colours = _joined(patches)

    def place_of(colour: Triple) -> Triple:
        x, y, z = (coordinates(np.array(colour)) - 0.5).tolist()
        return x, y, z

    def lines_to(colour: Triple) -> Floats:
        x, y, z = place_of(colour)
        return np.array([(-0.5, -0.5, -0.5), (x, -0.5, -0.5), (x, y, -0.5), (x, y, z)])

    origin = (-0.5, -0.5, -0.5)
    ends: tuple[Triple, ...] = ((0.5, -0.5, -0.5), (-0.5, 0.5, -0.5), (-0.5, -0.5, 0.5))
    axes = tuple((origin, end, letter) for end, letter in zip(ends, "CMY" if inks else "RGB", strict=True))
    return Solid(cells, colours, axes, place_of, lines_to)


_PURE = ((1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1), (1, 0, 1))


def _hexcone() -> Solid:
    top, bottom = 0.5 * _HEIGHT, -0.5 * _HEIGHT
    corners = [(_RADIUS * x, _RADIUS * y, top) for x, y in hexagon(1.0).tolist()]
    tip, centre = (0.0, 0.0, bottom), (0.0, 0.0, top)
    patches = []
    for k in range(6):
        after = (k + 1) % 6
        a, b = corners[k], corners[after]
        one, other = _PURE[k], _PURE[after]
        patches.append((np.array([centre, a, b, centre]), np.array([(1, 1, 1), one, other, (1, 1, 1)])))
        patches.append((np.array([tip, b, a, tip]), np.array([(0, 0, 0), other, one, (0, 0, 0)])))
    cells, colours = _joined([(ring, shades.astype(np.float64)) for ring, shades in patches])

    def place_of(colour: Triple) -> Triple:
        x, y = place(*colour)
        return _RADIUS * x, _RADIUS * y, bottom + _HEIGHT * max(colour)

    def lines_to(colour: Triple) -> Floats:
        x, y, z = place_of(colour)
        return np.array([tip, (0.0, 0.0, z), (x, y, z)])

    reach = 1.12
    axes = (
        (tip, (0.0, 0.0, top + 0.12), "V"),
        *(
            (centre, (reach * corners[k][0], reach * corners[k][1], top), letter)
            for k, letter in ((0, "R"), (2, "G"), (4, "B"))
        ),
    )
    return Solid(cells, colours, axes, place_of, lines_to)


def turned(places: Floats, turn: float, tilt: float) -> Floats:
    """Places (..., 3) seen from a direction: x to the right, y up, z towards the eye; angles in degrees.

    ``turn`` is about the upright axis, ``tilt`` how far the eye is above the solid.
    """
    a, b = math.radians(turn), math.radians(tilt)
    about = np.array([[math.cos(a), -math.sin(a), 0.0], [math.sin(a), math.cos(a), 0.0], [0.0, 0.0, 1.0]])
    # Looking along the world's +y, then raised by the tilt
    look = np.array(
        [
            [1.0, 0.0, 0.0],
            [0.0, math.sin(b), math.cos(b)],
            [0.0, -math.cos(b), math.sin(b)],
        ]
    )
    seen: Floats = places @ (look @ about).T
    return seen
