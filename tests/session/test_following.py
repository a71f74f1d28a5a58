"""The runs of a session follow what is active, and their cursor is the session's step."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document import DocumentError, edits
from workbench.document.model import Curve, CurvePoint, Sheet
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.rendering.mapping import Call
from workbench.session import Session, following


@pytest.fixture
def session(qtbot: QtBot) -> Session:
    session = Session(document=example("line").document)
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
    yield session
    session.close()
    session.deleteLater()


def recorded(session: Session, qtbot: QtBot) -> None:
    """Wait until what is active now is recorded."""
    session.flush()
    qtbot.waitUntil(lambda: session.run.done)


def test_the_front_figure_is_followed_until_another_is_made_active(session: Session, qtbot: QtBot) -> None:
    session.new(example("slopes").document)
    recorded(session, qtbot)
    assert (session.run.subject.ids, session.run.entry.slug) == (("f3",), "dda_line")
    session.update_state(active="f1")
    recorded(session, qtbot)
    assert (session.run.subject.ids, session.run.entry.slug) == (("f1",), "bresenham_line")
    assert session.run.arguments == (4, 12, 34, 18)


def test_an_edit_of_the_figure_is_a_new_run_that_stays_at_its_step(session: Session, qtbot: QtBot) -> None:
    session.run.go(4)
    assert session.state.step == 4
    session.apply(edits.move_points({"s1/f1/p2/x": (35.0, 12.0)}), "Move")
    recorded(session, qtbot)
    assert session.run.arguments == (20, 10, 35, 12)
    assert (session.run.position, session.state.step) == (4, 4)


def test_another_figures_run_begins_at_its_start(session: Session, qtbot: QtBot) -> None:
    session.new(example("circles").document)
    session.update_state(active="f1")
    recorded(session, qtbot)
    session.run.go(3)
    session.update_state(active="f2")
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (0, 0)
    session.update_state(active="f1", step=2)
    recorded(session, qtbot)
    assert session.run.position == 2
    session.apply(edits.remove_figures(["f1"]), "Remove")
    recorded(session, qtbot)
    assert (session.run.subject.ids, session.run.position) == (("f3",), 0)


def test_no_figure_no_run(session: Session, qtbot: QtBot) -> None:
    session.apply(edits.remove_figures(["f1"]), "Remove")
    recorded(session, qtbot)
    assert session.run.entry is None
    session.undo_stack.undo()
    recorded(session, qtbot)
    assert session.run.entry.slug == "bresenham_line"


def test_the_compared_algorithm_follows_step_for_step(session: Session, qtbot: QtBot) -> None:
    assert session.followers[0].entry is None
    session.update_state(compare="midpoint_line")
    session.flush()
    qtbot.waitUntil(lambda: session.followers[0].done and session.followers[0].entry is not None)
    session.run.go(6)
    assert (session.followers[0].entry.slug, session.followers[0].position) == ("midpoint_line", 6)
    session.update_state(compare="")
    session.flush()
    assert session.followers[0].entry is None


def test_the_step_comes_back_with_the_file(session: Session, qtbot: QtBot, tmp_path: Path) -> None:
    session.run.go(7)
    session.save_as(tmp_path / "a.gwb")
    session.new()
    recorded(session, qtbot)
    session.open(tmp_path / "a.gwb")
    recorded(session, qtbot)
    assert (session.run.position, session.state.step) == (7, 7)


def test_the_construction_of_a_curve_is_followed_at_u(session: Session, qtbot: QtBot) -> None:
    points = tuple(CurvePoint("", *p) for p in [(4.0, 4.0), (10.0, 22.0), (28.0, 24.0), (36.0, 6.0)])
    session.apply(edits.add_figure("s1", Curve("", points, "bresenham_line")), "Draw a curve")
    curve = session.sheet.figures[-1].id
    session.update_state(active=curve, subject=Subject("curve"))
    recorded(session, qtbot)
    assert session.run.entry is not None
    assert session.run.entry.slug == "de_casteljau"
    assert session.run.arguments[1] == 0.5
    session.run.go(3)
    session.update_state(subject=Subject("curve", arguments={"u": 0.25}))
    recorded(session, qtbot)
    assert (session.run.arguments[1], session.run.position) == (0.25, 3)
    session.update_state(subject=Subject("curve", entry="flatten_bezier"))
    recorded(session, qtbot)
    assert session.run.entry.slug == "flatten_bezier"
    session.update_state(subject=Subject("curve", entry="de_boor"))  # which this kind of curve has not
    recorded(session, qtbot)
    assert session.run.entry.slug == "de_casteljau"
    assert session.state.subject.entry == "de_boor"
    session.update_state(subject=Subject())
    recorded(session, qtbot)
    assert session.run.entry.slug == "bresenham_line"
    with pytest.raises(DocumentError, match="between 0 and 1"):
        session.update_state(subject=Subject("curve", arguments={"u": 1.5}))
    with pytest.raises(DocumentError, match="choose one of hermite_blend"):
        session.update_state(subject=Subject("curve", entry="bresenham_line"))


def test_under_a_drag_the_calls_of_a_run_are_worked_out_once_at_its_end(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Sheet] = []
    calls_of = following.calls_of

    def counted(sheet: Sheet, subject: Subject) -> list[Call]:
        asked.append(sheet)
        return calls_of(sheet, subject)

    monkeypatch.setattr(following, "calls_of", counted)
    session.hold_runs(True)
    for _move in range(5):
        session.apply(edits.move_figures(["f1"], 1.0, 0.0), "Move", "drag")
        session.flush()
    assert not asked
    session.hold_runs(False)
    assert asked == [session.sheet]
    assert session.run.arguments == (25, 10, 35, 18)


def test_who_asks_for_another_step_while_the_run_moves_is_heard(session: Session, qtbot: QtBot) -> None:
    def ask_for_another() -> None:
        if session.run.number == 5:
            session.update_state(step=3)

    session.run.moved.connect(ask_for_another)
    session.update_state(step=5)
    recorded(session, qtbot)
    recorded(session, qtbot)
    assert (session.state.step, session.run.number) == (3, 3)
