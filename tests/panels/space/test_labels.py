"""Labels of a view in space lie on nothing that can be laid free: not on one another, not under a card."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from workbench.panels.space.strokes import Labels


def test_two_names_at_one_place_and_a_card_over_it_are_all_read(qtbot: QtBot) -> None:
    view = QWidget()
    qtbot.addWidget(view)
    view.resize(400, 300)
    card = QWidget(view)
    card.setGeometry(8, 8, 230, 28)
    view.show()
    image = QImage(view.size(), QImage.Format.Format_RGB32)
    painter = QPainter(image)
    labels = Labels(painter, view)
    boxes = [
        labels.put(np.array([200.0, 40.0]), name, "#0B6BCB") for name in ("near 0.1", "view plane, d = 5")
    ]
    painter.end()
    taken = [QRectF(card.geometry()), *boxes]
    for k, box in enumerate(taken):
        assert not any(box.intersects(other) for other in taken[k + 1 :])


@pytest.mark.usefixtures("qapp")
@given(st.floats(-500, 900), st.floats(-500, 900))
def test_a_label_stays_within_its_view(x: float, y: float) -> None:
    view = QWidget()
    view.resize(300, 200)
    image = QImage(view.size(), QImage.Format.Format_RGB32)
    painter = QPainter(image)
    box = Labels(painter, view).put(np.array([x, y]), "eye (1, 2, 3)", "#0B6BCB")
    painter.end()
    assert QRectF(view.rect()).contains(box)
    view.deleteLater()
