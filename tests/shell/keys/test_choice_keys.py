"""In a closed list of choices a letter chooses; what steps stays the window's."""

from collections.abc import Iterator

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox

from tests.shell.keys.focus import press, settle, work_in
from workbench.shell.window import MainWindow


@pytest.fixture
def each_letter_begins_anew() -> Iterator[None]:
    interval = QApplication.keyboardInputInterval()
    QApplication.setKeyboardInputInterval(0)
    yield
    QApplication.setKeyboardInputInterval(interval)


@pytest.mark.usefixtures("each_letter_begins_anew")
def test_a_letter_at_a_list_of_choices_chooses_there(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in(window, "draw")
    done: list[str] = []
    monkeypatch.setattr(window, "do", lambda command: done.append(command.id))
    box = QComboBox(window)
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
    box.deleteLater()
