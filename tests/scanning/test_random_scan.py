"""The run of a display list is that of the vector tube, on every display whose speeds are known."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE
from workbench.algorithms.scanning.random_scan import random_scan
from workbench.display import VectorTiming, vector_displays
from workbench.display.refresh_limit import LineTime
from workbench.display.stroke_timeline import WAIT, StrokeTable, timeline
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.rendering.display_program import Strokes, equal_lines, program_of

SIZE = (64, 48)
corners = st.tuples(st.integers(0, 63), st.integers(0, 47))


def strokes_of(ends: list[tuple[tuple[int, int], tuple[int, int]]]) -> Strokes:
    """White strokes between pixels."""
    table = np.array(ends, float).reshape(-1, 2, 2)
    return Strokes(table, np.full(len(table), 0xFFFFFF), np.full(len(table), -1))


def rows_of(rows: np.ndarray, *numbers: float) -> list[tuple]:
    """The hand table of a run."""
    entry = catalogue.get("random_scan")
    return [s.row for s in Steps(entry, record(entry.function, rows, *numbers)) if s.row]


@pytest.mark.parametrize("name", vector_displays())
@given(ends=st.lists(st.tuples(corners, corners), min_size=1, max_size=6), linked=st.booleans())
@settings(max_examples=12, deadline=None)
def test_a_frame_is_the_sum_of_its_stroke_times_on_every_display(name, ends, linked) -> None:
    """The text, the tube's timeline, and the display's own times of strokes and jumps added by hand."""
    if linked:
        ends = [(a, b) for a, b in zip([e[0] for e in ends], [e[0] for e in ends[1:]], strict=False)] or ends
    timing, units = VectorTiming.named(name), 14.4
    strokes = strokes_of(ends)
    shortest = timing.min_frame_ps
    table = rows_of(program_of(strokes).rows, units, *timing.numbers_us, shortest * 1e-6)
    by_hand, at = 0, ends[-1][1]
    for start, end in ends:
        jump = (start[0] - at[0]) * units, (start[1] - at[1]) * units
        by_hand += timing.jump_ps(*jump) + (timing.settle_ps if at != start else 0)
        by_hand += timing.stroke_ps((end[0] - start[0]) * units, (end[1] - start[1]) * units)
        at = end
    frame = timeline(StrokeTable(strokes.ends, np.ones((len(strokes), 1))), timing, units, (0.0, 0.0))
    assert frame.duration_ps[frame.kind != WAIT].sum() == by_hand
    assert table[-2][-1] == pytest.approx(by_hand * 1e-6, rel=1e-9, abs=1e-4)
    assert table[-1][-1] == pytest.approx(max(by_hand, shortest) * 1e-6, rel=1e-9, abs=1e-4)
    assert frame.duration_ps.sum() == max(by_hand, shortest, 1)


@pytest.mark.parametrize("name", vector_displays())
@given(count=st.integers(1, 40), length=st.floats(1.0, 63.0))
@settings(max_examples=12, deadline=None)
def test_test_lines_take_the_time_of_one_of_them_times_their_number(name, count, length) -> None:
    timing, units = VectorTiming.named(name), 14.4
    program = program_of(equal_lines(count, length, SIZE))
    assert program.moves == count
    table = rows_of(program.rows, units, *timing.numbers_us, 0.0)
    one = LineTime.of(timing, length * units)
    assert table[-1][-1] == pytest.approx(count * one.total_ps * 1e-6, rel=1e-6, abs=1e-5 * count)


def test_a_move_is_made_only_where_the_beam_is_not_there_yet() -> None:
    program = program_of(strokes_of([((1, 1), (5, 1)), ((5, 1), (5, 4)), ((0, 0), (9, 9))]))
    assert program.rows[:, 0].tolist() == [MOVE, DRAW, DRAW, MOVE, DRAW, JUMP]
    assert program.rows[-1, 1:3].tolist() == [9, 9]
    assert program.stroke_of.tolist() == [0, 0, 1, 2, 2, -1]
    assert [program.address_of(k) for k in range(3)] == [1, 2, 4]
    assert program.moves == 2


def test_a_list_that_ends_where_it_began_says_so_all_the_same() -> None:
    """The first instruction places the beam, although it takes no time from the second frame on."""
    program = program_of(strokes_of([((1, 1), (5, 1)), ((5, 1), (1, 1))]))
    assert program.rows[:, 0].tolist() == [MOVE, DRAW, DRAW, JUMP]
    assert rows_of(program.rows, 1.0, *VectorTiming.named("teaching").numbers_us, 0.0)[0][5] == 0.0


def test_an_empty_list_is_no_program() -> None:
    assert len(program_of(strokes_of([]))) == 0
    assert list(random_scan(np.empty((0, 4)), 1.0, *([0.0] * 8))) == []


def test_the_2250_takes_what_its_manual_says() -> None:
    """8 us up to 16 units, 100 us for full scale, a frame of at least 25 ms."""
    timing = VectorTiming.named("ibm-2250-3")
    rows = np.array([[MOVE, 0, 0, 0], [DRAW, 16, 3, 1], [DRAW, 1039, 3, 1], [JUMP, 1039, 3, 0]], float)
    table = rows_of(rows, 1.0, *timing.numbers_us, timing.min_frame_ps * 1e-6)
    assert table[1][5] == pytest.approx(8.0)
    assert table[2][5] == pytest.approx(100.0, abs=1e-3)
    assert table[3][-1] == pytest.approx(25_000.0)


def test_the_vectrex_crosses_its_face_in_260_cycles() -> None:
    timing = VectorTiming.named("vectrex")
    assert timing.stroke_ps(timing.grid, 0.0) == pytest.approx(260 * 666_666.7, rel=1e-6)
    assert timing.min_frame_ps == pytest.approx(30_000 * 666_666.7, rel=1e-6)
    assert timing.uncertain
