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


class BarePage(PlainPage, QWidget):
    """A page without a dock."""

    def __init__(self, session: Session) -> None:
        super().__init__()


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


@pytest.mark.qt_log_ignore("does not support raise", extend=True)
def test_on_a_page_without_docks_one_of_no_page_comes_before_those_of_others(
    qtbot: QtBot, session: Session
) -> None:
    kinds = {"first": "OnePage", "bare": "BarePage", "second": "OnePage"}
    panel = PagedPanel(
        session, "test", [PageRow(slug, slug, "", f"{__name__}:{kind}") for slug, kind in kinds.items()]
    )
    window = QMainWindow()
    qtbot.addWidget(window)
    window.setCentralWidget(panel)
    parts = [part for _name, _title, part, _area in panel.docks()]
    first, second, common = docks = [QDockWidget(title) for title in ("first", "second", "common")]
    for dock, part in zip(docks, (*parts, QLabel("common")), strict=True):
        dock.setWidget(part)
        window.addDockWidget(RIGHT, dock)
    for behind in (second, common):
        window.tabifyDockWidget(first, behind)
    panel.show_page("bare")
    first.raise_()
    window.show()
    settle()
    assert in_front(common)  # from the first moment
    panel.show_page("second")  # only for want of it the common one was there
    settle()
    assert in_front(second)
    for slug, front in (("first", first), ("second", second), ("bare", common)):
        second.raise_()
        settle()
        panel.show_page(slug)
        settle()
        assert in_front(front)
    first.setFloating(True)  # what has a place of its own stays
    panel.show_page("bare")
    settle()
    assert first.isVisible()
    assert in_front(common)
