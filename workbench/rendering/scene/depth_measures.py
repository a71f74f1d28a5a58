"""What a depth buffer gives and what it costs, measured on one run of it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.scene.model import Camera
from workbench.rendering.mapping import Call
from workbench.rendering.scene.fragments import NOTHING, Fragments, fragments_of


class DepthMeasures(NamedTuple):
    """``covered`` pixels have a surface, ``layered`` of them more than one; ``overwritten`` writes are of no
    avail; ``piercing`` pairs of triangles change places; ``other_order`` pixels show another triangle when
    the last is drawn first, ``rounded`` ones than they would if depths were not rounded."""

    triangles: int
    fragments: int
    covered: int
    layered: int
    overwritten: int
    piercing: int
    other_order: int
    rounded: int


def measured(call: Call, reverse: Call, unrounded: Call) -> DepthMeasures:
    """The measures of a run, given the same one in reverse order, and without rounding."""
    run, size = fragments_of(call), call.arguments[0].shape[::-1]
    seen, tests = run.seen(size), run.tests(size)
    covered = int((seen != NOTHING).sum())
    last = len(call.arguments[3]) - 1
    turned = fragments_of(reverse).seen(size)
    turned = np.where(turned == NOTHING, NOTHING, last - turned)
    return DepthMeasures(
        triangles=last + 1,
        fragments=len(run),
        covered=covered,
        layered=int((tests > 1).sum()),
        overwritten=int(run.won.sum()) - covered,
        piercing=len(piercing_pairs(run, size)),
        other_order=int((turned != seen).sum()),
        rounded=int(differing(call, unrounded).sum()),
    )


def differing(call: Call, other: Call, count: int | None = None) -> NDArray[np.bool_]:
    """(height, width) which pixels show another triangle in one run than in the other after ``count``."""
    size = call.arguments[0].shape[::-1]
    runs = (fragments_of(each) for each in (call, other))
    one, two = ((run if count is None else run.upto(count)).seen(size) for run in runs)
    unlike: NDArray[np.bool_] = one != two
    return unlike


def piercing_pairs(run: Fragments, size: tuple[int, int]) -> set[tuple[int, int]]:
    """Pairs of triangles of which now the one, now the other is nearer, at pixels that both cover."""
    pixel = run.y * size[0] + run.x
    order = np.lexsort((run.z, pixel))
    nearer: set[tuple[int, int]] = set()
    surfaces, pixels, depths = run.surface[order], pixel[order], run.z[order]
    deepest = int(run.tests(size).max(initial=0))
    for apart in range(1, deepest):
        together = (pixels[apart:] == pixels[:-apart]) & (depths[apart:] > depths[:-apart])
        pairs = np.stack([surfaces[:-apart][together], surfaces[apart:][together]], axis=1)
        nearer.update(map(tuple, np.unique(pairs, axis=0).tolist()))
    return {(a, b) for a, b in nearer if a < b and (b, a) in nearer}


def distance_of(camera: Camera, share: float) -> float:
    """How far from the eye along the line of sight a depth lies, ``share`` being 0 at near and 1 at far."""
    near, far = camera.near, camera.far
    if camera.projection == "perspective":
        return near * far / (far - share * (far - near))
    return near + share * (far - near)


def least_distance(camera: Camera, share: float, bits: int) -> float:
    """How far apart, along the line of sight, two depths there must be to be told apart by ``bits`` bits.

    With z' = f (z - n) / (z (f - n)) of a perspective dz = z^2 (f - n) / (f n) dz'.
    """
    near, far, steps = camera.near, camera.far, 2**bits - 1
    if camera.projection == "perspective":
        return float(distance_of(camera, share) ** 2 * (far - near) / (far * near * steps))
    return float((far - near) / steps)
