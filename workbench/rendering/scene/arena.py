"""All methods for hidden surfaces let loose on one scene: what each shows, where it errs, what it costs."""

import time
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.visibility import depth_buffer, ray_casting
from workbench.algorithms.visibility.surfaces import NOTHING
from workbench.document.model import Rectangle
from workbench.document.scene.model import Camera, Scene
from workbench.engine.stopping import Stop
from workbench.geometry.meshes import Index
from workbench.rendering.mapping import Call
from workbench.rendering.scene.back_face_calls import (
    BACK_FACES,
    back_face_calls,
    looks_from_a_point,
    triangles_left,
)
from workbench.rendering.scene.fragments import fragments_of
from workbench.rendering.scene.methods import A_BUFFER, METHODS, method_call, surfaces_seen
from workbench.rendering.scene.render import DeviceTriangles, device_triangles, placed
from workbench.rendering.scene.viewpoint import Size

TRUTH = ray_casting.__name__
"""The method that the others are compared with: it compares all surfaces at each pixel."""

_SHORT_S, _MOST_RUNS = 0.02, 5


class MethodRun(NamedTuple):
    """A method on a scene: ``seen`` (h, w) the number of the triangle that each pixel shows, or NOTHING;
    ``different`` (h, w) where that is another than ray casting shows; ``tests`` comparisons written in the
    text that were made; ``counted`` what its entry counts beside, such as splits, ``keeps`` what it keeps
    beside the picture."""

    method: str
    seen: Index
    different: NDArray[np.bool_]
    tests: int
    counted: dict[str, int]
    keeps: dict[str, int]


def methods_for(camera: Camera) -> tuple[str, ...]:
    """The slugs of those that can be let loose, in teaching order; back faces are told from a point.

    To the A-buffer, the last, all surfaces are opaque here.
    """
    return (BACK_FACES, *METHODS, A_BUFFER) if looks_from_a_point(camera) else (*METHODS, A_BUFFER)


def run_methods(
    scene: Scene, size: Size, window: Rectangle | None = None, methods: Sequence[str] = METHODS
) -> list[MethodRun]:
    """Each of ``methods`` on what the scene's camera sees, at a size that can be counted.

    Nothing is compiled. Raises: ValueError, a sentence.
    """
    return list(runs_of(scene, size, window, methods))


def runs_of(
    scene: Scene,
    size: Size,
    window: Rectangle | None,
    methods: Sequence[str],
    stop: Stop | None = None,
) -> Iterator[MethodRun]:
    """The same, one after the other. Raises: ValueError, Stopped."""
    device = device_of(scene, size, window)
    truth = surfaces_seen(TRUTH, device.corners, device.triangles, size, stop=stop)
    for method in methods:
        yield _run(method, scene, device, size, truth, stop)


def device_of(scene: Scene, size: Size, window: Rectangle | None) -> DeviceTriangles:
    """What all methods get. Raises: ValueError, a sentence."""
    return device_triangles(placed(scene), scene.lights, scene.camera, size, window)


def timed(
    scene: Scene, size: Size, method: str, window: Rectangle | None = None, stop: Stop | None = None
) -> float:
    """Seconds of processor time that a method takes for a picture of ``size``, compiled beforehand.

    Raises: ValueError, a sentence; Stopped.
    """
    return time_of(method, scene, device_of(scene, size, window), size, stop)


def time_of(
    method: str, scene: Scene, device: DeviceTriangles, size: Size, stop: Stop | None = None
) -> float:
    """The same of device triangles; of a short run the best of some."""
    if method == BACK_FACES:
        _tell_back_faces(scene)
    else:
        surfaces_seen(method, device.corners, device.triangles[:1], (1, 1), compiling=True)
    times: list[float] = []
    while not times or (sum(times) < _SHORT_S and len(times) < _MOST_RUNS):
        begun = time.thread_time()
        if method == BACK_FACES:
            _tell_back_faces(scene)
        else:
            surfaces_seen(method, device.corners, device.triangles, size, compiling=True, stop=stop)
        times.append(time.thread_time() - begun)
    return min(times)


def _tell_back_faces(scene: Scene) -> None:
    from workbench.engine.compiled import collect

    for call in back_face_calls(scene):
        collect(call.entry.function, *call.arguments)


def _run(
    method: str, scene: Scene, device: DeviceTriangles, size: Size, truth: Index, stop: Stop | None
) -> MethodRun:
    if method == BACK_FACES:
        calls, seen = back_face_calls(scene), _front_faces_seen(scene, device, size)
    else:
        calls = [method_call(method, device.corners, device.triangles, device.colours, size)]
        seen = surfaces_seen(method, device.corners, device.triangles, size, stop=stop)
    tests, counted = _counted(calls, stop)
    return MethodRun(method, seen, seen != truth, tests, counted, _kept(calls, counted))


def _front_faces_seen(scene: Scene, device: DeviceTriangles, size: Size) -> Index:
    """As ``surfaces_seen``, where the faces that are not turned away are drawn in the order in which they
    come, one over the other."""
    call = method_call(depth_buffer.__name__, device.corners, device.triangles, device.colours, size)
    fragments = fragments_of(call)
    left = triangles_left(scene, device)[fragments.surface]
    seen = np.full(size[::-1], NOTHING)
    # Of several writes to one pixel NumPy keeps the last.
    seen[fragments.y[left], fragments.x[left]] = fragments.surface[left]
    return seen


def _counted(calls: Sequence[Call], stop: Stop | None) -> tuple[int, dict[str, int]]:
    """Comparisons, and what the entry counts beside."""
    from workbench.engine.counts import counts

    tests, counted = 0, dict.fromkeys(calls[0].entry.counted if calls else (), 0)
    for call in calls:
        work = counts(call.entry.function, *call.arguments, stop=stop, compiling=False)
        tests += work.tests
        for name, each in call.entry.counted.items():
            visits = (n for title, n in work.block_visits.items() if title.startswith(each.blocks))
            counted[name] += sum(visits)
    return tests, counted


def _kept(calls: Sequence[Call], counted: dict[str, int]) -> dict[str, int]:
    """What the entry says that it keeps."""
    kept: dict[str, int] = {}
    for call in calls:
        names = dict(zip(call.entry.parameter_names, call.arguments, strict=True))
        for what, each in call.entry.keeps.items():
            kept[what] = kept.get(what, 0) + int(eval(each.most, {"counted": counted}, names))
    return kept


def space_of(method: str) -> str:
    """Where it compares: object space, image space, or both, as its entry says."""
    return catalogue.get(method).works_in
