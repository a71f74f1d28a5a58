"""The raster beam: whole clocks, one hit per lit clock, and no trace of how time was cut."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import Phosphor, RasterBeam, RasterTiming, Tube, phosphor_names, raster_modes

P31 = Phosphor.named("P31")
TICKS = 10**12


def small(refresh: int = 60, phosphor: Phosphor = P31, seed: int = 1) -> tuple[Tube, RasterBeam]:
    timing = RasterTiming.synthesised(8, 6, refresh)
    tube = Tube((24, 18), (24.0, 18.0), [phosphor], spot_mm=1.0)
    drive = np.random.default_rng(seed).random((1, 6, 8))
    return tube, RasterBeam(tube, timing, drive, (2.0, 2.0, 22.0, 16.0))


@pytest.mark.parametrize("name", raster_modes())
def test_counts_of_a_mode(name: str) -> None:
    timing = RasterTiming.named(name)
    frame = timing.h_total * timing.v_total
    assert timing.clocks_per_frame == frame
    assert timing.frame_s * timing.pixel_clock_hz == frame
    assert 10**6 * timing.frame_s == Fraction(10**6 * frame) / timing.pixel_clock_hz
    rows = [timing.row_of_line(line) for line in range(timing.v_total)]
    scanned = [row for row in rows if row is not None]
    assert sorted(scanned) == list(range(timing.v_active))
    for row in scanned:
        assert timing.row_of_line(timing.line_of_row(row)) == row


@pytest.mark.parametrize(("name", "lines"), [("ntsc-525i", 262.5), ("pal-625i", 312.5)])
def test_fields_start_half_a_line_apart(name: str, lines: float) -> None:
    timing = RasterTiming.named(name)
    assert timing.interlaced
    assert timing.lines_per_field == Fraction(lines)
    first, second = (timing.line_of_row(row) for row in (0, 1))
    # Row 1 lies half a row pitch of its field below row 0; the beam needs half a line for that.
    assert second - timing.lines_per_field - first == Fraction(1, 2)
    order = [timing.row_of_line(line) for line in range(timing.v_total)]
    fields = [row for row in order if row is not None]
    assert fields[: timing.v_active // 2] == list(range(0, timing.v_active, 2))
    assert fields[timing.v_active // 2 :] == list(range(1, timing.v_active, 2))


@given(st.integers(1, 60), st.integers(1, 40), st.sampled_from([1, 50, 60, 75, 85]))
def test_a_synthesised_mode_is_exact(width: int, height: int, refresh: int) -> None:
    timing = RasterTiming.synthesised(width, height, refresh)
    assert timing.refresh_hz == refresh
    assert (timing.h_active, timing.v_active) == (width, height)
    assert timing.lit_share == Fraction(width * height, timing.h_total * timing.v_total)


def test_the_beam_is_lit_on_every_pixel_of_a_frame_once() -> None:
    _, beam = small()
    timing = beam.timing
    lit = []
    for clock in range(timing.clocks_per_frame):
        state = beam.state((clock + Fraction(1, 2)) / timing.pixel_clock_hz)
        if state.lit:
            lit.append((round(state.x_mm, 9), round(state.y_mm, 9)))
        else:
            assert state.currents == (0.0,)
    assert len(lit) == len(set(lit)) == 8 * 6
    assert lit == sorted(lit, key=lambda place: (-place[1], place[0]))
    assert lit[0] == pytest.approx((2.0 + 20.0 / 16, 16.0 - 14.0 / 12))


def test_deflection_is_continuous_but_for_the_steps_between_lines() -> None:
    _, beam = small()
    fine = [
        beam.state(Fraction(n, 16) / beam.timing.pixel_clock_hz) for n in range(16 * 3 * beam.timing.h_total)
    ]
    steps = np.abs(np.diff([state.x_mm for state in fine]))
    flyback = 20.0 / 8 * (beam.timing.h_total - beam.timing.h_sync) / beam.timing.h_sync / 16
    assert steps.max() < 1.01 * flyback


def test_no_drift_after_a_million_frames() -> None:
    _, beam = small()
    first = beam.state(Fraction(1, 7919))
    later = beam.state(Fraction(1, 7919) + 10**6 * beam.frame_s)
    assert later == first._replace(frame=first.frame + 10**6)


@given(st.lists(st.integers(1, 10**10), min_size=1, max_size=30), st.sampled_from(["P31", "P39", "P22G"]))
@settings(max_examples=40, deadline=None)
def test_state_and_light_do_not_depend_on_the_cuts(cuts: list[int], name: str) -> None:
    whole, beam = small(phosphor=Phosphor.named(name))
    cut, same = small(phosphor=Phosphor.named(name))
    beam.play(whole, sum(cuts))
    for ticks in cuts:
        same.play(cut, ticks)
    assert cut.ticks == whole.ticks
    scale = max(whole.stored[0].max(), 1e-300)
    assert abs(whole.stored[0] - cut.stored[0]).max() <= 1e-9 * scale
    assert math.isclose(whole.deposited_energy(), cut.deposited_energy(), rel_tol=1e-9, abs_tol=1e-15)
    light, cut_light = whole.exposure()[0], cut.exposure()[0]
    assert np.allclose(light, cut_light, rtol=1e-9, atol=1e-13 * whole.deposited_energy())


@pytest.mark.parametrize("rate", [24, 60, 144])
def test_ten_seconds_at_any_host_rate(rate: int) -> None:
    tube, beam = small()
    for _ in range(10 * rate):
        beam.play(tube, Fraction(TICKS, rate))
    reference, other = small()
    other.play(reference, 10 * TICKS)
    assert tube.seconds == 10
    assert abs(tube.stored[0] - reference.stored[0]).max() < 1e-9 * reference.stored[0].max()
    assert math.isclose(tube.emitted_energy(), reference.emitted_energy(), rel_tol=1e-9)


def test_slow_motion_changes_nothing_at_a_given_tube_time() -> None:
    steady, changed = small(), small()
    until = 3 * steady[1].frame_s
    steady[1].play(steady[0], until * TICKS)
    host = Fraction(1, 60)
    for factor in (Fraction(1), Fraction(1, 10), Fraction(1, 1000), Fraction(1, 10)):
        for _ in range(5):
            step = min(host * factor, until - changed[0].seconds)
            changed[1].play(changed[0], step * TICKS)
    changed[1].play(changed[0], (until - changed[0].seconds) * TICKS)
    assert abs(steady[0].stored[0] - changed[0].stored[0]).max() < 1e-9 * steady[0].stored[0].max()
    assert steady[1].state(until) == changed[1].state(changed[0].seconds)


def test_every_lit_clock_is_one_hit_computed_by_hand() -> None:
    tube, beam = small()
    seconds = Fraction(137, 100) * beam.frame_s
    beam.play(tube, seconds * TICKS)
    timing = beam.timing
    expected = np.zeros_like(tube.stored[0])
    for clock in range(2 * timing.clocks_per_frame):
        at = (clock + Fraction(1, 2)) / timing.pixel_clock_hz
        if at > seconds:
            break
        state = beam.state(at)
        if not state.lit:
            continue
        one = Tube((24, 18), (24.0, 18.0), [P31], spot_mm=1.0)
        width = 20.0 / 8
        ends = (state.x_mm - width / 2, state.y_mm), (state.x_mm + width / 2, state.y_mm)
        one.deposit_stroke(*ends, state.currents[0] * float(timing.pixel_s))
        one.advance((seconds - at) * TICKS)
        expected += one.stored[0]
    assert expected.max() > 0.0
    # The oracle samples the spot at pixel centres, the beam integrates it over the pixels.
    assert abs(tube.stored[0].sum() / expected.sum() - 1.0) < 1e-3
    assert abs(tube.stored[0] - expected).max() < 0.06 * expected.max()


@given(st.fractions(0, 3, max_denominator=997))
@settings(max_examples=30, deadline=None)
def test_the_settled_state_is_that_after_very_many_frames(frames: Fraction) -> None:
    tube, beam = small()
    long, same = small()
    whole = Fraction(400)
    same.play(long, (whole + frames) * same.frame_s * TICKS)
    tube.advance((whole + frames) * beam.frame_s * TICKS)
    beam.settle(tube)
    assert np.allclose(tube.stored[0], long.stored[0], rtol=1e-6, atol=1e-9 * long.stored[0].max())


@pytest.mark.parametrize("name", phosphor_names())
def test_mean_luminance_is_energy_over_time(name: str) -> None:
    tube, beam = small(phosphor=Phosphor.named(name))
    beam.settle(tube)
    tube.exposure()
    for _ in range(60):
        beam.play(tube, beam.frame_s / 60 * TICKS)
    mean = tube.exposure()[0].sum(axis=0) / float(beam.frame_s)
    assert np.allclose(mean, beam.energy_per_frame() / float(beam.frame_s), rtol=1e-6, atol=1e-9)


def test_another_picture_leaves_the_old_one_to_fade() -> None:
    tube, beam = small(phosphor=Phosphor.named("P39"))
    beam.settle(tube)
    before = tube.stored_energy()
    beam.show(np.zeros((1, 6, 8)))
    beam.play(tube, TICKS // 20)
    assert 0.3 * before < tube.stored_energy() < before
    with pytest.raises(ValueError, match="8 x 7"):
        beam.show(np.zeros((1, 7, 8)))
