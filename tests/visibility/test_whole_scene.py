"""Places and colours of a whole scene: what NumPy and Lambert's law say, the same in each reading."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.visibility.whole_scene import cosine, face_colours, places_on_device
from workbench.engine import compiled
from workbench.geometry.conventions import GRID

FLAVOURS = "interpreted", "checked", ""
seeds = st.integers(0, 10**6)


def run(text, written, *arguments):
    """What each reading writes: as Python, and in all flavours."""
    plain = written.copy()
    emitted = list(text(plain, *arguments))
    results = [plain]
    for flavour in FLAVOURS:
        results.append(written.copy())
        compiled.paint(text, results[-1], 0, results[-1], *arguments, flavour=flavour)
    assert all(result.tobytes() == plain.tobytes() for result in results)
    return plain, emitted


@given(seed=seeds, own_w=st.booleans())
@settings(max_examples=20)
def test_places_are_projected_divided_and_on_the_grid(seed: int, own_w: bool) -> None:
    rng = np.random.default_rng(seed)
    points = rng.uniform(-1, 1, (9, 3))
    matrix = np.vstack([rng.uniform(-2, 2, (3, 4)), [*rng.uniform(-0.3, 0.3, 3), 1.5]])
    rows = np.column_stack([points, np.ones(9)])
    arguments = (rows @ matrix.T, np.eye(4)) if own_w else (points, matrix)
    places, _emitted = run(places_on_device, np.zeros((9, 3)), *arguments, 300.0, 399.5, 200.0, 299.5)
    placed = rows @ matrix.T
    flat = placed[:, :3] / placed[:, 3:]
    assert np.abs(places[:, 0] - (flat[:, 0] * 300 + 399.5)).max() <= 0.5 / GRID + 1e-9
    assert np.abs(places[:, 1] - (flat[:, 1] * 200 + 299.5)).max() <= 0.5 / GRID + 1e-9
    assert np.allclose(places[:, 2], flat[:, 2], rtol=1e-12)
    assert (places[:, :2] * GRID % 1 == 0).all()


@given(seed=seeds, lamps=st.integers(0, 3), from_a_point=st.booleans())
@settings(max_examples=20)
def test_colours_are_the_same_in_each_reading(seed: int, lamps: int, from_a_point: bool) -> None:
    rng = np.random.default_rng(seed)
    normals = rng.normal(size=(3, 12))
    normals /= np.sqrt((normals * normals).sum(axis=0))
    normals[:, 5] = 0.0  # a face without an area
    lights = rng.uniform(0, 2, (lamps, 7))
    lights[:, 3] = rng.integers(0, 2, lamps)
    lasting = normals, rng.normal(size=12), rng.normal(size=(3, 12))
    viewer = np.append(rng.normal(size=3), float(from_a_point))
    surface = rng.uniform(0, 1, 5)
    arguments = 2, 10, *lasting, viewer, lights, surface
    colours, emitted = run(face_colours, np.full(12, -1), *arguments)
    assert (colours[[0, 1, 10, 11]] == -1).all()  # another share
    assert ((colours[2:10] >= 0) & (colours[2:10] <= 0xFFFFFF)).all()
    ambient = [math.floor(min(surface[0] * channel, 1.0) * 255 + 0.5) for channel in surface[2:]]
    assert colours[5] == ambient[0] << 16 | ambient[1] << 8 | ambient[2]
    assert emitted == [(2, 10)]


@pytest.mark.parametrize(
    ("way", "expected"), [((0, 0, 2), 1.0), ((0, 3, 0), 0.0), ((0, -4, 4), math.sqrt(0.5)), ((0, 0, 0), 0.0)]
)
def test_a_cosine_is_that_of_the_angle_and_0_for_no_way(way: tuple[float, ...], expected: float) -> None:
    assert cosine(0.0, 0.0, 1.0, *map(float, way)) == pytest.approx(expected)
