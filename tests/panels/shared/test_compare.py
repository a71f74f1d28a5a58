"""The Compare dock: two algorithms on the same figures, counted on a thread of its own."""

import threading

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from workbench.algorithms import catalogue
from workbench.document.model import Polygon
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.engine.compiled import Stop
from workbench.engine.counts import counts
from workbench.panels.shared.compare import CompareView
from workbench.panels.shared.compare_work import table_rows
from workbench.panels.shared.compare_worker import CompareWorker
from workbench.rendering import work
from workbench.rendering.comparing import BOTH, ONLY_FIRST, ONLY_SECOND, figure_pixels
from workbench.rendering.outline_fill import outline_fill
from workbench.rendering.subjects.registry import comparing, own_entry, rivals
from workbench.rendering.work import Job, outcome_of
from workbench.session.session import Session


def sheet_of(slug):
    return example(slug).document.sheets[0]


def of(kind, *figures):
    return tuple(Subject(kind, (figure.id,)) for figure in figures)


def clip_job(second="liang_barsky"):
    sheet = sheet_of("clip")
    return Job(sheet, of("clipper", *sheet.figures), "cohen_sutherland", second)


def test_the_counts_are_those_of_every_line_summed():
    outcome = outcome_of(clip_job(), Stop())
    rows = {label: (first, second) for label, first, second in table_rows(outcome)}
    for place, slug in enumerate(("cohen_sutherland", "liang_barsky")):
        function = catalogue.get(slug).function
        each = [
            counts(
                function, *(p for point in f.points_world for p in (point.x, point.y)), 8.0, 10.0, 38.0, 30.0
            )
            for f in outcome.job.sheet.figures
        ]
        assert rows["Tests"][place] == sum(one.tests for one in each)
        assert rows["Divisions"][place] == sum(one.divisions for one in each)
    # Cohen-Sutherland cuts the line past the corner and cuts one end twice, Liang-Barsky only what it keeps.
    assert rows["Intersections"][1] < rows["Intersections"][0]
    assert rows["Lines kept"] == (4, 4)


def test_both_clippers_paint_the_same_pixels():
    outcome = outcome_of(clip_job(), Stop())
    assert (outcome.only_first, outcome.only_second) == (0, 0)
    assert outcome.both > 30


def test_the_difference_picture_tells_whose_pixel_it_is():
    sheet = sheet_of("line")
    job = Job(sheet, of("figure", *sheet.figures), "bresenham_line", "dda_line")
    outcome = outcome_of(job, Stop())
    first, second = (
        {tuple(cell) for cell in figure_pixels(sheet, sheet.figures[0], slug).tolist()}
        for slug in ("bresenham_line", "dda_line")
    )
    rows, columns = np.nonzero(outcome.classes == BOTH)
    assert set(zip(columns.tolist(), rows.tolist(), strict=True)) == first & second
    only = int(np.isin(outcome.classes, (ONLY_FIRST, ONLY_SECOND)).sum()) + 2 * outcome.ties
    assert only <= len(first ^ second)
    assert len(first - second) >= outcome.only_first


def test_a_seed_fill_of_the_outline_paints_what_the_scan_lines_paint_and_the_outline():
    sheet = sheet_of("triangle")
    (triangle,) = sheet.figures
    for slug in ("boundary_fill_4", "boundary_fill_spans", "flood_fill_4", "boundary_fill_recursive"):
        job = Job(sheet, of("figure", triangle), "scan_line_exact", slug)
        outcome = outcome_of(job, Stop())
        assert outcome.both == 25
        assert outcome.only_first == 0
        outline = {tuple(cell) for cell in outline_fill(sheet, triangle, slug).outline.tolist()}
        only = np.argwhere(outcome.classes == ONLY_SECOND)[:, ::-1].tolist()
        assert {tuple(cell) for cell in only} <= outline


def test_an_outline_without_an_inside_has_nothing_to_fill():
    sheet = sheet_of("triangle")
    (triangle,) = sheet.figures
    from msgspec.structs import replace

    flat = replace(triangle, points_world=tuple(replace(p, y=3.0) for p in triangle.points_world))
    assert outline_fill(replace(sheet, figures=(flat,)), flat, "boundary_fill_4").call is None


def test_what_can_be_compared():
    sheet = sheet_of("clip")
    (clipper,), (line,) = of("clipper", sheet.figures[0]), of("figure", sheet.figures[0])
    assert (own_entry(sheet, clipper), rivals(sheet, clipper)) == ("cohen_sutherland", ("liang_barsky",))
    assert (own_entry(sheet, Subject("clipper")), rivals(sheet, Subject("clipper"))) == ("", ())
    assert own_entry(sheet, line) == "bresenham_line"
    assert "dda_line" in rivals(sheet, line)
    assert "bresenham_line" not in rivals(sheet, line)
    filled = sheet_of("triangle")
    assert isinstance(filled.figures[0], Polygon)
    assert "boundary_fill_4" in rivals(filled, *of("figure", filled.figures[0]))
    lab = sheet_of("clip-lab")
    (last,) = of("clipper", lab.figures[-1])
    assert len(comparing(last).alike(lab, last)) == 3


# The worker


def test_only_the_last_question_is_answered(qtbot):
    worker = CompareWorker()
    answers = []
    worker.answered.connect(answers.append)
    first, second = clip_job(), clip_job("")
    worker.ask(first)
    worker.ask(second)
    qtbot.waitUntil(lambda: not worker.busy, timeout=10_000)
    QApplication.processEvents()
    assert [answer.job for answer in answers] == [second]


def test_nothing_is_counted_on_the_interface_thread(qtbot, monkeypatch):
    threads = []

    def noted(function, *args, **kwargs):
        threads.append(threading.current_thread())
        assert kwargs["compiling"] is False
        return counts(function, *args, **kwargs)

    monkeypatch.setattr(work, "counts", noted)
    worker = CompareWorker()
    with qtbot.waitSignal(worker.answered, timeout=10_000):
        worker.ask(clip_job())
    assert threads
    assert threading.main_thread() not in threads


def test_a_job_that_fails_is_told(qtbot, monkeypatch):
    def broken(*_args, **_kwargs):
        raise ValueError("no counts today")

    monkeypatch.setattr(work, "counts", broken)
    worker = CompareWorker()
    with qtbot.waitSignal(worker.failed, timeout=10_000) as told:
        worker.ask(clip_job())
    assert told.args == ["no counts today"]


# The dock


@pytest.fixture
def session(qtbot):
    made = Session(document=example("clip").document)
    made.update_state(subject=Subject("clipper"), active="f6")
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def view(qtbot, session):
    made = CompareView(session)
    qtbot.addWidget(made)
    made.resize(460, 300)
    made.show()
    return made


def answered(qtbot, view):
    qtbot.waitUntil(
        lambda: view.outcome is not None and not view.model.stale and not view.worker.busy, timeout=10_000
    )


def cell(view, label, column):
    return next(row for row in view.model.rows if row[0] == label)[column]


def test_both_line_clippers_stand_side_by_side_and_the_whole_sheet_is_counted(qtbot, session, view):
    answered(qtbot, view)
    assert view.model.titles == ("Cohen-Sutherland", "Liang-Barsky")
    assert view.whole.isChecked()
    assert cell(view, "Runs", 1) == 6
    every = cell(view, "Tests", 1)
    assert "same" in view.note.text()
    view.whole.setChecked(False)
    qtbot.waitUntil(lambda: cell(view, "Tests", 1) < every and not view.model.stale, timeout=10_000)
    assert cell(view, "Intersections", 1) == 2


def test_the_second_run_goes_in_step(qtbot, session, view):
    session.update_state(compare="liang_barsky")
    qtbot.waitUntil(
        lambda: (
            session.run.entry is not None
            and session.run.done
            and session.followers[0].entry is not None
            and session.followers[0].done
        ),
        timeout=10_000,
    )
    answered(qtbot, view)
    session.run.go(2)
    assert session.followers[0].position == 2
    QApplication.processEvents()
    assert "Liang-Barsky after step 2 of 4" in view.note.text()


def test_choosing_the_first_swaps_with_the_second(qtbot, session, view):
    session.update_state(compare="liang_barsky")
    answered(qtbot, view)
    view.first.setCurrentIndex(view.first.findData("liang_barsky"))
    view.first.activated.emit(view.first.currentIndex())
    assert session.sheet.line_clipper == "liang_barsky"
    assert session.state.compare == "cohen_sutherland"
    session.undo_stack.undo()
    assert session.sheet.line_clipper == "cohen_sutherland"


def test_the_largest_stack_of_two_fills(qtbot):
    session = Session(document=example("pond").document)
    fill = session.sheet.figures[-1]
    session.update_state(active=fill.id, compare="boundary_fill_spans")
    view = CompareView(session)
    qtbot.addWidget(view)
    view.resize(460, 500)
    view.show()
    qtbot.waitUntil(
        lambda: (
            view.outcome is not None
            and view.outcome.second is not None
            and bool(view.outcome.first.deepest)
            and bool(view.outcome.second.deepest)
        ),
        timeout=20_000,
    )
    most = []
    for run in (session.run, *session.followers):
        depths = [len(run.recording[k].variables.get("stack", ())) for k in range(len(run.recording))]
        most.append(max(depths))
    assert [int(cell(view, "Largest stack", k)) for k in (1, 2)] == most
    assert cell(view, "Writes", 1) == cell(view, "Writes", 2) == len(session.run.recording.emitted)
    session.close()


def test_what_was_found_has_the_whole_width_in_a_low_dock(qtbot, session, view):
    view.resize(460, 165)
    answered(qtbot, view)
    QApplication.processEvents()
    assert view.note.width() > view.table.width() + view.difference.width()
    assert view.note.height() >= view.note.heightForWidth(view.note.width())


def test_the_table_is_copied(qtbot, session, view):
    answered(qtbot, view)
    view.copy()
    text = QGuiApplication.clipboard().text()
    assert "Cohen-Sutherland\tLiang-Barsky" in text
    assert "Lines kept\t4\t4" in text


def test_without_a_figure_one_sentence_and_a_button(qtbot, session, view):
    answered(qtbot, view)
    session.new()
    qtbot.waitUntil(lambda: view.state.empty, timeout=2000)
