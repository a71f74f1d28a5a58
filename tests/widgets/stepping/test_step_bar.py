"""The step bar keeps room for what it shows."""

from itertools import pairwise

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from workbench.session.run import Run
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.stepping.step_bar import StepBar


@pytest.mark.parametrize("total", [17, 123_456, 1_234_567, 987_654_321])
def test_a_step_number_of_any_length_has_room(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, total: int
) -> None:
    monkeypatch.setattr(Run, "total_text", f"{total}+")
    bar = StepBar(Run())
    qtbot.addWidget(bar)
    bar.resize(1200, 80)
    bar.show()
    qtbot.waitExposed(bar)
    field, text = bar.jump, str(total)
    field.setText(text)
    field.end(False)
    end = field.cursorRect().center().x()
    field.home(False)  # in a field that is too narrow this scrolls the text
    assert end - field.cursorRect().center().x() >= field.fontMetrics().horizontalAdvance(text) - 1


def test_the_button_that_plays_is_called_what_it_does_now(qtbot: QtBot) -> None:
    run = Run()
    bar = StepBar(run)
    qtbot.addWidget(bar)
    (button,) = (each for each in bar.findChildren(ActionButton) if each.action is bar.play)
    for playing, words in ((True, "Pause"), (False, "Play")):
        run.played.emit(playing)
        assert button.accessibleName() == words


def test_in_the_narrowest_window_nothing_lies_on_anything_or_is_squeezed(qtbot: QtBot) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    bar = StepBar(Run(), window)
    bar.setGeometry(0, 0, 640, 44)
    with qtbot.waitExposed(window):
        window.show()

    def seen() -> list[QWidget]:
        return [each for each in bar.children() if isinstance(each, QWidget) and each.isVisible()]

    assert all(each.width() >= each.minimumSizeHint().width() for each in seen())
    places = sorted((each.geometry() for each in seen()), key=lambda place: place.left())
    assert all(one.right() < other.left() for one, other in pairwise(places))
    few = len(seen())
    bar.setGeometry(0, 0, 960, 44)
    assert len(seen()) == few + 2  # with the buttons that lead to either end
