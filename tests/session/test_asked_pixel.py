"""The question about a pixel lasts where the pixel means the same, and ends with its sheet."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.edits import add_sheet, remove_sheet
from workbench.document.errors import DocumentError
from workbench.document.samples.examples import example
from workbench.document.state import FIGURES
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


@pytest.mark.parametrize("workspace", ["visibility", "shading", "arena", "a_new_wing"])
def test_the_question_is_of_the_figures_wherever_they_are_seen(session: Session, workspace: str) -> None:
    """It is not asked of the scene, and another wing has to be listed nowhere."""
    session.visit(workspace, Subject())
    assert session.state.asked(workspace) is None
    assert session.state.asked(FIGURES) == ASKED


def test_a_question_about_a_scene_is_of_its_workspace_alone(session: Session) -> None:
    session.update_state(workspace="visibility", pixel=(3, 4), pixel_of="visibility")
    assert session.state.asked("visibility") == (3, 4)
    session.visit("shading", Subject())
    assert session.state.asked("shading") is None
    assert session.state.asked(FIGURES) is None
    session.update_state(pixel=ASKED)
    assert session.state.asked(FIGURES) == ASKED


def test_a_question_that_was_written_before_is_about_the_figures(session: Session, tmp_path: Path) -> None:
    path = tmp_path / "before.gwb"
    session.save_as(path)
    whole = json.loads(path.read_bytes())
    del whole["session"]["pixel_of"]
    path.write_text(json.dumps(whole))
    session.open(path)
    assert session.state.asked(FIGURES) == ASKED


def test_what_a_question_is_about_is_a_name(session: Session) -> None:
    with pytest.raises(DocumentError, match="pixel_of"):
        session.update_state(pixel=ASKED, pixel_of="two words")
