"""Why this pixel: asked with a key or on the tube, answered in a list that leads to the step."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import keep_until_the_end
from workbench.algorithms.marks import Word
from workbench.document.edits import remove_figures
from workbench.document.samples.examples import example
from workbench.panels.fill.panel import FillPanel
from workbench.panels.shared.tube_dock import TubeDock
from workbench.panels.shared.why import WhyPanel
from workbench.rendering import painter_of
from workbench.session.session import Session


@pytest.fixture
def missed(qtbot):
    session = Session(document=example("missed").document)
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 620)
    panel.show()
    why = WhyPanel(session).why
    qtbot.addWidget(why)
    why.resize(360, 400)
    why.show()
    panel.activateWindow()
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=10000)
    QApplication.processEvents()
    return session, panel, why


def asked(qtbot, why):
    qtbot.waitUntil(lambda: not why.looking, timeout=10000)


def test_nothing_is_asked_at_first_and_that_is_said(missed):
    _session, _panel, why = missed
    assert "press Y" in why.caption.text()
    assert why.list.count() == 0


def test_a_key_at_the_pointer_asks_and_a_click_goes_to_the_step(qtbot, missed):
    session, panel, why = missed
    panel.canvas.setFocus()
    qtbot.mouseMove(panel.canvas, panel.canvas.widget_position(8, 6).toPoint())
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Y)
    assert session.state.pixel == (8, 6)
    qtbot.wait(200)
    asked(qtbot, why)
    verbs = [answer.verb for answer in why.answers]
    assert verbs.count("wrote") == 1
    assert verbs.count("refused") == 3
    stands = next(k for k, answer in enumerate(why.answers) if answer.stands)
    assert "its colour remains" in why.list.item(stands).text()
    assert session.sheet.figures[why.answers[stands].figure].id == why.answers[stands].figure_id
    why.list.itemClicked.emit(why.list.item(stands))
    qtbot.waitUntil(lambda: session.run.position == why.answers[stands].step)
    assert (8, 6) in session.run.step.chosen
    assert any(isinstance(mark, Word) and mark.text == "?" for mark in panel.canvas.overlay.drawn)


def test_the_keyboards_cursor_asks_too(qtbot, missed):
    session, panel, _why = missed
    panel.canvas.setFocus()
    qtbot.keyClick(panel.canvas, Qt.Key.Key_C)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Left)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Y)
    assert session.state.pixel == panel.canvas.cursor_cell


def test_what_nothing_touched_is_answered(qtbot, missed):
    session, _panel, why = missed
    session.update_state(pixel=(19, 1))
    session.flush()
    qtbot.wait(200)
    asked(qtbot, why)
    assert why.answers == []
    assert "No figure came near (19, 1)" in why.caption.text()


def test_an_edit_asks_anew(qtbot, missed):
    session, _panel, why = missed
    session.update_state(pixel=(8, 6))
    qtbot.wait(200)
    asked(qtbot, why)
    assert why.answers
    session.apply(remove_figures([session.sheet.figures[-1].id]), "Delete")
    session.flush()
    assert not why.list.isEnabled()
    asked(qtbot, why)
    assert int(painter_of(session.sheet)[6, 8]) == -1
    assert not any(answer.verb == "wrote" for answer in why.answers)


def test_a_click_on_the_tube_asks(qtbot):
    session = Session(document=example("missed").document)
    tube = TubeDock(session)
    qtbot.addWidget(tube)
    tube.raster.probed.emit(5, 6)
    assert session.state.pixel == (5, 6)
