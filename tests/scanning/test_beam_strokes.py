"""A whole display list on the face at once: what the beam spot leaves, stroke by stroke."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.scanning.beam_spot import beam_spot
from workbench.algorithms.scanning.beam_strokes import beam_strokes

places = st.tuples(st.floats(-4.0, 24.0), st.floats(-4.0, 20.0))
lists = st.lists(st.tuples(places, places, st.sampled_from([0.0, 1.0, 3.0])), max_size=4)
# Steps of these are not lost when a stroke is shifted by whole pixels
steps = st.integers(-256, 1280).map(lambda step: step / 64)


def left_by(strokes, sigma: float, shape=(16, 20)) -> np.ndarray:
    """The face after a list."""
    face = np.zeros(shape)
    rows = np.array([[*a, *b, energy] for a, b, energy in strokes], float).reshape(-1, 5)
    for _span in beam_strokes(face, rows, sigma):
        pass
    return face


@given(lists, st.floats(0.6, 2.0))
@settings(max_examples=30, deadline=None)
def test_a_list_leaves_what_its_strokes_leave(strokes, sigma: float) -> None:
    expected = np.zeros((16, 20))
    for a, b, energy in strokes:
        for x, y, share in beam_spot(*a, *b, energy, sigma):
            if 0 <= x < 20 and 0 <= y < 16:
                expected[y, x] += share
    # The brightest that a stroke can be is a dwell
    brightest = sum(energy for *_ends, energy in strokes) / (2.0 * np.pi * sigma * sigma)
    assert np.abs(left_by(strokes, sigma) - expected).max() <= 0.005 * brightest


@given(st.tuples(steps, steps), st.tuples(steps, steps))
@settings(max_examples=20, deadline=None)
def test_what_is_beside_the_face_is_left_out(a, b) -> None:
    whole = left_by([((a[0] + 20, a[1] + 20), (b[0] + 20, b[1] + 20), 1.0)], 1.0, (60, 64))
    assert np.allclose(left_by([(a, b, 1.0)], 1.0), whole[20:36, 20:40], atol=1e-9)
    assert not left_by([((100.0, 3.0), (120.0, 3.0), 1.0)], 1.0).any()
