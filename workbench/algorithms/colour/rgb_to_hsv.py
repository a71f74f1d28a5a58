"""From red, green and blue to hue, saturation and value.

largest, smallest   the greatest and the least of the components
delta               how far they are apart: 0 for a grey
v                   value: how far from black
s                   saturation: how far from grey, of what there can be at this value
h                   hue: the place around the hexagon, in degrees from red
"""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.colour.hexagon import hexagon, outline, place
from workbench.algorithms.colour.parameters import RGB, coded_rgb
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.marks import Mark, Spot, Stroke, along, closed
from workbench.algorithms.numerals import numeral


def rgb_to_hsv(r: float, g: float, b: float) -> Iterator[tuple[float, float, float]]:
    """Emit hue, saturation and value of a colour.

    Args: red, green and blue, 0 to 1. Emits: (h, s, v), h in degrees; a grey
    has no hue and gets 0. Source: Foley, van Dam, Feiner and Hughes, Computer
    Graphics, section 13.3.4; Hearn and Baker, C Version, section 15-8.
    """
    # Find the largest and the smallest component
    largest = max(r, g, b)
    smallest = min(r, g, b)
    delta = largest - smallest

    # The largest is the value
    v = largest

    # The saturation is the share that is not grey
    s = 0.0
    if largest > 0.0:
        s = delta / largest

    # Count sixths of the hexagon from red
    sixths = 0.0
    if delta > 0.0:
        if r == largest:
            sixths = (g - b) / delta
        elif g == largest:
            sixths = 2.0 + (b - r) / delta
        else:
            sixths = 4.0 + (r - g) / delta

    # Turn sixths into degrees from 0 to 360
    h = 60.0 * sixths
    if h < 0.0:
        h = h + 360.0
    yield h, s, v


def sixths_text(r: float, g: float, b: float) -> str:
    """How the sixths are worked out, with the numbers of the colour."""
    largest = max(r, g, b)
    delta = numeral(largest - min(r, g, b))
    if r == g == b:
        return "Δ = 0: none"
    red, green, blue = numeral(r), numeral(g), numeral(b)
    if r == largest:
        return f"({green} − {blue}) / {delta}"
    if g == largest:
        return f"2 + ({blue} − {red}) / {delta}"
    return f"4 + ({red} − {green}) / {delta}"


def strongest(r: float, g: float, b: float) -> str:
    """The component from which the hue is counted, red before green before blue."""
    largest = max(r, g, b)
    if r == largest:
        return "red"
    return "green" if g == largest else "blue"


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The hexagon of the value, the line from grey to the purest colour of the hue, the colour itself."""
    r, g, b = (float(level) for level in arguments)
    yield from outline()
    if (ended or "v" in now) and max(r, g, b) > 0.0:
        yield Stroke(closed(hexagon(max(r, g, b))), "data1", "medium")
    if ended or "s" in now:
        yield Stroke(along((0.0, 0.0), place(r, g, b)), "data2", "bold")
    if ended or "sixths" in now:
        yield Spot(*place(r, g, b), "accent", "ring", "large")


ENTRY = Entry(
    function=rgb_to_hsv,
    topic="colour",
    title="RGB to HSV",
    summary="The largest component is the value; what is apart from grey gives saturation and hue.",
    parameters=RGB,
    arguments=coded_rgb,
    emits="points",
    emitted_columns=("h", "s", "v"),
    source="Foley, van Dam, Feiner and Hughes, Computer Graphics, section 13.3.4",
    columns=("symbol", "worked out", "value"),
    view_functions=(numeral, sixths_text, strongest),
    views=(
        View(
            block="Find the largest and the smallest component",
            row="('Δ', f'{numeral(largest)} − {numeral(smallest)}', delta)",
            sentence="The components reach from {smallest} to {largest}: Δ = {delta}.",
        ),
        View(
            block="The largest is the value",
            row="('V', f'max({numeral(r)}, {numeral(g)}, {numeral(b)})', v)",
            sentence="The largest component is the value: V = {v}.",
        ),
        View(
            block="The saturation is the share that is not grey",
            when="largest > 0.0",
            row="('S', f'{numeral(delta)} / {numeral(largest)}', s)",
            sentence="Of {largest} the part {smallest} is common to all and grey: S = Δ / V = {s}.",
        ),
        View(
            block="The saturation is the share that is not grey",
            row="('S', 'V = 0: none', s)",
            sentence="Black has no saturation: S = {s}.",
        ),
        View(
            block="Count sixths of the hexagon from red",
            when="delta > 0.0",
            row="('sixths', sixths_text(r, g, b), sixths)",
            sentence="The largest is {strongest(r, g, b)}, so the hue lies at {sixths_text(r, g, b)} = "
            "{sixths} sixths of the way round from red.",
        ),
        View(
            block="Count sixths of the hexagon from red",
            row="('sixths', sixths_text(r, g, b), sixths)",
            sentence="A grey has no hue; 0 is written for it by custom.",
        ),
        View(
            block="Turn sixths into degrees from 0 to 360",
            when="sixths < 0.0",
            row="('H', f'60 · {numeral(sixths)} + 360', h)",
            sentence="A sixth is 60 degrees; below red the hue is counted on from 360: H = {h} degrees.",
        ),
        View(
            block="Turn sixths into degrees from 0 to 360",
            row="('H', f'60 · {numeral(sixths)}', h)",
            sentence="A sixth is 60 degrees: H = {h} degrees.",
        ),
    ),
    laws=(
        Law(
            "Hue, saturation and value are those of colorsys of the standard library.",
            "colour/test_colour.py::test_hue_saturation_and_value_are_those_of_the_standard_library",
        ),
        Law(
            "HSV to RGB gives the colour back.",
            "colour/test_colour.py::test_there_and_back_is_the_same_colour",
        ),
        Law(
            "Reckoned in exact fractions it is the same to 14 digits.",
            "colour/test_colour.py::test_reckoned_in_fractions_it_is_the_same",
        ),
    ),
    not_laws=(
        "The value is how bright a colour looks: pure blue and white both have value 1.",
        "A grey has the hue of red; it has none.",
    ),
    questions=(6,),
    labs=("Colour models",),
    marks=marks,
    frame="view",
    count="1",
    next_rung="hsv_to_rgb",
)
