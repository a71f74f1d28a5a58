"""Scenes of whole coordinates, and what is seen of them by exact fractions.

Corners lie on whole pixels or quarters, depths on sixteenths or 128ths: two exact depths that differ do so by
far more than the arithmetic errs. The scenes are of four kinds: any triangles, which pierce one another;
triangles in few planes; pieces of a mesh with shared edges; slats that overlap in a cycle.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.visibility.test_depth_buffer import Corner, Triangle, covers, depth_at
from workbench.algorithms.visibility import depth_buffer

WIDTH, HEIGHT = 12, 9
Image = NDArray[np.int64]
Scene = list[Triangle]


def corner(x: Any, y: Any, z: Any) -> Corner:
    return Fraction(x), Fraction(y), Fraction(z)


def piercing(chance: Random) -> Scene:
    def place() -> Corner:
        x, y = chance.randint(-8, 52), chance.randint(-8, 44)
        return corner(Fraction(x, 4), Fraction(y, 4), Fraction(chance.randint(0, 15), 16))

    return [(place(), place(), place()) for _triangle in range(chance.randint(2, 5))]


def coplanar(chance: Random) -> Scene:
    """Planes that are the same or parallel; corners on whole pixels."""
    a, b, planes = chance.randint(-2, 2), chance.randint(-2, 2), chance.randint(0, 2)
    scene = []
    for _triangle in range(chance.randint(2, 5)):
        base = Fraction(1, 2) + Fraction(chance.randint(0, planes), 64)
        places = [(chance.randint(0, 12), chance.randint(0, 9)) for _corner in range(3)]
        scene.append(tuple(corner(x, y, base + Fraction(a * x + b * y, 128)) for x, y in places))
    return scene  # type: ignore[return-value]


def mesh(chance: Random) -> Scene:
    """A net over whole corners with its edges shared, and up to two triangles through it."""
    net = [
        corner(k % 4 * 3 + chance.randint(0, 1), k // 4 * 3 + chance.randint(0, 1), _depth(chance))
        for k in range(12)
    ]
    faces = [f for k in (0, 1, 2, 4, 5, 6) for f in ((k, k + 1, k + 5), (k, k + 5, k + 4))]
    chance.shuffle(faces)
    scene: Scene = [(net[i], net[j], net[k]) for i, j, k in faces[: chance.randint(4, 12)]]
    return scene + piercing(chance)[: chance.randint(0, 2)]


def cyclic(chance: Random) -> Scene:
    """Slats round a ring, each over the next and under the one before; seen from either side."""
    middle, turn = chance.randint(4, 6), chance.choice((1, -1))
    near, far = (2, 12) if turn == 1 else (12, 2)
    ends = [(middle - 4, 0), (middle + 4, 0), (middle + 4, 7), (middle - 4, 7)]
    scene: Scene = []
    for k in range(4):
        (x0, y0), (x1, y1) = ends[k], ends[(k + 1) % 4]
        inwards = ends[(k + 2) % 4]
        x2, y2 = x1 + Fraction(inwards[0] - x1, 4), y1 + Fraction(inwards[1] - y1, 4)
        start = corner(x0, y0, Fraction(near, 16))
        scene.append((start, corner(x1, y1, Fraction(far, 16)), corner(x2, y2, Fraction(far, 16))))
    chance.shuffle(scene)
    return scene + piercing(chance)[: chance.randint(0, 1)]


def _depth(chance: Random) -> Fraction:
    return Fraction(chance.randint(0, 15), 16)


KINDS: tuple[Callable[[Random], Scene], ...] = (piercing, coplanar, mesh, cyclic)


def scenes(kind: Callable[[Random], Scene], count: int) -> Iterator[Scene]:
    return (kind(Random(f"{kind.__name__} {number}")) for number in range(count))


def arrays(scene: Scene) -> tuple[NDArray[np.float64], Image, Image]:
    """Vertices, faces, and colours: that of each triangle is one more than its number."""
    vertices = np.array([[float(v) for v in place] for triangle in scene for place in triangle])
    return vertices, np.arange(3 * len(scene)).reshape(-1, 3), np.arange(1, len(scene) + 1)


def picture(method: Callable[..., Any], scene: Scene) -> Image:
    """What a method paints."""
    image = np.zeros((HEIGHT, WIDTH), np.int64)
    for _emitted in method(image, *arrays(scene)):
        pass
    return image


def buffered(scene: Scene) -> Image:
    """What the depth buffer paints."""
    image = np.zeros((HEIGHT, WIDTH), np.int64)
    for _emitted in depth_buffer(image, np.ones((HEIGHT, WIDTH)), *arrays(scene)):
        pass
    return image


def at(scene: Scene, x: int, y: int) -> list[tuple[Fraction, int]]:
    """Exact depth and colour of each triangle that covers a pixel."""
    return [(depth_at(t, x, y), colour) for colour, t in enumerate(scene, 1) if covers(t, x, y)]


def assert_same_but_for_ties(image: Image, scene: Scene) -> None:
    """Like the depth buffer's; where not, two exact depths are equal there and the least."""
    for y, x in np.argwhere(image != buffered(scene)).tolist():
        here = at(scene, x, y)
        assert here, (x, y)
        nearest = min(here)[0]
        tied = [colour for z, colour in here if z == nearest]
        assert len(tied) > 1, (x, y)
        assert image[y, x] in tied
