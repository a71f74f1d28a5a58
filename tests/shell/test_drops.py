"""Files dropped on the window, as another program sends them."""

import gc
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from workbench.document import save
from workbench.document.model import Curve
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.document.sheet_edits import add_sheet, rename_sheet
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow

MOVE, COPY = Qt.DropAction.MoveAction, Qt.DropAction.CopyAction
LEFT, PLAIN = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 48"><path d="M8 8C20 40 40 40 56 8"/></svg>'


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    window.attach(Session(window, example_document()))
    window.go("draw")
    qtbot.waitExposed(window)
    yield window
    leave(window)


def drop(window: MainWindow, *paths: Path) -> bool:
    """Drag files over the middle of the window and let go of them; whether the window took them."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    place = window.rect().center()
    under = window.childAt(place)
    assert under is not None
    spot = under.mapFrom(window, place)
    entered = QDragEnterEvent(spot, MOVE | COPY, data, LEFT, PLAIN)
    entered.ignore()
    QApplication.sendEvent(under, entered)
    if not entered.isAccepted():
        return False
    # A file that were moved would be gone from where it was.
    assert entered.dropAction() == COPY
    dropped = QDropEvent(QPoint(place), MOVE | COPY, data, LEFT, PLAIN)
    dropped.ignore()
    QApplication.sendEvent(window, dropped)
    assert dropped.isAccepted()
    assert dropped.dropAction() == COPY
    QApplication.processEvents()
    return True


def is_error(window: MainWindow) -> bool:
    return "Error" in [each.accessibleName() for each in window.messages.findChildren(QWidget)]


def curves(window: MainWindow) -> list[Curve]:
    return [figure for figure in window.session.sheet.figures if isinstance(figure, Curve)]


@pytest.mark.parametrize("ending", [".gwb", ".GWB"])
def test_a_picture_is_opened_once_unsaved_changes_are_settled(
    window: MainWindow, tmp_path: Path, ending: str
) -> None:
    path = tmp_path / f"lines{ending}"
    save(example_document(), path)
    session = window.session
    session.apply(rename_sheet(session.sheet.id, "Mine"), "Rename")
    assert drop(window, path)
    assert session.sheet.name == "Mine"
    next(
        each for each in window.messages.findChildren(QPushButton) if each.text() == "Discard changes"
    ).click()
    assert session.path == path
    assert session.sheet.name != "Mine"


@pytest.mark.parametrize("place", ["home", "draw", "curves"])
def test_a_drawing_comes_into_curves(window: MainWindow, tmp_path: Path, place: str) -> None:
    window.go(place)
    path = tmp_path / "wave.svg"
    path.write_text(SVG)
    before = window.session.sheet.figures
    assert drop(window, path)
    assert window.place == "curves"
    (curve,) = curves(window)
    assert curve.spline == "bezier_path"
    assert "wave.svg: 2 figures imported" in window.messages.text
    window.undo()
    assert window.session.sheet.figures == before
    assert window.messages.text == ""


def test_redo_shows_a_mesh_again_and_undo_takes_back_what_was_said_of_it(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    path = tmp_path / "part.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    control = Qt.KeyboardModifier.ControlModifier
    assert drop(window, path)
    assert window.session.sheet.scene is not None
    mesh = window.session.sheet.id
    assert drop(window, path)  # now beside the first
    assert window.messages.text == "part.obj is in the scene."
    qtbot.keyClick(window, Qt.Key.Key_Z, control)
    assert window.messages.text == ""
    assert window.session.sheet.id == mesh
    qtbot.keyClick(window, Qt.Key.Key_Z, control)
    assert window.session.sheet.scene is None
    qtbot.keyClick(window, Qt.Key.Key_Y, control)
    assert window.session.sheet.id == mesh


def test_undo_of_something_else_leaves_what_was_said(window: MainWindow, tmp_path: Path) -> None:
    session = window.session
    (tmp_path / "points.csv").write_text("1,2\n30,20\n")
    assert drop(window, tmp_path / "points.csv")
    said = window.messages.text
    session.apply(rename_sheet(session.sheet.id, "Mine"), "Rename")
    window.undo()
    assert window.messages.text == said != ""
    window.undo()
    assert window.messages.text == ""


def test_what_was_said_of_a_step_does_not_keep_its_documents(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    session = window.session
    (tmp_path / "points.csv").write_text("1,2\n30,20\n")
    assert drop(window, tmp_path / "points.csv")
    session.apply(rename_sheet(session.sheet.id, "Mine"), "Rename")
    last = session.undo_stack.last
    assert last is not None
    document = last.old  # which the step that something was said of led to
    del last
    session.new()

    def let_go() -> bool:
        gc.collect()
        return sys.getrefcount(document) == 2  # here, and by the call

    qtbot.waitUntil(let_go, timeout=10000)


@pytest.mark.parametrize("name", ["points.csv", "points.TXT"])
def test_a_list_of_points_becomes_a_curve(window: MainWindow, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"x,y\r\n1,2\r\n30,20\r\n50,4\r\n")
    assert drop(window, tmp_path / name)
    (curve,) = curves(window)
    assert [(p.x, p.y) for p in curve.points_world] == [(1, 2), (30, 20), (50, 4)]


def test_what_is_wrong_with_a_dropped_file_is_said_as_an_error(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    before = window.session.document
    for name, content, said in (
        ("a.svg", "<svg", "XML"),
        ("bare.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>', "bare.svg: This SVG contains no figures"),
        ("words.svg", '<svg xmlns="http://www.w3.org/2000/svg"><text>A</text></svg>', "words.svg: "),
        ("many.csv", "1,2\n" * 10_001, "many.csv: The list of points has 10,001"),
        ("b.csv", "1;2\n3;four", "2"),
        ("c.csv", None, "c.csv"),
        ("d.obj", "v 0 0\nf 1 2 9\n", "d.obj was not imported"),
        ("e.gwb", "{", "e.gwb was not opened"),
    ):
        if content is not None:
            (tmp_path / name).write_text(content)
        window.messages.dismiss()
        assert drop(window, tmp_path / name)
        qtbot.waitUntil(lambda said=said: said in window.messages.text)
        assert is_error(window)
    assert window.session.document is before


def test_undo_of_something_else_leaves_why_a_drawing_did_not_come_in(
    window: MainWindow, tmp_path: Path
) -> None:
    window.session.apply(rename_sheet(window.session.sheet.id, "Mine"), "Rename")
    (tmp_path / "bare.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    assert drop(window, tmp_path / "bare.svg")
    said = window.messages.text
    window.undo()
    assert window.messages.text == said != ""


def test_a_drawing_that_was_read_for_another_sheet_is_an_error(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    session = window.session
    session.apply(add_sheet(blank_sheet(64, 48, "Other").sheets[0]), "New sheet")
    path = tmp_path / "long.svg"
    path.write_text(SVG.replace("</svg>", '<path d="M8 8C20 40 40 40 56 8"/>' * 2000 + "</svg>"))
    assert drop(window, path)
    assert session.incoming.busy
    session.show_sheet(session.document.sheets[-1].id)
    qtbot.waitUntil(lambda: not session.incoming.busy, timeout=15000)
    assert "long.svg: Another sheet was opened" in window.messages.text
    assert is_error(window)


@pytest.mark.parametrize(
    ("size", "said"), [((64, 48), ""), ((640, 200), " Scaled to 10 % to fit the sheet.")]
)
def test_how_a_drawing_of_another_size_was_scaled_is_said(
    window: MainWindow, tmp_path: Path, size: tuple[int, int], said: str
) -> None:
    width, height = size
    path = tmp_path / "line.svg"
    line = f'<line x2="{width}" y2="{height}" fill="none" stroke="red"/>'
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">{line}</svg>')
    session = window.session
    session.apply(add_sheet(blank_sheet(64, 48, "Other").sheets[0]), "New sheet")
    session.show_sheet(session.document.sheets[-1].id)
    assert drop(window, path)
    (figure,) = session.sheet.figures
    left, right = (point.x for point in figure.points_world)
    assert right - left == pytest.approx(64)
    assert window.messages.text == f"line.svg: 1 figure imported.{said}"


def test_anything_else_is_not_taken_and_that_is_said(window: MainWindow, tmp_path: Path) -> None:
    before = window.session.document
    for paths in ([tmp_path / "photo.png"], [tmp_path / "a.svg", tmp_path / "b.svg"], [tmp_path]):
        window.status.hover.clear()
        assert not drop(window, *paths)
        assert "Drop one file" in window.status.hover.text()
    assert window.session.document is before
