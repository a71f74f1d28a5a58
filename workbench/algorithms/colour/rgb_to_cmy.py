"""From light to ink: a printer takes away from white what a screen would not have added to black.

r, g, b         red, green and blue as they are coded, 0 to 1
c, m, y         cyan, magenta and yellow: cyan ink swallows red, magenta green, yellow blue
"""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.colour.parameters import RGB, coded_rgb
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.marks import Ink, Mark, Stroke, Word, along
from workbench.algorithms.numerals import numeral


def rgb_to_cmy(r: float, g: float, b: float) -> Iterator[tuple[float, float, float]]:
    """Emit how much cyan, magenta and yellow make the colour on white paper.

    Args: red, green and blue, 0 to 1. Emits: (c, m, y), 0 to 1.
    Source: Hearn and Baker, Computer Graphics, C Version, section 15-6.
    """
    # Cyan takes the red that is missing from white
    c = 1.0 - r

    # Magenta takes the green that is missing
    m = 1.0 - g

    # Yellow takes the blue that is missing
    y = 1.0 - b
    yield c, m, y


_BARS: tuple[tuple[str, str, Ink], ...] = (("r", "c", "data2"), ("g", "m", "data3"), ("b", "y", "data1"))


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """A bar for each component from black to white: what there is of light, and above it what ink takes."""
    for place, (level, (light, ink, colour)) in enumerate(zip(arguments, _BARS, strict=True)):
        x = 0.25 + 0.5 * place
        yield Stroke(along((x, 0.0), (x, float(level))), colour, "heavy")
        yield Word(light.upper(), x, -0.12, "muted")
        if ended or ink in now:
            yield Stroke(along((x, float(level)), (x, 1.0)), "text", "thin", "dot")
            yield Word(ink.upper(), x, 1.12, "text", strong=True)


ENTRY = Entry(
    function=rgb_to_cmy,
    topic="colour",
    title="RGB to CMY",
    summary="Ink takes away what light adds: each of cyan, magenta and yellow is 1 minus its opposite.",
    parameters=RGB,
    arguments=coded_rgb,
    emits="points",
    emitted_columns=("c", "m", "y"),
    source="Hearn and Baker, Computer Graphics, C Version, section 15-6",
    columns=("symbol", "worked out", "value"),
    view_functions=(numeral,),
    views=(
        View(
            block="Cyan takes the red that is missing from white",
            row="('C', f'1 − {numeral(r)}', c)",
            sentence="White has 1 of red and the colour {r}: cyan ink takes the other {c}.",
        ),
        View(
            block="Magenta takes the green that is missing",
            row="('M', f'1 − {numeral(g)}', m)",
            sentence="The colour has {g} of green: magenta ink takes the other {m}.",
        ),
        View(
            block="Yellow takes the blue that is missing",
            row="('Y', f'1 − {numeral(b)}', y)",
            sentence="The colour has {b} of blue: yellow ink takes the other {y}.",
        ),
    ),
    laws=(
        Law(
            "Light and ink of each component together make white.",
            "colour/test_colour.py::test_light_and_ink_make_white",
        ),
        Law(
            "Done twice it gives the colour back: CMY to RGB is the same subtraction.",
            "colour/test_colour.py::test_the_subtraction_undoes_itself",
        ),
    ),
    questions=(6,),
    labs=("Colour models",),
    marks=marks,
    frame="view",
    count="1",
    next_rung="rgb_to_hsv",
)
