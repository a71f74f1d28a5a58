"""The subject of a session: a kind of one's own is stepped, and every workspace keeps its place."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QStackedWidget, QWidget
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Mark, Spot
from workbench.document import DocumentError, edits
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.samples.examples import example
from workbench.document.state import SessionState
from workbench.document.storage.files import Stored
from workbench.document.subjects import Position, Subject
from workbench.rendering.mapping import Call, device_map
from workbench.rendering.subjects import registry
from workbench.rendering.subjects.registry import (
    Comparing,
    Given,
    SubjectKind,
    marks_on_device,
    register,
)
from workbench.session import Session


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Session]:
    session = Session(document=example("slopes").document)
    session.visit("draw", Subject())
    recorded(session, qtbot)
    yield session
    session.close()
    session.deleteLater()


def recorded(session: Session, qtbot: QtBot) -> None:
    """Wait until the runs are those of the session's subject, and done."""
    session.flush()
    qtbot.waitUntil(lambda: all(run.done for run in (session.run, *session.followers)), timeout=20_000)


# A kind of one's own


def spoke_calls(sheet: Sheet, subject: Subject) -> list[Call]:
    """A line from the middle of the sheet, as long as is asked for, once for every id."""
    length = int(subject.arguments.get("length", 9))
    x, y = sheet.width_px // 2, sheet.height_px // 2
    entry = catalogue.get(subject.entry or "bresenham_line")
    return [Call(entry, (x, y, x + length, y + number)) for number, _id in enumerate(subject.ids)]


def turned_over(sheet: Sheet, subject: Subject, frame: str, marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    return tuple(mark._replace(x=-mark.x) for mark in marks)


SPOKES = SubjectKind(
    title="Spokes",
    calls=spoke_calls,
    choices=lambda sheet, subject: ("bresenham_line", "dda_line"),
    entries=("bresenham_line", "dda_line"),
    arguments={"length": Given(9, Number(label="length", low=1, high=12, whole=True, keyed=False))},
    on_device=turned_over,
    comparing=Comparing(choices=lambda sheet, subject: ("bresenham_line", "dda_line")),
)


@pytest.fixture
def spokes(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Subject]:
    """Registers the kind for one test."""
    monkeypatch.setattr(registry, "_REGISTERED", dict(registry._REGISTERED))
    register("spokes", SPOKES)
    return lambda *ids, **arguments: Subject("spokes", ids, arguments=arguments)


def test_an_invented_kind_is_stepped_chosen_and_compared(
    session: Session, qtbot: QtBot, spokes: Callable[..., Subject]
) -> None:
    session.visit("wheel", spokes("f1", "f2"))
    recorded(session, qtbot)
    run = session.run
    assert run.subject == spokes("f1", "f2")
    assert run.entry is catalogue.get("bresenham_line")
    assert [len(call) for call in run.calls] == [4, 4]
    assert run.total_steps == 2 * 9
    run.go(12)
    assert (session.state.workspace, session.state.step) == ("wheel", 12)
    session.update_state(subject=spokes("f1", "f2", length=12))  # other arguments: it stays in its step
    recorded(session, qtbot)
    assert (run.total_steps, run.position, session.state.step) == (24, 12, 12)
    session.update_state(compare="dda_line")
    recorded(session, qtbot)
    (follower,) = session.followers
    assert follower.entry is catalogue.get("dda_line")
    run.forward()
    assert follower.position == run.position == 13
    session.choose("dda_line")
    recorded(session, qtbot)
    assert session.state.subject.entry == "dda_line"
    assert run.entry is catalogue.get("dda_line")
    assert (run.position, session.state.step) == (0, 0)
    session.choose("midpoint_line")  # is no choice here
    assert session.state.subject.entry == "dda_line"
    with pytest.raises(DocumentError, match="between 1 and 12"):
        session.update_state(subject=spokes("f1", length=13))
    with pytest.raises(DocumentError, match="f9"):
        session.update_state(subject=spokes("f9"))


def test_an_invented_kind_brings_its_marks_to_the_device_itself(
    session: Session, spokes: Callable[..., Subject]
) -> None:
    (mark,) = marks_on_device(session.shown, spokes(), "world", (Spot(3.0, 4.0),))
    assert (mark.x, mark.y) == (-3.0, 4.0)
    (mark,) = marks_on_device(session.shown, Subject(), "world", (Spot(3.0, 4.0),))
    assert (mark.x, mark.y) == device_map(session.shown).point(3.0, 4.0)


# Positions


def test_each_workspace_comes_back_to_its_place(session: Session, qtbot: QtBot) -> None:
    session.run.go(7)
    session.visit("clip", Subject("clipper"))
    recorded(session, qtbot)
    assert session.run.entry is None  # the sheet has no window
    assert (session.state.subject, session.state.step) == (Subject("clipper"), 0)
    session.visit("fill", Subject())
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (0, 0)
    session.run.go(3)
    session.visit("draw", Subject())
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (7, 7)
    session.visit("fill", Subject())
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (3, 3)


def test_what_still_runs_says_nothing_of_the_step_of_what_is_entered(session: Session, qtbot: QtBot) -> None:
    session.run.go(7)
    session.visit("fill", Subject())
    session.update_state(step=2)
    session.run.go(5)  # as when its recording has come so far
    assert (session.state.workspace, session.state.step) == ("fill", 2)
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (2, 2)
    session.visit("draw", Subject())
    recorded(session, qtbot)
    assert session.run.position == 7


class Page(QWidget):
    """Tells when it is painted."""

    def __init__(self, told: list[str]) -> None:
        super().__init__()
        self.told = told

    def paintEvent(self, _event: QPaintEvent) -> None:
        self.told.append("painted")


def test_what_is_entered_is_painted_before_its_run_follows(session: Session, qtbot: QtBot) -> None:
    told: list[str] = []
    window, page = QStackedWidget(), Page(told)
    qtbot.addWidget(window)
    window.addWidget(QWidget())
    window.addWidget(page)
    with qtbot.waitExposed(window):
        window.show()
    session.run.changed.connect(lambda: told.append("run"))
    session.state_changed.connect(lambda *_states: told.append("state"))
    window.setCurrentWidget(page)
    session.visit("clip", Subject("clipper"))
    assert session.state.workspace == "clip"
    assert session.run.entry is not None
    qtbot.waitUntil(lambda: "state" in told)
    assert list(dict.fromkeys(told))[:3] == ["painted", "run", "state"]
    told.clear()
    session.update_state(ask_first=True)
    page.update()
    qtbot.waitUntil(lambda: len(told) >= 2)
    assert told[0] == "state"  # on the page that is seen nothing is painted that is out of date


def test_lines_are_counted_where_they_were_switched_on(session: Session, qtbot: QtBot) -> None:
    session.run.go(3)
    session.run.set_detail(True)
    line = session.run.position
    assert line > 3
    session.visit("fill", Subject())
    recorded(session, qtbot)
    assert (session.run.detail, session.run.position, session.state.step) == (False, 0, 0)
    session.run.go(2)
    session.visit("draw", Subject())
    recorded(session, qtbot)
    assert (session.run.detail, session.run.position, session.state.step) == (True, line, line)
    session.update_state(detail=False)
    session.flush()
    assert (session.run.position, session.state.step) == (3, 3)
    session.visit("fill", Subject())
    recorded(session, qtbot)
    assert session.run.position == 2


def test_a_row_and_a_line_of_the_same_number_are_two_places(session: Session, qtbot: QtBot) -> None:
    session.run.set_detail(True)
    session.run.go(5)
    session.visit("fill", Subject())
    recorded(session, qtbot)
    session.run.go(5)
    for workspace, detail in (("draw", True), ("fill", False)):
        session.visit(workspace, Subject())
        recorded(session, qtbot)
        assert (session.run.detail, session.run.position) == (detail, 5)


def test_what_is_visited_for_the_first_time_is_what_it_usually_is(session: Session, qtbot: QtBot) -> None:
    session.new(example("curve-bezier").document)
    session.visit("curves", Subject("curve"))
    session.update_state(subject=Subject("curve", arguments={"u": 0.25}))
    session.visit("draw", Subject())
    session.visit("curves", Subject("curve"))
    recorded(session, qtbot)
    assert session.state.subject.arguments == {"u": 0.25}
    assert session.run.entry is not None
    assert session.run.arguments[-1] == 0.25
    assert session.run.subject == Subject("curve", (session.sheet.figures[-1].id,), arguments={"u": 0.25})


def test_another_active_figure_puts_its_runs_to_the_start_and_no_others(
    session: Session, qtbot: QtBot
) -> None:
    session.run.go(7)
    session.visit("fill", Subject(ids=("f1",)))
    recorded(session, qtbot)
    session.run.go(5)
    session.update_state(active="f2")
    recorded(session, qtbot)
    assert (session.run.subject, session.run.position) == (Subject(ids=("f1",)), 5)
    session.visit("draw", Subject())
    recorded(session, qtbot)
    assert (session.run.subject, session.run.position, session.state.step) == (Subject(ids=("f2",)), 0, 0)


def test_with_what_it_names_a_subject_goes_back_to_the_active_figure(session: Session, qtbot: QtBot) -> None:
    session.visit("fill", Subject(ids=("f1",)))
    recorded(session, qtbot)
    session.run.go(5)
    session.apply(edits.remove_figures(["f1"]), "Delete")
    recorded(session, qtbot)
    assert session.state.position == Position()
    assert session.run.subject == Subject(ids=("f3",))


def test_places_and_arguments_come_back_with_the_file(session: Session, qtbot: QtBot, tmp_path: Path) -> None:
    session.run.go(7)
    session.visit("curves", Subject("curve", arguments={"u": 0.75}))
    recorded(session, qtbot)
    session.run.go(4)
    session.save_as(tmp_path / "a.gwb")
    session.new()
    recorded(session, qtbot)
    session.open(tmp_path / "a.gwb")
    recorded(session, qtbot)
    assert (session.state.workspace, session.run.position) == ("curves", 4)
    assert session.state.subject.arguments == {"u": 0.75}
    session.visit("draw", Subject())
    recorded(session, qtbot)
    assert session.run.position == 7


# What a file holds that cannot be run


@pytest.mark.parametrize(
    ("subject", "said"),
    [
        (Subject("flea_circus"), "This version of the program cannot step “flea_circus”."),
        (Subject("curve", entry="construction_of_tomorrow"), "construction_of_tomorrow"),
        (Subject("curve", arguments={"v": 0.5}), "v = 0.5"),
    ],
)
def test_what_a_newer_program_stepped_is_left_out_and_said(
    session: Session, qtbot: QtBot, subject: Subject, said: str
) -> None:
    told: list[str] = []
    session.left_out.connect(told.append)
    positions = {"draw": Position(step=2), "circus": Position(subject, 3)}
    stored = Stored(example("slopes").document, SessionState(workspace="circus", positions=positions))
    session.take(stored, Path("a.gwb"), None)
    recorded(session, qtbot)
    assert len(told) == 1
    assert said in told[0]
    assert session.state.positions == {"draw": Position(step=2)}
    assert session.run.subject == Subject(ids=("f3",))
    session.take(replace(stored, session=SessionState()), Path("b.gwb"), None)
    assert len(told) == 1


@pytest.mark.parametrize(
    ("kind", "sentence"),
    [
        ("chain", "Draw a figure and give it a transform, to see its matrices worked out step by step."),
        ("clipper", "Draw a figure and a window to see how the algorithm works, step by step."),
        ("window", "Click a point in one of the pictures, and follow it to the other step by step."),
        ("figure", "Draw a figure to see how the algorithm works, step by step."),
    ],
)
def test_where_nothing_is_run_each_subject_says_what_it_lacks(qtbot, kind, sentence):
    session = Session()
    session.visit("elsewhere", Subject("curve"))
    session.visit("here", Subject(kind))
    session.flush()
    assert session.run.entry is None
    assert session.run.invitation == sentence
    session.close()
