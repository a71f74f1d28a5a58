"""The places of the window that can have the focus, and what is pressed there."""

from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from workbench.document.edits import move_figures
from workbench.shell.actions import commands
from workbench.shell.window import MainWindow

EXAMPLES = {"draw": "line", "fill": "triangle", "clip": "clip", "curves": "curve-interpolation"}


def settle() -> None:
    for _turn in range(5):
        QApplication.processEvents()


def work_in(window: MainWindow, place: str) -> None:
    """Open the example of a workspace and edit it twice, so that undo and redo are able."""
    session = window.session
    session.undo_stack.setClean()
    window.open_example(EXAMPLES.get(place, "line"))
    window.go(place)
    session.update_state(selection=())
    settle()
    figure = session.sheet.figures[0].id
    session.apply(move_figures([figure], 1, 0), "Move")
    session.apply(move_figures([figure], 1, 0), "Move")
    session.undo_stack.undo()
    settle()
    session.run.last()
    settle()
    for command in commands():
        if command.needs == "answer":  # as after a wrong answer, which not every place asks for
            window.menus.actions[command.id].setEnabled(True)


def press(widget: QWidget, key: str) -> None:
    combination = QKeySequence(key)[0]
    QTest.keyClick(widget, combination.key(), combination.keyboardModifiers())
