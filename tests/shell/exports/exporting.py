"""What a person does to export something."""

from pathlib import Path

from pytestqt.qtbot import QtBot

from workbench.shell.window import MainWindow

BLUE = (0x00, 0x72, 0xB2)


def recorded(qtbot: QtBot, window: MainWindow) -> None:
    run = window.session.run
    window.session.flush()
    qtbot.waitUntil(lambda: run.entry is not None and run.done, timeout=10_000)


def trigger(window: MainWindow, name: str) -> None:
    window.menus.actions[name].trigger()


def written(qtbot: QtBot, window: MainWindow) -> str:
    """Wait until it is written; what is said then."""
    qtbot.waitUntil(lambda: not window.files.exports.writing.writer.busy, timeout=20_000)
    return window.messages.text


def names(folder: Path) -> list[str]:
    return sorted(each.name for each in folder.iterdir())
