"""Long pictures are read, pasted and recovered beside the interface."""

import threading
from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.shell.files.filing import CONTROL, answer, crash, draw_a_line
from workbench.document import building
from workbench.document.model import Document, Polyline, WorldPoint
from workbench.document.samples.examples import example_document
from workbench.document.storage.files import save
from workbench.engine import background
from workbench.shell.window import MainWindow

pytestmark = [
    # The offscreen platform says so of every dialog and menu.
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.xdist_group("processes"),
]


def long_picture(path: Path) -> Document:
    """A picture that is too long to be read at once."""
    points = tuple(WorldPoint(f"q{k}x", k % 30, k % 20) for k in range(2_000))
    sheet = replace(example_document().sheets[0], figures=(Polyline("long", points, "dda_line"),))
    document = replace(example_document(), sheets=(sheet,))
    save(document, path)
    return document


def test_a_long_picture_is_read_beside_and_says_how_far_it_is(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    document = long_picture(chosen)
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.document is before
    assert window.messages.text.startswith("Reading my lines.gwb ... ")
    assert [button.text() for button in window.messages.buttons()] == ["Cancel"]
    qtbot.waitUntil(lambda: window.session.path == chosen, timeout=30_000)
    assert window.session.document == document
    assert window.messages.text == ""
    assert not window.session.dirty
    assert not window.session.changed_on_disk
    assert window.settings.recent() == [chosen.resolve()]


@pytest.mark.parametrize("how", ["button", "escape", "new"])
def test_a_reading_can_be_cancelled(qtbot: QtBot, window: MainWindow, chosen: Path, how: str) -> None:
    long_picture(chosen)
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.incoming.busy
    if how == "button":
        answer(window, "Cancel")
    elif how == "escape":
        qtbot.keyClick(window.messages, Qt.Key.Key_Escape)
    else:
        qtbot.keyClick(window, "N", CONTROL)
        before = window.session.document
    assert not window.session.incoming.busy
    assert window.messages.text == ""
    assert background.end_all()
    QApplication.processEvents()
    assert window.session.document is before
    assert window.session.path is None


def test_what_is_drawn_while_a_picture_is_read_is_asked_about(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    document = long_picture(chosen)
    qtbot.keyClick(window, "O", CONTROL)
    draw_a_line(qtbot, window)
    drawn = window.session.document
    qtbot.waitUntil(lambda: "unsaved changes" in window.messages.text, timeout=30_000)
    assert window.session.document is drawn
    answer(window, "Discard changes")
    assert window.session.document == document


def test_a_long_picture_that_is_broken_is_refused(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    long_picture(chosen)
    chosen.write_bytes(chosen.read_bytes()[:-40])
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    qtbot.waitUntil(lambda: "was not opened" in window.messages.text, timeout=30_000)
    assert "breaks off at line" in window.messages.text
    assert window.session.document is before


def other_threads(monkeypatch: pytest.MonkeyPatch, module: object, name: str) -> list[bool]:
    """For each call of a function from now on, whether it is on a thread beside the interface."""
    real, beside = getattr(module, name), []

    def watched(*given: object) -> object:
        beside.append(threading.current_thread() is not threading.main_thread())
        return real(*given)

    monkeypatch.setattr(module, name, watched)
    return beside


def test_the_sheets_of_a_long_picture_are_put_in_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = long_picture(chosen)
    beside = other_threads(monkeypatch, building, "foreseen")
    window.files.bring_in()
    qtbot.waitUntil(lambda: len(window.session.document.sheets) == 2, timeout=30_000)
    assert beside == [True]
    points = [(point.x, point.y) for point in window.session.sheet.figures[0].points_world]
    assert points == [(point.x, point.y) for point in document.sheets[0].figures[0].points_world]


def test_many_figures_are_pasted_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbench.panels.stage import clipboard

    session, said = window.session, []
    (figure,) = long_picture(chosen).sheets[0].figures
    beside = other_threads(monkeypatch, clipboard, "foreseen")
    clipboard.copy_figures(session.sheet, [figure])
    for _time in range(2):
        before = session.document
        clipboard.paste_figures(session, said.append)
        assert session.document is before
        qtbot.waitUntil(lambda: not session.incoming.busy, timeout=30_000)
    assert beside == [True, True]
    assert said == ["1 figure pasted.", "1 figure pasted."]
    first, second = session.sheet.figures[-2:]
    assert session.state.selection == (second.id,)
    shifts = {(b.x - a.x, b.y - a.y) for a, b in zip(first.points_world, second.points_world, strict=True)}
    assert shifts == {(1, -1)}
    clipboard.paste_figures(session, said.append)
    session.open_example("line")
    qtbot.waitUntil(lambda: not session.incoming.busy, timeout=30_000)
    assert said[2:] == ["Another sheet was opened before the figures were pasted; paste them again here."]
    QApplication.clipboard().clear()


def test_long_work_is_recovered_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, tmp_path: Path
) -> None:
    document = long_picture(chosen)
    crash(chosen)
    before = window.session.document
    window.session.start_autosave()
    window.files.offer_recovery()
    answer(window, "Recover")
    assert window.session.document is before
    qtbot.waitUntil(lambda: window.session.document is not before, timeout=30_000)
    assert window.session.sheet.figures == document.sheets[0].figures
    assert window.session.dirty
    assert window.session._recovery.flush()
    window.files.offer_recovery()
    assert window.messages.text == ""
