"""The energy that a moving spot leaves: the beam is a Gaussian, and a pixel collects what passes over it.

sigma           standard deviation of the spot, in pixels
u, v            place of a pixel along and across the stroke, from its start
along, across   share of the energy that this place gets in each direction
"""

import math
from collections.abc import Iterator
from random import Random

from workbench.algorithms.entry import Entry, Law, Parameter, View


def beam_spot(
    x0: float, y0: float, x1: float, y1: float, energy: float, sigma: float
) -> Iterator[tuple[int, int, float]]:
    """Emit what a stroke at constant speed leaves in each pixel near it; the sum is the energy sent.

    Args: ends of the stroke in pixels, the energy (beam power times time), the spot's standard deviation.
    Emits: (x, y, energy of the pixel). Source: integral of a moving Gaussian in closed form.
    """
    # Measure the stroke
    sigma = max(float(sigma), 0.1)
    length = math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0))
    cosine = 1.0
    sine = 0.0
    if length > 0.0001 * sigma:
        cosine = (x1 - x0) / length
        sine = (y1 - y0) / length
    reach = 4.0 * sigma + 1.0
    left = math.ceil(min(x0, x1) - reach)
    right = math.floor(max(x0, x1) + reach)
    low = math.ceil(min(y0, y1) - reach)
    high = math.floor(max(y0, y1) + reach)

    for y in range(low, high + 1):
        for x in range(left, right + 1):
            # Find the pixel along and across the stroke
            u = (x - x0) * cosine + (y - y0) * sine
            v = (y - y0) * cosine - (x - x0) * sine

            # Deposit what passes over it
            across = math.exp(-v * v / (2.0 * sigma * sigma)) / (math.sqrt(2.0 * math.pi) * sigma)
            if length > 0.0001 * sigma:
                begun = math.erf(u / (math.sqrt(2.0) * sigma))
                ended = math.erf((u - length) / (math.sqrt(2.0) * sigma))
                along = (begun - ended) / (2.0 * length)
            else:
                along = math.exp(-u * u / (2.0 * sigma * sigma)) / (math.sqrt(2.0 * math.pi) * sigma)
            yield x, y, energy * along * across


def _stroke(chance: Random) -> tuple[float, ...]:
    """A short stroke of a small spot; one in three has no length or next to none."""
    x0, y0 = chance.randint(-9, 9) / 2, chance.uniform(-4.0, 4.0)
    x1, y1 = x0 + chance.uniform(-4.0, 4.0), y0 + chance.randint(-9, 9) / 2
    if chance.randint(0, 2) == 0:
        x1, y1 = x0 + chance.choice((0.0, 1e-9, 1e-3)), y0
    return x0, y0, x1, y1, chance.choice((0.0, 1.0, chance.uniform(0.0, 60.0))), chance.uniform(0.6, 1.5)


ENTRY = Entry(
    function=beam_spot,
    topic="scanning",
    title="Beam spot",
    summary="A slow stroke is bright, a fast one dim and a resting beam a hot dot: the energy decides.",
    parameters=(
        Parameter("x0", "x_0", "float", 6.0, -1024, 1024, "px", "start of the stroke, column"),
        Parameter("y0", "y_0", "float", 5.0, -1024, 1024, "px", "start of the stroke, row"),
        Parameter("x1", "x_1", "float", 14.0, -1024, 1024, "px", "end of the stroke, column"),
        Parameter("y1", "y_1", "float", 9.0, -1024, 1024, "px", "end of the stroke, row"),
        Parameter("energy", "Q", "float", 1.0, 0.0, 1e9, "", "energy sent: power times time"),
        Parameter("sigma", "σ", "float", 1.0, 0.6, 8.0, "px", "standard deviation of the spot"),
    ),
    arguments=_stroke,
    emits="coverage",
    source="A Gaussian spot moved at constant speed, integrated over time",
    columns=("(x, y)", "u", "v", "along", "across", "energy"),
    views=(
        View(
            block="Find the pixel along and across the stroke",
            sentence="Pixel {(x, y)} lies {u} along the stroke and {v} across it.",
        ),
        View(
            block="Deposit what passes over it",
            candidates="((x, y),)",
            chosen="((x, y),)",
            row="((x, y), u, v, along, across, energy * along * across)",
            sentence="It gets {along} of the energy per pixel along and {across} across: "
            "{energy * along * across}.",
        ),
    ),
    laws=(
        Law(
            "The pixels together get the energy sent, but for 4 exp(−2π²σ²) + 1.3 · 10⁻⁴ of it.",
            "scanning/test_beam_spot.py::test_the_pixels_together_get_the_energy_sent",
        ),
        Law(
            "A stroke drawn in two parts leaves the same, to 10⁻⁴ of the energy in each pixel.",
            "scanning/test_beam_spot.py::test_a_stroke_in_two_parts_leaves_the_same",
        ),
        Law(
            "A stroke drawn backwards leaves the same, to 10⁻¹², or where it has next to no length to 10⁻⁵.",
            "scanning/test_beam_spot.py::test_a_stroke_backwards_leaves_the_same",
        ),
        Law(
            "A stroke without length is a round spot.",
            "scanning/test_beam_spot.py::test_a_stroke_without_length_is_a_round_spot",
        ),
    ),
    questions=(6,),
    labs=("Beam, spot and focus",),
    next_rung="beam_strokes",
)
