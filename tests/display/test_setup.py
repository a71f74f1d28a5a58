"""From a picture to a tube as it was set up: the law of the gun, the rate of the vector tube."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from workbench.display import setup as module
from workbench.display import vector_displays
from workbench.display.setup import (
    TubeSetup,
    currents_of_image,
    mm_of,
    raster_tube,
    vector_beam,
    vector_tube,
)
from workbench.display.vector_timing import VectorTiming

SIZE = (96, 72)
PICTURE = (20, 15)
places = st.tuples(st.integers(0, 19), st.integers(0, 14))
stroke_lists = st.lists(st.tuples(places, places), max_size=12)


def field(level: int) -> np.ndarray:
    return np.full((15, 20), level * 0x010101, np.uint32)


def energy(level: int, setup: TubeSetup) -> float:
    _tube, beam = raster_tube(field(level), SIZE, setup, np.float64)
    return float(beam.energy_per_frame(0).sum())


@given(gamma=st.floats(1.0, 3.0))
@settings(max_examples=10, deadline=None)
def test_the_law_of_the_gun(gamma: float) -> None:
    setup = TubeSetup(gamma=gamma)
    half = 128
    assert energy(255, setup) / energy(half, setup) == pytest.approx((255 / half) ** gamma, rel=1e-9)
    assert energy(0, setup) == 0.0
    assert energy(254, setup) / energy(127, setup) == pytest.approx(2.0**gamma, rel=1e-9)


def test_the_colours_of_a_vector_list_follow_the_same_law() -> None:
    setup = TubeSetup(gamma=2.0)
    tube = vector_tube(PICTURE, SIZE, setup, np.float64)
    bright, dim = (
        float(vector_beam(tube, [(1, 1, 18, 9, colour)], PICTURE, setup).energy_per_frame(0).sum())
        for colour in (0xFE0000, 0x7F0000)
    )
    assert bright / dim == pytest.approx(4.0, rel=1e-9)


def test_a_colour_tube_has_a_current_for_each_channel() -> None:
    image = np.array([[0xFF8000]], np.uint32)
    assert currents_of_image(image, 3, TubeSetup(gamma=2.0))[:, 0, 0] == pytest.approx(
        [1.0, (128 / 255) ** 2, 0.0]
    )
    assert currents_of_image(image, 1, TubeSetup(gamma=2.0))[:, 0, 0] == pytest.approx([1.0])


@given(
    stroke_lists,
    places,
    places,
    st.floats(10.0, 500.0),
    st.sampled_from(vector_displays()),
)
@settings(max_examples=60, deadline=None)
def test_the_vector_tube_never_refreshes_above_its_cap(
    pairs: list[tuple[tuple[int, int], tuple[int, int]]],
    a: tuple[int, int],
    b: tuple[int, int],
    rate: float,
    display: str,
) -> None:
    setup = TubeSetup(refresh_hz=rate, vector_display=display)
    tube = vector_tube(PICTURE, SIZE, setup)
    strokes = [(*start, *end, 0xFFFFFF) for start, end in pairs]
    beam = vector_beam(tube, strokes, PICTURE, setup)
    cap = VectorTiming.named(display).min_frame_ps
    assert beam.frame_s >= Fraction(1) / setup.refresh - Fraction(1, 10**12)
    assert beam.frame_ps >= cap
    longer = vector_beam(tube, [*strokes, (*a, *b, 0xFFFFFF)], PICTURE, setup)
    assert longer.frame_ps >= beam.frame_ps


@pytest.mark.parametrize("far", [100.0, 1e6, 1e9])
def test_a_stroke_costs_no_more_than_the_face_has_of_it(far: float) -> None:
    setup = TubeSetup()
    tube = vector_tube(PICTURE, SIZE, setup, np.float64)
    within, beyond, away = (
        vector_beam(tube, [(x0, 7, x1, 7, 0xFFFFFF)], PICTURE, setup)
        for x0, x1 in ((-3, 23), (-far, far), (far, 2 * far))
    )
    assert len(beyond.pieces) <= 2 * len(within.pieces)
    assert away.pieces == []
    face = slice(None), slice(8, -8)
    assert beyond.energy_per_frame(0)[face] == pytest.approx(within.energy_per_frame(0)[face], rel=1e-3)


def test_only_strokes_that_reach_beyond_the_face_are_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Strokes keep their order and their colours; one that misses the face goes, and one across it is cut."""
    cut: list[tuple[float, ...]] = []

    def counted(*numbers: float) -> object:
        cut.append(numbers)
        return clipped(*numbers)

    clipped = module.liang_barsky
    monkeypatch.setattr(module, "liang_barsky", counted)
    setup = TubeSetup(gamma=1.0)
    tube = vector_tube(PICTURE, SIZE, setup, np.float64)
    here = [(k % 20, k % 15, (k + 3) % 20, k % 15, 0x010101 * k) for k in range(1, 200)]
    away, across = (10, 400, 900, 400, 0xFFFFFF), (5, 7, 5000, 7, 0xC0C0C0)
    beam = vector_beam(tube, [*here[:90], away, *here[90:150], across, *here[150:]], PICTURE, setup)
    assert len(cut) == 2
    drawn = [segment for segment in beam.segments if segment.kind == "stroke"]
    levels = [*range(1, 151), 0xC0, *range(151, 200)]
    assert [segment.currents[0] for segment in drawn] == pytest.approx([level / 255 for level in levels])
    straight = vector_beam(tube, here, PICTURE, setup)
    ends = [(segment.begin, segment.end) for segment in drawn]
    assert ends[:150] + ends[151:] == [
        (segment.begin, segment.end) for segment in straight.segments if segment.kind == "stroke"
    ]
    (x0, y0), (x1, y1) = ends[150]
    assert (x0, y0, y1) == pytest.approx((*mm_of(5, 7, PICTURE), mm_of(5, 7, PICTURE)[1]))
    assert x1 == pytest.approx(tube.size_mm[0] + tube.reach * tube.spot_mm)


@given(
    arrays.arrays(np.uint32, (3, 4), elements=st.integers(0, 0xFFFFFF)),
    st.sampled_from([1.0, 1.8, 2.2, 2.8]),
)
def test_a_single_gun_follows_the_largest_of_three_currents(image: np.ndarray, gamma: float) -> None:
    (single,) = currents_of_image(image, 1, TubeSetup(gamma=gamma))
    assert np.array_equal(single, currents_of_image(image, 3, TubeSetup(gamma=gamma)).max(axis=0))
