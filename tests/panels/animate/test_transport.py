"""The bar over the timeline takes the widest form that has room."""

from collections.abc import Iterator
from itertools import pairwise

import pytest
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from workbench.session.session import Session
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.timeline.transport import Transport


@pytest.fixture
def transport(qtbot: QtBot) -> Iterator[Transport]:
    session = Session()
    around = QWidget()
    qtbot.addWidget(around)
    column = QVBoxLayout(around)
    column.setContentsMargins(0, 0, 0, 0)
    bar = Transport(session)
    column.addWidget(bar)
    around.show()
    yield bar
    session.close()


def test_at_any_width_nothing_overlaps_or_sticks_out(transport: Transport) -> None:
    around = transport.window()
    for width in range(460, 1300, 20):
        around.resize(width, 60)
        QApplication.processEvents()
        assert (around.width(), transport.width()) == (width, width)
        children = (child for child in transport.children() if isinstance(child, QWidget))
        places = sorted((each.geometry() for each in children if each.isVisible()), key=lambda at: at.left())
        assert places[-1].right() < width
        assert all(left.right() < right.left() for left, right in pairwise(places))
        assert transport.frame.isVisible()
    assert all(part.isVisible() for part in (transport.rate, transport.speed, transport.mode))


def test_the_button_that_plays_is_called_what_it_does_now(transport: Transport) -> None:
    (button,) = (each for each in transport.findChildren(ActionButton) if each.action is transport.play)
    for playing, words in ((True, "Stop the frames"), (False, "Play the frames")):
        transport._session.frames.played.emit(playing)
        assert button.accessibleName() == words
