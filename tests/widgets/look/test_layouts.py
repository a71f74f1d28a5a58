"""Layouts whose widgets come and go."""

import gc

from PySide6.QtWidgets import QGridLayout, QLabel, QLayoutItem, QWidget
from pytestqt.qtbot import QtBot

from workbench.widgets.look.layouts import take_widgets


def test_widgets_are_taken_out_of_a_layout_and_no_item_stays(qtbot: QtBot) -> None:
    host = QWidget()
    qtbot.addWidget(host)
    grid = QGridLayout(host)
    labels = [QLabel(str(number)) for number in range(5)]
    for place, label in enumerate(labels):
        grid.addWidget(label, place // 2, place % 2)
    grid.setRowMinimumHeight(3, 4)
    assert take_widgets(grid) == labels
    assert grid.count() == 0
    assert all(label.parentWidget() is host for label in labels)
    assert take_widgets(grid) == []
    gc.collect()
    assert not [each for each in gc.get_objects() if type(each) is QLayoutItem]
