"""Columns of tables: as wide as what stands in them, closer to each other where there is little room."""

import pytest
from PySide6.QtCore import QAbstractTableModel, QModelIndex, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QTableView
from pytestqt.qtbot import QtBot

from workbench.widgets.tables.table_columns import ROOM_FOR, FittedColumns

TEXTS = ("accelerating anode", "2000", "sin θ", "26524.1023", "km/s", "58")


class Model(QAbstractTableModel):
    """Sixty equal rows; the first column says that a longer text will come."""

    def __init__(self, longest: str = "") -> None:
        super().__init__()
        self.longest, self.last = longest, TEXTS[5]
        self.asked = 0

    def rowCount(self, _parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 60

    def columnCount(self, _parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return len(TEXTS)

    def data(self, index: QModelIndex, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        texts = (*TEXTS[:5], self.last)
        return texts[index.column()] if role == Qt.ItemDataRole.DisplayRole else None

    def headerData(self, section: int, _way: object, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        self.asked += role == ROOM_FOR
        if role == ROOM_FOR and section == 1:
            return self.longest
        return "z" if role == Qt.ItemDataRole.DisplayRole else None


def fitted(qtbot: QtBot, model: Model, width: int) -> tuple[list[int], int]:
    """The widths of the columns, and of the place they have."""
    view = QTableView()
    qtbot.addWidget(view)
    view.setModel(model)
    model.setParent(view)
    view.verticalHeader().hide()
    FittedColumns(view)
    view.resize(width, 200)
    with qtbot.waitExposed(view):
        view.show()
    return [view.columnWidth(k) for k in range(len(TEXTS))], view.viewport().width()


def test_where_there_is_little_room_columns_stand_closer_and_no_text_is_cut(qtbot: QtBot) -> None:
    wide, room = fitted(qtbot, Model(), 900)
    assert sum(wide) == room
    metrics = QFontMetrics(QTableView().font())
    needed = [metrics.horizontalAdvance(text) for text in TEXTS]
    close, room = fitted(qtbot, Model(), sum(needed) + 16 * len(TEXTS) + 30)
    assert sum(close) <= room  # the style of the window takes 16 px of a cell
    assert all(width >= need + 16 for width, need in zip(close, needed, strict=True))
    least, room = fitted(qtbot, Model(), 200)
    assert sum(least) > room  # it is scrolled rather than cut
    assert all(width >= need + 16 for width, need in zip(least, needed, strict=True))


def test_another_width_measures_nothing_anew_but_another_content_does(qtbot: QtBot) -> None:
    model = Model()
    view = QTableView()
    qtbot.addWidget(view)
    view.setModel(model)
    model.setParent(view)
    columns = FittedColumns(view)
    view.resize(700, 200)
    with qtbot.waitExposed(view):
        view.show()
    model.asked = 0
    view.resize(900, 200)
    qtbot.waitUntil(lambda: sum(map(view.columnWidth, range(len(TEXTS)))) == view.viewport().width())
    assert model.asked == 0
    before = view.columnWidth(5)
    model.last = "58.123456789012345678901234567890"
    model.dataChanged.emit(model.index(0, 5), model.index(59, 5))
    view.resize(500, 200)
    qtbot.waitUntil(lambda: view.columnWidth(5) > before)
    assert columns._needed is not None


@pytest.mark.parametrize("longest", ["▶ 100000", "▶ 12"])
def test_a_column_has_room_for_what_its_heading_says_will_come(qtbot: QtBot, longest: str) -> None:
    widths, _room = fitted(qtbot, Model(longest), 200)
    assert widths[1] >= QFontMetrics(QTableView().font()).horizontalAdvance(longest) + 8
