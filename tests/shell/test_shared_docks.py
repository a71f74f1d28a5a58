"""What several workspaces show: one widget, which moves into the docks of the one that is entered."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.panels.shared.tube_dock import TubeDock
from workbench.session.session import Session
from workbench.shell.questions import Question, questions
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    window.attach(Session(window, example_document()))
    window.go("draw")
    window.go("fill")
    yield window
    window.close()
    window.deleteLater()


def dock(window: MainWindow, workspace: str, name: str) -> QDockWidget:
    """The dock of this name among those of a workspace."""
    return next(each for each in window.arrangements.docks(workspace) if each.objectName() == name)


def test_both_workspaces_have_the_same_docks_but_for_their_own(window: MainWindow) -> None:
    drawing, filling = (
        {each.objectName() for each in window.arrangements.docks(slug)} for slug in ("draw", "fill")
    )
    assert drawing - filling == {"distance"}
    assert filling - drawing == {"depth"}
    for name in drawing & filling:
        assert dock(window, "draw", name) is not dock(window, "fill", name)
        assert dock(window, "draw", name).widget() is None
        widget = dock(window, "fill", name).widget()
        window.go("draw")
        assert dock(window, "draw", name).widget() is widget
        assert dock(window, "fill", name).widget() is None
        window.go("fill")
        assert dock(window, "fill", name).widget() is widget


@pytest.mark.qt_log_ignore("does not support raise", extend=True)
def test_a_dock_closed_in_one_workspace_stays_open_in_the_other(window: MainWindow) -> None:
    filling, drawing = (dock(window, slug, "hand_table") for slug in ("fill", "draw"))
    filling.close()
    window.go("draw")
    assert drawing.isVisible()
    drawing.setFloating(True)
    window.go("fill")
    assert filling.isHidden()
    assert drawing.isHidden()  # it would float over the wrong workspace
    window.go("draw")
    assert drawing.isVisible()
    assert drawing.isFloating()


def test_a_tube_in_the_middle_of_one_workspace_is_a_dock_in_the_other(
    qtbot: QtBot, window: MainWindow
) -> None:
    filling, drawing = (dock(window, slug, "tube") for slug in ("fill", "draw"))
    middle = window.panels("fill")[0].center
    qtbot.keyClick(window, Qt.Key.Key_T)
    assert filling.widget() is middle
    assert filling.windowTitle() == "Canvas"
    window.go("draw")
    assert isinstance(drawing.widget(), TubeDock)
    assert drawing.windowTitle() == "Tube"
    assert window.panels("draw")[0].center.isVisibleTo(window)
    window.go("home")
    window.go("fill")
    assert filling.widget() is middle
    assert filling.windowTitle() == "Canvas"
    qtbot.keyClick(window, Qt.Key.Key_T)
    assert isinstance(filling.widget(), TubeDock)
    assert middle.isVisibleTo(window)
    qtbot.keyClick(window, Qt.Key.Key_T)
    window.reset_workspace()
    filling = dock(window, "fill", "tube")
    assert isinstance(filling.widget(), TubeDock)
    assert middle.isVisibleTo(window)


def test_each_workspace_keeps_its_place(qtbot: QtBot, window: MainWindow) -> None:
    session = window.session

    def stands(slug: str, step: int) -> None:
        """Wait until this entry is run, and its cursor is at this step."""
        session.flush()
        qtbot.waitUntil(lambda: session.run.entry.slug == slug and session.run.done, timeout=20_000)
        assert session.run.position == session.state.step == step

    window.open_example("clip")
    session.update_state(active=session.sheet.figures[0].id)
    stands("cohen_sutherland", 0)
    session.run.go(1)
    window.go("draw")
    stands("bresenham_line", 0)
    session.run.go(6)
    window.go("display")
    window.go("clip")
    stands("cohen_sutherland", 1)
    window.go("draw")
    stands("bresenham_line", 6)


OFFERED = questions()


@pytest.mark.parametrize("question", OFFERED, ids=lambda question: question.example)
def test_a_question_opens_at_its_step_from_any_workspace(
    qtbot: QtBot, window: MainWindow, question: Question
) -> None:
    window.open_question(question)
    assert window.place == question.workspace
    window.session.flush()
    qtbot.waitUntil(lambda: window.session.run.done, timeout=20_000)
    assert window.session.run.number == window.session.state.step == question.step
