"""All methods for hidden surfaces let loose on one scene: what each shows, where it errs, what it costs."""

import time
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility import ray_casting
from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.geometry.meshes import Index
from workbench.rendering.scene.methods import METHODS, method_call, surfaces_seen
from workbench.rendering.scene.render import DeviceTriangles, device_triangles, placed
from workbench.rendering.scene.viewpoint import Size

TRUTH = ray_casting.__name__
"""The method that the others are compared with: it compares all surfaces at each pixel."""


class MethodRun(NamedTuple):
    """A method on a scene: ``seen`` (h, w) the number of the triangle that each pixel shows, or NOTHING;
    ``different`` (h, w) where that is another than ray casting shows; ``tests`` comparisons written in the
    text that were made; ``counted`` what its entry counts beside, such as splits."""

    method: str
    seen: Index
    different: NDArray[np.bool_]
    tests: int
    counted: dict[str, int]


def run_methods(
    scene: Scene, size: Size, window: Rectangle | None = None, methods: Sequence[str] = METHODS
) -> list[MethodRun]:
    """Each of ``methods`` on what the scene's camera sees, at a size that can be counted.

    Nothing is compiled. Raises: ValueError, a sentence.
    """
    device = device_triangles(placed(scene), scene.lights, scene.camera, size, window)
    truth = surfaces_seen(TRUTH, device.corners, device.triangles, size)
    return [_run(method, device, size, truth) for method in methods]


def timed(scene: Scene, size: Size, method: str, window: Rectangle | None = None) -> float:
    """Seconds of processor time that a method takes for a picture of ``size``, compiled beforehand.

    Raises: ValueError, a sentence.
    """
    device = device_triangles(placed(scene), scene.lights, scene.camera, size, window)
    surfaces_seen(method, device.corners, device.triangles[:1], (1, 1), compiling=True)
    begun = time.thread_time()
    surfaces_seen(method, device.corners, device.triangles, size, compiling=True)
    return time.thread_time() - begun


def _run(method: str, device: DeviceTriangles, size: Size, truth: Index) -> MethodRun:
    from workbench.engine.counts import counts

    seen = surfaces_seen(method, device.corners, device.triangles, size)
    call = method_call(method, device.corners, device.triangles, device.colours, size)
    work = counts(call.entry.function, *call.arguments, compiling=False)
    counted = {
        name: sum(
            visits for title, visits in work.block_visits.items() if title.startswith(tuple(beginnings))
        )
        for name, beginnings in call.entry.counted.items()
    }
    return MethodRun(method, seen, seen != truth, work.tests, counted)
