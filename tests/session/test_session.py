"""The session: undo, merging, what it tells and when, and what it keeps of files."""

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from tests.document.made_documents import documents, sound_edits
from workbench.document import DocumentError, edits, load, read
from workbench.document.addresses import Address
from workbench.document.model import Document
from workbench.document.samples.examples import blank_sheet, example_document, examples
from workbench.session import Session


class Told:
    """What a session told, in order."""

    def __init__(self, session: Session) -> None:
        self.all: list[tuple[Any, ...]] = []
        session.changed.connect(lambda old, new, addresses: self.all.append((old, new, addresses)))
        session.state_changed.connect(lambda old, new: self.all.append((old, new)))


@pytest.fixture
def session(qtbot: QtBot) -> Session:
    return Session(document=example_document())


def moved(x: float) -> edits.Edit:
    return edits.move_points({"s1/f1/p1/x": (x, 10.0)})


def test_an_edit_is_done_at_once_and_told_once_per_turn(session: Session, qtbot: QtBot) -> None:
    told = Told(session)
    before = session.document
    session.apply(moved(1), "Move")
    session.apply(moved(2), "Move")
    session.apply(edits.set_attribute("s1/f1/colour", 2), "Colour")
    assert session.revision == 3
    assert told.all == []
    qtbot.wait(1)
    assert told.all == [
        (before, session.document, {Address("s1", "f1", "p1", "x"), Address("s1", "f1", "", "colour")})
    ]
    assert session.undo_stack.count() == 3


def test_what_is_undone_within_the_turn_is_not_told(session: Session, qtbot: QtBot) -> None:
    told = Told(session)
    session.apply(moved(1), "Move")
    session.undo_stack.undo()
    qtbot.wait(1)
    assert told.all == []


def test_a_drag_is_one_step(session: Session) -> None:
    start = session.document
    for x in range(50):
        session.apply(moved(x), "Move", merge="drag")
    session.end_merge()
    end = session.document
    session.apply(moved(99), "Move", merge="drag")
    assert session.undo_stack.count() == 2
    session.undo_stack.undo()
    assert session.document == end
    session.undo_stack.undo()
    assert session.document == start
    session.undo_stack.redo()
    assert session.document == end


def test_a_drag_back_to_its_start_leaves_no_step(session: Session) -> None:
    for x in (5, 7, 20):
        session.apply(moved(x), "Move", merge="drag")
    session.end_merge()
    assert session.undo_stack.count() == 0
    assert session.document == example_document()
    assert not session.dirty


def test_edits_of_another_kind_end_a_drag(session: Session) -> None:
    session.apply(moved(1), "Move", merge="drag")
    session.apply(moved(2), "Move", merge="other drag")
    session.apply(moved(3), "Move")
    session.apply(moved(4), "Move", merge="drag")
    assert session.undo_stack.count() == 4
    session.undo_stack.undo()
    session.apply(moved(5), "Move", merge="drag")
    assert session.undo_stack.count() == 4
    session.undo_stack.undo()
    assert session.document.sheets[0].figures[0].points_world[0].x == 3


def test_saving_in_the_middle_of_a_drag_keeps_dirty_true(session: Session, tmp_path: Path) -> None:
    session.apply(moved(1), "Move", merge="drag")
    session.save_as(tmp_path / "a.gwb")
    assert not session.dirty
    session.apply(moved(2), "Move", merge="drag")
    assert session.dirty
    session.undo_stack.undo()
    assert not session.dirty
    assert session.document == load(tmp_path / "a.gwb")


def test_a_drag_that_goes_on_when_it_is_saved_at_its_start_is_dirty(session: Session, tmp_path: Path) -> None:
    start = session.document
    session.save_behind(tmp_path / "a.gwb")
    for name in ("away", "A line"):
        session.apply(edits.rename_sheet("s1", name), "Rename", merge="drag")
    assert session.document == start
    session.finish_saving()
    assert not session.dirty
    for name in ("further", "on"):
        session.apply(edits.rename_sheet("s1", name), "Rename", merge="drag")
    assert session.dirty
    session.end_merge()
    assert session.undo_stack.count() == 1
    session.undo_stack.undo()
    assert session.document == start
    assert not session.dirty


def test_a_refused_edit_leaves_everything(session: Session, qtbot: QtBot) -> None:
    told = Told(session)
    session.apply(moved(1), "Move", merge="drag")
    before = session.document
    with pytest.raises(DocumentError):
        session.apply(moved(float("nan")), "Move", merge="drag")
    assert session.document is before
    assert (session.undo_stack.count(), session.revision) == (1, 1)
    qtbot.wait(1)
    assert len(told.all) == 1


def test_an_edit_that_changes_nothing_leaves_no_step(session: Session) -> None:
    session.apply(moved(20), "Move")
    assert not session.dirty


@settings(max_examples=40)
@given(st.data(), documents())
def test_whatever_is_done_is_undone_and_done_again_equally(data: st.DataObject, document: Document) -> None:
    session = Session(document=document)
    seen = [document]
    for _turn in range(data.draw(st.integers(1, 6))):
        try:
            session.apply(data.draw(sound_edits(session.document)), "Edit")
        except DocumentError:
            continue
        if session.document != seen[-1]:
            seen.append(session.document)
    assert session.undo_stack.count() == len(seen) - 1
    for expected in reversed(seen[:-1]):
        session.undo_stack.undo()
        assert session.document == expected
        assert all(session.state.sheet != "" for _sheet in expected.sheets)
    for expected in seen[1:]:
        session.undo_stack.redo()
        assert session.document == expected


def test_selection_and_cursor_are_no_steps_of_undo_and_not_dirty(session: Session, qtbot: QtBot) -> None:
    told = Told(session)
    old = session.state
    session.update_state(selection=("f1",), active="f1")
    session.update_state(step=4, detail=True)
    assert session.state.step == 4
    assert not session.dirty
    assert session.undo_stack.count() == 0
    qtbot.wait(1)
    assert told.all == [(old, session.state)]


def test_state_that_refers_to_nothing_is_refused(session: Session) -> None:
    with pytest.raises(DocumentError):
        session.update_state(selection=("f1", "f9"))
    with pytest.raises(DocumentError):
        session.update_state(step=-1)
    assert session.state.selection == ()


def test_a_removed_figure_leaves_the_selection_and_the_document_is_told_first(
    session: Session, qtbot: QtBot
) -> None:
    session.update_state(selection=("f1",), active="f1", step=3)
    qtbot.wait(1)
    told = Told(session)
    session.apply(edits.remove_figures(["f1"]), "Remove")
    assert (session.state.selection, session.state.active, session.state.step) == ((), "", 0)
    assert session.active_figure is None
    qtbot.wait(1)
    assert [len(one) for one in told.all] == [3, 2]


def test_the_current_sheet_goes_with_its_removal(session: Session) -> None:
    session.apply(edits.add_sheet(blank_sheet().sheets[0]), "Add")
    added = session.document.sheets[1].id
    session.update_state(sheet=added)
    assert session.sheet.id == added
    session.apply(edits.remove_sheet(added), "Remove")
    assert session.sheet.id == "s1"


def test_saved_opened_and_dirty(session: Session, tmp_path: Path) -> None:
    seen: list[bool] = []
    session.dirty_changed.connect(seen.append)
    with pytest.raises(DocumentError):
        session.save()
    session.apply(moved(3), "Move")
    session.update_state(selection=("f1",), step=2, compare="dda_line")
    session.save_as(tmp_path / "a.gwb")
    assert seen == [True, False]
    session.undo_stack.undo()
    assert session.dirty
    session.undo_stack.redo()
    assert not session.dirty
    other = Session()
    other.open(tmp_path / "a.gwb")
    assert other.document == session.document
    assert other.state == session.state
    assert other.path == tmp_path / "a.gwb"
    assert not other.dirty
    other.apply(moved(8), "Move")
    other.save()
    assert load(tmp_path / "a.gwb") == other.document


def test_blobs_of_a_file_are_kept(tmp_path: Path, qtbot: QtBot) -> None:
    sample = Path(__file__).parents[1] / "document" / "samples" / "version-1.gwb"
    session = Session()
    session.open(sample)
    session.save_as(tmp_path / "a.gwb")
    assert read(tmp_path / "a.gwb") == read(sample)


def test_what_cannot_be_opened_leaves_what_is_open(session: Session, tmp_path: Path) -> None:
    session.save_as(tmp_path / "a.gwb")
    session.apply(moved(3), "Move")
    (tmp_path / "bad.gwb").write_text('{"format": "graphics-workbench", "version": 1')
    before = (session.document, session.state, session.path, session.undo_stack.count(), session.revision)
    for path in (tmp_path / "bad.gwb", tmp_path / "none.gwb", tmp_path):
        with pytest.raises(DocumentError):
            session.open(path)
    with pytest.raises(DocumentError):
        session.save_as(tmp_path)
    assert (
        session.document,
        session.state,
        session.path,
        session.undo_stack.count(),
        session.revision,
    ) == before
    assert session.dirty


@pytest.mark.parametrize("slug", [one.slug for one in examples()])
def test_an_example_is_not_dirty_until_it_is_edited(slug: str, session: Session, tmp_path: Path) -> None:
    session.save_as(tmp_path / "a.gwb")
    session.open_example(slug)
    assert not session.dirty
    assert session.path is None
    assert session.document == next(one.document for one in examples() if one.slug == slug)
    session.apply(edits.rename_sheet("s1", "Mine"), "Rename")
    assert session.dirty


def test_the_stepped_figure_of_an_example_is_selected(session: Session) -> None:
    for _beside_unsaved_work in (False, True):
        session.open_example("house")
        assert session.state.selection == (session.sheet.figures[-1].id,)
        assert session.active_figure == session.sheet.figures[-1]
        session.apply(moved(3), "Move")


def test_an_example_never_takes_the_place_of_unsaved_work(session: Session) -> None:
    session.apply(moved(3), "Move")
    mine = session.sheet
    session.open_example("house")
    assert session.sheet.name == "A house of lines"
    assert session.document.sheets[0] == mine
    session.undo_stack.undo()
    assert session.document.sheets == (mine,)


def test_a_new_document_has_no_file_and_no_past(session: Session, tmp_path: Path) -> None:
    session.apply(moved(3), "Move")
    session.save_as(tmp_path / "a.gwb")
    session.new()
    assert session.document == blank_sheet()
    assert (session.path, session.dirty, session.undo_stack.count()) == (None, False, 0)
