"""Parallel and perspective projection of one scene from one place, side by side in numbers.

Each row is what the course says of the two, measured on the edges of the scene, with what was measured as
segments of the world, and what has to be added where the short answer says too much.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.projection import Classification, classify
from workbench.document.scene.looking import projecting
from workbench.document.scene.model import Camera, Scene
from workbench.document.scene.viewing import is_central, projection_matrix, view_matrix
from workbench.geometry.meshes import Array, Index, edges_of
from workbench.language import _
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.volume import LEAST_W

_MOST_EDGES = 4_000
_SAME, _CRUMB = 1e-6, 1e-9
_AXES = "xyz"
_KINDS = ("front", "isometric", "dimetric", "cavalier", "cabinet")


class Row(NamedTuple):
    """One row: what is compared, what holds of either projection here, what has to be added, if anything,
    and the segments (n, 2, 3) of the world on which it was measured."""

    feature: str
    parallel: str
    perspective: str
    but: str
    segments: Array


class Contrast(NamedTuple):
    """The two cameras, their rows, and of some parallel kinds how long a unit along x, y and z is."""

    parallel: Camera
    perspective: Camera
    rows: tuple[Row, ...]
    kinds: tuple[tuple[str, tuple[float, float, float]], ...]


class _Seen(NamedTuple):
    """A camera, its matrix (4, 4) from the world, what that is, and the images (e, 2, 2) of the edges."""

    camera: Camera
    matrix: Array
    kind: Classification
    images: Array

    @property
    def lengths(self) -> Array:
        return np.asarray(np.hypot(*(self.images[:, 1] - self.images[:, 0]).T))


def pair_of(camera: Camera) -> tuple[Camera, Camera]:
    """The parallel and the perspective projection from where a camera stands.

    Its own is one of them, unless it is a central matrix of one's own, whose centre need not be the eye.
    """
    if is_central(camera):
        camera = replace(camera, projection="perspective")
        return replace(camera, projection="orthographic"), camera
    return camera, replace(camera, projection="perspective")


def contrast(scene: Scene) -> Contrast | None:
    """Both projections of a scene; None where no edge is before both cameras. Raises: ValueError."""
    parallel, perspective = pair_of(scene.camera)
    edges = _edges(scene)
    cameras = [(each, projection_matrix(each) @ view_matrix(each)) for each in (parallel, perspective)]
    before = np.logical_and.reduce([_before(matrix, edges) for _camera, matrix in cameras])
    edges = edges[before]
    if not len(edges):
        return None
    one, two = (
        _Seen(each, matrix, classify(matrix, view_matrix(each)), _images(matrix, edges))
        for each, matrix in cameras
    )
    measures: tuple[Callable[[Array, _Seen, _Seen], Row], ...] = (
        _projectors,
        _centres,
        _sizes,
        _vanishing,
        _parallels,
        _ratios,
        _true_lengths,
        _realism,
    )
    rows = tuple(measure(edges, one, two) for measure in measures)
    return Contrast(parallel, perspective, rows, _kinds(scene.camera))


def _edges(scene: Scene) -> Array:
    """Both ends (e, 2, 3) of the edges of what is visible, world; of very many the first."""
    parts = [mesh.vertices[edges_of(mesh)] for mesh, *_rest in placed(scene)]
    edges = np.concatenate(parts or [np.zeros((0, 2, 3))])[:_MOST_EDGES]
    kept: Array = edges[_long(edges) > 0]
    return kept


def _long(segments: Array) -> Array:
    lengths: Array = np.sqrt(((segments[:, 1] - segments[:, 0]) ** 2).sum(axis=1))
    return lengths


def _homogeneous(matrix: Array, points: Array) -> Array:
    placed_points: Array = points @ matrix[:, :3].T + matrix[:, 3]
    return placed_points


def _before(matrix: Array, edges: Array) -> NDArray[np.bool_]:
    w, z = (_homogeneous(matrix, edges)[..., k] for k in (3, 2))
    return np.asarray(((w > LEAST_W) & (z >= 0) & (z <= w)).all(axis=1))


def _images(matrix: Array, points: Array) -> Array:
    placed_points = _homogeneous(matrix, points)
    images: Array = placed_points[..., :2] / placed_points[..., 3:]
    return images


# The rows


def _projectors(edges: Array, one: _Seen, two: _Seen) -> Row:
    points = edges.reshape(-1, 3)
    rays = points - two.camera.eye.xyz
    rays /= np.sqrt((rays**2).sum(axis=1))[:, None]
    first = int((rays @ rays.mean(axis=0)).argmin())
    second = int((rays @ rays[first]).argmin())
    angle = np.degrees(np.arccos(np.clip(rays[first] @ rays[second], -1.0, 1.0)))
    return Row(
        _("Projectors"),
        _("parallel: 0° between any two"),
        _("meet at the eye: up to {angle} apart").format(angle=_degrees(angle)),
        "",
        np.array([[points[k], two.camera.eye.xyz] for k in (first, second)]),
    )


def _centres(_edges: Array, one: _Seen, two: _Seen) -> Row:
    said = [_("none: projectors differ"), _("none: projectors differ")]
    for k, seen in enumerate((one, two)):
        if seen.kind.centre is not None:
            words = _("at infinity, along {place}") if seen.kind.centre[3] == 0.0 else _("at {place}")
            said[k] = words.format(place=_place(seen.kind.centre[:3]))
    return Row(_("Centre of projection"), said[0], said[1], "", np.zeros((0, 2, 3)))


def _sizes(edges: Array, one: _Seen, two: _Seen) -> Row:
    """One length, parallel to the view plane, at the nearest and at the farthest vertex."""
    view = view_matrix(two.camera)
    points = edges.reshape(-1, 3)
    depth = _homogeneous(view, points)[:, 2]
    length = float(np.median(_long(edges)))
    across = view[0, :3] * length / 2
    segments = np.stack(
        [np.stack([points[k] - across, points[k] + across]) for k in (depth.argmin(), depth.argmax())]
    )
    said = []
    for seen in (one, two):
        images = _images(seen.matrix, segments)
        near, far = (np.hypot(*(images[:, 1] - images[:, 0]).T) / length).tolist()
        said.append(_("a unit is {near} near, {far} far away").format(near=_n(near), far=_n(far)))
    shares = ", ".join(_n(each) for each in foreshortenings(one.matrix))
    but = _(
        "Distance does not matter, but foreshortening remains: what is at an angle to the view plane "
        "is shortened. A unit along x, y and z is {shares} long in the parallel picture."
    )
    return Row(_("Size with distance"), said[0], said[1], but.format(shares=shares), segments)


def _vanishing(_edges: Array, one: _Seen, two: _Seen) -> Row:
    def said(seen: _Seen) -> str:
        there = [
            _("{axis} at {place}").format(axis=axis, place=_place(point))
            for axis, point in zip(_AXES, seen.kind.vanishing, strict=True)
            if point is not None
        ]
        return f"{len(there)}: {', '.join(there)}" if there else _("none")

    without = [axis for axis, point in zip(_AXES, two.kind.vanishing, strict=True) if point is None]
    but = ""
    if without:
        but = _("Lines along {axes} are parallel to the view plane: they have no vanishing point here.")
        but = but.format(axes=_(" and ").join(without))
    return Row(_("Vanishing points"), said(one), said(two), but, np.zeros((0, 2, 3)))


def _parallels(edges: Array, one: _Seen, two: _Seen) -> Row:
    """The two parallel edges whose images are most at an angle."""
    pairs = _parallel_pairs(edges, two.images)
    if not pairs:
        return _unmeasured(_("Parallel lines"), _("No two edges of this scene are parallel."))
    first, second = max(pairs, key=lambda pair: _angle(two.images, *pair))
    angles = [_degrees(_angle(seen.images, first, second)) for seen in (one, two)]
    flat = [pair for pair in pairs if _angle(two.images, *pair) < 1e-4]
    but = _("Not all converge: those parallel to the view plane stay parallel.") if flat else ""
    return Row(
        _("Parallel lines"),
        _("stay parallel: {angle} between their images").format(angle=angles[0]),
        _("converge: up to {angle} between their images").format(angle=angles[1]),
        but,
        edges[[first, second]],
    )


def _parallel_pairs(edges: Array, images: Array) -> list[tuple[int, int]]:
    """Of each direction of the world the two edges whose images differ most."""
    along = (edges[:, 1] - edges[:, 0]) / _long(edges)[:, None]
    # One of the two senses, the same for all that are parallel
    lead = np.abs(along).argmax(axis=1)
    along = along * np.sign(along[np.arange(len(along)), lead])[:, None]
    ways, of = np.unique(np.round(along, 6) + 0.0, axis=0, return_inverse=True)
    towards = np.arctan2(*(images[:, 1] - images[:, 0]).T[::-1]) % np.pi
    pairs = []
    for way in range(len(ways)):
        members: Index = np.flatnonzero(of.ravel() == way)
        if len(members) > 1:
            # Angles go round at a half turn: measured from the middle one
            middle = towards[members[len(members) // 2]]
            turned = (towards[members] - middle + np.pi / 2) % np.pi
            pairs.append((int(members[turned.argmin()]), int(members[turned.argmax()])))
    return pairs


def _angle(images: Array, first: int, second: int) -> float:
    """Degrees, at most 90, between two images."""
    a, b = (images[k, 1] - images[k, 0] for k in (first, second))
    return float(np.degrees(np.arctan2(abs(a[0] * b[1] - a[1] * b[0]), abs(a @ b))))


def _ratios(edges: Array, one: _Seen, two: _Seen) -> Row:
    """The middle of a line across the scene, from its nearest vertex far back and far aside."""
    points = edges.reshape(-1, 3)
    depth = _homogeneous(view_matrix(two.camera), points)[:, 2]
    near = int(depth.argmin())
    aside = np.hypot(*(_images(one.matrix, points) - _images(one.matrix, points[near])).T)
    far = int(((depth - depth[near]) * aside).argmax())
    line = np.stack([points[near], (points[near] + points[far]) / 2, points[far]])
    said = []
    for seen in (one, two):
        start, middle, end = _images(seen.matrix, line)
        along = end - start
        if not along @ along > _SAME**2:
            return _unmeasured(_("Ratios along a line"), _("Every line across the scene is seen end on."))
        share = float((middle - start) @ along / (along @ along))
        said.append(_("the middle lands at {share}").format(share=_n(share)))
    but = _("This is what a parallel projection always keeps, besides parallelism.")
    return Row(_("Ratios along a line"), said[0], said[1], but, np.stack([line[:2], line[1:]]))


def _true_lengths(edges: Array, one: _Seen, two: _Seen) -> Row:
    lengths = _long(edges)
    true = [np.abs(seen.lengths / lengths - 1.0) < _SAME for seen in (one, two)]
    words = _("{n} of {all} edges in true length")
    shares = one.lengths / lengths
    but = _(
        "Parallel alone is not enough: only what is parallel to the view plane keeps lengths and angles. "
        "In the parallel picture edges are {least} to {most} of their length."
    ).format(least=_n(float(shares.min())), most=_n(float(shares.max())))
    said = [words.format(n=int(each.sum()), all=len(edges)) for each in true]
    return Row(_("True dimensions"), said[0], said[1], but, edges[true[0]])


def _realism(_edges: Array, one: _Seen, two: _Seen) -> Row:
    return Row(
        _("Realism"),
        _("right for an eye infinitely far away"),
        _("right for an eye {d} in front of the picture").format(d=_n(two.camera.distance)),
        _("For drawings to be measured, parallel; for pictures to be looked at, perspective."),
        np.zeros((0, 2, 3)),
    )


def _unmeasured(feature: str, why: str) -> Row:
    return Row(feature, "–", "–", why, np.zeros((0, 2, 3)))


# Kinds of parallel projections


def foreshortenings(matrix: Array) -> tuple[float, float, float]:
    """How long a unit along the world's x, y and z is in a parallel picture; ``matrix`` (4, 4)."""
    x, y, z = np.hypot(*matrix[:2, :3] / matrix[3, 3]).tolist()
    return x, y, z


def _kinds(camera: Camera) -> tuple[tuple[str, tuple[float, float, float]], ...]:
    """Slug, and how long a unit along each axis is."""
    rows = []
    for slug in _KINDS:
        other = projecting(camera, slug, 1.0)
        rows.append((slug, foreshortenings(projection_matrix(other) @ view_matrix(other))))
    return tuple(rows)


def _n(value: float) -> str:
    return with_minus(f"{0.0 if abs(value) < _CRUMB else value:.3g}")


def _degrees(value: float) -> str:
    return f"{value:.1f}°" if value >= 0.05 else "0°"


def _place(point: tuple[float, ...]) -> str:
    return f"({', '.join(_n(each) for each in point)})"
