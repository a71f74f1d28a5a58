"""Retraces show when brightness is turned up, and none of their energy is lost or counted twice."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display import MmStroke, Phosphor, RasterBeam, RasterTiming, Tube, VectorBeam, VectorTiming
from workbench.display.monitor import Knobs
from workbench.display.retrace import RetracingBeam
from workbench.display.setup import TubeSetup, raster_tube, vector_beam, vector_tube

P31 = Phosphor.named("P31")
TIMING = RasterTiming("small", Fraction(480000), 8, 1, 2, 2, 6, 1, 3, 2)
SIZE, MM = (48, 36), (60.0, 44.0)


def retracing(blanked: float = 0.5) -> tuple[Tube, RetracingBeam]:
    tube = Tube(SIZE, MM, [P31], spot_mm=1.5)
    drive = np.zeros((1, 6, 8))
    drive[0, 2:4, 3:5] = 1.0
    return tube, RetracingBeam(tube, TIMING, drive, (10.0, 8.0, 50.0, 36.0), 3.0, blanked)


def test_a_frame_has_its_picture_and_its_flights() -> None:
    tube, beam = retracing()
    plain = RasterBeam(tube, TIMING, beam.drive, beam.area_mm, 3.0)
    flights = beam.energy_per_frame() - plain.energy_per_frame()
    clocks = TIMING.clocks_per_frame - TIMING.h_active * TIMING.v_active
    whole = 3.0 * 0.5 * clocks * float(TIMING.pixel_s)
    assert flights.min() > -1e-15
    assert flights.sum() == pytest.approx(whole, rel=0.02)
    assert (flights.max(axis=0) > 1e-3 * flights.max()).all()
    assert (flights.max(axis=1) > 1e-4 * flights.max())[4:-4].all()


def test_the_zigzag_runs_where_the_beam_is() -> None:
    _tube, beam = retracing()
    flights = beam._flights(np.zeros(6), np.ones(6))
    lit = flights > 0.2 * flights.max()
    for clock in np.arange(6 * 13 + 13, 6 * 13 + 52) + 0.37:
        state = beam.state(Fraction(clock) * TIMING.pixel_s)
        row, column = int(state.y_mm / MM[1] * SIZE[1]), int(state.x_mm / MM[0] * SIZE[0])
        near = lit[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2]
        assert near.any() or not (0 <= row < SIZE[1] and 0 <= column < SIZE[0])


def played(cuts: list[Fraction]) -> tuple[Tube, RetracingBeam]:
    tube, beam = retracing()
    for cut in cuts:
        beam.play(tube, cut * 10**12)
    return tube, beam


@settings(max_examples=15, deadline=None)
@given(st.lists(st.integers(1, 40), min_size=1, max_size=6), st.fractions(Fraction(1, 7), 3))
def test_the_way_time_is_cut_does_not_matter(shares: list[int], frames: Fraction) -> None:
    whole = frames * TIMING.frame_s
    once, _beam = played([whole])
    often, _beam = played([whole * share / sum(shares) for share in shares])
    assert once.stored[0] == pytest.approx(often.stored[0], rel=1e-9, abs=1e-12)
    assert once.emitted_energy() + once.stored_energy() == pytest.approx(once.deposited_energy(), rel=1e-9)


def test_whole_frames_deposit_what_a_frame_has() -> None:
    tube, beam = played([TIMING.frame_s * 5])
    assert tube.deposited_energy() == pytest.approx(5 * beam.energy_per_frame().sum(), rel=1e-9)


def test_what_is_settled_is_what_long_playing_comes_to() -> None:
    tube, _beam = played([TIMING.frame_s * Fraction(40007, 10)])
    fresh, other = retracing()
    fresh.skip(tube.ticks)
    other.settle(fresh)
    assert fresh.stored[0] == pytest.approx(tube.stored[0], rel=1e-6, abs=1e-9 * tube.stored[0].max())


def test_another_picture_keeps_the_flights() -> None:
    _tube, beam = retracing()
    dark = beam.with_drive(np.zeros((1, 6, 8)))
    assert isinstance(dark, RetracingBeam)
    assert dark.energy_per_frame() == pytest.approx(beam._retrace)
    assert beam.energy_per_frame().sum() > dark.energy_per_frame().sum() * 1.05


def test_blanked_it_keeps_a_rest_of_its_current() -> None:
    _tube, beam = retracing(0.25)
    assert beam.state(9 * TIMING.pixel_s).currents == (0.25,)
    assert beam.state(0 * TIMING.pixel_s).currents == (0.0,)


@pytest.mark.parametrize("phosphor", ["P31", "P22"])
def test_only_a_brightness_turned_up_shows_retraces(phosphor: str) -> None:
    image = np.full((12, 16), 0x808080, np.uint32)
    for brightness, kind in ((-0.2, RasterBeam), (0.0, RasterBeam), (0.05, RasterBeam), (0.2, RetracingBeam)):
        setup = TubeSetup(phosphor=phosphor, knobs=Knobs(brightness))
        assert type(raster_tube(image, (64, 48), setup)[1]) is kind


def test_the_jumps_of_a_vector_tube_show_likewise() -> None:
    strokes = [(2.0, 2.0, 12.0, 2.0, 0xFFFFFF), (2.0, 10.0, 12.0, 10.0, 0xFFFFFF)]
    for phosphor in ("P31", "P22"):
        usual, up = (TubeSetup(phosphor=phosphor, knobs=Knobs(brightness)) for brightness in (0.0, 0.3))
        tube = vector_tube((16, 12), (64, 48), usual)
        dark, lit = (vector_beam(tube, strokes, (16, 12), setup) for setup in (usual, up))
        middle = 24, 31
        assert dark.energy_per_frame()[middle] == 0.0
        assert lit.energy_per_frame()[middle] > 1e-5 * lit.energy_per_frame().max()
        assert vector_beam(tube, [], (16, 12), up).energy_per_frame().any()


def test_a_dark_beam_between_strokes_leaves_nothing() -> None:
    tube = Tube((20, 20), (20.0, 20.0), [P31], spot_mm=0.5)
    strokes = [MmStroke((2.0, 2.0), (8.0, 2.0), (1.0,)), MmStroke((2.0, 15.0), (8.0, 15.0), (1.0,))]
    beam = VectorBeam(tube, strokes, VectorTiming.named("teaching"))
    assert {piece.kind for piece in beam.pieces} == {"stroke"}
