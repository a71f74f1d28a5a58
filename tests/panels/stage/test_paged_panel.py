"""Pages of a workspace: the docks of the one that is shown lie before those of the others."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QLabel, QMainWindow, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import settle
from workbench.panels.panel import DockPart
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.panels.stage.plain_page import PlainPage
from workbench.panels.stage.workspace_page import PageRow
from workbench.session.session import Session
from workbench.widgets.look.in_sight import in_front

RIGHT = Qt.DockWidgetArea.RightDockWidgetArea


class OnePage(PlainPage, QWidget):
    """A page with one dock of its own."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.part = QLabel("one")

    def docks(self) -> list[DockPart]:
        return [(f"part {id(self)}", "Part", self.part, RIGHT)]


@pytest.fixture
def session() -> Iterator[Session]:
    made = Session()
    yield made
    made.close()


def test_the_dock_of_the_page_comes_before_those_of_others(qtbot: QtBot, session: Session) -> None:
    rows = [PageRow(slug, slug, "", f"{__name__}:OnePage") for slug in ("first", "second")]
    panel = PagedPanel(session, "test", rows)
    window = QMainWindow()
    qtbot.addWidget(window)
    window.setCentralWidget(panel)
    docks = []
    for _name, title, part, _area in panel.docks():
        dock = QDockWidget(title)
        dock.setWidget(part)
        window.addDockWidget(RIGHT, dock)
        docks.append(dock)
    common = QDockWidget("common")
    window.addDockWidget(RIGHT, common)
    for behind in (docks[1], common):
        window.tabifyDockWidget(docks[0], behind)
    docks[0].raise_()
    window.show()
    settle()
    for slug, front in (("second", docks[1]), ("first", docks[0])):
        panel.show_page(slug)
        settle()
        assert in_front(front)
    common.raise_()
    settle()
    panel.show_page("second")  # what belongs to no page stays
    settle()
    assert in_front(common)
