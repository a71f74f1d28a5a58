"""What is said in the status bar is read whole, or its end is cut visibly and said when pointed at."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget
from pytestqt.qtbot import QtBot

from workbench.panels.panel import PlainPanel, Said
from workbench.shell.status import Status

SHORT = "(12, 34) Line"
LONG = "Line 1, column 1, <path>: command 3 of the path is wrong: Q needs 4 numbers, and 1 is there."


class Bar:
    def __init__(self, qtbot: QtBot) -> None:
        self.window = QMainWindow()
        qtbot.addWidget(self.window)
        self.status = Status(self.window.statusBar())
        self.status.run.setText("Scan-line fill by crossings, step 1 of 7")
        self.status.zoom.setText("3100 %")
        self.status.preparing("")
        self.window.resize(960, 200)
        self.window.show()
        self.settle()

    def settle(self) -> None:
        QApplication.processEvents()
        QApplication.processEvents()


@pytest.fixture
def bar(qtbot: QtBot) -> Iterator[Bar]:
    made = Bar(qtbot)
    yield made
    made.window.close()


def test_a_long_sentence_takes_the_room_of_the_run_while_it_is_there(bar: Bar) -> None:
    hover, run = bar.status.hover, bar.status.run
    bar.status.show_hover(SHORT)
    bar.settle()
    beside = run.width()
    assert beside > 0
    bar.status.say(LONG)
    bar.settle()
    assert hover.fontMetrics().horizontalAdvance(LONG) <= hover.contentsRect().width()
    assert hover.toolTip() == ""
    bar.status.show_hover(SHORT)
    bar.settle()
    assert run.width() == beside


def test_what_does_not_fit_is_cut_visibly_and_said_when_pointed_at(bar: Bar) -> None:
    hover, twice = bar.status.hover, f"{LONG} {LONG}"
    bar.status.say(twice)
    bar.settle()
    assert hover.toolTip() == f"<qt>{twice}</qt>".replace("<path>", "&lt;path&gt;")
    cut = hover.grab().toImage()
    bar.status.say(hover.fontMetrics().elidedText(twice, Qt.TextElideMode.ElideRight, hover.width()))
    bar.settle()
    assert hover.grab().toImage() == cut
    bar.window.resize(2400, 200)
    bar.settle()
    assert hover.toolTip() == ""


def test_a_place_without_steps_starts_with_nothing_said(bar: Bar) -> None:
    bar.status.say(LONG)
    bar.status.in_workspace(False)
    bar.status.in_workspace(True)
    bar.settle()
    assert bar.status.hover.text() == ""
    assert bar.status.run.width() > 0


class Zoomed(PlainPanel, QWidget):
    """The middle of a workspace that says how far it is zoomed."""

    zoom_text = Signal(str)

    @property
    def center(self) -> QWidget:
        return self

    def said(self) -> Said:
        return Said(None, self.zoom_text)


def test_the_zoom_is_that_of_the_workspace(bar: Bar, qtbot: QtBot) -> None:
    panels = Zoomed(), Zoomed(), Zoomed()
    for panel, text in zip(panels, ("100 %", "7 px", ""), strict=True):
        qtbot.addWidget(panel)
        bar.status.listen(panel)
        if text:
            panel.zoom_text.emit(text)  # of a panel out of sight, which is not yet to be read
    assert bar.status.zoom.text() == "3100 %"
    for panel, text in zip(panels, ("100 %", "7 px", ""), strict=True):
        bar.status.in_workspace(True, [panel])
        assert bar.status.zoom.text() == text
    bar.status.in_workspace(False)
    assert bar.status.zoom.text() == ""
