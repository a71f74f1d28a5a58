"""The colour table of the page Raster: edited by hand, and too short or not."""

from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from tests.panels.display.raster.conftest import show_dock
from workbench.panels.display.raster.page import RasterPage
from workbench.session.session import Session


def test_the_colour_table_is_edited(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    show_dock(qtbot, page.buffer)
    page.buffer.choose_depth(2)
    session.flush()
    page.buffer.refresh()
    assert page.buffer.table == (0, 0x555555, 0xAAAAAA, 0xFFFFFF)
    assert not page.buffer.add.isEnabled()
    qtbot.mouseClick(page.buffer.grid, Qt.MouseButton.LeftButton, pos=QPoint(30, 10))
    assert page.buffer.grid.index == 1
    page.buffer.colour.selectAll()
    qtbot.keyClicks(page.buffer.colour, "#FF8800")
    qtbot.keyClick(page.buffer.colour, Qt.Key.Key_Return)
    session.flush()
    assert page.buffer.table[1] == 0xFF8800
    page.buffer.refresh()
    page.buffer.colour.selectAll()
    qtbot.keyClicks(page.buffer.colour, "mud")
    qtbot.keyClick(page.buffer.colour, Qt.Key.Key_Return)
    assert "mud" in page.buffer.fault.text()
    assert page.buffer.table[1] == 0xFF8800
    page.buffer.remove.click()
    session.flush()
    page.buffer.refresh()
    assert page.buffer.table == (0, 0xAAAAAA, 0xFFFFFF)
    assert "too short" in page.buffer.fault.text()
    assert page.buffer.add.isEnabled()
    page.buffer._load(())
    session.flush()
    page.buffer.refresh()
    assert "empty" in page.buffer.fault.text()
    page.buffer._load("picture")
    session.flush()
    assert 0 in page.buffer.table
    assert len(page.buffer.table) == 4
    page.buffer._load(None)
    session.flush()
    assert page.buffer.table == (0, 0x555555, 0xAAAAAA, 0xFFFFFF)


def test_a_short_table_that_keeps_every_colour_is_no_fault(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    show_dock(qtbot, page.buffer)
    page.buffer.choose_depth(8)
    page.buffer._load("picture")
    session.flush()
    page.refresh()
    page.buffer.refresh()
    assert 1 < len(page.buffer.table) < 256
    assert page.buffer.loss.text().startswith("Nothing is lost")
    assert page.buffer.fault.text() == ""
    page.buffer._take(page.buffer.table[:-1])
    session.flush()
    page.refresh()
    page.buffer.refresh()
    assert "too short" in page.buffer.fault.text()
