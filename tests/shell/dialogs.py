"""A person at the program's own dialogs: types a name, answers the question about a file that is there."""

from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QLineEdit, QMessageBox
from pytestqt.qtbot import QtBot

from workbench.shell.window import MainWindow
from workbench.widgets.fields.save_dialog import SaveDialog


def dialog_of(qtbot: QtBot, window: MainWindow) -> SaveDialog:
    """The dialog that asks for a name."""
    qtbot.waitUntil(lambda: any(each.isVisible() for each in window.findChildren(SaveDialog)))
    return next(each for each in window.findChildren(SaveDialog) if each.isVisible())


def type_name(qtbot: QtBot, window: MainWindow, name: str | Path, answer: str = "") -> list[str]:
    """Type ``name`` and press Enter; the questions that came up, each answered by the button ``answer``."""
    dialog = dialog_of(qtbot, window)
    field = dialog.findChild(QLineEdit, "fileNameEdit")
    assert field is not None
    qtbot.waitUntil(lambda: field.hasFocus() or bool(dialog.activateWindow()) or bool(field.setFocus()))
    field.clear()
    if str(name).isascii() and str(name).isprintable():
        qtbot.keyClicks(field, str(name))
    else:
        field.insert(str(name))  # as it is pasted
    QApplication.processEvents()
    asked: list[str] = []

    def look() -> None:
        box = QApplication.activeModalWidget()
        if isinstance(box, QMessageBox):
            asked.append(box.text())
            wanted = [each for each in box.buttons() if each.text().replace("&", "") == answer]
            (wanted or [box.buttons()[-1]])[0].click()

    watch = QTimer()
    watch.timeout.connect(look)
    watch.start(20)
    buttons = dialog.findChild(QDialogButtonBox, "buttonBox")
    assert buttons is not None
    qtbot.mouseClick(buttons.button(QDialogButtonBox.StandardButton.Save), Qt.MouseButton.LeftButton)
    watch.stop()
    return asked
