"""Clipping in homogeneous coordinates (x, y, z, w), before the division by w: triangles and segments.

A plane is (a, b, c, d); what has a x + b y + c z + d w >= 0 is kept. A cut is computed from the end that is
kept, so that two triangles find the same point on the edge they share.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Rectangle = tuple[float, float, float, float]

LEAST_W = 1e-9

DEPTH_PLANES = np.array([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, -1.0, 1.0]])
"""Near and far: 0 <= z <= w."""


def side_planes(xmin: float, ymin: float, xmax: float, ymax: float) -> Array:
    """The four sides of what a rectangle of the view plane shows."""
    return np.array([[1.0, 0, 0, -xmin], [-1.0, 0, 0, xmax], [0, 1.0, 0, -ymin], [0, -1.0, 0, ymax]])


def clip_triangles(points: Array, triangles: Index, planes: Array) -> tuple[Array, Index, Index]:
    """What of triangles (t, 3) of homogeneous points (n, 4) all planes keep: points, triangles, and of which
    of the triangles that were given each is a part."""
    owners = np.arange(len(triangles))
    for plane in planes:
        away = points @ plane
        inside = away >= 0
        if inside.all():
            continue
        kept = inside[triangles]
        count = kept.view(np.int8) @ np.ones(3, np.int8)
        if (count == 3).all():
            continue
        parts, part_owners = [triangles[count == 3]], [owners[count == 3]]
        for number in (1, 2):
            some = count == number
            # The corner that is alone on its side comes first; the turn stays as it was.
            alone = (kept[some] == (number == 1)).argmax(axis=1)
            turned = np.take_along_axis(triangles[some], (alone[:, None] + np.arange(3)) % 3, axis=1)
            a, b, c = turned.T
            pairs = [(a, b), (a, c)] if number == 1 else [(b, a), (c, a)]
            first, second = (len(points) + k * len(a) + np.arange(len(a)) for k in (0, 1))
            points = np.concatenate([points, *(_cut(points, away, inner, outer) for inner, outer in pairs)])
            away = np.append(away, np.zeros(2 * len(a)))
            if number == 1:
                parts.append(np.stack([a, first, second], axis=1))
                part_owners.append(owners[some])
            else:
                parts += [np.stack([first, b, c], axis=1), np.stack([first, c, second], axis=1)]
                part_owners += [owners[some]] * 2
        triangles, owners = np.concatenate(parts), np.concatenate(part_owners)
        order = np.argsort(owners, kind="stable")
        triangles, owners = triangles[order], owners[order]
    return points, triangles, owners


def clip_segments(points: Array, segments: Index, planes: Array) -> tuple[Array, Array, Index]:
    """Both ends (s, 4) of what of segments (s, 2) all planes keep, and of which segment each is a part."""
    begin, end = points[segments[:, 0]], points[segments[:, 1]]
    owners = np.arange(len(segments))
    for plane in planes:
        from_begin, from_end = begin @ plane, end @ plane
        some = (from_begin >= 0) | (from_end >= 0)
        begin, end, owners = begin[some], end[some], owners[some]
        from_begin, from_end = from_begin[some], from_end[some]
        both = np.concatenate([begin, end])
        away = np.concatenate([from_begin, from_end])
        at = np.arange(len(begin))
        cut_begin, cut_end = from_begin < 0, from_end < 0
        begin, end = begin.copy(), end.copy()
        begin[cut_begin] = _cut(both, away, at[cut_begin] + len(at), at[cut_begin])
        end[cut_end] = _cut(both, away, at[cut_end], at[cut_end] + len(at))
    return begin, end, owners


def _cut(points: Array, away: Array, inner: Index, outer: Index) -> Array:
    share = away[inner] / (away[inner] - away[outer])
    cuts: Array = points[inner] + share[:, None] * (points[outer] - points[inner])
    return cuts
