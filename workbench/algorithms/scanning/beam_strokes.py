"""Beam strokes: the energy of a whole display list, stroke by stroke, where the spot reaches and no further.

face            energy of each pixel of the face, (h, w); what a stroke leaves is added to it
sigma           standard deviation of the spot, in pixels
BELL, RAMP      density of the spot, and its sum up to a place, at 256 places for each sigma
u, v            place of a pixel along and across the stroke, as places of the tables
ended           how far the stroke goes, in places of the tables
pitch           one pixel, in spot widths
lean            how far the stroke's line moves sideways while it climbs by 1
beside          how far from that line in a row the spot still reaches
left, right     columns of a row that are within reach of the spot
"""

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View

REACH = 3.3
FINE = 256.0
SHORT = 0.35
"""A stroke shorter than this, in spot widths, is a dwell in its middle; that is half a percent off."""

_PLACES = np.arange(int(2 * REACH * FINE) + 2) / FINE - REACH
BELL = np.exp(-0.5 * _PLACES * _PLACES) / math.sqrt(2.0 * math.pi)
RAMP = np.array([0.5 * (1.0 + math.erf(place / math.sqrt(2.0))) for place in _PLACES.tolist()])


LAST = int(2 * REACH * FINE)


def within(place: int) -> int:
    """A place of the tables, or the nearer end where it is beyond."""
    return min(max(place, 0), LAST)


def beam_strokes(face: NDArray[Any], strokes: NDArray[Any], sigma: float) -> Iterator[tuple[int, int, int]]:
    """Add to the face what strokes leave, and emit the pixels of each row.

    Args: the face (h, w); x0, y0, x1, y1 and energy of each stroke (n, 5), in
    pixels; the standard deviation of the spot. Emits: (y, left, right).
    Source: as beam_spot, its curves looked up in tables.
    """
    height, width = face.shape
    stride = FINE / sigma
    pitch = 1.0 / sigma
    for k in range(len(strokes)):
        # Measure the stroke in spot widths
        x0 = float(strokes[k, 0])
        y0 = float(strokes[k, 1])
        dx = (float(strokes[k, 2]) - x0) / sigma
        dy = (float(strokes[k, 3]) - y0) / sigma
        length = math.sqrt(dx * dx + dy * dy)
        cosine = 1.0
        sine = 0.0
        if length > 0.0:
            cosine = dx / length
            sine = dy / length
        ended = length * FINE
        slanted = abs(sine) > 0.001
        lean = 0.0
        beside = 0.0
        if slanted:
            lean = cosine / sine
            beside = REACH / abs(sine)
        energy = float(strokes[k, 4]) / (sigma * sigma)
        if length > SHORT:
            energy /= length
        low = max(math.ceil(y0 + sigma * (min(dy, 0.0) - REACH)), 0)
        high = min(math.floor(y0 + sigma * (max(dy, 0.0) + REACH)), height - 1)

        for y in range(low, high + 1):
            # Find the columns that the spot reaches in this row
            up = (y - y0) * pitch
            near = min(dx, 0.0) - REACH
            far = max(dx, 0.0) + REACH
            if slanted:
                near = max(near, up * lean - beside)
                far = min(far, up * lean + beside)
            left = max(math.ceil(x0 + sigma * near), 0)
            right = min(math.floor(x0 + sigma * far), width - 1)

            # Add what passes over each of them
            across = (left - x0) * pitch
            u = (across * cosine + up * sine + REACH) * FINE + 0.5
            v = (up * cosine - across * sine + REACH) * FINE + 0.5
            for x in range(left, right + 1):
                if length > SHORT:
                    passed = RAMP[within(int(u))] - RAMP[within(int(u - ended))]
                else:
                    passed = BELL[within(int(u - 0.5 * ended))]
                face[y, x] += energy * passed * BELL[within(int(v))]
                u += cosine * stride
                v -= sine * stride
            yield y, left, right


_STROKES = np.array([[3.0, 3.0, 10.0, 6.0, 1.0], [10.0, 6.0, 3.0, 6.0, 1.0]])


def _strokes(chance: Random) -> tuple[Any, ...]:
    """A small face, dark or not, and strokes on it, beside it, of no length and along the axes."""
    height, width = chance.randint(1, 9), chance.randint(1, 12)
    face = np.array([[chance.choice((0.0, 1.0)) for _x in range(width)] for _y in range(height)])
    rows = []
    for _stroke in range(chance.randint(0, 3)):
        x0, y0 = chance.uniform(-6.0, 16.0), float(chance.randint(-4, 12))
        x1, y1 = chance.choice(((x0, y0), (x0, y0 + 3.0), (x0 - 0.1, y0), (chance.uniform(-6.0, 16.0), 2.0)))
        rows.append([x0, y0, x1, y1, chance.choice((0.0, 1.0, 7.5))])
    return face, np.array(rows, np.float64).reshape(-1, 5), chance.uniform(0.6, 1.5)


ENTRY = Entry(
    function=beam_strokes,
    topic="scanning",
    title="Beam strokes",
    summary="What a whole display list leaves on the face is the sum of what each of its strokes leaves.",
    parameters=(
        Parameter("face", "E", "matrix", np.zeros((9, 14)), meaning="energy of each pixel of the face"),
        Parameter("strokes", "strokes", "matrix", _STROKES, meaning="x0, y0, x1, y1 and energy"),
        Parameter("sigma", "σ", "float", 0.8, 0.6, 8.0, "px", "standard deviation of the spot"),
    ),
    arguments=_strokes,
    emits="spans",
    writes="face",
    source="A Gaussian spot moved at constant speed, integrated over time, as a table",
    columns=("k", "y", "left", "right", "up"),
    views=(
        View(
            block="Measure the stroke in spot widths",
            sentence="Stroke {k} is {length} spots long; it reaches rows {low} to {high}.",
        ),
        View(
            block="Find the columns that the spot reaches in this row",
            row="(k, y, left, right, up)",
            sentence="In row {y} the spot reaches columns {left} to {right}.",
        ),
        View(
            block="Add what passes over each of them",
            sentence="Each of them gets what the spot leaves there, looked up along and across the stroke.",
        ),
    ),
    laws=(
        Law(
            "It leaves what the beam spot leaves stroke by stroke, to half a percent of the brightest pixel.",
            "scanning/test_beam_strokes.py::test_a_list_leaves_what_its_strokes_leave",
        ),
        Law(
            "A stroke beside the face leaves nothing, and one across its edge what is on it.",
            "scanning/test_beam_strokes.py::test_what_is_beside_the_face_is_left_out",
        ),
    ),
    questions=(10,),
    labs=("Beam, spot and focus",),
    next_rung="phosphor_decay",
)
