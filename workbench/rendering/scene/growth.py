"""How the time of a method for hidden surfaces grows with the pixels and with the polygons of one scene."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine.stopping import Stop, Stopped
from workbench.rendering.scene.arena import device_of, time_of
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.scene.viewpoint import Size

TIMES = 10
"""The picture that is timed is so many times as wide and as high as the one that is shown."""
FACTORS = (1, 2, 5, TIMES)
CUTS = (0, 1, 2, 3, 4)
FITTED = 3
"""An exponent is fitted to so many of the largest runs, where what any run costs matters least."""
MOST_S = 5.0
"""A run that would take longer is not begun: what it would take is told from the smaller ones."""

Point = tuple[int, float]


class Growth(NamedTuple):
    """Of a method the seconds by the number of pixels, with the polygons as they are, and by the number of
    polygons in the coarse picture, each cut into four and again. ``at_ten`` are those of the largest picture;
    ``measured`` tells whether it was drawn, or they are foretold from the smaller ones."""

    method: str
    by_pixels: tuple[Point, ...]
    by_polygons: tuple[Point, ...]
    at_ten: float
    measured: bool

    @property
    def exponents(self) -> tuple[float | None, float | None]:
        """That of the pixels, and that of the polygons; None where there are too few points."""
        return exponent(self.by_pixels[-FITTED:]), exponent(self.by_polygons[-FITTED:])


def growth_of(
    method: str, scene: Scene, size: Size, window: Rectangle | None, stop: Stop | None = None
) -> Growth:
    """Measure a method; ``size`` is that of the coarse picture. Raises: ValueError, a sentence; Stopped."""

    def larger(factor: int) -> tuple[int, Callable[[], float]]:
        width, height = size[0] * factor, size[1] * factor
        device = device_of(scene, (width, height), window)
        return width * height, lambda: time_of(method, scene, device, (width, height), stop)

    def finer(cuts: int) -> tuple[int, Callable[[], float]]:
        device = cut_up(device_of(scene, size, window), cuts)
        return len(device.triangles), lambda: time_of(method, scene, device, size, stop)

    pixels, foretold = _measured(map(larger, FACTORS), stop)
    polygons, _foretold = _measured(map(finer, CUTS), stop)
    at_ten = pixels[-1][1] if foretold is None else foretold
    return Growth(method, pixels, polygons, at_ten, foretold is None)


def _measured(
    runs: Iterator[tuple[int, Callable[[], float]]], stop: Stop | None
) -> tuple[tuple[Point, ...], float | None]:
    """As many as are short enough, and what the last of all would take where that is not among them."""
    points: list[Point] = []
    foretold: float | None = None
    for number, run in runs:
        if stop is not None and stop.is_set:
            raise Stopped
        if number == 0:  # nothing of the scene is seen: there is no cost that could grow
            continue
        if len(points) > 1 or (points and points[-1][1] > MOST_S):
            foretold = foretell(points, number)
            if foretold > MOST_S:
                continue
        points.append((number, run()))
        foretold = None
    return tuple(points), foretold


def exponent(points: Sequence[Point]) -> float | None:
    """The power of n that the seconds grow with: the slope of the line through the logarithms that is best
    by least squares. None for fewer than two numbers n."""
    usable = [(n, seconds) for n, seconds in points if n > 0 and seconds > 0]
    if len({n for n, _seconds in usable}) < 2:
        return None
    n, seconds = np.log(np.array(usable, np.float64)).T
    away = n - n.mean()
    return float((away * (seconds - seconds.mean())).sum() / (away * away).sum())


def foretell(points: Sequence[Point], n: int) -> float:
    """The seconds for ``n``, going on from the last point as between the last two."""
    power = exponent(points[-2:])
    last, seconds = points[-1]
    return float(seconds * (n / last) ** (1.0 if power is None else power))


def cut_up(device: DeviceTriangles, times: int) -> DeviceTriangles:
    """The same picture of more triangles: each cut into four at the middles of its edges, so many times."""
    corners, triangles, *owners = device
    for _cut in range(times):
        a, b, c = (corners[triangles[:, k]] for k in range(3))
        corners = np.concatenate([a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2])
        first = np.arange(len(triangles))
        a_, b_, c_, ab, bc, ca = (first + k * len(triangles) for k in range(6))
        quarters = [(a_, ab, ca), (ab, b_, bc), (ca, bc, c_), (ab, bc, ca)]
        triangles = np.concatenate([np.stack(quarter, axis=1) for quarter in quarters])
        owners = [np.tile(column, 4) for column in owners]
    return DeviceTriangles(corners, triangles, *owners)
