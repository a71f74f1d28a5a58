"""Every edit of a curve is undone and redone to the same document."""

from collections.abc import Iterator

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from tests.document.curves.made_curves import curve_edit_of, documents_with_curves
from workbench.document import DocumentError
from workbench.document.curves.conversions import convert
from workbench.document.curves.cutting import insert_on_curve, split
from workbench.document.curves.degrees import lower_degree, raise_degree
from workbench.document.curves.joining import join, reverse
from workbench.document.curves.shaping import drag_curve, smooth_joint
from workbench.document.model import Document
from workbench.session import Session


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Session]:
    session = Session()
    yield session
    session.close()
    session.deleteLater()


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data(), documents_with_curves())
def test_edits_of_curves_are_undone_and_redone(
    session: Session, data: st.DataObject, document: Document
) -> None:
    session.new(document)
    seen = [document]
    for _turn in range(4):
        now = session.document
        if not now.sheets[0].figures:
            break
        curve, last = now.sheets[0].figures[0].id, now.sheets[0].figures[-1].id
        changes = [
            insert_on_curve(curve, 0.4),
            split(curve, 0.6),
            join(curve, last),
            reverse(curve),
            raise_degree(curve),
            lower_degree(curve),
            convert(curve, "bezier_path", 1.0),
            drag_curve(curve, 0.5, 3, 4),
            smooth_joint(curve, 0, "C1"),
        ]
        edit = data.draw(curve_edit_of(now) | st.sampled_from(changes))
        try:
            session.apply(edit, "Change")
        except DocumentError:
            assert session.document == now
            continue
        if session.document != seen[-1]:
            seen.append(session.document)
    assert session.undo_stack.count() == len(seen) - 1
    for before in reversed(seen[:-1]):
        session.undo_stack.undo()
        assert session.document == before
    for after in seen[1:]:
        session.undo_stack.redo()
        assert session.document == after
