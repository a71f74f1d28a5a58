"""Random scan: the display processor runs through its list, and the beam goes where each instruction says.

program         the display list: operation, x, y and intensity of each instruction
counter         address of the next instruction, counted from 0
operation       MOVE: the beam is off; DRAW: it is on; JUMP: back to the first instruction
x, y            where the beam is
distance        the longer of the two ways, across or up, in units of the deflection
took            time of this instruction, in microseconds
time            since the frame began; the picture is refreshed when the whole list was run through
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.scanning.list_marks import list_marks
from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE, operation_name


def random_scan(
    program: NDArray[Any],
    units: float,
    start: float,
    knee: float,
    pace: float,
    jump_start: float,
    jump_pace: float,
    settle: float,
    dwell: float,
    shortest: float,
) -> Iterator[tuple[float, float, float, float]]:
    """Emit each stroke of one frame while the beam is on.

    Args: instructions (n, 4), the last of which says where the beam rests;
    units of the deflection per unit of the list; what a stroke costs before
    it moves, up to which distance it costs no more, and each unit beyond;
    the same for a dark jump, and how long the beam settles after it; the
    least time on a point; the shortest frame (all times in microseconds).
    Emits: (x0, y0, x1, y1). Source: Hearn and Baker, section 2-1.
    """
    # Begin where the last frame left the beam
    counter = 0
    time = 0.0
    x = 0.0
    y = 0.0
    if len(program) > 0:
        x = float(program[len(program) - 1, 1])
        y = float(program[len(program) - 1, 2])

    while counter < len(program):
        # Fetch the instruction that the counter points at
        address = counter
        operation = int(program[address, 0])
        x0 = x
        y0 = y
        x = float(program[address, 1])
        y = float(program[address, 2])
        distance = max(abs(x - x0), abs(y - y0)) * units
        took = 0.0
        counter += 1

        if operation == MOVE:
            # Move the beam while it is off, and let it settle
            if distance > 0.0:
                took = jump_start + jump_pace * max(distance - knee, 0.0)
                took += settle
            time += took
        elif operation == DRAW:
            # Draw with the beam on
            took = max(start, dwell)
            if distance > 0.0:
                took = start + pace * max(distance - knee, 0.0)
            time += took
            yield x0, y0, x, y
        else:
            # Wait until the frame may end, and go back to the first one
            took = max(shortest - time, 0.0)
            time += took
            counter = len(program)


_PROGRAM = np.array(
    [
        [MOVE, 10, 10, 0],
        [DRAW, 40, 10, 1],
        [DRAW, 25, 34, 1],
        [DRAW, 10, 10, 1],
        [MOVE, 50, 5, 0],
        [DRAW, 50, 35, 0.5],
        [JUMP, 50, 35, 0],
    ],
    np.float64,
)


def _program(chance: Random) -> tuple[Any, ...]:
    """Up to five strokes, each beginning where the last one ended, or elsewhere; some have no length."""
    rows: list[list[float]] = []
    x, y = 0.0, 0.0
    for _stroke in range(chance.randint(0, 5)):
        if not rows or chance.randint(0, 1):
            x, y = float(chance.randint(0, 60)), chance.uniform(0.0, 60.0)
            rows.append([MOVE, x, y, 0.0])
        if chance.randint(0, 4):
            x, y = chance.uniform(0.0, 60.0), float(chance.randint(0, 60))
        rows.append([DRAW, x, y, chance.choice((0.25, 1.0))])
    if chance.randint(0, 4):
        rows.append([JUMP, x, y, 0.0])
    times = [chance.choice((0.0, 0.1, 1.0, chance.uniform(0.0, 60.0))) for _time in range(8)]
    units = chance.choice((1.0, 0.5, 14.4))
    return np.array(rows, np.float64).reshape(-1, 4), units, *times


def _time(name: str, label: str, example: float, meaning: str, unit: str = "µs") -> Parameter:
    return Parameter(name, label, "float", example, 0.0, 1e6, unit, meaning)


ENTRY = Entry(
    function=random_scan,
    topic="scanning",
    title="Random scan",
    summary="The beam goes only where there is something to draw; a long list takes long, and flickers.",
    parameters=(
        Parameter("program", "display list", "matrix", _PROGRAM, meaning="operation, x, y and intensity"),
        Parameter("units", "u", "float", 10.0, 1e-3, 1e6, "units", "deflection per unit of the list"),
        _time("start", "t_0", 0.0, "time of a stroke before it moves"),
        Parameter("knee", "N_0", "float", 0.0, 0.0, 1e6, "units", "up to here a stroke takes only t_0"),
        _time("pace", "c", 0.1, "time per unit, beam on", "µs/unit"),
        _time("jump_start", "t_j", 0.0, "time of a jump before it moves"),
        _time("jump_pace", "c_j", 0.07, "time per unit, beam off", "µs/unit"),
        _time("settle", "t_s", 5.0, "time to settle after a jump"),
        _time("dwell", "t_d", 5.0, "least time on a point"),
        _time("shortest", "T_min", 200.0, "shortest frame: one over the highest refresh rate"),
    ),
    arguments=_program,
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=("PC", "instruction", "to", "I", "N", "t (µs)", "time (µs)"),
    views=(
        View(
            block="Fetch the instruction that the counter points at",
            when="operation == JUMP",
            sentence="The counter points at {address}: JUMP 0.",
        ),
        View(
            block="Fetch the instruction that the counter points at",
            sentence="The counter points at {address}: {operation_name(operation)} ({x}, {y}).",
        ),
        View(
            block="Move the beam while it is off, and let it settle",
            row="(address, 'MOVE', (x, y), program[address, 3], distance, took, time)",
            sentence="The dark beam jumps {distance} units to ({x}, {y}) and settles: {took} µs, "
            "together {time} µs.",
        ),
        View(
            block="Draw with the beam on",
            row="(address, 'DRAW', (x, y), program[address, 3], distance, took, time)",
            sentence="The lit beam draws {distance} units to ({x}, {y}) in {took} µs, together {time} µs.",
        ),
        View(
            block="Wait until the frame may end, and go back to the first one",
            when="took > 0.0",
            row="(address, 'JUMP', 0, 0.0, 0.0, took, time)",
            sentence="The list is done early and waits {took} µs: the frame takes {time} µs. "
            "Then it begins again at 0.",
        ),
        View(
            block="Wait until the frame may end, and go back to the first one",
            row="(address, 'JUMP', 0, 0.0, 0.0, took, time)",
            sentence="The list took {time} µs, all the time there is: it begins again at 0 without a wait.",
        ),
    ),
    view_functions=(operation_name,),
    marks=list_marks,
    laws=(
        Law(
            "Every stroke is emitted once, in the order of the list.",
            "scanning/test_scanning.py::test_the_time_of_a_list_is_that_of_its_jumps_settles_and_strokes",
        ),
        Law(
            "The time of the list is the sum of its jumps, settles and strokes.",
            "scanning/test_scanning.py::test_the_time_of_a_list_is_that_of_its_jumps_settles_and_strokes",
        ),
        Law(
            "A frame takes the time of its list, and never less than the shortest frame.",
            "scanning/test_random_scan.py::test_a_frame_is_the_sum_of_its_stroke_times_on_every_display",
        ),
    ),
    not_laws=("A list of twice as many lines is refreshed half as often: it may have waited until then.",),
    questions=(10,),
    labs=("Random scan and display list",),
    next_rung="nearest_end_first",
)
