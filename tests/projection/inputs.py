"""Views and projections to try, and a point's image by NumPy alone."""

import math

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.projection import (
    cabinet,
    cavalier,
    oblique,
    orthographic,
    perspective,
    perspective_depth,
    perspective_from_plane,
    view,
)

Matrix = NDArray[np.float64]

coordinates = st.one_of(st.integers(-9, 9).map(float), st.floats(-9, 9, allow_subnormal=False))
points = st.tuples(coordinates, coordinates, coordinates).map(np.array)
angles = st.one_of(st.sampled_from([0.0, math.pi / 6, math.pi / 4, math.pi / 2]), st.floats(-3.0, 3.0))
distances = st.one_of(st.sampled_from([0.5, 1.0, 5.0]), st.floats(0.1, 50.0))


@st.composite
def views(draw: st.DrawFn) -> Matrix:
    """Eyes on whole places, often along an axis, looking at others."""
    eye, look_at, up = (draw(st.tuples(*[st.integers(-6, 6)] * 3)) for _vector in range(3))
    sight = np.subtract(look_at, eye)
    assume(np.linalg.norm(np.cross(sight, up)) > 0)
    return view(eye, look_at, up)


parallels = st.one_of(
    st.just(orthographic()),
    angles.map(cavalier),
    angles.map(cabinet),
    st.builds(oblique, st.floats(0.3, 2.8), angles),
)
perspectives = st.one_of(
    distances.map(perspective),
    distances.map(perspective_from_plane),
    st.builds(
        lambda d, near, depth: perspective_depth(d, near, near + depth), distances, distances, distances
    ),
)


def image(matrix: Matrix, point: ArrayLike) -> Matrix:
    """x, y and z of the point's image, after the division."""
    x, y, z, w = matrix @ np.append(np.asarray(point, np.float64), 1.0)
    return np.array([x / w, y / w, z / w])
