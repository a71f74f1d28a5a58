"""The light of one place of a raster tube over one refresh, as the simulated beam makes it.

A face of one small pixel is scanned by the whole picture's beam: what lies beside the place lights it too,
through the width of the spot.
"""

import itertools
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.setup import TubeSetup, area_mm, raster_tube
from workbench.display.tube import PICOSECOND

Floats = NDArray[np.float64]

_NEAR, _FAR = 20, 28
"""Steps up to a tenth of the refresh, each longer than the one before, and even ones for the rest."""

_FIRST_STEP = 1e-5
"""The first step after the hit, of the period."""

_PATCH = 0.2
"""Side of the face that is looked at, of a pixel of the picture."""


class ProbedLight(NamedTuple):
    """Seconds since the hit (n + 1,) over one refresh, the light then (n + 1,), energies between (n,)."""

    seconds: Floats
    light: Floats
    energies: Floats


def _instants(period: Fraction) -> list[Fraction]:
    """Times from the hit on, near each other at first, up to one period."""
    near = np.geomspace(_FIRST_STEP, 0.1, _NEAR)
    far = np.linspace(0.1, 1.0, _FAR + 1)[1:-1]
    return [Fraction(0), *(period * Fraction(float(t)) for t in (*near, *far)), period]


def probed_light(
    image: NDArray[np.uint32], setup: TubeSetup, pixel: tuple[int, int], gun: int | None = None
) -> ProbedLight:
    """What the middle of a pixel (x, y) of ``image`` gives off from one of its hits to the next.

    ``gun`` chooses one of a colour tube's. The tube has run for long before. Dark places give 0 throughout.
    """
    height, width = image.shape
    left, bottom, right, _top = area_mm((width, height))
    pitch = (right - left) / width
    x, y = left + (pixel[0] + 0.5) * pitch, bottom + (pixel[1] + 0.5) * pitch
    half = 0.5 * _PATCH * pitch
    window = x - half, y - half, x + half, y + half
    tube, beam = raster_tube(image, (1, 1), setup, np.float64, window_mm=window, gun=gun)
    tube.skip(beam.timing.hit_s(*pixel) / PICOSECOND)
    beam.settle(tube)
    tube.exposure()
    times = _instants(beam.frame_s)
    light, energies = [float(tube.luminance().sum())], []
    for before, after in itertools.pairwise(times):
        beam.play(tube, (after - before) / PICOSECOND)
        energies.append(float(sum(layers.sum() for layers in tube.exposure())))
        light.append(float(tube.luminance().sum()))
    return ProbedLight(np.array([float(t) for t in times]), np.array(light), np.array(energies))
