"""A tube steered by hand: its beam lands where the text says, and its figures keep all their energy."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.scanning.electron_optics import FACE_MM
from workbench.display.gun import OFF, SAWTOOTH, SINE, Deflection, Gun
from workbench.display.steered_beam import SteeredBeam, steered_tube
from workbench.display.tube import Tube

SMALL = 56, 48
FIGURE = Gun(x=Deflection(wave=SINE, peak=320.0, rate=100.0), y=Deflection(wave=SINE, rate=150.0))

ways = st.builds(
    Deflection,
    volts=st.floats(-700, 700),
    field=st.floats(-2, 2),
    wave=st.sampled_from([OFF, SINE, SAWTOOTH]),
    peak=st.floats(0, 700),
    peak_field=st.floats(0, 2),
    rate=st.sampled_from([50.0, 100.0, 150.0]),
    phase=st.floats(-180, 180),
)
guns = st.builds(
    Gun,
    coils=st.booleans(),
    x=ways,
    y=ways,
    anode=st.floats(500, 9000),
    focus=st.floats(200, 1200),
    moment=st.floats(0, 40),
)


@given(guns, st.floats(0.0, 0.1))
def test_the_beam_lands_where_the_text_says(gun: Gun, seconds: float) -> None:
    x, y, reached = gun.landing(np.array([seconds]))
    z, text_x, text_y, _r = gun.way(seconds)[-1]
    inside = abs(text_x) <= FACE_MM[0] / 2 and abs(text_y) <= FACE_MM[1] / 2
    assert bool(reached[0]) == (z >= gun.screen and inside)
    if reached[0]:
        assert (float(x[0]), float(y[0])) == pytest.approx((text_x, text_y), abs=1e-9)


@given(guns, st.floats(-60, 60), st.floats(-50, 50))
def test_what_is_steered_to_a_place_lands_there(gun: Gun, x: float, y: float) -> None:
    drive_x, drive_y = gun.drive_to(x, y)
    held = replace(gun, x=Deflection(drive_x, drive_x), y=Deflection(drive_y, drive_y))
    z, at_x, at_y, _r = held.way()[-1]
    if z >= held.screen:
        assert (at_x, at_y) == pytest.approx((x, y), abs=1e-6)
    else:
        assert not held.coils


@pytest.mark.parametrize(
    ("x", "y", "period"), [(100, 150, Fraction(1, 50)), (0.5, 2, Fraction(2)), (0.1, 0.3, Fraction(10))]
)
def test_a_figure_begins_anew_when_both_inputs_do(x: float, y: float, period: Fraction) -> None:
    gun = Gun(x=Deflection(wave=SINE, rate=x), y=Deflection(wave=SINE, rate=y))
    assert gun.period == period
    assert gun.cycles == max(x, y) * period


def test_the_inputs_have_the_form_of_their_waves() -> None:
    quarters = np.array([0.0, 0.25, 0.5, 0.75]) / 50.0
    sine, saw = (Deflection(wave=wave, peak=10.0, rate=50.0) for wave in (SINE, SAWTOOTH))
    assert sine.drive(quarters, False) == pytest.approx([0.0, 10.0, 0.0, -10.0], abs=1e-12)
    assert saw.drive(quarters, False) == pytest.approx([-10.0, -5.0, 0.0, 5.0])
    ahead = replace(sine, phase=90.0)
    assert ahead.drive(quarters, False) == pytest.approx([10.0, 0.0, -10.0, 0.0], abs=1e-12)
    assert Deflection(7.0, 0.3).drive(quarters, True) == pytest.approx([0.3] * 4)


@pytest.mark.parametrize(
    ("gun", "words"),
    [
        (Gun(reach_x=170.0), "would overlap"),
        (Gun(coils=True, reach_y=19.0), "inside the plates"),
        (Gun(x=Deflection(wave=SINE, rate=100.1), y=Deflection(wave=SINE)), "simpler ratio"),
        (Gun(), ""),
    ],
)
def test_a_tube_that_cannot_be_says_why(gun: Gun, words: str) -> None:
    assert words in gun.fault()
    assert bool(gun.fault()) == bool(words)


# What the beam leaves on the face


def energy(gun: Gun, size: tuple[int, int] = SMALL) -> np.ndarray:
    _tube, beam = steered_tube(gun, size, np.float64)
    return beam.energy_per_frame() / beam.power


def test_a_figure_leaves_all_the_energy_of_its_period() -> None:
    assert energy(FIGURE).sum() == pytest.approx(0.02, rel=1e-4)
    assert energy(replace(FIGURE, focus=300.0)).sum() == pytest.approx(0.02, rel=2e-3)


def test_focus_changes_the_width_and_not_the_energy() -> None:
    sharp, blurred = (energy(Gun(focus=focus), (140, 120)) for focus in (420.0, 330.0))
    assert sharp.sum() == pytest.approx(blurred.sum(), rel=1e-4)
    assert sharp.max() > 1.8 * blurred.max()


def test_the_spot_on_the_face_swells_and_brightens_with_the_current() -> None:
    """Its spread is measured on the picture, against the half width that the text emits."""
    brightest = []
    for grid in (-40.0, -18.0, 0.0):
        gun = Gun(grid=grid, x=Deflection(), y=Deflection())
        _tube, beam = steered_tube(gun, (280, 240), np.float64)
        picture = beam.energy_per_frame()
        pitch = FACE_MM[0] / 280
        x = pitch * (np.arange(280) + 0.5) - FACE_MM[0] / 2
        spread = math.sqrt((picture.sum(axis=0) * x * x).sum() / picture.sum() - pitch * pitch / 12)
        assert spread == pytest.approx(gun.way()[-1][3], rel=0.01)
        brightest.append(picture.max())
    assert brightest == sorted(brightest)


@given(st.floats(-60.0, 0.0))
def test_the_light_follows_the_current_of_the_grid(grid: float) -> None:
    gun = Gun(grid=grid)
    _tube, beam = steered_tube(gun, SMALL)
    _tube, full = steered_tube(Gun(grid=0.0), SMALL)
    assert beam.power == pytest.approx(full.power * (1.0 - grid / -60.0) ** 2.4, rel=1e-9, abs=1e-9)


def test_a_caught_or_cut_off_beam_leaves_nothing() -> None:
    for gun in (Gun(grid=-60.0), Gun(y=Deflection(700.0)), Gun(coils=True, y=Deflection(field=5.0))):
        tube, beam = steered_tube(gun, SMALL)
        assert not beam.energy_per_frame().any()
        beam.play(tube, Fraction(10**10))
        assert tube.deposited_energy() == 0.0


def test_a_figure_is_the_text_at_many_moments() -> None:
    size = 70, 60
    _tube, beam = steered_tube(FIGURE, size, np.float64)
    pitch = FACE_MM[0] / size[0]
    counted = np.zeros(size[::-1])
    for k in range(beam.count):
        _z, x, y, _r = FIGURE.way(float(FIGURE.period) * (k + 0.5) / beam.count)[-1]
        counted[int((y + FACE_MM[1] / 2) / pitch), int((x + FACE_MM[0] / 2) / pitch)] += 1
    light = beam.energy_per_frame()
    assert (light[counted > 0] > 0.02 * light.max()).all()
    far = np.ones_like(counted, bool)
    for row, column in zip(*np.nonzero(counted), strict=True):
        far[max(row - 2, 0) : row + 3, max(column - 2, 0) : column + 3] = False
    assert light[far].max() < 1e-3 * light.max()


def state_after(cuts: list[int]) -> Tube:
    tube, beam = steered_tube(replace(FIGURE, phosphor="P7"), SMALL, np.float64)
    for cut in cuts:
        beam.play(tube, Fraction(cut))
    return tube


@settings(max_examples=8, deadline=None)
@given(st.lists(st.integers(1, 9), min_size=1, max_size=5))
def test_the_way_time_is_cut_does_not_matter(shares: list[int]) -> None:
    whole = 63_000_000_000
    cuts = [whole * share // sum(shares) for share in shares]
    cuts[-1] += whole - sum(cuts)
    once, often = state_after([whole]), state_after(cuts)
    assert once.deposited_energy() == pytest.approx(often.deposited_energy(), rel=1e-12)
    for one, other in zip(once.stored, often.stored, strict=True):
        assert one == pytest.approx(other, rel=1e-9, abs=1e-12 * one.max())
    emitted = once.emitted_energy() + once.stored_energy()
    assert emitted == pytest.approx(once.deposited_energy(), rel=1e-9)


def test_what_is_settled_is_what_long_playing_comes_to() -> None:
    gun = replace(FIGURE, phosphor="P1")
    tube, beam = steered_tube(gun, SMALL, np.float64)
    beam.play(tube, Fraction(2 * 10**12 + 7 * 10**9))
    fresh, _beam = steered_tube(gun, SMALL, np.float64)
    fresh.skip(tube.ticks)
    SteeredBeam(fresh, gun).settle(fresh)
    assert fresh.stored[0] == pytest.approx(tube.stored[0], rel=1e-9, abs=1e-9 * tube.stored[0].max())


def test_the_beam_says_where_it_is() -> None:
    _tube, beam = steered_tube(FIGURE, SMALL)
    state = beam.state(Fraction(1, 600) + 3 * FIGURE.period)
    _z, x, y, _r = FIGURE.way(1.0 / 600.0)[-1]
    assert (state.x_mm, state.y_mm) == pytest.approx((x + 70.0, y + 60.0), abs=1e-6)
    assert (state.frame, state.lit) == (3, True)
    assert state.currents[0] == pytest.approx(0.7**2.4)
    assert math.isclose(float(beam.frame_s), 0.02)


def test_a_beam_that_stands_gives_its_energy_to_one_place() -> None:
    """As the sum of its hits, one by one."""
    _tube, beam = steered_tube(Gun(), (60, 45), np.float64)
    hits = sum(np.outer(beam._across[:, k], beam._along[:, k]) for k in range(beam.count))
    assert beam.energy_per_frame() == pytest.approx(beam.power * float(beam._step) * hits)
    assert beam.energy_per_frame().sum() > 0.0
