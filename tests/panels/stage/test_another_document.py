"""A gesture ends with the sheet it was begun on, and a run is shown on a picture of its own size alone."""

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import at, keep_until_the_end, settle
from workbench.document.edits import add_sheet, set_attributes
from workbench.document.samples.examples import blank_sheet, example
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.session.session import Session

CORNERS = ((12, 3), (24, 4))
TOOLS = {DrawPanel: "polyline", FillPanel: "polygon", CurvesPanel: "pen"}


def drawing(qtbot: QtBot, kind: type[QWidget]) -> QWidget:
    """A panel on which two corners were clicked."""
    panel = kind(Session(document=blank_sheet(30, 24)))  # type: ignore[call-arg]
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 620)
    panel.show()
    qtbot.waitExposed(panel)
    panel.choose_tool(TOOLS[kind])
    for x, y in CORNERS:
        qtbot.mouseMove(panel.canvas, at(panel, x, y))
        qtbot.mouseClick(panel.canvas, Qt.MouseButton.LeftButton, pos=at(panel, x, y))
        settle()
    assert panel.gesturing
    return panel


@pytest.mark.parametrize("kind", TOOLS)
@pytest.mark.parametrize("other", ["document", "sheet"])
def test_what_was_begun_ends_with_its_sheet_and_the_new_one_is_stepped(
    qtbot: QtBot, kind: type[QWidget], other: str
) -> None:
    panel = drawing(qtbot, kind)
    session = panel.session
    if other == "document":
        session.new(example("missed").document)
    else:
        session.apply(add_sheet(example("missed").document.sheets[0]), "Open")
        session.show_sheet(session.document.sheets[-1].id)
    settle()
    assert not panel.gesturing
    figures = session.sheet.figures
    assert len(figures) == len(example("missed").document.sheets[0].figures)
    session.update_state(active=figures[-1].id)
    qtbot.waitUntil(lambda: session.run.subject is not None and session.run.done, timeout=15_000)
    assert session.run.subject.ids == (figures[-1].id,)
    session.close()


def test_a_panel_that_is_left_in_the_middle_holds_no_run(qtbot: QtBot) -> None:
    panel = drawing(qtbot, DrawPanel)
    session = panel.session
    panel.hide()
    figures = example("missed").document.sheets[0].figures
    session.apply(
        lambda document: replace(document, sheets=(replace(session.sheet, figures=figures),)), "Draw"
    )
    settle()
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=15_000)
    session.close()


def test_a_run_of_another_size_is_not_laid_over_the_picture(qtbot: QtBot) -> None:
    session = Session(document=example("missed").document)
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.show()
    session.update_state(active=session.sheet.figures[-1].id)
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=15_000)
    panel.card.heat.setChecked(True)
    session.run.last()
    settle()
    qtbot.waitUntil(lambda: len(panel.view._tested or ()) >= len(session.run.steps), timeout=20_000)
    sheet = session.sheet
    session.hold_runs(True)
    session.apply(set_attributes({f"{sheet.id}/width_px": sheet.width_px - 1}), "Width")
    settle()
    assert session.run.image_size == (sheet.width_px, sheet.height_px)
    assert panel.view.stepped_run() is None
    assert panel.canvas.picture.size == (sheet.width_px - 1, sheet.height_px)
    session.hold_runs(False)
    qtbot.waitUntil(lambda: panel.view.stepped_run() is session.run, timeout=15_000)
    session.close()
