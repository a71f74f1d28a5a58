"""The step bar keeps room for what it shows."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.session.run import Run
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
