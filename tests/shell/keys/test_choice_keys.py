"""In a closed list of choices a letter chooses; what steps stays the window's."""

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox

from tests.shell.keys.focus import press, settle, work_in
from workbench.shell.window import MainWindow


def test_a_letter_at_a_list_of_choices_chooses_there(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in(window, "draw")
    done: list[str] = []
    interval = QApplication.keyboardInputInterval()
    monkeypatch.setattr(window, "do", lambda command: done.append(command.id))
    box = QComboBox(window)
    QApplication.setKeyboardInputInterval(0)  # each letter begins anew
    box.addItems(["Dutch", "Aleph", "2 bits", "Tube"])
    box.show()
    box.setFocus()
    settle()
    assert box.hasFocus()
    for letter in "DaT2":
        box.setCurrentIndex(0)
        QTest.keyClick(box, letter)
        assert box.currentText()[0].lower() == letter.lower()
        assert done == []
        QTest.qWait(2)
    press(box, ".")
    press(box, "Ctrl+K")
    assert done == ["forward", "palette"]
    QApplication.setKeyboardInputInterval(interval)
    box.deleteLater()
