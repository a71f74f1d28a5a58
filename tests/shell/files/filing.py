"""What a person does with files in the window: draw, save, answer."""

import os
import subprocess
import sys
from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from workbench.shell.window import MainWindow

ROOT = Path(__file__).resolve().parents[3]

CONTROL = Qt.KeyboardModifier.ControlModifier


def draw_a_line(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    qtbot.mouseClick(window.panels("draw")[0], Qt.MouseButton.LeftButton, pos=QPoint(30, 30))
    window.session.flush()


def saved(window: MainWindow) -> None:
    """Wait for the save in the background."""
    window.session.finish_saving()


def answer(window: MainWindow, text: str) -> None:
    next(button for button in window.messages.buttons() if button.text() == text).click()


CRASH = """
import os, sys
from PySide6.QtCore import QCoreApplication
from workbench.document import building
from workbench.document.edits import rename_sheet
from workbench.document.samples.examples import example_document
from workbench.session.session import Session
application = QCoreApplication([])
session = Session(None, example_document())
if sys.argv[1:]:
    session.open(sys.argv[1])
session.start_autosave()
session.apply(rename_sheet(session.sheet.id, "nearly lost"), "Rename")
session._recovery.flush()
os._exit(1)
"""


def crash(*opened: Path) -> None:
    """Let another start of the program change a picture, the one ``opened`` if any, and die."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-c", CRASH, *map(str, opened)], env=environment, timeout=60)
