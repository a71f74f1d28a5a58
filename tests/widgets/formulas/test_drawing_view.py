"""A labelled drawing is laid out when what it shows, its size, its type or the theme is another."""

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.exchange.diagrams import Drawing
from workbench.widgets.formulas.drawing_view import DrawingView
from workbench.widgets.look.tokens import DARK, LIGHT, theme


@pytest.fixture(autouse=True)
def _as_it_was() -> Iterator[None]:
    yield
    theme.use(LIGHT)


def test_it_is_laid_out_when_something_of_it_is_another_and_no_more_often(qtbot: QtBot) -> None:
    laid: list[tuple[float, float]] = []

    def drawn(place: NDArray[np.float64], height: float) -> Drawing:
        laid.append((float(place[0]), height))
        return Drawing((0.0, 0.0, 100.0, 50.0), ())

    view = DrawingView("System", "")
    qtbot.addWidget(view)
    view.resize(500, 300)
    with qtbot.waitExposed(view):
        view.show()

    def times() -> int:
        view.repaint()
        QApplication.processEvents()
        return len(laid)

    assert times() == 0
    view.show_drawing(drawn, np.array([1.0, 2.0]), "")
    assert [times(), times()] == [1, 1]
    view.show_drawing(drawn, np.array([1.0, 2.0]), "")
    assert times() == 1
    view.show_drawing(drawn, np.array([3.0, 2.0]), "")
    assert times() == 2
    assert laid[-1][0] == 3.0
    view.resize(500, 400)
    assert times() == 3
    assert laid[-1][1] - laid[-2][1] == pytest.approx(100.0)
    theme.use(DARK)
    assert times() == 4
    view.setFont(QFont(view.font().family(), 20))
    assert times() == 5
