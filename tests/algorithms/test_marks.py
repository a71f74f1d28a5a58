"""What is drawn of every entry, at every line of generated runs: well formed, and the story of its table."""

import copy
import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue, marks
from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP
from workbench.algorithms.clipping.window_marks import edge_mark
from workbench.algorithms.entry import CALLS, Entry
from workbench.algorithms.marks import INKS, Mark, Matrix, Ray, Region, Spot, Stroke, Word, no_marks
from workbench.algorithms.numerals import numeral
from workbench.engine.calls import own_call
from workbench.engine.observation import Step, Steps
from workbench.engine.recorder import record

ENTRIES = catalogue.entries()
DRAWING = [entry for entry in ENTRIES if entry.marks is not no_marks]
drawing = pytest.mark.parametrize("entry", DRAWING, ids=lambda entry: entry.slug)
MOST_LINES = 40


def run_of(entry: Entry, given_to_it: tuple[Any, ...]) -> Steps:
    recording = record(entry.function, *copy.deepcopy(given_to_it))
    assert recording.complete
    return Steps(entry, recording)


def at_event(entry: Entry, steps: Steps, run: tuple[Any, ...], event: int, ended: bool = False) -> list[Mark]:
    """What is drawn before an event, or after the last one."""
    recording = steps.recording
    count = len(recording.emitted) if ended else recording.emitted_count(event)
    call = own_call(recording, event, event, count, ended)
    assert (call.number, call.ended) == (0, ended)
    return list(entry.marks(run, call.variables, call.emitted, call.ended))


def at_step(entry: Entry, steps: Steps, run: tuple[Any, ...], step: Step) -> list[Mark]:
    """What is drawn of a step, that of its block last."""
    last = max(step.last, 0)
    ended = last == len(steps.recording) - 1
    call = own_call(steps.recording, max(step.first, 0), last, step.emitted_to, ended)
    return [*entry.marks(run, call.variables, call.emitted, call.ended), *step.marks]


def frame_of(entry: Entry, run: tuple[Any, ...], rows: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """A box around all that a run is about, as wide again on each side."""
    places: list[tuple[float, float]] = [(0.0, 0.0)]
    values = dict(zip(entry.parameter_names, run, strict=True))
    for parameter in entry.parameters:
        value = values[parameter.name]
        if parameter.kind == "points":
            places += [(float(x), float(y)) for x, y, *_z in value]
        elif parameter.name == "program":
            places += [(x, y) for _operation, x, y, _intensity in value.tolist()]
        elif parameter.name == "point":
            places.append((float(value[0]), float(value[1])))
        elif parameter.name == "corner":  # of a cube, in a cabinet drawing
            x, y, z = value
            places += [(x - max(z, 0), y - max(z, 0)), (x - z + values["size"], y - z + values["size"])]
        elif parameter.kind == "image":
            places.append(value.shape[::-1])
        elif parameter.name.startswith("x") and f"y{parameter.name[1:]}" in values:
            places.append((value, values[f"y{parameter.name[1:]}"]))
    if len(rows) and entry.emits == "spans":
        places += [(x, y) for y, left, right, *_more in rows.tolist() for x in (left, right)]
    elif len(rows) and entry.emits == "points":
        places += [(x, y) for x, y, *_more in rows.tolist()]
    found = np.array(places, float)
    low, high = found.min(axis=0), found.max(axis=0)
    room = 2.0 + 1.5 * (high - low).max()
    return low - room, high + room


def places_of(mark: Mark) -> NDArray[Any]:
    match mark:
        case Stroke() | Region():
            assert mark.points.dtype == np.float64
            assert mark.points.ndim == 2
            assert mark.points.shape[1] == 2
            assert len(mark.points) > 0
            return mark.points
        case Matrix():
            return np.empty((0, 2))
    return np.array([(mark.x, mark.y)], float)


def assert_well_formed(found: Iterable[Mark], low: NDArray[Any], high: NDArray[Any]) -> None:
    for mark in found:
        assert isinstance(mark, Mark)
        if isinstance(mark, Matrix):
            assert_matrix(mark)
            continue
        assert mark.ink in INKS
        places = places_of(mark)
        assert np.isfinite(places).all()
        assert (places >= low).all()
        assert (places <= high).all()
        match mark:
            case Stroke() | Ray():
                assert mark.weight in get_args(marks.Weight)
                assert mark.pattern in get_args(marks.Pattern)
            case Spot():
                assert mark.shape in get_args(marks.Shape)
                assert mark.size in get_args(marks.Size)
            case Word():
                assert mark.text.strip()
                assert {mark.right, mark.up} <= {-1, 0, 1}
        if isinstance(mark, Ray):
            assert math.hypot(mark.dx, mark.dy) > 0
            assert mark.least <= (high - low).max()


def assert_matrix(mark: Matrix) -> None:
    """Rows of one length, and a place and an ink for each cell that is looked at, each once."""
    assert mark.name.strip()
    (columns,) = {len(row) for row in mark.cells}
    assert columns > 0
    for row, column, ink in mark.inked:
        assert 0 <= row < len(mark.cells)
        assert 0 <= column < columns
        assert ink in INKS
    assert len({cell[:2] for cell in mark.inked}) == len(mark.inked)


@drawing
@settings(max_examples=6, deadline=None)
@given(data=st.data())
def test_marks_are_well_formed_at_every_line(entry: Entry, data: st.DataObject) -> None:
    run = data.draw(arguments(entry))
    before = copy.deepcopy(run)
    steps = run_of(entry, run)
    recording = steps.recording
    low, high = frame_of(entry, run, recording.emitted.array())
    stride = max(1, len(recording) // MOST_LINES)
    depths = recording.depths
    inner = np.flatnonzero(depths > 0)[:: max(1, stride)].tolist()
    for event in sorted({*range(0, len(recording), stride), *inner[:MOST_LINES]}):
        assert_well_formed(at_event(entry, steps, run, event), low, high)
    assert_well_formed(at_event(entry, steps, run, len(recording) - 1, ended=True), low, high)
    for step in itertools.islice(steps, MOST_LINES):
        assert_well_formed(at_step(entry, steps, run, step), low, high)
    for given_to_it, now in zip(run, before, strict=True):
        assert np.array_equal(given_to_it, now)


@drawing
@settings(max_examples=6, deadline=None)
@given(data=st.data())
def test_marks_need_no_recording(entry: Entry, data: st.DataObject) -> None:
    """As under a drag: the arguments and all that is emitted; also while only a part of it is there."""
    run = data.draw(arguments(entry))
    steps = run_of(entry, run)
    rows = steps.recording.emitted.array()
    low, high = frame_of(entry, run, rows)
    for ended, count in ((True, len(rows)), (False, len(rows) // 2), (False, 0)):
        found = list(entry.marks(run, {}, rows[:count], ended))
        assert_well_formed(found, low, high)
        again = list(entry.marks(run, {}, rows[:count], ended))
        assert [repr(mark) for mark in found] == [repr(mark) for mark in again]


def test_most_texts_draw_nothing_beside_their_pixels() -> None:
    for entry in (each for each in ENTRIES if each.marks is no_marks):
        assert list(entry.marks(entry.example, {}, np.empty((0, 0)), True)) == []
    assert len(DRAWING) >= 14


def test_a_stack_is_a_list_of_the_text_or_its_calls() -> None:
    for entry in ENTRIES:
        if entry.stack == CALLS:
            assert entry.slug in entry.function.__code__.co_names
        elif entry.stack:
            recording = record(entry.function, *entry.example)
            assert isinstance(recording.after(len(recording) - 1)[entry.stack], list)


def test_what_is_counted_beside_is_a_block_of_the_text() -> None:
    from workbench.engine.blocks import blocks
    from workbench.engine.effects import texts_of

    for entry in ENTRIES:
        titles = {block.title for text in texts_of(entry.function) for block in blocks(text.function)}
        for beginning in itertools.chain(*(each.blocks for each in entry.counted.values())):
            assert any(title.startswith(beginning) for title in titles)


# The marks tell the story of table and sentence


def example_steps(slug: str) -> Iterator[tuple[Step, list[Mark]]]:
    entry = catalogue.get(slug)
    yield from steps_and_marks(entry, entry.example)


def steps_and_marks(entry: Entry, run: tuple[Any, ...]) -> Iterator[tuple[Step, list[Mark]]]:
    steps = run_of(entry, run)
    for step in itertools.islice(steps, 1, MOST_LINES):
        yield step, at_step(entry, steps, run, step)


def strokes(found: list[Mark], ink: str, weight: str) -> list[Any]:
    return [m.points.tolist() for m in found if isinstance(m, Stroke) and (m.ink, m.weight) == (ink, weight)]


def spots(found: list[Mark], ink: str, shape: str) -> list[tuple[float, float]]:
    return [(m.x, m.y) for m in found if isinstance(m, Spot) and (m.ink, m.shape) == (ink, shape)]


@pytest.mark.parametrize("slug", ["boundary_fill_4", "boundary_fill_8", "flood_fill_4", "flood_fill_8"])
@settings(max_examples=8, deadline=None)
@given(data=st.data())
def test_the_stack_that_is_drawn_is_the_table(slug: str, data: st.DataObject) -> None:
    entry = catalogue.get(slug)
    for step, found in steps_and_marks(entry, data.draw(arguments(entry))):
        table = step.tables["Stack"][1]
        # A pixel is taken from the stack in the step before the first of its neighbours is looked at.
        taken = len(table) - len(spots(found, "text", "dot"))
        assert 0 <= taken <= 1
        assert spots(found, "text", "dot") == [tuple(row) for row in table[: len(table) - taken]]
        assert spots(found, "text", "ring") == [tuple(row) for row in table[: len(table) - taken][-1:]]


@settings(max_examples=8, deadline=None)
@given(data=st.data())
def test_the_spans_that_are_drawn_are_the_table(data: st.DataObject) -> None:
    entry = catalogue.get("boundary_fill_spans")
    for step, found in steps_and_marks(entry, data.draw(arguments(entry))):
        drawn = strokes(found, "data5", "medium")
        table = [[[left, y], [right, y]] for y, left, right, _step in step.tables["Stack"][1]]
        assert drawn == table[: len(drawn)] or drawn[: len(table) - 1] == table[:-1]


@settings(max_examples=8, deadline=None)
@given(data=st.data())
def test_the_calls_that_are_drawn_lead_to_the_pixel_of_the_row(data: st.DataObject) -> None:
    entry = catalogue.get("boundary_fill_recursive")
    told = list(steps_and_marks(entry, data.draw(arguments(entry))))
    for (step, found), following in itertools.zip_longest(told, told[1:]):
        (ring,) = spots(found, "text", "ring")
        (path,) = strokes(found, "text", "pixel") or [[[*ring]]]
        assert (np.abs(np.diff(np.array(path), axis=0)).sum(axis=1) == 1).all()
        assert tuple(path[-1]) == ring
        if step.row[2] == 1:
            assert ring == step.row[0]
        if following is not None:
            # What is ringed is the call that goes on, to one of its neighbours.
            assert np.abs(np.subtract(ring, following[0].row[0])).sum() == 1


@settings(max_examples=30, deadline=None)
@given(data=st.data())
def test_cohen_and_sutherlands_marks_are_their_row(data: st.DataObject) -> None:
    entry = catalogue.get("cohen_sutherland")
    run = data.draw(arguments(entry))
    edges = {"top": TOP, "bottom": BOTTOM, "right": RIGHT, "left": LEFT}
    for step, found in steps_and_marks(entry, run):
        _k, _codes, _either, _both, decision, _end, intersection = step.row
        heavy = strokes(found, "accent", "heavy")
        if decision.startswith("clip"):
            assert heavy == [edge_mark(run[4:], edges[decision[5:]]).points.tolist()]
            unmoved = intersection in (run[:2], run[2:4])
            assert intersection in spots(found, "text" if unmoved else "data2", "dot" if unmoved else "ring")
            assert len(strokes(found, "data1", "medium")) == 1
        else:
            assert heavy == []
            assert len(strokes(found, "data4", "medium")) == (decision == "reject")
            assert len(strokes(found, "data1", "medium")) == (decision == "accept")


@settings(max_examples=30, deadline=None)
@given(data=st.data())
def test_liang_and_barskys_marks_are_their_row(data: st.DataObject) -> None:
    entry = catalogue.get("liang_barsky")
    run = data.draw(arguments(entry))
    start, way = np.array(run[:2]), np.subtract(run[2:4], run[:2])
    all_steps = list(steps_and_marks(entry, run))
    for step, found in all_steps:
        k, _p, _q, _r, u1, u2 = step.row
        interval = strokes(found, "data1", "bold")
        assert len(interval) == (u1 <= u2)
        for ends in interval:
            np.testing.assert_allclose(ends, [start + u1 * way, start + u2 * way], atol=1e-9)
        edge = [edge_mark(run[4:], (LEFT, RIGHT, BOTTOM, TOP)[k - 1]).points.tolist()]
        assert strokes(found, "accent", "heavy") == ([] if step is all_steps[-1][0] else edge)


@settings(max_examples=20, deadline=None)
@given(data=st.data())
def test_sutherland_and_hodgmans_marks_are_their_row(data: st.DataObject) -> None:
    entry = catalogue.get("sutherland_hodgman")
    run = data.draw(arguments(entry))
    edges = {"top": TOP, "bottom": BOTTOM, "right": RIGHT, "left": LEFT}
    told = list(steps_and_marks(entry, run))
    for (step, found), (after, _found) in itertools.pairwise(told):
        edge, start, end = step.row[:3]
        if edge == after.row[0]:
            assert strokes(found, "data2", "bold") == [[[*start], [*end]]]
            assert strokes(found, "accent", "heavy") == [edge_mark(run[1:], edges[edge]).points.tolist()]
            handed_on = map(tuple, step.tables["Vertices handed on"][1])
            assert spots(found, "data1", "square") == [*handed_on]


def numbers(text: str) -> list[float]:
    return [float(part.replace("−", "-")) for part in text.split(", ") if part not in ("", "…")]


@pytest.mark.parametrize("slug", ["scan_line_fill", "scan_line_exact"])
@pytest.mark.parametrize("closed", [True, False])
@settings(max_examples=20, deadline=None)
@given(
    corners=st.lists(
        st.tuples(st.integers(-20, 20), st.integers(-12, 12)).map(lambda c: (c[0] / 2, c[1] / 2)),
        min_size=3,
        max_size=6,
    )
)
def test_the_scan_lines_marks_are_its_row(
    slug: str, closed: bool, corners: list[tuple[float, float]]
) -> None:
    run = (np.array(corners, float), np.array([len(corners)]), closed, False)
    for step, found in steps_and_marks(catalogue.get(slug), run):
        y, crossings, spans, _count = step.row
        (ray,) = [mark for mark in found if isinstance(mark, Ray)]
        assert ray.y == y
        assert [x for x, _y in spots(found, "data2", "ring")] == pytest.approx(numbers(crossings), abs=1e-4)
        ends = [(a[0], b[0]) for a, b in strokes(found, "accent", "bold")]
        told = [[int(x) for x in span.replace("−", "-").split(" to ")] for span in spans.split(", ") if span]
        filled = [x for left, right in ends for x in range(int(left), int(right) + 1)]
        assert filled == [x for span in told for x in range(span[0], span[-1] + 1)]


@pytest.mark.parametrize("slug", ["de_casteljau", "de_boor", "de_boor_rational"])
@settings(max_examples=8, deadline=None)
@given(data=st.data())
def test_a_constructions_marks_are_its_row(slug: str, data: st.DataObject) -> None:
    entry = catalogue.get(slug)
    all_steps = list(steps_and_marks(entry, data.draw(arguments(entry))))
    for step, found in all_steps:
        point = step.row[-1]
        leg, *_ends, ring = step.marks
        assert isinstance(leg, Stroke)
        assert isinstance(ring, Spot)
        for mark in found:
            if isinstance(mark, Spot) and mark.size == "large":
                assert mark == ring
        assert (ring.x, ring.y) == pytest.approx(point)
        if slug != "de_boor_rational":
            np.testing.assert_allclose(leg.points, step.row[-3:-1])
        assert ring.ink == ("text" if step is all_steps[-1][0] else "accent")
        made = spots(found, "data2", "dot") + spots(found, "data3", "dot") + spots(found, "data4", "dot")
        assert len(made) <= step.number


def test_in_detail_what_is_drawn_of_a_block_is_that_of_the_sentence() -> None:
    entry = catalogue.get("de_boor")
    steps = run_of(entry, entry.example)
    recording = steps.recording
    assert steps.marks_told(0) == ()
    seen = 0
    for event in range(len(recording)):
        told = "".join(part.text for part in steps.told(event))
        for mark in steps.marks_told(event):
            for x, y in places_of(mark).tolist():
                assert f"({numeral(x)}, {numeral(y)})" in told
            seen += 1
    assert seen > 10


def test_the_crossings_of_the_ray_are_those_of_the_table() -> None:
    for step, found in example_steps("inside_outside"):
        crossings = step.row[-2]
        assert len(spots(found, "data2", "ring")) == crossings
        assert sum("↑" in m.text or "↓" in m.text for m in found if isinstance(m, Word)) == crossings


def test_very_much_is_not_drawn_one_by_one() -> None:
    many = [(k % 100, k // 100) for k in range(50_000)]
    for slug in ("boundary_fill_4", "flood_fill_8"):
        found = list(catalogue.get(slug).marks((), {"stack": many}, np.empty((0, 2)), False))
        assert len(found) <= marks.MOST_SPOTS + 1
    spans = [(k, 0, 9, 1) for k in range(50_000)]
    found = list(catalogue.get("boundary_fill_spans").marks((), {"stack": spans}, np.empty((0, 3)), False))
    assert len(found) <= marks.MOST_SPOTS
    rows = np.column_stack([np.arange(50_000.0), np.zeros(50_000)])
    assert len(list(catalogue.get("flatten_bezier").marks((rows, 1.0), {}, rows, True))) == 1
    circle = np.linspace(0, math.tau, 5_000)
    ring = np.column_stack([np.cos(circle), np.sin(circle)]) * 9
    now = {"polygon": ring.tolist(), "clipped": ring.tolist(), "edge": TOP, "i": 7}
    run = (ring, -8.0, -8.0, 8.0, 8.0)
    assert len(list(catalogue.get("sutherland_hodgman").marks(run, now, np.empty((0, 2)), False))) < 20
