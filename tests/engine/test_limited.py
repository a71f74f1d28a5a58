"""Recursion with a limit: what is drawn is what is recorded; what waits is what the text itself holds."""

import sys
import threading
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.engine import written_texts as texts
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.algorithms.seed_fill.example import BOUNDED
from workbench.engine.limited import Limited, collect_limited
from workbench.engine.observation import Steps
from workbench.engine.pending import Depths, PixelTests, largest, stack_at
from workbench.engine.recorder import Recorder, record

RECURSIVE = catalogue.get("boundary_fill_recursive").function
STACKED = ("boundary_fill_4", "boundary_fill_8", "flood_fill_4", "flood_fill_8")


@st.composite
def pictures(draw: st.DrawFn) -> np.ndarray:
    height, width = draw(st.integers(1, 7)), draw(st.integers(1, 7))
    cells = draw(st.lists(st.sampled_from([0, 0, 0, 1]), min_size=height * width, max_size=height * width))
    return np.array(cells, np.int64).reshape(height, width)


@settings(max_examples=60, deadline=None)
@given(pictures(), st.integers(0, 6), st.integers(0, 6), st.integers(1, 40))
def test_what_is_drawn_is_what_is_recorded(picture: np.ndarray, x: int, y: int, limit: int) -> None:
    recorded_on, drawn_on = picture.copy(), picture.copy()
    recording = record(RECURSIVE, recorded_on, x, y, 2, 1, depth_limit=limit)
    drawn = collect_limited(RECURSIVE, limit, drawn_on, x, y, 2, 1)
    assert drawn.rows == list(recording.emitted)
    assert drawn.overflowed == (recording.error is not None)
    assert (recorded_on == drawn_on).all()
    if recording.error is not None:
        assert recording.error.overflow
        assert recording.error.depth == drawn.deepest == limit


@pytest.mark.parametrize("side", [60, 500])
def test_large_regions_overflow_and_hurt_nothing(side: int) -> None:
    before = sys.getrecursionlimit()
    picture = np.zeros((side, side), np.int64)
    found = collect_limited(RECURSIVE, 1000, picture, side // 2, side // 2, 2, 1)
    assert found.overflowed
    assert found.deepest == 1000
    assert (picture == 2).sum() == len(found.rows) == 1001
    assert sys.getrecursionlimit() == before


def test_a_deep_limit_fills_sixty_by_sixty() -> None:
    picture = np.zeros((60, 60), np.int64)
    found = collect_limited(RECURSIVE, 4000, picture, 30, 30, 2, 1)
    assert not found.overflowed
    assert (picture == 2).all()


def test_no_depth_takes_room_on_the_stack_of_the_thread() -> None:
    """A small stack would end the process."""
    results: list[Limited] = []

    def fill() -> None:
        results.append(collect_limited(RECURSIVE, 20_000, np.zeros((300, 300), np.int64), 150, 150, 2, 1))

    before = threading.stack_size(128 * 1024)
    try:
        thread = threading.Thread(target=fill)
        thread.start()
    finally:
        threading.stack_size(before)
    thread.join()
    assert (results[0].deepest, results[0].overflowed) == (20_000, True)


def test_calls_keep_their_names_and_what_they_leave_out() -> None:
    for function in (texts.box, texts.taking_decorators):
        arguments = range(1, 3 if function is texts.box else 5)
        drawn = collect_limited(function, 10, *arguments)
        assert drawn.rows == list(function(*arguments))
        assert not drawn.overflowed


def test_it_begins_no_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_thread: threading.Thread) -> None:
        raise AssertionError

    monkeypatch.setattr(threading.Thread, "start", refuse)
    assert len(collect_limited(RECURSIVE, 100, np.zeros((5, 5), np.int64), 2, 2, 2, 1).rows) == 25


def test_a_recorder_nests_deeper_than_python_would() -> None:
    before = sys.getrecursionlimit()
    recorder = Recorder(RECURSIVE, np.zeros((40, 40), np.int64), 20, 20, 2, 1, depth_limit=1200)
    recorder.start()
    assert recorder.join(60)
    failure = recorder.error
    if failure is None:
        assert recorder.recording.complete
    else:
        assert failure.overflow
        assert failure.depth == 1200
    assert sys.getrecursionlimit() == before


@settings(max_examples=25, deadline=None)
@given(pictures(), st.sampled_from(STACKED))
def test_the_stack_that_is_read_is_the_one_in_the_table(picture: np.ndarray, slug: str) -> None:
    entry = catalogue.get(slug)
    arguments = [picture, picture.shape[1] // 2, picture.shape[0] // 2, 2, 1][: len(entry.parameters)]
    recording = record(entry.function, *arguments)
    steps = Steps(entry, recording)
    depths = Depths(steps)
    while depths.advance(7):
        pass
    for number in range(1, len(steps) + 1):
        step = steps[number]
        waiting = list(stack_at(entry, recording, step.last))
        assert len(waiting) == depths.values[number]
        table = step.tables.get("Stack")
        if table is not None and step.last < len(recording) - 1:
            assert [tuple(row) for row in table[1]] == waiting
    sizes = [len(stack_at(entry, recording, event)) for event in range(len(recording))]
    assert largest(entry, recording) == max(sizes)


@settings(max_examples=25, deadline=None)
@given(pictures())
def test_tests_are_counted_where_they_were_made(picture: np.ndarray) -> None:
    before = picture.copy()
    height, width = picture.shape
    entry = catalogue.get("boundary_fill_4")
    recording = record(entry.function, picture, width // 2, height // 2, 2, 1)
    steps = Steps(entry, recording)
    tested = PixelTests(steps)
    while tested.advance(5):
        pass
    filled = (picture == 2) & (before != 2)
    expected = np.zeros_like(picture)
    padded = np.pad(filled, 1)
    for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        expected += padded[1 + dy : 1 + dy + height, 1 + dx : 1 + dx + width]
    expected[height // 2, width // 2] += 1
    assert (tested.counts(len(steps), (width, height)) == expected).all()


def reach(row, x):
    """The first pixel from x on that is not free.

    A text of its own, with a line before its loop.
    """
    at = x
    x = at
    while x < len(row) and row[x] == 0:
        x += 1
    return x


def fill_rows(image, x, y):
    """Fill from a column on, row by row."""
    while y < len(image):
        # Fill the row
        end = reach(image[y], x)
        image[y, x:end] = 1
        yield y, x, end - 1
        y += 1


def test_tests_are_counted_in_the_functions_that_an_entry_names() -> None:
    entry = Entry(fill_rows, "seed_fill", "Rows", "", BOUNDED, "spans", "", tests_in=(reach,))
    steps = Steps(entry, record(fill_rows, np.array([[0, 0, 0, 9], [0, 0, 9, 0]]), 0, 0))
    tested = PixelTests(steps)
    while tested.advance(3):
        pass
    assert tested.counts(len(steps), (4, 2)).tolist() == [[1, 1, 1, 1], [1, 1, 1, 0]]


def test_calls_under_way_are_the_path_to_the_pixel() -> None:
    recording = record(RECURSIVE, np.zeros((3, 5), np.int64), 0, 1, 2, 1, depth_limit=50)
    deepest = int(np.argmax(np.where(recording.codes == 0, recording.depths, 0)))
    entry = catalogue.get("boundary_fill_recursive")
    calls = stack_at(entry, recording, deepest)
    path = [(call["x"], call["y"]) for call in calls]
    assert calls[-1]["image"].shape == (3, 5)
    assert (calls[0]["x"], calls[0]["y"]) == (0, 1)
    assert len(calls) == largest(entry, recording)
    assert len(path) == recording.depths[recording.codes == 0].max() + 1
    assert path[0] == (0, 1)
    assert all(abs(a[0] - b[0]) + abs(a[1] - b[1]) == 1 for a, b in pairwise(path))


def test_a_fill_by_spans_tests_where_its_runs_look() -> None:
    picture = np.zeros((3, 5), np.int64)
    entry = catalogue.get("boundary_fill_spans")
    recording = record(entry.function, picture, 2, 0, 2, 1)
    steps = Steps(entry, recording)
    tests = PixelTests(steps)
    while tests.advance(3):
        pass
    counts = tests.counts(len(steps), (5, 3))
    # The seed's row is walked from the seed both ways, so that the seed is tested twice.
    assert counts[0].tolist() == [1, 1, 2, 1, 1]
    # Each further row is entered at its left end, by the look back and then by the run.
    assert counts[1].tolist() == [2, 1, 1, 1, 1]
    assert counts[2].tolist() == [2, 1, 1, 1, 1]
