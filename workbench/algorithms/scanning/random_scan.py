"""Random scan: the beam draws the strokes of a display list one after the other.

ends            first and last point of each stroke, two rows for a stroke
x, y            where the beam is
jump            time of the dark movement to the stroke, in microseconds
duration        time of the lit stroke
time            since the list began; the picture can be refreshed no faster than the whole list is drawn
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View


def random_scan(
    ends: NDArray[Any], pace: float, jump_pace: float, settle: float
) -> Iterator[tuple[float, float, float, float]]:
    """Emit each stroke while the beam is on, jumping in between with the beam off.

    Args: end points (2 n, 2); microseconds per unit with the beam on and off; the time the deflection needs
    to settle after a jump, in microseconds. Emits: (x0, y0, x1, y1).
    Source: Hearn and Baker, Computer Graphics, C Version, section 2-1.
    """
    # Start where the last stroke of the list ended
    strokes = len(ends) // 2
    x = 0.0
    y = 0.0
    if strokes > 0:
        x = float(ends[2 * strokes - 1, 0])
        y = float(ends[2 * strokes - 1, 1])
    time = 0.0

    for k in range(strokes):
        # Jump to the stroke with the beam off
        x0 = float(ends[2 * k, 0])
        y0 = float(ends[2 * k, 1])
        jump = 0.0
        if x0 != x or y0 != y:
            jump = max(abs(x0 - x), abs(y0 - y)) * jump_pace + settle
        time += jump

        # Draw the stroke with the beam on
        x = float(ends[2 * k + 1, 0])
        y = float(ends[2 * k + 1, 1])
        duration = max(abs(x - x0), abs(y - y0)) * pace
        time += duration
        yield x0, y0, x, y


_A, _B, _C = [10.0, 10.0], [40.0, 10.0], [25.0, 34.0]
_TRIANGLE_AND_LINE = np.array([_A, _B, _B, _C, _C, _A, [50.0, 5.0], [50.0, 35.0]])


def _strokes(chance: Random) -> tuple[Any, ...]:
    """Up to five strokes, each beginning where the last one ended, or elsewhere; some have no length."""
    rows: list[list[float]] = []
    for _stroke in range(chance.randint(0, 5)):
        linked = bool(rows) and chance.randint(0, 1)
        start = rows[-1] if linked else [float(chance.randint(0, 60)), chance.uniform(0.0, 60.0)]
        end = (
            start if chance.randint(0, 4) == 0 else [chance.uniform(0.0, 60.0), float(chance.randint(0, 60))]
        )
        rows += [start, end]
    paces = [chance.choice((0.0, 0.1, 1.0, chance.uniform(0.0, 60.0))) for _pace in range(3)]
    return np.array(rows, np.float64).reshape(-1, 2), *paces


ENTRY = Entry(
    function=random_scan,
    topic="scanning",
    title="Random scan",
    summary="The beam goes only where there is something to draw; a long list takes long, and flickers.",
    parameters=(
        Parameter("ends", "ends", "points", _TRIANGLE_AND_LINE, meaning="end points, two for a stroke"),
        Parameter("pace", "c", "float", 0.1, 0.0, 1e6, "us/unit", "time per unit, beam on"),
        Parameter("jump_pace", "c_jump", "float", 0.07, 0.0, 1e6, "us/unit", "time per unit, beam off"),
        Parameter("settle", "t_settle", "float", 5.0, 0.0, 1e6, "us", "time to settle after a jump"),
    ),
    arguments=_strokes,
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=("k", "from", "to", "jump", "stroke", "time"),
    views=(
        View(
            block="Jump to the stroke with the beam off",
            sentence="Stroke {k} begins at ({x0}, {y0}); the dark beam gets there in {jump} us.",
        ),
        View(
            block="Draw the stroke with the beam on",
            row="(k, (x0, y0), (x, y), jump, duration, time)",
            sentence="The beam draws to ({x}, {y}) in {duration} us; so far the list took {time} us.",
        ),
    ),
    laws=(
        Law(
            "Every stroke is emitted once, in the order of the list.",
            "scanning/test_scanning.py::test_the_time_of_a_list_is_that_of_its_jumps_settles_and_strokes",
        ),
        Law(
            "The time of the list is the sum of its jumps, settles and strokes.",
            "scanning/test_scanning.py::test_the_time_of_a_list_is_that_of_its_jumps_settles_and_strokes",
        ),
    ),
    questions=(10,),
    labs=("Random scan and display list",),
    next_rung="beam_spot",
)
