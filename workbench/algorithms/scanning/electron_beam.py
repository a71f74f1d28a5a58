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
from workbench.algorithms.scanning.electron_optics import (
    ANODE_MM,
    CHARGE_TO_MASS,
    FOCUS_SHARE,
    GRID_MM,
    LENS_MM,
    LENS_RADIUS,
    PLATES_MM,
    beam_current,
    bent_by_coils,
    bent_by_plates,
    coil_sine,
    exact_speed,
    half_width,
    light_left,
    off_the_face,
    refuse_tube,
    sharp_spot,
    thrown,
)

Array = NDArray[Any]


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
    length, gap, reach_x, reach_y = float(tube[3]), float(tube[4]), float(tube[5]), float(tube[6])
    screen = PLATES_MM + length / 2.0 + reach_y
    yield 0.0, 0.0, 0.0, 2.0

    # Hold electrons back with the control grid
    current = beam_current(v_grid, v_cut, peak, gamma)
    if current <= 0.0:
        return
    least = sharp_spot(current)
    yield GRID_MM, 0.0, 0.0, least

    # Focus the beam
    throw = screen - LENS_MM
    crossing = throw * v_focus / (FOCUS_SHARE * v_anode)
    spot = half_width(screen, crossing, least)
    yield LENS_MM, 0.0, 0.0, LENS_RADIUS

    # Accelerate it
    speed = math.sqrt(2.0 * CHARGE_TO_MASS * v_anode) / 1000.0
    yield ANODE_MM, 0.0, 0.0, half_width(ANODE_MM, crossing, least)

    # Deflect it
    drive_x, drive_y = float(drive[0]), float(drive[1])
    sine, limit = 0.0, 0.0
    if coils:
        sine = coil_sine(drive_x, drive_y, v_anode, length)
        x, y = thrown(sine, drive_x, drive_y, reach_y)
        stopped = sine >= 1.0
        yield from bent_by_coils(sine, drive_x, drive_y, length, crossing, least)
    else:
        limit = 2.0 * gap * gap * v_anode / (length * length)
        x = length * reach_x * drive_x / (2.0 * gap * v_anode)
        y = length * reach_y * drive_y / (2.0 * gap * v_anode)
        stopped = max(abs(drive_x), abs(drive_y)) > limit
        yield from bent_by_plates(drive_x, drive_y, v_anode, length, gap, reach_y - reach_x, crossing, least)
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
    summary="A cathode-ray tube makes a beam of electrons from a hot cathode, focuses it, speeds it up, "
    "bends it to one place of the screen, and makes the phosphor glow there.",
    parameters=(
        Parameter("v_grid", "V_g", "float", -18.0, -500, 0, "V", "voltage of the control grid"),
        Parameter("v_focus", "V_f", "float", 420.0, 1, 30000, "V", "voltage of the focusing anode"),
        Parameter("v_anode", "V_a", "float", 2000.0, 1, 30000, "V", "accelerating voltage"),
        Parameter("coils", "coils", "bool", False, meaning="bent by coils, not by plates"),
        Parameter("drive", "V_x, V_y", "floats", _DRIVE, unit="V", meaning="across and upwards (coils: mT)"),
        Parameter("tube", "tube", "floats", _TUBE, meaning="V_c, K and γ, then l, d, D_x, D_y in mm"),
        Parameter("terms", "w_k, τ_k", "points", _P1, meaning="weight and time constant in ms: P1"),
        Parameter("refresh", "f", "float", 60.0, 1, 1000, "Hz", "pictures per second"),
    ),
    arguments=_voltages,
    emits="points",
    emitted_columns=("z", "x", "y", "r"),
    frame="world",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=(exact_speed, off_the_face),
    laws=(
        Law(
            "The grid passes nothing from V_c on, all of K at 0 V, and more the nearer to 0 it is.",
            "scanning/test_electron_beam.py::test_the_grid_passes_nothing_from_its_cut_off_and_all_at_zero",
        ),
        Law(
            "The spot's area in focus grows in step with the current, so more current is never dimmer.",
            "scanning/test_electron_beam.py::test_the_spot_swells_with_the_current",
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
        "So is the swelling of the spot: in a real tube the electrons push each other apart, and a large "
        "current lowers the voltages; how far depends on the gun.",
    ),
    questions=(6,),
    labs=("Electron gun and deflection",),
)
