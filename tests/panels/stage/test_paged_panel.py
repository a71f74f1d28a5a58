"""Pages of a workspace: the docks of the one that is shown lie before those of the others."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDockWidget, QLabel, QMainWindow, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import settle
from workbench.panels.panel import DockPart, Said
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.panels.stage.plain_page import PlainPage
from workbench.panels.stage.workspace_page import PageRow, pages_of
from workbench.session.session import Session
from workbench.shell.workspaces import panel_class
from workbench.widgets.look.in_sight import in_front

RIGHT = Qt.DockWidgetArea.RightDockWidgetArea


class OnePage(PlainPage, QWidget):
    """A page with one dock of its own."""

    zoom_text = Signal(str)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.part = QLabel("one")

    def said(self) -> Said:
        return Said(None, self.zoom_text)

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


def test_the_zoom_is_that_of_the_page(qtbot: QtBot, session: Session) -> None:
    kinds = {"first": "OnePage", "bare": "BarePage", "second": "OnePage"}
    panel = PagedPanel(
        session, "test", [PageRow(slug, slug, "", f"{__name__}:{kind}") for slug, kind in kinds.items()]
    )
    qtbot.addWidget(panel)
    said: list[str] = []
    panel.zoom_text.connect(said.append)
    for slug, text in (("first", "100 %"), ("second", "7 px")):  # the second while it is out of sight
        page = panel.page_of(slug)
        assert isinstance(page, OnePage)
        page.zoom_text.emit(text)
    assert said == ["100 %"]
    for slug in ("bare", "second", "first"):
        panel.show_page(slug)
    assert said == ["100 %", "", "7 px", "100 %"]


def test_no_title_of_a_page_is_cut_in_a_narrow_window(qtbot: QtBot, session: Session) -> None:
    titles = ("Tubes", "Gun", "Raster", "Random scan", "Raster or random", "Flicker", "Colour")
    panel = PagedPanel(
        session, "test", [PageRow(title.lower(), title, "", f"{__name__}:BarePage") for title in titles]
    )
    qtbot.addWidget(panel)
    panel.resize(900, 300)
    panel.show()
    settle()
    buttons = panel.buttons.buttons()
    assert len({button.y() for button in buttons}) == 1
    panel.resize(300, 300)
    settle()
    assert panel.width() == 300
    assert all(button.width() >= button.sizeHint().width() for button in buttons)
    assert all(panel.rect().contains(button.mapTo(panel, button.rect().bottomRight())) for button in buttons)
    assert all(button.mapTo(panel, button.rect().bottomLeft()).y() < panel.stack.y() for button in buttons)


def test_what_was_said_about_a_page_goes_with_it(qtbot: QtBot, session: Session) -> None:
    rows = [PageRow(slug, slug, "", f"{__name__}:BarePage") for slug in ("first", "second")]
    panel = PagedPanel(session, "test", rows)
    qtbot.addWidget(panel)
    panel.show_page("first")
    said: list[str] = []
    panel.said().hover.connect(said.append)
    panel.hover_text.emit("12 is no colour.")
    panel.show_page("first")
    assert said == ["12 is no colour."]
    panel.show_page("second")
    assert said == ["12 is no colour.", ""]


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


def test_each_page_is_made_in_a_step_of_its_own(
    qtbot: QtBot, session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [PageRow(slug, slug, "", f"{__name__}:OnePage") for slug in ("first", "second", "third")]
    made: list[str] = []
    make = PageRow.make

    def counted(row: PageRow, session: Session) -> object:
        made.append(row.slug)
        return make(row, session)

    monkeypatch.setattr(PageRow, "make", counted)
    making = pages_of(rows, session)
    while True:
        before = len(made)
        try:
            next(making)
        except StopIteration as end:
            pages = end.value
            break
        assert len(made) - before <= 1
    panel = PagedPanel(session, "test", rows, pages=pages)
    qtbot.addWidget(panel)
    assert made == ["first", "second", "third"]
    assert [panel.page_of(slug) for slug in made] == list(pages.values())


@pytest.mark.parametrize("wing", ["display", "space"])
def test_a_wing_is_made_page_by_page(
    qtbot: QtBot, session: Session, monkeypatch: pytest.MonkeyPatch, wing: str
) -> None:
    """Which is what keeps its first entry from holding the interface."""
    most: list[int] = []

    def counted(_row: PageRow, session: Session) -> object:
        most[-1] += 1
        return BarePage(session)

    monkeypatch.setattr(PageRow, "make", counted)
    making = panel_class(f"workbench.panels.{wing}.panel:{wing.title()}Panel").making(session)
    panel = None
    while panel is None:
        most.append(0)
        try:
            next(making)
        except StopIteration as end:
            panel = end.value
    qtbot.addWidget(panel.center)
    assert max(most) == 1
    assert sum(most) == len(panel.buttons.buttons())
