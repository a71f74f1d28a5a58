"""Every number of the Compare dock is the one that its label names, counted of the right algorithm."""

from fractions import Fraction

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document.model import WorldPoint
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.engine.compiled import Stop
from workbench.engine.counts import counts
from workbench.panels.shared.compare import CompareView
from workbench.panels.shared.compare_work import table_rows
from workbench.rendering.subjects.registry import comparing
from workbench.rendering.work import Job, Outcome, Work, outcome_of, side_of, work_of
from workbench.session.session import Session


def job_of(slug, first, second, kind="figure"):
    sheet = example(slug).document.sheets[0]
    figures = sheet.figures if kind == "clipper" else sheet.figures[-1:]
    return Job(sheet, tuple(Subject(kind, (figure.id,)) for figure in figures), first, second)


def rows_of(outcome):
    return {label: (first, second) for label, first, second in table_rows(outcome)}


def emitted_by(slug, *arguments):
    return [tuple(map(int, pixel[:2])) for pixel in catalogue.get(slug).function(*arguments)]


JOBS = [
    job_of("line", "bresenham_line", "dda_line"),
    job_of("clip", "cohen_sutherland", "liang_barsky", "clipper"),
    job_of("triangle", "scan_line_exact", "boundary_fill_spans"),
    job_of("pond", "boundary_fill_4", "flood_fill_8"),
]


@pytest.mark.parametrize("job", JOBS, ids=lambda job: f"{job.first}-{job.second}")
def test_what_a_side_did_is_the_sum_of_its_calls(job):
    for slug in (job.first, job.second):
        side = side_of(job, slug)
        work = work_of(side, Stop())
        each = [counts(call.entry.function, *call.arguments, compiling=False) for call in side.calls]
        assert {call.entry.slug for call in side.calls} == {slug}
        assert work.calls == len(each) > 0
        for name in ("tests", "additions", "multiplications", "divisions", "emitted"):
            assert getattr(work, name) == sum(getattr(one, name) for one in each), name


def test_the_operations_of_two_lines_reckoned_by_hand():
    # (20, 10) to (30, 18): 10 steps, of which 8 go up. Bresenham: three tests and the sign of p at each step;
    # 6 sums and differences before the loop, p and x at each step, y where it goes up; two doublings.
    # DDA: two differences, x and y at each step, and both rounded for each of 11 pixels; two quotients.
    rows = rows_of(outcome_of(job_of("line", "bresenham_line", "dda_line"), Stop()))
    assert rows["Tests"] == (3 + 10, 0)
    assert rows["Additions"] == (6 + 10 + 10 + 8, 2 + 20 + 22)
    assert rows["Multiplications"] == (2, 0)
    assert rows["Divisions"] == (0, 2)
    assert rows["Pixels"] == (11, 11)
    assert "Intersections" not in rows
    assert "Ties" not in rows


def test_each_label_reads_its_own_number():
    job = job_of("triangle", "scan_line_exact", "boundary_fill_spans")
    names = ("tests", "additions", "multiplications", "divisions", "emitted", "writes", "before", "calls")
    sides = [
        Work(
            title,
            **{name: base + number for number, name in enumerate(names)},
            deepest=f"{base}",
            cells=np.zeros((base, 2), np.int64),
        )
        for title, base in (("one", 100), ("two", 200))
    ]
    rows = rows_of(
        Outcome(job, *sides, np.zeros((1, 1), np.uint8), both=7, only_first=5, only_second=6, ties=4)
    )
    labels = (
        "Tests",
        "Additions",
        "Multiplications",
        "Divisions",
        "Spans",
        "Writes",
        "Outline first",
        "Runs",
    )
    expected = {label: (100 + number, 200 + number) for number, label in enumerate(labels)}
    expected |= {"Pixels": (100, 200), "Largest stack": ("100", "200")}
    assert rows == expected | {"This one only": (5, 6), "The same": (7, 7), "Ties": (4, 4)}


@pytest.mark.parametrize(
    ("slug", "clipper", "label"),
    [("clip", "cohen_sutherland", "Lines kept"), ("clip-fork", "sutherland_hodgman", "Points handed on")],
)
def test_intersections_lines_and_points_have_their_labels(slug, clipper, label):
    sheet = example(slug).document.sheets[0]
    subject = Subject("clipper", (sheet.figures[-1].id,))
    job = Job(sheet, comparing(subject).alike(sheet, subject), clipper)
    rows = rows_of(outcome_of(job, Stop()))
    calls = [(call.entry.function, call.arguments) for call in side_of(job, clipper).calls]
    visits = [counts(function, *given, compiling=False).block_visits for function, given in calls]
    cut = sum(times for each in visits for title, times in each.items() if "Find the intersection" in title)
    kept = sum(len(list(function(*given))) for function, given in calls)
    assert cut != kept
    assert (rows["Intersections"][0], rows[label][0]) == (cut, kept)
    assert "Pixels" not in rows


def test_pixels_that_one_alone_paints_are_counted_for_it_and_ties_apart():
    job = job_of("line", "bresenham_line", "dda_line")
    ends = (14, 6, 4, 1)  # dx = -10, dy = -5: halfway at every second step
    first, second = (set(emitted_by(slug, *ends)) for slug in (job.first, job.second))
    assert first != second
    exact = {x: 6 + Fraction(x - 14, 2) for x, _y in first | second}
    assert all(abs(exact[x] - y) == Fraction(1, 2) for x, y in first ^ second)
    (line,) = job.sheet.figures
    line = replace(line, points_world=(WorldPoint("p", 14, 6), WorldPoint("q", 4, 1)))
    sheet = replace(job.sheet, figures=(line,))
    rows = rows_of(outcome_of(Job(sheet, job.subjects, job.first, job.second), Stop()))
    assert rows["Pixels"] == (11, 11)
    assert rows["The same"] == (len(first & second),) * 2
    assert rows["This one only"] == (0, 0)
    assert rows["Ties"] == (len(first - second),) * 2 == (5, 5)


def test_the_note_says_whose_pixels_are_how_many(qtbot):
    session = Session(document=example("triangle").document)
    session.update_state(compare="boundary_fill_4")
    view = CompareView(session)
    qtbot.addWidget(view)
    view.resize(460, 400)
    view.show()
    qtbot.waitUntil(lambda: view.outcome is not None and view.outcome.second is not None, timeout=10_000)
    qtbot.waitUntil(lambda: not view.model.stale and not view.worker.busy, timeout=10_000)
    inside = {(x, y) for y, left, right in ((1, 2, 8), (2, 3, 7), (3, 3, 7)) for x in range(left, right + 1)}
    assert len(inside) == 17
    outline = {(int(x), int(y)) for x, y in view.outcome.second.cells} - {
        (int(x), int(y)) for x, y in view.outcome.first.cells
    }
    said = f"25 pixels are the same, 0 only the first paints, {len(outline)} only the second."
    assert view.note.text().startswith(said)
    session.close()
