"""The vector beam: the frame is the sum of its parts, and cutting time leaves no trace."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import MmStroke, Phosphor, Tube, VectorBeam, VectorTiming, vector_displays

TICKS = 10**12
FREE = VectorTiming.named("teaching")
points = st.tuples(st.integers(4, 36), st.integers(4, 36))
lists = st.lists(st.tuples(points, points), min_size=1, max_size=6)


def strokes(pairs: list[tuple[tuple[int, int], tuple[int, int]]]) -> list[MmStroke]:
    return [
        MmStroke(tuple(map(float, a)), tuple(map(float, b)), (0.5 + 0.5 * (i % 2),))
        for i, (a, b) in enumerate(pairs)
    ]


def made(pairs, timing: VectorTiming = FREE, phosphor: str = "P31") -> tuple[Tube, VectorBeam]:
    tube = Tube((40, 40), (40.0, 40.0), [Phosphor.named(phosphor)], spot_mm=1.0)
    return tube, VectorBeam(tube, strokes(pairs), timing)


def test_the_printed_times_of_the_ibm_2250() -> None:
    display = VectorTiming.named("ibm-2250-3")
    assert display.stroke_ps(16, 3) == display.stroke_ps(1, 0) == 8_000_000
    assert abs(display.stroke_ps(1023, 500) - 100_000_000) < 100
    assert display.min_frame_ps == 25_000_000_000


@given(lists, st.sampled_from(vector_displays()))
@settings(deadline=None)
def test_a_frame_is_the_sum_of_its_parts(pairs, name: str) -> None:
    timing = VectorTiming.named(name)
    _, beam = made(pairs, timing)
    assert sum(segment.duration_ps for segment in beam.segments) == beam.frame_ps
    assert beam.frame_ps == max(beam.list_ps, timing.min_frame_ps, 1)
    clock = 0
    place = beam.segments[-1].end
    for segment in beam.segments:
        assert segment.start_ps == clock
        assert segment.begin == place
        clock, place = clock + segment.duration_ps, segment.end


@given(lists, points, points)
@settings(deadline=None)
def test_a_further_stroke_never_shortens_the_frame(pairs, a, b) -> None:
    assert made([*pairs, (a, b)])[1].frame_ps >= made(pairs)[1].frame_ps


@given(lists, st.lists(st.integers(1, 2 * 10**10), min_size=1, max_size=12))
@settings(max_examples=30, deadline=None)
def test_state_and_light_do_not_depend_on_the_cuts(pairs, cuts) -> None:
    whole, beam = made(pairs)
    cut, same = made(pairs)
    beam.play(whole, sum(cuts))
    for ticks in cuts:
        same.play(cut, ticks)
    scale = max(whole.stored[0].max(), 1e-300)
    assert abs(whole.stored[0] - cut.stored[0]).max() <= 1e-9 * scale
    light, cut_light = whole.exposure()[0], cut.exposure()[0]
    assert np.allclose(light, cut_light, rtol=1e-9, atol=1e-12 * whole.deposited_energy())
    assert math.isclose(
        whole.emitted_energy() + whole.stored_energy(), whole.deposited_energy(), abs_tol=1e-12
    )


@given(lists, st.integers(1, 4 * 10**10))
@settings(max_examples=30, deadline=None)
def test_the_state_is_that_of_strokes_deposited_one_after_the_other(pairs, ticks: int) -> None:
    tube, beam = made(pairs)
    beam.play(tube, ticks)
    oracle = Tube((40, 40), (40.0, 40.0), tube.guns, spot_mm=1.0)
    left = ticks
    while left > 0:
        for s in beam.segments:
            took = min(s.duration_ps, left)
            left -= took
            if s.kind == "stroke" and took > 0:
                share = took / s.duration_ps
                to = (
                    s.begin[0] + share * (s.end[0] - s.begin[0]),
                    s.begin[1] + share * (s.end[1] - s.begin[1]),
                )
                oracle.deposit_stroke(s.begin, to, took * 1e-12 * s.currents[0], took)
            else:
                oracle.advance(took)
    assert oracle.ticks == tube.ticks
    scale = max(oracle.stored[0].max(), 1e-300)
    assert abs(oracle.stored[0] - tube.stored[0]).max() <= 1e-9 * scale


@given(lists, st.fractions(0, 2, max_denominator=499))
@settings(max_examples=20, deadline=None)
def test_the_settled_state_is_that_after_very_many_frames(pairs, frames: Fraction) -> None:
    tube, beam = made(pairs)
    long, same = made(pairs)
    total = (400 + frames) * beam.frame_s * TICKS
    same.play(long, total)
    tube.advance(total)
    beam.settle(tube)
    assert np.allclose(
        tube.stored[0], long.stored[0], rtol=1e-6, atol=1e-8 * max(long.stored[0].max(), 1e-300)
    )


def test_energy_per_length_does_not_depend_on_the_length_at_constant_speed() -> None:
    _, beam = made([((5, 10), (15, 10)), ((5, 30), (35, 30))])
    energy = beam.energy_per_frame()
    short, long = energy[5:15].sum(), energy[25:35].sum()
    assert math.isclose(long, 2 * 3 * short, rel_tol=1e-6)  # three times as long, twice the current


def test_the_beam_is_found_by_time() -> None:
    _, beam = made([((5, 10), (15, 10)), ((5, 30), (35, 30))])
    for segment in beam.segments:
        middle = Fraction(2 * segment.start_ps + segment.duration_ps, 2 * TICKS)
        state = beam.state(middle + 5 * beam.frame_s)
        assert state.lit == (segment.kind == "stroke")
        assert math.isclose(state.x_mm, (segment.begin[0] + segment.end[0]) / 2)
        assert state.frame == 5


def test_an_empty_list_waits() -> None:
    tube, beam = made([])
    beam.play(tube, TICKS)
    assert tube.deposited_energy() == 0.0
    assert beam.frame_ps == FREE.min_frame_ps


def test_an_unknown_display_is_answered_with_near_ones() -> None:
    with pytest.raises(LookupError, match="atari-avg"):
        VectorTiming.named("atari")
