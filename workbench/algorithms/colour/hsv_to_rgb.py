"""From hue, saturation and value to red, green and blue.

i, f            the sixth of the hexagon in which the hue lies, and how far into it
p               the smallest component: what of the value is grey
q, t            the component in the middle, falling in odd sixths and rising in even ones
"""

import math
from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.colour.hexagon import CORNERS, hexagon, outline, place
from workbench.algorithms.colour.parameters import coded_hsv
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark, Region, Spot, Stroke, along, closed
from workbench.algorithms.numerals import numeral


def hsv_to_rgb(h: float, s: float, v: float) -> Iterator[tuple[float, float, float]]:
    """Emit red, green and blue of a colour.

    Args: hue in degrees, 0 to 360; saturation and value, 0 to 1. Emits:
    (r, g, b), 0 to 1. Source: Foley, van Dam, Feiner and Hughes, Computer
    Graphics, section 13.3.4; Hearn and Baker, C Version, section 15-8.
    """
    # Find the sixth of the hexagon, and how far into it
    sixths = h / 60.0
    i = math.floor(sixths)
    f = sixths - i
    if i == 6:
        i = 0

    # Work out the levels that the components can have
    p = v * (1.0 - s)
    q = v * (1.0 - s * f)
    t = v * (1.0 - s * (1.0 - f))

    # Give each component its level
    if i == 0:
        r, g, b = v, t, p
    elif i == 1:
        r, g, b = q, v, p
    elif i == 2:
        r, g, b = p, v, t
    elif i == 3:
        r, g, b = p, q, v
    elif i == 4:
        r, g, b = t, p, v
    else:
        r, g, b = v, p, q
    yield r, g, b


_NAMES = ("red", "yellow", "green", "cyan", "blue", "magenta")
_LEVELS = ("(v, t, p)", "(q, v, p)", "(p, v, t)", "(p, q, v)", "(t, p, v)", "(v, p, q)")


def sixth_text(i: int) -> str:
    """Between which corners of the hexagon a sixth lies."""
    return f"from {_NAMES[i]} to {_NAMES[(i + 1) % 6]}"


def levels_text(i: int) -> str:
    """Which levels red, green and blue have in a sixth."""
    return _LEVELS[i]


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The sixth of the hexagon, the hexagon of the value, and the colour in it."""
    h, _s, v = (float(number) for number in arguments)
    if ended or "i" in now:
        sixth = math.floor(h / 60.0) % len(CORNERS)
        corners = hexagon(1.0).tolist()
        yield Region(along((0.0, 0.0), corners[sixth], corners[(sixth + 1) % 6]))
    yield from outline()
    if (ended or "p" in now) and v > 0.0:
        yield Stroke(closed(hexagon(v)), "data1", "medium")
    if len(emitted):
        where = place(*emitted[-1].tolist())
        yield Stroke(along((0.0, 0.0), where), "data2", "bold")
        yield Spot(*where, "accent", "ring", "large")


ENTRY = Entry(
    function=hsv_to_rgb,
    topic="colour",
    title="HSV to RGB",
    summary="The sixth of the hexagon tells which component is largest, smallest and in between.",
    parameters=(
        Parameter("h", "H", "float", 200.0, 0.0, 360.0, "degrees", meaning="hue, from red over green"),
        Parameter("s", "S", "float", 0.6, 0.0, 1.0, meaning="saturation: 0 is grey"),
        Parameter("v", "V", "float", 0.9, 0.0, 1.0, meaning="value: 0 is black"),
    ),
    arguments=coded_hsv,
    emits="points",
    emitted_columns=("r", "g", "b"),
    source="Foley, van Dam, Feiner and Hughes, Computer Graphics, section 13.3.4",
    columns=("symbol", "worked out", "value"),
    view_functions=(numeral, sixth_text, levels_text),
    views=(
        View(
            block="Find the sixth of the hexagon, and how far into it",
            row="('i, f', f'{numeral(h)} / 60', (i, f))",
            sentence="{h} / 60 = {sixths}: sixth {i}, {sixth_text(i)}, and {f} of the way into it.",
        ),
        View(
            block="Work out the levels that the components can have",
            tables={
                "Levels": (
                    "[('v', 'V', v), ('p', 'V (1 − S)', p), ('q', 'V (1 − S f)', q), "
                    "('t', 'V (1 − S (1 − f))', t)]",
                    ("level", "worked out", "value"),
                )
            },
            row="('p, q, t', 'V (1 − S), V (1 − S f), V (1 − S (1 − f))', (p, q, t))",
            sentence="The largest component is {v}, the smallest {p}; the one between is {q} where it falls "
            "and {t} where it rises.",
        ),
        View(
            block="Give each component its level",
            row="('R, G, B', levels_text(i), (r, g, b))",
            sentence="In sixth {i} red, green and blue are {levels_text(i)}: R = {r}, G = {g}, B = {b}.",
        ),
    ),
    laws=(
        Law(
            "Red, green and blue are those of colorsys of the standard library.",
            "colour/test_colour.py::test_red_green_and_blue_are_those_of_the_standard_library",
        ),
        Law(
            "RGB to HSV gives hue, saturation and value back, where there is a hue.",
            "colour/test_colour.py::test_back_and_there_is_the_same_hue",
        ),
        Law(
            "The largest component is the value, the smallest V (1 − S).",
            "colour/test_colour.py::test_value_and_saturation_are_those_of_the_components",
        ),
    ),
    questions=(6,),
    labs=("Colour models",),
    marks=marks,
    frame="view",
    count="1",
)
