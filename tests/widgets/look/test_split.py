"""Lines between parts that are drawn by hand, and go back."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from workbench.widgets.look.split import Split


@pytest.fixture(params=[Qt.Orientation.Horizontal, Qt.Orientation.Vertical], ids=["beside", "above"])
def split(request: pytest.FixtureRequest, qtbot: QtBot) -> Split:
    split = Split(request.param)
    qtbot.addWidget(split)
    for _part in range(3):
        part = QWidget()
        part.setMinimumSize(20, 20)
        split.addWidget(part)
    split.resize(406, 406)
    split.setSizes([100, 200, 100])
    split.show()
    QApplication.processEvents()
    return split


def draw(split: Split, number: int, by: int) -> None:
    line = split.handle(number)
    begin = line.rect().center()
    end = begin + (QPoint(by, 0) if split.orientation() == Qt.Orientation.Horizontal else QPoint(0, by))
    QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=begin)
    QTest.mouseMove(line, end)
    QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=end)


def test_lines_drawn_by_hand_go_back(split: Split) -> None:
    first = split.sizes()
    draw(split, 1, 60)
    draw(split, 2, -30)
    assert split.sizes() == [first[0] + 60, first[1] - 90, first[2] + 30]
    split.reset()
    assert split.sizes() == first
    draw(split, 1, 15)
    split.reset()
    assert split.sizes() == first


def test_shares_given_since_are_those_that_stay(split: Split) -> None:
    draw(split, 1, 60)
    split.setSizes([200, 100, 100])
    given = split.sizes()
    split.reset()
    assert split.sizes() == given
    split.resize(812, 812)
    QApplication.processEvents()
    draw(split, 2, 50)
    drawn = split.sizes()
    split.reset()
    assert split.sizes() != drawn


def test_no_part_is_drawn_away(split: Split) -> None:
    draw(split, 1, -400)
    draw(split, 2, 400)
    assert min(split.sizes()) >= 20
