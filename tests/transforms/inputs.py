"""Angles, points and matrices to try transformations with, near-degenerate ones among them."""

import math

import numpy as np
from hypothesis import strategies as st

coordinates = st.one_of(st.integers(-20, 20).map(float), st.floats(-1e3, 1e3, allow_subnormal=False))
quarters = st.integers(-9, 9).map(lambda count: count * math.pi / 2)
angles = st.one_of(quarters, st.sampled_from([math.pi / 6, math.pi / 4, 1e-9]), st.floats(-10.0, 10.0))
factors = st.one_of(st.sampled_from([0.0, 1.0, -1.0, 2.0, 1e-9]), st.floats(-9.0, 9.0, allow_subnormal=False))
points = st.tuples(coordinates, coordinates)
points_3d = st.tuples(coordinates, coordinates, coordinates)


def moved(matrix: np.ndarray, point: tuple[float, ...]) -> np.ndarray:
    """The point that the matrix makes of a point, by NumPy alone."""
    image = matrix @ np.array([*point, 1.0])
    return np.asarray(image[:-1] / image[-1])
