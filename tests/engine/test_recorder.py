"""A recording gives back every state of a run exactly as copying all variables at every line does."""

import gc
import sys
import threading
import weakref
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.engine import snapshots
from workbench.algorithms.lines.bresenham import bresenham_line
from workbench.engine.containers import LeftOut
from workbench.engine.recorder import Recorder, record
from workbench.engine.recording import Recording

coordinates = st.integers(-12, 12)


def equal(a: Any, b: Any) -> bool:
    """Equality, of the types too, through lists, tuples and arrays."""
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray):
        return a.shape == b.shape and a.dtype == b.dtype and np.array_equal(a, b)
    if isinstance(a, list | tuple):
        return len(a) == len(b) and all(map(equal, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(equal(a[key], b[key]) for key in a)
    return bool(a == b)


def check(function: Callable[..., Any], make: Callable[[], tuple[Any, ...]], *callees: Any) -> Recording:
    """Every event of the recording against the naive tracer's, in an order that jumps about."""
    seen, emitted = snapshots.watch(function, *make(), callees=callees)
    recording = record(function, *make())
    assert recording.complete
    assert recording.error is None
    assert list(recording.emitted) == emitted
    assert len(recording) == len(seen)
    assert recording.lines.tolist() == [each.line for each in seen]
    assert recording.depths.tolist() == [each.depth for each in seen]
    order = np.random.default_rng(len(seen)).permutation(len(seen))
    for k in order.tolist():
        moment, expected = recording[k], seen[k]
        assert (moment.line, moment.function, moment.depth) == (
            expected.line,
            expected.function,
            expected.depth,
        )
        assert equal(moment.variables, expected.variables), f"event {k}, line {expected.line}"
        assert len(moment.emitted) == recording.emitted_count(k) == expected.emitted
    return recording


@given(coordinates, coordinates, coordinates, coordinates)
@settings(max_examples=25, deadline=None)
def test_a_plain_text(x0: int, y0: int, x1: int, y1: int) -> None:
    check(bresenham_line, lambda: (x0, y0, x1, y1))


@given(st.integers(1, 5), st.integers(1, 5), st.integers(0, 2**25 - 1))
@settings(max_examples=15, deadline=None)
def test_recursion_helpers_and_an_array_written_in_place(width: int, height: int, walls: int) -> None:
    def make() -> tuple[Any, ...]:
        bits = [(walls >> k) & 1 for k in range(width * height)]
        return np.array(bits, np.int64).reshape(height, width), width // 2, height // 2, 7

    check(snapshots.recursive_fill, make, snapshots.inside)
    check(snapshots.stack_fill, make, snapshots.inside)


@given(st.integers(0, 40))
@settings(max_examples=15, deadline=None)
def test_nested_generators_do_not_show_their_siblings_values(high: int) -> None:
    check(snapshots.halves, lambda: (0, high))


@given(st.lists(st.integers(-50, 400), max_size=12))
@settings(max_examples=25, deadline=None)
def test_lists_in_lists_aliases_and_what_a_helper_changes(values: list[int]) -> None:
    check(snapshots.tables, lambda: (list(values),), snapshots.add_to)


@given(st.lists(st.tuples(st.integers(0, 6), st.integers(2, 11), st.integers(-3, 3)), min_size=1, max_size=8))
@settings(max_examples=25, deadline=None)
def test_a_list_of_named_tuples_changed_in_place(rows: list[tuple[int, int, int]]) -> None:
    check(snapshots.active_edges, lambda: (list(rows),))


@given(
    st.lists(st.floats(-1e6, 1e6), min_size=3, max_size=9), st.lists(st.floats(-3, 3), min_size=1, max_size=3)
)
@settings(max_examples=25, deadline=None)
def test_arrays_views_patterns_and_comprehensions(numbers: list[float], weights: list[float]) -> None:
    check(snapshots.arithmetic, lambda: (np.array(numbers), np.array(weights)))


def test_a_long_list_and_a_much_changed_array_keep_their_history_through_keyframes() -> None:
    def make() -> tuple[Any, ...]:
        return np.zeros((16, 16), np.uint8), 8, 8, 3

    recording = check(snapshots.stack_fill, make, snapshots.inside)
    top = [k for k in range(100, len(recording), 97) if recording.depths[k] == 0]
    assert max(len(recording[k].variables["stack"]) for k in top) > 150
    assert len(recording.emitted) == 256


def test_a_large_array_is_left_out_and_what_was_emitted_still_tells() -> None:
    recording = record(snapshots.stack_fill, np.zeros((80, 80), np.int64), 0, 0, 1, limit=2000)
    assert recording[-1].variables["image"] == LeftOut((80, 80), "int64")
    assert recording.truncated
    assert len(recording) == 2000


def counting(n: int) -> Iterator[tuple[int]]:
    for i in range(n):
        below = i - 1
        yield (below,)


def test_what_changed_and_what_comes_after_a_line() -> None:
    recording = record(counting, 3)
    binding = recording.lines.tolist().index(recording[1].line, 2)
    assert recording.changed(binding) == {"i"}
    assert recording[binding].variables == {"n": 3, "i": 1, "below": -1}
    assert recording.after(binding) == {"n": 3, "i": 1, "below": 0}
    assert recording.next_in_frame(binding) == binding + 1
    assert recording.next_in_frame(len(recording) - 1) is None
    assert recording.after(len(recording) - 1) == {"n": 3, "i": 2, "below": 1}


def test_after_the_last_line_of_a_nested_call_stands_its_final_state() -> None:
    recording = record(snapshots.halves, 0, 4)
    for k in range(len(recording)):
        following = recording.next_in_frame(k)
        later = [j for j in range(k + 1, len(recording)) if recording.frames[j] == recording.frames[k]]
        assert following == (later[0] if later else None)
        if following is not None:
            assert recording.after(k) == recording[following].variables
    leaves = [k for k in range(len(recording)) if "found" in recording.after(k)]
    assert all(recording.after(k)["found"] == recording.after(k)["low"] for k in leaves)


def test_the_stack_of_calls() -> None:
    recording = record(snapshots.halves, 0, 4)
    deepest = int(np.argmax(recording.depths))
    stack = recording.stack(deepest)
    assert [variables["high"] for _, _, variables in stack] == [1, 2, 4]
    assert {name for _, name, _ in stack} == {"halves"}


def failing(n: int) -> Iterator[tuple[float]]:
    for k in range(n, -1, -1):
        share = 1 / k
        yield (share,)


def test_a_text_that_raises_ends_the_recording_with_its_place() -> None:
    recording = record(failing, 3)
    assert [round(1 / share) for (share,) in recording.emitted] == [3, 2, 1]
    assert recording.error is not None
    assert isinstance(recording.error.exception, ZeroDivisionError)
    assert recording.error.line == recording[-1].line
    assert recording[-1].variables["k"] == 0
    assert not recording.complete
    assert not recording.truncated


def overrunning(values: list[int], image: np.ndarray) -> Iterator[tuple[int]]:
    for k in range(9):
        image[0, -1 - k] = k
        values[k - 2] = 10 * k
        values[k] += 1
        yield (k,)


def test_a_store_outside_of_its_list_or_array_is_reported_as_any_error() -> None:
    short = record(overrunning, [0, 0, 0], np.zeros((2, 9), np.int8))
    assert short.error is not None
    assert isinstance(short.error.exception, IndexError)
    assert short[-1].variables["values"] == [20, 30, 11]
    narrow = record(overrunning, [0] * 20, np.zeros((2, 2), np.int8))
    assert narrow.error is not None
    assert narrow.error.line == narrow[-1].line
    assert narrow[-1].variables["image"].tolist() == [[1, 0], [0, 0]]


def endless() -> Iterator[tuple[int]]:
    count = 0
    while True:
        count += 1
        yield (count,)


@pytest.mark.parametrize("limit", [0, 1, 7, 5000])
def test_an_endless_text_ends_at_the_limit(limit: int) -> None:
    recording = record(endless, limit=limit)
    assert len(recording) == limit
    assert recording.truncated
    assert recording.error is None


def deeper(level: int) -> Iterator[tuple[int]]:
    yield (level,)
    yield from deeper(level + 1)


@pytest.mark.parametrize("limit", [0, 1, 50, 300])
def test_recursion_overflows_at_the_chosen_depth(limit: int) -> None:
    recording = record(deeper, 0, depth_limit=limit)
    assert recording.error is not None
    assert recording.error.overflow
    assert recording.error.depth == limit
    assert len(recording.emitted) == limit + 1
    assert max(recording.depths.tolist()) == limit


def test_recursion_overflows_at_the_interpreters_own_depth() -> None:
    recording = record(deeper, 0)
    assert recording.error is not None
    assert recording.error.overflow
    assert recording.error.depth > 100
    assert recording[len(recording) - 1].variables["level"] == recording[len(recording) - 1].depth


@pytest.mark.parametrize(
    ("function", "arguments", "options"),
    [
        (counting, (3,), {}),
        (failing, (3,), {}),
        (endless, (), {"limit": 10}),
        (deeper, (0,), {"depth_limit": 5}),
        (deeper, (0,), {}),
        (counting, (), {}),
    ],
)
def test_the_trace_function_that_was_there_is_put_back(
    function: Callable[..., Any], arguments: tuple[Any, ...], options: dict[str, Any]
) -> None:
    def mine(frame: Any, event: str, arg: Any) -> None:
        return None

    before = sys.gettrace()
    sys.settrace(mine)
    try:
        record(function, *arguments, **options)
        found = sys.gettrace()
    finally:
        sys.settrace(before)
    assert found is mine


def test_wrong_arguments_are_reported_not_raised() -> None:
    recording = record(counting)
    assert recording.error is not None
    assert isinstance(recording.error.exception, TypeError)
    assert len(recording) == 0


def test_what_is_no_python_function_is_refused() -> None:
    with pytest.raises(TypeError, match="not a Python function"):
        record(abs, 3)


def test_a_plain_function_gives_its_result() -> None:
    recording = record(snapshots.inside, np.zeros((3, 3)), 1, 5)
    assert recording.complete
    assert recording.result is False
    assert recording[1].variables["height"] == 3


def test_emissions_of_changing_types() -> None:
    def emit() -> Iterator[tuple[Any, ...]]:
        yield 1, 2.0
        yield 2**80, True
        yield 0.5, 3

    recording = record(emit)
    assert equal(list(recording.emitted), [(1, 2.0), (2**80, True), (0.5, 3)])
    assert recording.emitted[1:] == [(2**80, True), (0.5, 3)]
    assert record(counting, 4).emitted.array(1, 3).tolist() == [[0], [1]]


def test_on_a_thread_it_records_the_same_and_can_be_held_and_stopped() -> None:
    recorder = Recorder(bresenham_line, 0, 0, 4000, 1234)
    recorder.start()
    assert recorder.join(60)
    straight = record(bresenham_line, 0, 0, 4000, 1234)
    assert recorder.done
    assert recorder.recording.complete
    assert np.array_equal(recorder.recording.lines, straight.lines)
    assert recorder.recording.emitted == straight.emitted

    endless_one = Recorder(endless, limit=10**9)
    endless_one.hold()
    endless_one.start()
    assert not endless_one.join(0.05)
    held_at = len(endless_one.recording)
    assert held_at <= 512
    assert not endless_one.join(0.05)
    assert len(endless_one.recording) == held_at
    endless_one.go_on()
    while len(endless_one.recording) <= held_at + 2000:
        assert not endless_one.done
        k = len(endless_one.recording) - 1
        assert endless_one.recording[k].variables["count"] >= k // 3
    endless_one.stop()
    assert endless_one.join(60)
    assert not endless_one.recording.truncated
    assert not endless_one.recording.complete


def test_reading_while_it_grows_gives_whole_states() -> None:
    recorder = Recorder(snapshots.stack_fill, np.zeros((40, 40), np.int64), 20, 20, 1)
    recorder.start()
    read = []
    while not recorder.done:
        k = len(recorder.recording) - 1
        if k >= 0:
            read.append((k, recorder.recording[k]))
        recorder.join(0.005)
    straight = record(snapshots.stack_fill, np.zeros((40, 40), np.int64), 20, 20, 1)
    for k, moment in read:
        assert equal(moment.variables, straight[k].variables)
        assert moment.line == straight[k].line


def test_the_recording_threads_settings_do_not_stay() -> None:
    before = sys.getswitchinterval()
    recorder = Recorder(counting, 2000)
    recorder.start()
    assert recorder.join(60)
    assert sys.getswitchinterval() == before
    assert not any(thread.name.startswith("record") for thread in threading.enumerate())


def failing_in_depth(n: int) -> int:
    if n == 0:
        raise ValueError("no further")
    return failing_in_depth(n - 1)


@pytest.mark.parametrize(
    ("function", "arguments", "limit"),
    [(bresenham_line, (0, 0, 20, 12), 10**6), (endless, (), 1000), (failing_in_depth, (9,), 10**6)],
    ids=["complete", "truncated", "failed"],
)
@pytest.mark.parametrize("beside", [False, True], ids=["here", "on a thread"])
def test_what_nobody_looks_at_any_more_is_gone_at_once(
    function: Callable[..., Any], arguments: tuple[Any, ...], limit: int, beside: bool
) -> None:
    gc.disable()
    try:
        if beside:
            recorder = Recorder(function, *arguments, limit=limit)
            recorder.start()
            assert recorder.join(60)
            recording = recorder.recording
            del recorder
        else:
            recording = record(function, *arguments, limit=limit)
        assert len(recording) > 10
        gone = weakref.ref(recording)
        del recording
        assert gone() is None
    finally:
        gc.enable()
