"""Which sheet is seen after undo and redo."""

from workbench.document.building import both
from workbench.document.edits import add_sheet, remove_sheet, rename_sheet
from workbench.document.samples.examples import blank_sheet
from workbench.session.session import Session


def with_sheets(count: int) -> Session:
    session = Session(document=blank_sheet())
    for _number in range(count - 1):
        session.apply(add_sheet(blank_sheet().sheets[0]), "Add sheet")
    return session


def add_and_show(session: Session, *names: str) -> list[str]:
    known = {sheet.id for sheet in session.document.sheets}
    session.apply(both(*(add_sheet(blank_sheet(8, 8, name).sheets[0]) for name in names)), "Add sheets")
    added = [sheet.id for sheet in session.document.sheets if sheet.id not in known]
    session.show_sheet(added[0])
    return added


def test_redo_shows_the_sheet_that_it_brings_back(qapp: object) -> None:
    session = with_sheets(1)
    first, added = session.sheet.id, add_and_show(session, "Mesh", "Second")
    session.undo_stack.undo()
    assert session.sheet.id == first
    session.undo_stack.redo()
    assert session.sheet.id == added[0]
    session.close()


def test_undo_shows_again_what_was_seen_before(qapp: object) -> None:
    session = with_sheets(3)
    middle = session.document.sheets[1].id
    session.show_sheet(middle)
    add_and_show(session, "Mesh")
    session.undo_stack.undo()
    assert session.sheet.id == middle
    session.close()


def test_undo_shows_a_removed_sheet_again(qapp: object) -> None:
    session = with_sheets(2)
    gone = session.document.sheets[1].id
    session.show_sheet(gone)
    session.apply(remove_sheet(gone), "Remove sheet")
    assert session.sheet.id != gone
    session.undo_stack.undo()
    assert session.sheet.id == gone
    session.close()


def test_other_steps_leave_the_sheet_that_is_seen(qapp: object) -> None:
    session = with_sheets(2)
    session.show_sheet(session.document.sheets[1].id)
    seen = session.sheet.id
    session.apply(rename_sheet(session.document.sheets[0].id, "Other"), "Rename")
    shown: list[bool] = []
    session.opened.connect(lambda: shown.append(True))
    session.undo_stack.undo()
    session.undo_stack.redo()
    assert session.sheet.id == seen
    assert not shown
    session.close()
