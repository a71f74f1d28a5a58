"""The question about a pixel lasts where the pixel means the same, and ends with its sheet."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.edits import add_sheet, remove_sheet
from workbench.document.samples.examples import example
from workbench.document.subjects import Subject
from workbench.session.session import Session

ASKED = (8, 6)


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Session]:
    """A line in Draw, a pixel of which is asked about, and a second sheet."""
    session = Session(document=example("line").document)
    session.apply(add_sheet(example("missed").document.sheets[0]), "Add")
    session.visit("draw", Subject())
    session.update_state(pixel=ASKED)
    yield session
    session.close()
    session.deleteLater()


def test_the_question_ends_with_another_sheet(session: Session) -> None:
    session.show_sheet(session.document.sheets[1].id)
    assert session.state.pixel is None


def test_the_question_ends_with_an_example_beside_unsaved_work(session: Session) -> None:
    session.open_example("triangle")
    assert session.state.pixel is None


def test_the_question_ends_with_its_sheet(session: Session) -> None:
    session.apply(remove_sheet(session.sheet.id), "Remove sheet")
    assert session.state.pixel is None


@pytest.mark.parametrize("workspace", ["transform", "view", "visibility", "animate", "raster"])
def test_the_question_ends_where_it_means_nothing(session: Session, workspace: str) -> None:
    session.visit(workspace, Subject())
    session.visit("draw", Subject())
    assert session.state.pixel is None


@pytest.mark.parametrize("workspace", ["fill", "clip", "curves", "why"])
def test_the_question_lasts_among_the_figures_of_one_sheet(session: Session, workspace: str) -> None:
    session.visit(workspace, Subject())
    assert session.state.pixel == ASKED


def test_a_question_that_is_taken_along_is_asked_where_it_leads(session: Session) -> None:
    session.update_state(workspace="visibility", pixel=(3, 4))
    assert session.state.pixel == (3, 4)
    session.visit("shading", Subject())
    assert session.state.pixel is None
