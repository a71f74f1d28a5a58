"""The largest stretch of a map of the plane, beside NumPy's singular values."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.geometry.stretch import largest_stretch

ENTRIES = st.one_of(st.floats(-1e6, 1e6), st.integers(-3, 3).map(float))


@given(st.tuples(ENTRIES, ENTRIES, ENTRIES, ENTRIES))
def test_it_is_the_larger_singular_value(entries: tuple[float, ...]) -> None:
    matrix = np.array(entries).reshape(2, 2)
    assert largest_stretch(matrix) == pytest.approx(np.linalg.norm(matrix, 2), rel=1e-12, abs=1e-300)
