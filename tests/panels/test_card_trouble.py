"""What is too far away to be drawn is said in the card."""

from collections.abc import Iterator

import pytest
from msgspec.structs import replace
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.document.edits import add_figure, set_attribute
from workbench.document.model import AnyFigure, Circle, Ellipse, SeedFill, WorldPoint
from workbench.document.samples import blank_sheet
from workbench.panels.draw import DrawPanel
from workbench.rendering import REACH_PX, figure_calls
from workbench.session.session import Session

PLACE = (WorldPoint("p1", 10, 10),)
FIGURES = (
    Circle("f1", PLACE, "midpoint_circle", 1, radius_world=5.0),
    Ellipse("f1", PLACE, "midpoint_ellipse", 1, radius_x_world=5.0, radius_y_world=4.0),
    SeedFill("f1", PLACE, "boundary_fill_4", 1),
)


@pytest.fixture
def panel(qtbot: QtBot) -> Iterator[DrawPanel]:
    session = Session(document=blank_sheet(64, 48))
    panel = DrawPanel(session)
    qtbot.addWidget(panel)
    panel.show()
    yield panel
    session.close()


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: type(figure).__name__)
def test_what_is_beyond_reach_is_said(panel: DrawPanel, figure: AnyFigure) -> None:
    session = panel.session
    sheet = session.sheet
    session.apply(add_figure(sheet.id, figure), "Draw")
    session.update_state(selection=("f1",), active="f1")
    QApplication.processEvents()
    QApplication.processEvents()
    assert panel.card.trouble.isHidden()
    field = "radius_world" if isinstance(figure, Circle) else "p1/x"
    session.apply(set_attribute(f"{sheet.id}/f1/{field}", REACH_PX + 3_616.0), "Change value")
    QApplication.processEvents()
    QApplication.processEvents()
    assert not panel.card.trouble.isHidden()
    assert "20,000" in panel.card.trouble.text()
    assert "16,384" in panel.card.trouble.text()
    if not isinstance(figure, SeedFill):
        assert figure_calls(session.sheet, session.sheet.figures[0]) == []


def test_what_is_just_within_reach_is_drawn(panel: DrawPanel) -> None:
    session = panel.session
    circle = replace(FIGURES[0], radius_world=float(REACH_PX))
    session.apply(add_figure(session.sheet.id, circle), "Draw")
    assert len(figure_calls(session.sheet, session.sheet.figures[0])) == 1
