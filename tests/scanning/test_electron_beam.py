"""The electron beam against closed forms, and against its motion added up in small steps."""

import math
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.scanning.electron_beam import electron_beam
from workbench.algorithms.scanning.electron_optics import ANODE_MM, PLATES_MM, beam_current, exact_speed
from workbench.display import Phosphor
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

ENTRY = catalogue.get("electron_beam")
ELECTRON_KG, CHARGE_C, LIGHT_M_S = 9.1093837e-31, 1.602176634e-19, 299792458.0
EXAMPLE = ENTRY.example
runs = st.randoms(use_true_random=False).map(lambda chance: generated(chance))


def generated(chance: Random) -> tuple[Any, ...]:
    assert ENTRY.arguments is not None
    return ENTRY.arguments(chance)


def beam(
    drive: tuple[float, float] = (0.0, 0.0),
    *,
    v_grid: float = -18.0,
    v_focus: float = 420.0,
    v_anode: float = 2000.0,
    coils: bool = False,
    length: float = 40.0,
    gap: float = 16.0,
    reach: tuple[float, float] = (150.0, 200.0),
) -> list[tuple[float, float, float, float]]:
    tube = np.array([-60.0, 100.0, 2.4, length, gap, *reach])
    run = v_grid, v_focus, v_anode, coils, np.array(drive), tube, EXAMPLE[6], 60.0
    return list(electron_beam(*run))


def sentence(number: int, *run: Any) -> str:
    steps = Steps(ENTRY, record(electron_beam, *run))
    return "".join(part.text for part in steps[number].sentence)


# The worked examples of the course


def test_a_deflection_worked_by_hand() -> None:
    *_way, (_z, x, y, _r) = beam((0.0, 30.0), length=20.0, gap=5.0)
    assert (x, y) == (0.0, pytest.approx(6.0, abs=1e-12))


def test_the_plates_of_the_worked_example_catch_the_beam_at_250_volts() -> None:
    *_way, (_z, _x, y, _r) = beam((0.0, 250.0), length=20.0, gap=5.0)
    assert y == pytest.approx(50.0, abs=1e-9)
    *_way, last = beam((0.0, 250.1), length=20.0, gap=5.0)
    assert last[0] < PLATES_MM + 20.0
    assert last[2] == pytest.approx(2.5, abs=1e-9)


def test_coils_worked_by_hand() -> None:
    *_way, (_z, x, y, _r) = beam((0.0, 1.0), coils=True, length=20.0)
    assert (x, y) == (0.0, pytest.approx(26.76, abs=0.005))
    tube = np.array([-60.0, 100.0, 2.4, 20.0, 16.0, 150.0, 200.0])
    run = -18.0, 420.0, 2000.0, True, np.array([0.0, 1.0]), tube, EXAMPLE[6], 60.0
    assert "= 0.1326;" in sentence(5, *run)


def test_coils_bend_a_beam_of_twice_the_voltage_less_by_the_root_of_two() -> None:
    once, twice = (beam((0.0, 0.01), coils=True, v_anode=volts)[-1][2] for volts in (2000.0, 4000.0))
    assert once / twice == pytest.approx(math.sqrt(2.0), rel=1e-5)


@pytest.mark.parametrize(("volts", "speed"), [(1e3, 1.88e4), (1e4, 5.93e4), (2.5e4, 9.38e4)])
def test_speeds_worked_by_hand(volts: float, speed: float) -> None:
    run = (-18.0, 0.21 * volts, volts, *EXAMPLE[3:])
    rows = Steps(ENTRY, record(electron_beam, *run))
    assert rows[4].row[3] == pytest.approx(speed, rel=3e-3)


# The laws


@given(st.floats(-90.0, -1.0), st.floats(0.0, 200.0), st.floats(1.8, 3.0), st.floats(0.0, 1.0))
def test_the_grid_passes_nothing_from_its_cut_off_and_all_at_zero(v_cut, peak, gamma, share) -> None:
    assert beam_current(v_cut, v_cut, peak, gamma) == 0.0
    assert beam_current(1.5 * v_cut, v_cut, peak, gamma) == 0.0
    assert beam_current(0.0, v_cut, peak, gamma) == peak
    less = beam_current(v_cut * (1.0 - 0.9 * share), v_cut, peak, gamma)
    assert 0.0 <= less <= beam_current(v_cut * (1.0 - share), v_cut, peak, gamma) <= peak * (1 + 1e-12)
    assert beam_current(v_cut * (1.0 - share), v_cut, peak, gamma) == pytest.approx(peak * share**gamma)
    dark = (v_cut, 420.0, 2000.0, False, EXAMPLE[4], np.array([v_cut, peak, gamma, 40, 16, 150, 200]))
    assert len(list(electron_beam(*dark, EXAMPLE[6], 60.0))) == 1


@given(st.floats(-59.9, 0.0), st.floats(-59.9, 0.0), st.floats(150.0, 900.0))
def test_the_spot_swells_with_the_current(v_grid, v_other, v_focus) -> None:
    less, more = sorted((v_grid, v_other))
    currents = [beam_current(grid, -60.0, 100.0, 2.4) for grid in (less, more)]
    sharp = [beam(v_grid=grid)[-1][3] ** 2 for grid in (less, more)]
    assert sharp[1] - sharp[0] == pytest.approx(0.16 * (currents[1] - currents[0]) / 36.0, abs=1e-12)
    assert beam(v_grid=-60.0 + 1e-9)[-1][3] == pytest.approx(0.4)  # of hardly any current
    assert currents[0] / sharp[0] <= currents[1] / sharp[1] * (1 + 1e-12)
    blurred = [beam(v_grid=grid, v_focus=v_focus)[-1][3] for grid in (less, more)]
    assert blurred[0] <= blurred[1]


@given(st.floats(0.3, 3.0), st.floats(-600.0, 600.0))
def test_focus_changes_the_width_of_the_spot_and_nothing_else(factor, volts) -> None:
    sharp, other = beam((0.0, volts)), beam((0.0, volts), v_focus=420.0 * factor)
    assert [place[:3] for place in sharp] == [place[:3] for place in other]
    assert sharp[-1][3] == pytest.approx(0.5906, abs=1e-4)
    assert other[-1][3] >= sharp[-1][3]
    wider = beam(v_focus=420.0 * (factor + 0.2 if factor > 1.0 else factor - 0.2))
    assert wider[-1][3] >= beam(v_focus=420.0 * factor)[-1][3]


@given(st.floats(100.0, 30000.0))
def test_the_speed_has_the_energy_of_the_anode(volts) -> None:
    run = (-18.0, 0.21 * volts, volts, *EXAMPLE[3:])
    speed = Steps(ENTRY, record(electron_beam, *run))[4].row[3] * 1000.0
    assert ELECTRON_KG * speed * speed / 2.0 == pytest.approx(CHARGE_C * volts, rel=1e-6)
    exact = exact_speed(volts) * 1000.0
    growth = 1.0 / math.sqrt(1.0 - (exact / LIGHT_M_S) ** 2)
    assert (growth - 1.0) * ELECTRON_KG * LIGHT_M_S**2 == pytest.approx(CHARGE_C * volts, rel=1e-6)
    assert exact < speed
    assert 93.78e6 / exact_speed(25000.0) / 1000.0 == pytest.approx(1.036, abs=1e-3)


def motion(field, start, speed: float, ends, step: float) -> np.ndarray:
    """Places (z, x, y) in metres of an electron, Runge and Kutta's fourth order; ``field(p, v)``: m/s²."""
    place, velocity = np.array(start, float), np.array([speed, 0.0, 0.0])
    places = [place]
    while not ends(place):
        k1 = field(place, velocity)
        k2 = field(place + velocity * step / 2, velocity + k1 * step / 2)
        k3 = field(place + velocity * step / 2 + k1 * step**2 / 4, velocity + k2 * step / 2)
        k4 = field(place + velocity * step + k2 * step**2 / 2, velocity + k3 * step)
        place = place + step * (velocity + step / 6 * (k1 + k2 + k3))
        velocity = velocity + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        places.append(place)
    return np.array(places)


@pytest.mark.parametrize(
    "drive", [(185.0, 192.0), (-300.0, 75.0), (0.0, 600.0), (500.0, 0.0), (100.0, 900.0)]
)
def test_the_way_through_the_plates_is_that_of_the_motion_added_up(drive) -> None:
    ratio, speed = CHARGE_C / ELECTRON_KG, math.sqrt(2 * CHARGE_C * 2000.0 / ELECTRON_KG)
    first, second = PLATES_MM * 1e-3, (PLATES_MM + 50.0) * 1e-3

    def field(place, _velocity):
        z = place[0]
        up = ratio * drive[1] / 0.016 if first <= z < first + 0.04 else 0.0
        across = ratio * drive[0] / 0.016 if second <= z < second + 0.04 else 0.0
        return np.array([0.0, across, up])

    def ends(place):
        return place[0] >= 0.286 or (place[0] < first + 0.04 and abs(place[2]) >= 0.008)

    added_up = motion(field, (0.058, 0.0, 0.0), speed, ends, 5e-5 / speed) * 1e3
    way = [place for place in beam(drive) if place[0] > ANODE_MM]
    for z, x, y, _r in way:
        assert x == pytest.approx(np.interp(z, added_up[:, 0], added_up[:, 1]), abs=0.03)
        assert y == pytest.approx(np.interp(z, added_up[:, 0], added_up[:, 2]), abs=0.05)
    assert way[-1][0] == pytest.approx(added_up[-1, 0], abs=0.1)


@given(runs)
def test_the_plates_bend_in_proportion_and_catch_beyond_their_limit(run) -> None:
    _v_grid, v_focus, v_anode, _coils, drive, tube, terms, refresh = run
    _cut, _peak, _gamma, length, gap, reach_x, reach_y = tube.tolist()

    def last(volts, anode=v_anode):
        whole = -0.1, v_focus, anode, False, volts, np.array([-60.0, 100.0, 2.4, *tube[3:]]), terms, refresh
        return list(electron_beam(*whole))[-1]

    limit = 2.0 * gap * gap * v_anode / length**2
    screen = PLATES_MM + length / 2 + reach_y
    passing = np.clip(drive, -0.4 * limit, 0.4 * limit)
    z, x, y, _r = last(passing)
    assert z == pytest.approx(screen)
    assert (x, y) == pytest.approx(
        (
            length * reach_x * passing[0] / (2 * gap * v_anode),
            length * reach_y * passing[1] / (2 * gap * v_anode),
        )
    )
    assert last(2.0 * passing)[1:3] == pytest.approx((2 * x, 2 * y))
    assert last(passing, 2.0 * v_anode)[1:3] == pytest.approx((x / 2, y / 2))
    assert last(np.array([0.0, 0.999999 * limit]))[0] == pytest.approx(screen)
    caught = last(np.array([0.0, -1.000001 * limit]))
    assert caught[0] < screen
    assert caught[2] == pytest.approx(-gap / 2)


@pytest.mark.parametrize("field_mt", [(0.0, 1.0), (0.4, -0.8), (3.0, 0.0)])
@pytest.mark.parametrize("length", [20.0, 40.0])
def test_the_way_through_the_coils_is_an_arc(field_mt, length) -> None:
    ratio, speed = CHARGE_C / ELECTRON_KG, math.sqrt(2 * CHARGE_C * 2000.0 / ELECTRON_KG)
    begin, out = PLATES_MM * 1e-3, (PLATES_MM + length) * 1e-3

    def field(place, velocity):
        if not begin <= place[0] < out:
            return np.zeros(3)
        across, up = np.array(field_mt) * 1e-3 * ratio
        return np.array([-velocity[1] * across - velocity[2] * up, velocity[0] * across, velocity[0] * up])

    screen = PLATES_MM + length / 2 + 200.0
    added_up = motion(field, (0.06, 0, 0), speed, lambda p: p[0] * 1e3 >= screen, 4e-5 / speed) * 1e3
    way = beam(field_mt, coils=True, length=length)
    for z, x, y, _r in way[4:-1]:
        assert x == pytest.approx(np.interp(z, added_up[:, 0], added_up[:, 1]), abs=0.05)
        assert y == pytest.approx(np.interp(z, added_up[:, 0], added_up[:, 2]), abs=0.05)
    landed, beyond = np.hypot(*added_up[-1, 1:]), np.hypot(*way[-1][1:3])
    tangent = beyond / 200.0
    assert -0.3 < beyond - landed < length * tangent**3 / 8 + 0.3


def test_coils_that_would_turn_the_beam_round_let_nothing_out() -> None:
    assert beam((0.0, 5.0), coils=True)[-1][0] == PLATES_MM  # where they begin
    assert beam((0.0, 3.0), coils=True)[-1][0] > 200.0
    run = (-18.0, 420.0, 2000.0, True, np.array([0.0, 5.0]), *EXAMPLE[5:])
    assert "no sine is 1 or more" in sentence(5, *run)


@given(st.sampled_from(["P1", "P4", "P7", "P31", "P22G"]), st.floats(10.0, 200.0))
def test_what_is_left_of_the_light_is_what_the_phosphor_leaves(name, refresh) -> None:
    phosphor = Phosphor.named(name)
    terms = np.array([(term.weight, term.tau_s * 1000.0) for term in phosphor.terms])
    run = (*EXAMPLE[:6], terms, refresh)
    left = Steps(ENTRY, record(electron_beam, *run))[6].row[3]
    assert left == pytest.approx(100.0 * phosphor.intensity(1.0 / refresh))


# What is said


def test_six_parts_are_told_one_after_the_other() -> None:
    steps = Steps(ENTRY, record(electron_beam, *EXAMPLE))
    rows = [steps[number].row[0] for number in range(1, len(steps) + 1)]
    assert rows == [
        *("cathode", "control grid", "focusing anode", "accelerating anode", "deflection", "screen"),
    ]


@pytest.mark.parametrize(
    ("number", "change", "words"),
    [
        (2, {0: -60.0}, "the screen stays dark"),
        (3, {1: 300.0}, "too much"),
        (3, {1: 500.0}, "too little"),
        (5, {4: np.array([0.0, 700.0])}, "hits a plate"),
        (6, {4: np.array([0.0, 600.0])}, "no screen any more"),
    ],
)
def test_what_goes_wrong_is_told(number: int, change: dict[int, Any], words: str) -> None:
    run = [change.get(place, value) for place, value in enumerate(EXAMPLE)]
    assert words in sentence(number, *run)


@pytest.mark.parametrize(
    ("place", "value", "word"),
    [(2, 0.0, "above 0 V"), (1, -1.0, "above 0 V"), (5, np.array([1.0, 1, 1, 1, 1, 1, 1]), "cut-off")],
)
def test_a_tube_that_cannot_be_is_refused(place: int, value: Any, word: str) -> None:
    run = [value if k == place else each for k, each in enumerate(EXAMPLE)]
    with pytest.raises(ValueError, match=word):
        list(electron_beam(*run))
