"""What the parts of a cathode-ray tube do to its electrons: plain laws that the text of the beam calls.

Voltages in V, currents in microamperes, fields in mT, lengths in mm, z along the tube from the cathode.
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

Array = NDArray[Any]

CHARGE_TO_MASS = 1.75882001e11
"""Of an electron, in coulombs per kilogram (CODATA 2018)."""

LIGHT_KM_S, REST_VOLTS = 299792.458, 510998.95
"""The speed of light, and the energy of an electron at rest."""

GRID_MM, LENS_MM, ANODE_MM, PLATES_MM = 8.0, 32.0, 58.0, 66.0
"""Where grid, middle of the focusing anode and accelerating anode are, and where the first plates begin."""

FOCUS_SHARE = 0.21
LENS_RADIUS = 3.0
"""A thin lens, for teaching: it brings the beam together at the screen when V_f is this share of V_a."""

SPOT, SWELL_UA = 0.4, 36.0
"""Half the width of a sharp spot of hardly any current, and the current that doubles its area."""

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


def sharp_spot(current: float) -> float:
    """Half the width of the spot in focus: its area grows in step with the current, a model for teaching."""
    return SPOT * math.sqrt(1.0 + current / SWELL_UA)


def half_width(z: float, crossing: float, least: float) -> float:
    """Of the beam at z; its rays run together ``crossing`` mm behind the lens, to no less than ``least``."""
    ray = LENS_RADIUS * (1.0 - (z - LENS_MM) / crossing)
    return math.sqrt(least * least + ray * ray)


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
        raise ValueError("A tube has seven numbers: V_c, K and γ, l, d, D_x and D_y.")
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
    v_x: float,
    v_y: float,
    v_anode: float,
    length: float,
    gap: float,
    between: float,
    crossing: float,
    least: float,
) -> Iterator[tuple[float, float, float, float]]:
    """The way through both pairs of plates, the second ``between`` mm behind the first, or to a plate."""
    z, x, y, slope = PLATES_MM, 0.0, 0.0, 0.0
    yield z, x, y, half_width(z, crossing, least)
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
            yield z, x, y, half_width(z, crossing, least)
        if reached < length:
            return
        if pair == 0:
            slope = volts * length / (2.0 * gap * v_anode)
            z = PLATES_MM + between
            y += slope * (between - length)
            yield z, x, y, half_width(z, crossing, least)


def bent_by_coils(
    sine: float, field_x: float, field_y: float, length: float, crossing: float, least: float
) -> Iterator[tuple[float, float, float, float]]:
    """The arc through the coils, which turn the beam by this sine; where they turn it back, its way in."""
    pieces = PIECES
    if sine >= 1.0:
        pieces = 0
    field = math.sqrt(field_x * field_x + field_y * field_y)
    for k in range(pieces + 1):
        z = PLATES_MM + length * k / PIECES
        x = 0.0
        y = 0.0
        if field > 0.0:
            turned = sine * k / PIECES
            bend = length / sine * (1.0 - math.sqrt(1.0 - turned * turned))
            x = bend * field_x / field
            y = bend * field_y / field
        yield z, x, y, half_width(z, crossing, least)


def off_the_face(x: float, y: float) -> bool:
    """Whether a place, from the middle of the screen, is none of it."""
    return abs(x) > FACE_MM[0] / 2.0 or abs(y) > FACE_MM[1] / 2.0
