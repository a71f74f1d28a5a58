"""A hand table that comes into sight late, or whose rows come all at once."""

from PySide6.QtCore import QCoreApplication
from pytestqt.qtbot import QtBot

from tests.widgets.stepping.test_stepping import follow, shown
from tests.widgets.stepping.test_stepping import run as run
from workbench.session.run import Run
from workbench.widgets.tables.hand_table import HandTable


def test_a_hand_table_that_is_opened_late_shows_its_current_row(run: Run, qtbot: QtBot) -> None:
    table = HandTable(run)
    qtbot.addWidget(table)
    run.last()
    table.resize(300, 120)
    table.show()
    qtbot.waitExposed(table)
    last = table.model.index(run.position - 1, 0)
    qtbot.waitUntil(lambda: table.view.viewport().rect().contains(table.view.visualRect(last)), timeout=5_000)


def test_rows_that_come_all_at_once_bring_their_current_one_into_sight(run: Run, qtbot: QtBot) -> None:
    hand = HandTable(run)
    shown(qtbot, hand, height=160)
    follow(qtbot, run, "bresenham_line", 0, 0, 1500, 9)
    hand.model.reset()
    hand.model.beginRemoveRows(hand.model.index(-1, -1), 404, hand.model.rowCount() - 1)
    hand.model._rows = 404  # as many as had been recorded when the cursor was set
    hand.model.endRemoveRows()
    QCoreApplication.processEvents()
    run.go(1200)

    def in_sight() -> bool:
        place = hand.view.visualRect(hand.model.index(1199, 0))
        return hand.view.viewport().rect().intersects(place)

    qtbot.waitUntil(in_sight, timeout=5_000)
