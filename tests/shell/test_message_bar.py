"""What the bar under the menus says, and how long."""

import pytest

from workbench.shell.window import MainWindow


@pytest.mark.parametrize(("kind", "stays"), [("info", False), ("warn", True), ("error", True)])
def test_a_remark_goes_with_the_picture_it_was_made_of(window: MainWindow, kind: str, stays: bool) -> None:
    window.messages.say("star.svg is written in /home.", kind)
    window.open_example("line")
    assert bool(window.messages.text) == stays


def test_a_question_stays_though_another_picture_comes(window: MainWindow) -> None:
    window.messages.ask("Save it?", [("Save", lambda: None)])
    window.session.open_example("line")
    assert window.messages.text == "Save it?"
