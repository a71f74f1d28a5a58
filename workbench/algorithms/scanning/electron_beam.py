"""The beam of a cathode-ray tube, part by part: from the heated cathode to the light of the phosphor.

V_g, V_c        voltage of the control grid, and the one at which it cuts the beam off
K, gamma        current at V_g = 0, in microamperes, and the exponent of the gun
V_f, V_a        voltages of the focusing and the accelerating anode
l, d            length of the plates (or coils) and the gap between the plates, in mm
D_x, D_y        from the middle of the plates to the screen, in mm
z, x, y, r      a place of the beam, z along the tube from the cathode, and its half width, in mm
"""

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.scanning.electron_beam_views import COLUMNS, VIEWS

Array = NDArray[Any]

CHARGE_TO_MASS = 1.75882001e11
"""Of an electron, in coulombs per kilogram (CODATA 2018)."""

LIGHT_KM_S, REST_VOLTS = 299792.458, 510998.95
"""The speed of light, and the energy of an electron at rest."""

GRID_MM, LENS_MM, ANODE_MM, PLATES_MM = 8.0, 32.0, 58.0, 66.0
"""Where grid, middle of the focusing anode and accelerating anode are, and where the first plates begin."""

FOCUS_SHARE = 0.21
LENS_RADIUS, SPOT = 3.0, 0.6
"""A thin lens, for teaching: it brings the beam together at the screen when V_f is this share of V_a."""

FACE_MM = 140.0, 120.0
PIECES = 12


def beam_current(v_grid: float, v_cut: float, peak: float, gamma: float) -> float:
    """What the grid lets through: I = K (1 - V_g / V_c)^gamma, and nothing from V_c < 0 downwards."""
    share = 1.0 - v_grid / v_cut
    if share <= 0.0:
        return 0.0
    return peak * math.pow(share, gamma)


def exact_speed(v_anode: float) -> float:
    """The speed behind the anode in km/s, with the mass growing as relativity has it."""
    growth = 1.0 + v_anode / REST_VOLTS
    return LIGHT_KM_S * math.sqrt(1.0 - 1.0 / (growth * growth))


def half_width(z: float, crossing: float) -> float:
    """Of the beam at z; its rays run together ``crossing`` mm behind the lens, to no less than the spot."""
    ray = LENS_RADIUS * (1.0 - (z - LENS_MM) / crossing)
    return math.sqrt(SPOT * SPOT + ray * ray)


def light_left(terms: Array, time: float) -> float:
    """The share of a phosphor's light that is left ``time`` ms after the hit; weights and times of terms."""
    left = 0.0
    for k in range(len(terms)):
        tau = float(terms[k, 1])
        if tau > 0.0:
            left += float(terms[k, 0]) * math.exp(-time / tau)
    return left


def refuse_tube(v_focus: float, v_anode: float, tube: Array) -> None:
    """Raise ValueError for a tube without acceleration, focus, cut-off or plates."""
    if not (v_anode > 0.0 and v_focus > 0.0):
        raise ValueError("The anodes need voltages above 0 V.")
    if len(tube) != 7:
        raise ValueError("A tube has seven numbers: V_c, K and gamma, l, d, D_x and D_y.")
    if not tube[0] < 0.0:
        raise ValueError("The cut-off of the control grid lies below 0 V.")
    if not (tube[3] > 0.0 and tube[4] > 0.0):
        raise ValueError("The plates need a length and a gap of more than 0 mm.")


def coil_sine(field_x: float, field_y: float, v_anode: float, length: float) -> float:
    """Of the angle by which coils turn the beam: l B sqrt(e / (2 m V_a)), fields in mT, the length in mm."""
    field = math.sqrt(field_x * field_x + field_y * field_y)
    return 1e-6 * length * field * math.sqrt(CHARGE_TO_MASS / (2.0 * v_anode))


def thrown(sine: float, field_x: float, field_y: float, reach: float) -> tuple[float, float]:
    """Where the turned beam lands, in mm: D tan(angle), towards where the fields bend it."""
    field = math.sqrt(field_x * field_x + field_y * field_y)
    if field == 0.0 or sine >= 1.0:
        return 0.0, 0.0
    fall = reach * sine / math.sqrt(1.0 - sine * sine)
    return fall * field_x / field, fall * field_y / field


def bent_by_plates(
    v_x: float, v_y: float, v_anode: float, length: float, gap: float, between: float, crossing: float
) -> Iterator[tuple[float, float, float, float]]:
    """The way through both pairs of plates, the second ``between`` mm behind the first, or to a plate."""
    z, x, y, slope = PLATES_MM, 0.0, 0.0, 0.0
    yield z, x, y, half_width(z, crossing)
    for pair in range(2):
        volts = v_y if pair == 0 else v_x
        reached = length
        if abs(volts) > 2.0 * gap * gap * v_anode / (length * length):
            reached = gap * math.sqrt(2.0 * v_anode / abs(volts))
        start = z
        rise = y
        for k in range(1, PIECES + 1):
            s = reached * k / PIECES
            bend = volts * s * s / (4.0 * gap * v_anode)
            z = start + s
            if pair == 0:
                y = bend
            else:
                x = bend
                y = rise + slope * s
            yield z, x, y, half_width(z, crossing)
        if reached < length:
            return
        if pair == 0:
            slope = volts * length / (2.0 * gap * v_anode)
            z = PLATES_MM + between
            y += slope * (between - length)
            yield z, x, y, half_width(z, crossing)


def bent_by_coils(
    sine: float, field_x: float, field_y: float, length: float, crossing: float
) -> Iterator[tuple[float, float, float, float]]:
    """The arc through the coils, which turn the beam by this sine; nothing of a beam that never leaves."""
    if sine >= 1.0:
        return
    field = math.sqrt(field_x * field_x + field_y * field_y)
    for k in range(PIECES + 1):
        z = PLATES_MM + length * k / PIECES
        x = 0.0
        y = 0.0
        if field > 0.0:
            turned = sine * k / PIECES
            bend = length / sine * (1.0 - math.sqrt(1.0 - turned * turned))
            x = bend * field_x / field
            y = bend * field_y / field
        yield z, x, y, half_width(z, crossing)


def electron_beam(
    v_grid: float,
    v_focus: float,
    v_anode: float,
    coils: bool,
    drive: Array,
    tube: Array,
    terms: Array,
    refresh: float,
) -> Iterator[tuple[float, float, float, float]]:
    """Follow the beam from the cathode to the screen.

    Args: voltages; drive (2,) in V, of coils in mT; tube (7,): V_c, K,
    gamma, l, d, D_x, D_y; the phosphor's terms (n, 2) in ms; pictures per
    second. Emits: (z, x, y, half width) in mm. Source: Hearn and Baker 2-1.
    """
    # Heat the cathode
    refuse_tube(v_focus, v_anode, tube)
    v_cut, peak, gamma = float(tube[0]), float(tube[1]), float(tube[2])
    length, gap = float(tube[3]), float(tube[4])
    reach_x, reach_y = float(tube[5]), float(tube[6])
    screen = PLATES_MM + length / 2.0 + reach_y
    yield 0.0, 0.0, 0.0, 2.0

    # Hold electrons back with the control grid
    current = beam_current(v_grid, v_cut, peak, gamma)
    if current <= 0.0:
        return
    yield GRID_MM, 0.0, 0.0, SPOT

    # Focus the beam
    throw = screen - LENS_MM
    crossing = throw * v_focus / (FOCUS_SHARE * v_anode)
    spot = half_width(screen, crossing)
    yield LENS_MM, 0.0, 0.0, LENS_RADIUS

    # Accelerate it
    speed = math.sqrt(2.0 * CHARGE_TO_MASS * v_anode) / 1000.0
    yield ANODE_MM, 0.0, 0.0, half_width(ANODE_MM, crossing)

    # Deflect it
    drive_x, drive_y = float(drive[0]), float(drive[1])
    sine, limit = 0.0, 0.0
    if coils:
        sine = coil_sine(drive_x, drive_y, v_anode, length)
        x, y = thrown(sine, drive_x, drive_y, reach_y)
        stopped = sine >= 1.0
        yield from bent_by_coils(sine, drive_x, drive_y, length, crossing)
    else:
        limit = 2.0 * gap * gap * v_anode / (length * length)
        x = length * reach_x * drive_x / (2.0 * gap * v_anode)
        y = length * reach_y * drive_y / (2.0 * gap * v_anode)
        stopped = max(abs(drive_x), abs(drive_y)) > limit
        yield from bent_by_plates(drive_x, drive_y, v_anode, length, gap, reach_y - reach_x, crossing)
    if stopped:
        return

    # Light the phosphor
    left = 100.0 * light_left(terms, 1000.0 / refresh)
    yield screen, x, y, spot


_DRIVE = np.array([185.0, 192.0])
_TUBE = np.array([-60.0, 100.0, 2.4, 40.0, 16.0, 150.0, 200.0])
_P1 = np.array([[1.0, 11.73]])


def _voltages(chance: Random) -> tuple[Any, ...]:
    """Tubes of all sizes; some are cut off, some catch the beam on a plate or turn it back in the coils."""
    v_cut, v_anode = -chance.choice((40.0, 60.0, chance.uniform(1.0, 90.0))), chance.uniform(200.0, 25000.0)
    v_grid = chance.choice((0.0, v_cut, chance.uniform(1.2 * v_cut, 0.0)))
    length, gap = chance.uniform(5.0, 40.0), chance.uniform(3.0, 20.0)
    reach_x = chance.uniform(length, 200.0)
    coils = chance.random() < 0.4
    limit = 2.0 * gap * gap * v_anode / (length * length)
    most = 6.0 if coils else 1.5 * limit
    drives = [chance.choice((0.0, 0.3 * most, chance.uniform(-most, most))) for _way in "xy"]
    terms = [[chance.random(), chance.uniform(0.01, 60.0)] for _term in range(chance.randint(1, 3))]
    tube = [v_cut, chance.uniform(0.0, 200.0), chance.uniform(1.8, 3.0), length, gap, reach_x]
    tube.append(reach_x + length + chance.uniform(0.0, 60.0))
    v_focus = v_anode * chance.choice((0.21, chance.uniform(0.05, 0.6)))
    refresh = chance.choice((25.0, 60.0, 100.0))
    return v_grid, v_focus, v_anode, coils, np.array(drives), np.array(tube), np.array(terms), refresh


ENTRY = Entry(
    function=electron_beam,
    topic="scanning",
    title="Electron beam",
    summary="Cathode, grid, focus, acceleration, deflection, phosphor: each does one thing to the beam.",
    parameters=(
        Parameter("v_grid", "V_g", "float", -18.0, -500, 0, "V", "voltage of the control grid"),
        Parameter("v_focus", "V_f", "float", 420.0, 1, 30000, "V", "voltage of the focusing anode"),
        Parameter("v_anode", "V_a", "float", 2000.0, 1, 30000, "V", "accelerating voltage"),
        Parameter("coils", "coils", "bool", False, meaning="bent by coils, not by plates"),
        Parameter("drive", "V_x, V_y", "floats", _DRIVE, unit="V", meaning="across and upwards (coils: mT)"),
        Parameter("tube", "tube", "floats", _TUBE, meaning="V_c, K and gamma, then l, d, D_x, D_y in mm"),
        Parameter("terms", "w_k, tau_k", "points", _P1, meaning="weight and time constant in ms: P1"),
        Parameter("refresh", "f", "float", 60.0, 1, 1000, "Hz", "pictures per second"),
    ),
    arguments=_voltages,
    emits="points",
    emitted_columns=("z", "x", "y", "r"),
    frame="world",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=COLUMNS,
    views=VIEWS,
    laws=(
        Law(
            "The grid passes nothing from V_c on, all of K at 0 V, and more the nearer to 0 it is.",
            "scanning/test_electron_beam.py::test_the_grid_passes_nothing_from_its_cut_off_and_all_at_zero",
        ),
        Law(
            "Focus changes the width of the spot, which is least at one voltage, and nothing else.",
            "scanning/test_electron_beam.py::test_focus_changes_the_width_of_the_spot_and_nothing_else",
        ),
        Law(
            "Behind the anode m v² / 2 is e V_a; relativity makes it slower, by 3.5 % at 25 kV.",
            "scanning/test_electron_beam.py::test_the_speed_has_the_energy_of_the_anode",
        ),
        Law(
            "The way through the plates is that of an electron whose motion is added up in small steps.",
            "scanning/test_electron_beam.py::test_the_way_through_the_plates_is_that_of_the_motion_added_up",
        ),
        Law(
            "Twice V_y bends twice as far, twice V_a half as far; beyond 2 d² V_a / l² the plates catch it.",
            "scanning/test_electron_beam.py::test_the_plates_bend_in_proportion_and_catch_beyond_their_limit",
        ),
        Law(
            "In the coils it runs on the arc of the motion added up; D tan θ is at most l tan³ θ / 8 beyond.",
            "scanning/test_electron_beam.py::test_the_way_through_the_coils_is_an_arc",
        ),
        Law(
            "What is left of the light is what the phosphor's decay leaves.",
            "scanning/test_electron_beam.py::test_what_is_left_of_the_light_is_what_the_phosphor_leaves",
        ),
    ),
    not_laws=(
        "Mass that grows with speed matters in a tube: at 2 kV the formulas are 0.3 % off in the speed and "
        "0.2 % in what the plates bend; at 25 kV 3.6 % and 2.4 %, still less than a drawing shows.",
        "The lens is a model for teaching: a real one is two gaps whose field bends the rays, and its focal "
        "length is no straight line over V_f.",
    ),
    questions=(6,),
    labs=("Electron gun and deflection",),
    next_rung="beam_spot",
)
