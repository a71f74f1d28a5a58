"""A strip that flows: every part whole, in order, and no wider than its place."""

import pytest
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from workbench.widgets.look.flow_layout import FlowArea, flowing


def strip(sizes: list[int], growing: int = -1) -> QWidget:
    """Parts of these widths, 20 pixels high; one of them may grow."""
    made = QWidget()
    flow = flowing(made, 10, 5)
    for number, width in enumerate(sizes):
        part = QLabel()
        part.setMinimumSize(width, 20)
        if number != growing:
            part.setMaximumSize(width, 20)
        else:
            part.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        flow.addWidget(part)
    return made


@pytest.mark.parametrize(
    ("width", "rows"), [(340, [[0, 1, 2]]), (330, [[0, 1, 2]]), (329, [[0, 1], [2]]), (150, [[0], [1], [2]])]
)
def test_parts_go_on_in_the_next_row(qtbot: QtBot, width: int, rows: list[list[int]]) -> None:
    made = strip([100, 110, 100])
    qtbot.addWidget(made)
    assert made.heightForWidth(width) == len(rows) * 20 + (len(rows) - 1) * 5
    made.resize(width, made.heightForWidth(width))
    made.show()
    parts = [child for child in made.children() if isinstance(child, QLabel)]
    for y, row in enumerate(rows):
        assert [parts[k].geometry().top() for k in row] == [25 * y] * len(row)
        lefts = [parts[k].geometry().left() for k in row]
        assert lefts == sorted(lefts)
        assert lefts[0] == 0
    assert all(part.geometry().right() < width for part in parts)


def test_what_can_grow_takes_what_is_left(qtbot: QtBot) -> None:
    made = strip([100, 50], growing=1)
    qtbot.addWidget(made)
    made.resize(300, 20)
    made.show()
    assert [child.width() for child in made.children() if isinstance(child, QLabel)] == [100, 190]


def test_a_hidden_part_takes_no_room(qtbot: QtBot) -> None:
    made = strip([100, 100, 100])
    qtbot.addWidget(made)
    made.show()
    made.findChildren(QLabel)[1].hide()
    assert made.heightForWidth(210) == 20


def test_on_a_low_page_the_strip_scrolls(qtbot: QtBot) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    area = FlowArea(strip([100, 100, 100]), most=0.3)
    column = QVBoxLayout(page)
    column.setContentsMargins(0, 0, 0, 0)
    column.addWidget(area)
    page.resize(120, 400)
    page.show()
    area.fit(120, 400)
    assert area.height() == 70
    area.fit(120, 100)
    assert area.height() == 20


def test_less_than_half_a_row_is_not_scrolled(qtbot: QtBot) -> None:
    area = FlowArea(strip([100, 100, 100]), most=0.3)
    qtbot.addWidget(area)
    area.show()
    for page_height, height in ((230, 70), (200, 70), (190, 45)):
        area.fit(120, page_height)
        assert area.height() == height


def test_a_part_that_grows_into_another_row_is_not_cut(qtbot: QtBot) -> None:
    made = strip([100, 100, 100])
    area = FlowArea(made)
    qtbot.addWidget(area)
    area.resize(340, 20)
    area.show()
    area.fit(340, 1000)
    assert area.height() == 20
    made.findChildren(QLabel)[1].setFixedWidth(140)
    qtbot.waitUntil(lambda: area.height() == 45)


@pytest.mark.parametrize(("page_height", "rows"), [(30, 1), (120, 1), (150, 2), (225, 3)])
def test_a_strip_that_scrolls_ends_with_a_whole_row(qtbot: QtBot, page_height: int, rows: int) -> None:
    made = strip([100, 100, 100, 100, 100])
    area = FlowArea(made)
    qtbot.addWidget(area)
    area.fit(150, page_height)
    assert area.height() == 25 * rows - 5
