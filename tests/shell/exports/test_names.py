"""What exported files are called, and where their dialogs begin."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import dialog_of, type_name
from tests.shell.exports.exporting import names, trigger, written
from workbench.document.storage.files import load
from workbench.shell.window import MainWindow

# The offscreen platform says so of every dialog and menu.
pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


def test_a_name_without_ending_is_completed_before_the_question(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    before = (tmp_path / "work.gwb").read_bytes()
    window.open_example("octants")
    drawn = window.session.document
    window.files.save_as()
    asked = type_name(qtbot, window, "work", "No")
    assert len(asked) == 1
    assert "work.gwb" in asked[0]
    assert (tmp_path / "work.gwb").read_bytes() == before
    assert type_name(qtbot, window, "work", "Yes") == asked
    window.session.finish_saving()
    assert load(tmp_path / "work.gwb") == drawn
    assert names(tmp_path) == ["work.gwb"]


@pytest.mark.parametrize(
    ("typed", "name"), [("lab 2.3", "lab 2.3.gwb"), ("new.", "new.gwb"), ("A.GWB", "A.GWB")]
)
def test_a_point_in_a_name_is_no_ending(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, typed: str, name: str
) -> None:
    window.files.save_as()
    assert type_name(qtbot, window, typed) == []
    window.session.finish_saving()
    assert names(tmp_path) == sorted([name, "work.gwb"])


def test_a_completed_name_that_is_there_is_asked_about(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    (tmp_path / "lab 2.3.gwb").write_bytes(b"mine")
    window.files.save_as()
    (question,) = type_name(qtbot, window, "lab 2.3", "No")
    assert "lab 2.3.gwb" in question
    assert (tmp_path / "lab 2.3.gwb").read_bytes() == b"mine"
    dialog_of(qtbot, window).reject()


def test_a_wrong_ending_is_refused_with_those_there_are(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.files.save_as()
    assert type_name(qtbot, window, "work.png") == ["work.png: choose a name that ends in .gwb."]
    dialog_of(qtbot, window).reject()
    trigger(window, "export_step")
    (said,) = type_name(qtbot, window, "step.xyz")
    assert said == "step.xyz: choose a name that ends in .png, .svg or .pdf."
    dialog_of(qtbot, window).reject()
    assert names(tmp_path) == ["work.gwb"]


def test_dialogs_begin_beside_the_document_with_its_name(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    for command, name in (
        ("export_picture", "work.png"),
        ("export_drawing", "work.svg"),
        ("export_step", "work-step.png"),
        ("export_hand", "work-table.csv"),
    ):
        trigger(window, command)
        dialog = dialog_of(qtbot, window)
        assert Path(dialog.selectedFiles()[0]) == tmp_path / name
        dialog.reject()
        qtbot.waitUntil(lambda dialog=dialog: not dialog.isVisible())


def test_without_a_home_dialogs_begin_here(window: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", none)
    window.session.new()
    assert window.files.exports.writing.proposed("run", ".gif") == Path("Untitled-run.gif")


def test_the_ending_follows_the_kind_that_is_chosen(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    trigger(window, "export_step")
    dialog = dialog_of(qtbot, window)
    dialog.selectNameFilter("PDF (*.pdf)")
    dialog.filterSelected.emit("PDF (*.pdf)")
    assert Path(dialog.selectedFiles()[0]) == tmp_path / "work-step.pdf"
    assert type_name(qtbot, window, "mine") == []
    written(qtbot, window)
    assert (tmp_path / "mine.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize("place", ["display", "space"])
def test_a_page_without_canvas_says_where_its_step_can_be_exported(window: MainWindow, place: str) -> None:
    window.go(place)
    trigger(window, "export_step")
    said = window.status.hover.text()
    assert said == "A step is exported with its canvas: go to Draw, Fill, Clip, Transform, View or Curves."
