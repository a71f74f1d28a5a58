"""What the sentence names is pointed at: its pixels on the canvas, its variables in their table."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.shared.inspector import InspectorPanel
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    session = Session(window, example_document())
    window.attach(session)
    window.go("draw")
    qtbot.waitUntil(lambda: session.run.done and session.run.step is not None, timeout=10_000)
    session.run.go(2)
    yield window
    window.close()
    window.deleteLater()


def parts(window: MainWindow) -> tuple[DrawPanel, InspectorPanel]:
    draw = next(panel for panel in window.panels("draw") if isinstance(panel, DrawPanel))
    inspector = next(panel for panel in window.panels("draw") if isinstance(panel, InspectorPanel))
    return draw, inspector


def link(sentence: QLabel, kind: str) -> str:
    """The target of the first link to a pixel or a variable in the sentence."""
    return next(
        str(number)
        for number, part in enumerate(sentence._parts)
        if part.link is not None and part.link[0] == kind
    )


def test_a_pixel_of_the_sentence_is_ringed_on_the_canvas(qtbot: QtBot, window: MainWindow) -> None:
    draw, inspector = parts(window)
    sentence = inspector.step_bar.sentence
    pixel = sentence._parts[int(link(sentence, "pixel"))].link[1]
    for _ in range(6):
        draw.canvas.zoom(1, draw.canvas.widget_position(0, 0))
    assert not seen(draw, pixel)
    sentence.linkActivated.emit(link(sentence, "pixel"))
    assert draw.canvas.pointed == pixel
    assert seen(draw, pixel)
    assert window.session.run.position == 2
    sentence.linkHovered.emit("")
    assert draw.canvas.pointed == pixel
    qtbot.keyClick(draw.canvas, Qt.Key.Key_Period)
    window.session.run.forward()
    assert draw.canvas.pointed is None


def test_a_pixel_pointed_at_in_passing_is_let_go(window: MainWindow) -> None:
    draw, inspector = parts(window)
    sentence = inspector.step_bar.sentence
    sentence.linkHovered.emit(link(sentence, "pixel"))
    assert draw.canvas.pointed is not None
    sentence.linkHovered.emit("")
    assert draw.canvas.pointed is None


def test_a_variable_of_the_sentence_is_shown_in_its_table(window: MainWindow) -> None:
    _draw, inspector = parts(window)
    sentence = inspector.step_bar.sentence
    name = sentence._parts[int(link(sentence, "variable"))].link[1]
    source = next(d for d in window.arrangements.docks("draw") if d.objectName() == "source")
    source.raise_()
    sentence.linkActivated.emit(link(sentence, "variable"))
    row = inspector.variables.view.selectionModel().selectedRows()[0].row()
    assert inspector.variables.model.names[row] == name
    assert inspector.variables.isVisible()


def seen(draw: DrawPanel, cell: tuple[int, int]) -> bool:
    """Whether the middle of a cell lies in what the canvas shows."""
    area = draw.canvas.area
    left, top, side = draw.canvas.view.cell_box(*cell)
    return area.left <= left + side / 2 <= area.right and area.top <= top + side / 2 <= area.bottom
