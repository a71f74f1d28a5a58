"""What holds of a tube whatever drives it, for how long at a time, and on whichever phosphor."""

import math
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import (
    MmStroke,
    Phosphor,
    RasterBeam,
    RasterTiming,
    Tube,
    VectorBeam,
    VectorTiming,
    phosphor_names,
)
from workbench.display.beam import Beam

TICKS = 10**12
SIZE_MM = 16.0, 12.0
PICTURE = np.random.default_rng(3).random((1, 4, 6)) * (np.random.default_rng(4).random((1, 4, 6)) > 0.3)
STROKES = [MmStroke((3.0, 3.0), (12.0, 4.0), (1.0,)), MmStroke((12.0, 4.0), (6.0, 10.0), (0.4,))]

names = st.sampled_from(phosphor_names())
ticks = st.floats(0.0, 11.0).map(lambda power: round(10.0**power))


def made(name: str = "P31", refresh: int = 60, spot: float = 0.8) -> tuple[Tube, RasterBeam, VectorBeam]:
    """One face, and a beam of each kind that can drive it."""
    tube = Tube((24, 18), SIZE_MM, [Phosphor.named(name)], spot_mm=spot)
    timing = RasterTiming.synthesised(6, 4, refresh)
    raster = RasterBeam(tube, timing, PICTURE, (2.0, 2.0, 14.0, 10.0))
    return tube, raster, VectorBeam(tube, STROKES, VectorTiming.named("teaching"))


@given(
    names,
    st.lists(
        st.tuples(st.sampled_from(["raster", "vector", "wait", "stream", "stroke", "look"]), ticks),
        max_size=12,
    ),
)
@settings(max_examples=60, deadline=None)
def test_what_was_emitted_and_what_is_stored_is_what_was_deposited(name: str, steps) -> None:
    """Whatever the tube goes through, in whatever steps: beams, strokes, streams, darkness, looks at it."""
    tube, raster, vector = made(name)
    do: dict[str, Callable[[int], object]] = {
        "raster": lambda span: raster.play(tube, span),
        "vector": lambda span: vector.play(tube, span),
        "wait": tube.advance,
        "stream": lambda span: tube.sustain(np.full((18, 24), 0.3), span),
        "stroke": lambda span: tube.deposit_stroke((4.0, 4.0), (9.0, 7.0), span * 1e-12, span),
        "look": lambda _span: tube.exposure(),
    }
    for what, span in steps:
        do[what](span)
    deposited = tube.deposited_energy()
    assert abs(tube.emitted_energy() + tube.stored_energy() - deposited) <= 1e-9 * max(deposited, 1e-12)


places = st.tuples(st.floats(7.0, 9.0), st.floats(5.0, 7.0))


@given(places, places, st.lists(st.floats(0.0, 1.0), max_size=5), names)
@settings(max_examples=60, deadline=None)
def test_a_stroke_cut_anywhere_deposits_the_same(start, end, cuts, name: str) -> None:
    """Also next to its ends, and in one place twice: joints need no special case."""
    whole, cut = made(name)[0], made(name)[0]
    whole.deposit_stroke(start, end, 1.0)
    shares = [0.0, *sorted(cuts), 1.0]

    def at(share: float) -> tuple[float, float]:
        return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])

    for before, after in pairwise(shares):
        if after > before:
            cut.deposit_stroke(at(before), at(after), after - before)
    assert math.isclose(cut.deposited_energy(), whole.deposited_energy(), rel_tol=1e-9)
    assert abs(cut.stored[0] - whole.stored[0]).max() <= 1e-8 * whole.stored[0].max()


@given(names, st.fractions(0, 2, max_denominator=97))
@settings(max_examples=30, deadline=None)
def test_a_steady_raster_is_the_sum_over_its_hits_in_closed_form(name: str, frames: Fraction) -> None:
    """L(t) = sum over hits of E e_k / tau_k exp(-((t - t_hit) mod T) / tau_k) / (1 - exp(-T / tau_k))."""
    tube, raster, _vector = made(name)
    tube.advance(frames * raster.frame_s * TICKS)
    raster.settle(tube)
    timing, period = raster.timing, float(raster.frame_s)
    light = np.zeros((18, 24))
    for row, column in zip(*np.nonzero(PICTURE[0]), strict=True):
        alone = np.zeros_like(PICTURE)
        alone[0, row, column] = PICTURE[0, row, column]
        energy = raster.with_drive(alone).energy_per_frame()
        line = timing.v_active - 1 - int(row)
        hit = (line * timing.h_total + int(column) + Fraction(1, 2)) * timing.pixel_s
        age = float((tube.seconds - hit) % raster.frame_s)
        gun = tube.guns[0]
        for term, share in zip(gun.terms, gun.energy_fractions, strict=True):
            kept = math.exp(-age / term.tau_s) / -math.expm1(-period / term.tau_s)
            light += energy * (share / term.tau_s * kept)
    assert np.allclose(tube.luminance()[0:].sum(axis=0), light, rtol=1e-9, atol=1e-9 * light.max())


def _host(beam: Beam, tube: Tube, rate: int, until: Fraction) -> None:
    """As a window does that shows so many pictures a second."""
    while tube.seconds < until:
        beam.play(tube, min(Fraction(1, rate), until - tube.seconds) * TICKS)


@pytest.mark.parametrize("which", [1, 2], ids=["raster", "vector"])
@pytest.mark.parametrize("rate", [24, 60, 240])
def test_host_rate_pauses_and_slow_motion_leave_no_trace(which: int, rate: int) -> None:
    until = Fraction(7, 24)
    steady, moved = made(refresh=50), made(refresh=50)
    steady[which].play(steady[0], until * TICKS)
    tube, beam = moved[0], moved[which]
    _host(beam, tube, rate, Fraction(1, 10))
    _host(beam, tube, rate, tube.seconds)  # paused: the window goes on, the tube does not
    for _picture in range(20):  # a thousand times slower
        beam.play(tube, Fraction(1, 1000 * rate) * TICKS)
    _host(beam, tube, rate, until)
    assert tube.ticks == steady[0].ticks
    assert abs(tube.stored[0] - steady[0].stored[0]).max() <= 1e-9 * steady[0].stored[0].max()
    assert math.isclose(tube.emitted_energy(), steady[0].emitted_energy(), rel_tol=1e-9)
    assert beam.state(tube.seconds) == steady[which].state(until)


def test_half_the_speed_leaves_twice_the_energy() -> None:
    """A generator that takes twice as long for its strokes, at the same current."""
    paces = (1.0, 2.0)
    energies = []
    for pace in paces:
        tube = made()[0]
        timing = VectorTiming("test", 200, 0, 1e6 * pace, jump_ps_per_unit=1e5, settle_ps=0)
        energies.append(VectorBeam(tube, STROKES, timing).energy_per_frame().sum())
    assert math.isclose(energies[1], 2.0 * energies[0], rel_tol=1e-9)


def test_after_two_fields_each_line_was_hit_once() -> None:
    timing = RasterTiming("test", Fraction(10**5), 4, 1, 1, 1, 6, 1, 1, 1, interlaced=True)
    tube = Tube((8, 12), (8.0, 12.0), [Phosphor.named("P1")], spot_mm=0.1)
    beam = RasterBeam(tube, timing, np.ones((1, 6, 4)), (0.0, 0.0, 8.0, 12.0))
    half = beam.frame_s / 2
    beam.play(tube, half * TICKS)
    rows = tube.deposited_energy()
    beam.play(tube, half * TICKS)
    assert math.isclose(tube.deposited_energy(), beam.energy_per_frame().sum(), rel_tol=1e-9)
    assert math.isclose(rows, 0.5 * tube.deposited_energy(), rel_tol=1e-6)
