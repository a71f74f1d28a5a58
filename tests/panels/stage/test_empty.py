"""What an empty canvas says is read whole, also on a narrow or a low one."""

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from workbench.panels.stage.empty import EmptyState

SENTENCE = "Click corners on the canvas to draw a polygon, then give it a transform."


@pytest.mark.parametrize("size", [(765, 450), (444, 325), (300, 200)])
def test_the_sentence_fits_its_canvas(qtbot: QtBot, size: tuple[int, int]) -> None:
    canvas = QWidget()
    qtbot.addWidget(canvas)
    canvas.resize(*size)
    state = EmptyState(canvas, SENTENCE, lambda: None)
    canvas.show()
    state.setVisible(True)
    assert canvas.rect().contains(state.geometry())
    assert state.sentence.height() >= state.sentence.heightForWidth(state.sentence.width())
    assert state.sentence.width() <= size[0]
