"""The sentence of the step bar."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.session.session import Session
from workbench.widgets.stepping.sentence_view import SentenceView

_NARROW_PX = 936  # the step bar of the least window that is designed for


@pytest.fixture
def view(qtbot: QtBot) -> SentenceView:
    session = Session()
    shown = SentenceView(session.run)
    qtbot.addWidget(shown)
    shown.resize(_NARROW_PX, shown.height())
    return shown


def test_before_the_first_step_there_is_room_to_say_what_any_algorithm_does(view: SentenceView) -> None:
    for entry in catalogue.entries():
        view.setText(f"{entry.summary} Press the right arrow key for the first step.")
        assert view.heightForWidth(_NARROW_PX) <= view.maximumHeight(), entry.title
