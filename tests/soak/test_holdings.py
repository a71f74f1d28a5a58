"""What the process holds is told apart by kind."""

import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.soak.holdings import edited, holdings
from workbench.algorithms.catalogue import get
from workbench.document.model import Rectangle, View
from workbench.engine import compiled
from workbench.memory import Memory
from workbench.rendering.mapping import view_map
from workbench.session.session import Session


def test_each_kind_is_counted_where_it_is_held(qtbot: QtBot) -> None:
    view_map.cache_clear()
    compiled.collect(get("bresenham_line").function, 0, 0, 9, 4)
    emptied, before = holdings(), holdings()
    assert before.kept <= emptied.kept
    memory = Memory[np.ndarray](1 << 24)
    memory.get("zeros", lambda: np.full(10**6, 1.0))
    for number in range(5):
        view_map(View("", Rectangle(0.0, 0.0, 7.0 + number, 9.0), Rectangle(0.0, 0.0, 64.0, 48.0)))
    picture = QImage(200, 200, QImage.Format.Format_RGB32)
    halves = memory.get("zeros", lambda: np.zeros(0)).reshape(2, -1)  # their base is counted already
    parent = QWidget()
    qtbot.addWidget(parent)
    children = [QWidget(parent) for _count in range(9)]
    texts = [str(number) for number in range(10**5, 2 * 10**5)]
    after = holdings()
    assert 8 <= round(after.pictures - before.pictures, 3) < 8.1
    assert 8 <= round(after.arrays - before.arrays, 3) < 8.1
    assert 0.16 <= round(after.images - before.images, 3) < 0.17
    assert (after.kept - before.kept, after.widgets - before.widgets) == (5, 1 + len(children))
    assert view_map.cache_info().currsize == 0  # it has a bound
    assert after.blocks - before.blocks >= len(texts) // 1000
    assert after.resident > before.resident
    assert after.kernels >= 1
    assert (picture.width(), halves.ndim) == (200, 2)
    assert 0 < after.allocated <= after.arenas


def test_the_steps_of_undo_are_weighed() -> None:
    session = Session()
    assert edited(session).endswith("undo 0.0 MB in 0 steps")
    session.close()
