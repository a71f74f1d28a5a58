"""The pictures of Display for the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


def display_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("display-gun", lambda window: _gun(window, "spot", 5)),
        ("display-gun-lissajous", lambda window: _gun(window, "lissajous", 6)),
        ("display-gun-p7", lambda window: _gun(window, "p7", 0)),
        ("display-gun-coils", lambda window: _gun(window, "coils", 5)),
        ("display-gun-caught", lambda window: _gun(window, "caught", 5)),
        ("display-question-6", _question_6),
    ]


def _gun(window: MainWindow, slug: str, step: int) -> None:
    """The page Gun with one of its examples, at a step."""
    from workbench.panels.display.gun.page import GunPage
    from workbench.panels.display.panel import DisplayPanel
    from workbench.shell.workspaces import panel_of

    def arrive() -> None:
        panel = panel_of(window.panels("display"), DisplayPanel)
        panel.show_page("gun")
        page = panel.page_of("gun")
        assert isinstance(page, GunPage)
        page.take_preset(slug)
        window.session.update_state(step=step)
        window.arrangements.bring_forward("gun_part")

    window.open_example("house")
    window.enter("display", arrive)


def _question_6(window: MainWindow) -> None:
    from workbench.shell.questions import questions

    window.open_question(next(each for each in questions() if each.number == 6))
