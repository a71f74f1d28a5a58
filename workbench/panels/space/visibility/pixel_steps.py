"""What a method that keeps no depths painted at a pixel: each step, its surface, what was there before."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.algorithms.visibility.surfaces import depth_at, surface_of
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.rendering.scene.fragments import NOTHING
from workbench.session.run import Run


class PixelStep(NamedTuple):
    """In step ``step`` the triangle ``surface`` was painted, ``z`` deep there, over ``under``, or NOTHING."""

    step: int
    surface: int
    z: float
    under: int
    under_z: float

    @property
    def hides_nearer(self) -> bool:
        """Whether it was painted over what is nearer."""
        return self.under != NOTHING and self.z > self.under_z


def pixel_steps(depth: DepthRun, run: Run | None, x: int, y: int) -> list[PixelStep]:
    """Those that are recorded by now; asked first, those that were seen."""
    if run is None or run.entry is None or run.recording is None or run.steps is None:
        return []
    rows = run.recording.emitted.array(0, len(run.recording.emitted))
    told: list[PixelStep] = []
    before, before_z = NOTHING, depth.farthest
    for number in np.flatnonzero(_covers(run.entry, rows, x, y)).tolist():
        step = run.steps.step_of(run.recording.event_at(number))
        if step > run.tellable:
            break
        surface = int(rows[number, -1])
        z = depth_at(surface_of(depth.device.corners, depth.device.triangles, surface), x, y)
        told.append(PixelStep(step, surface, z, before, before_z))
        before, before_z = surface, z
    return told


def _covers(entry: Entry, rows: NDArray[np.float64], x: int, y: int) -> NDArray[np.bool_]:
    """(n,) which of what was emitted is at the pixel."""
    if not len(rows):
        return np.zeros(0, bool)
    if entry.emits == "spans":
        covers = (rows[:, 0] == y) & (rows[:, 1] <= x) & (x <= rows[:, 2])
    else:
        covers = (rows[:, 0] == x) & (rows[:, 1] == y)
    return np.asarray(covers)
