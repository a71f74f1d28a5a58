"""The pictures of View in the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from workbench.shell.workspaces import panel_of

if TYPE_CHECKING:
    from workbench.panels.viewing.panel import ViewingPanel
    from workbench.shell.window import MainWindow

_TELLING = 12


def viewing_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("view-house", lambda window: _open(window, "view-house", _TELLING)),
        ("view-numbers", lambda window: _open(window, "view-numbers", _TELLING)),
        ("view-circle", _circle),
        ("view-again", _device),
        ("view-point", _point),
        ("view-empty", _empty),
    ]


def _open(window: MainWindow, slug: str, step: int = 0) -> ViewingPanel:
    from workbench.panels.viewing.panel import ViewingPanel

    window.open_example(slug)
    window.session.update_state(step=step)
    panel = panel_of(window.panels("view"), ViewingPanel)
    panel.open_stage("window", right=False)
    panel.open_stage("viewport", right=True)
    return panel


def _circle(window: MainWindow) -> None:
    _open(window, "view-circle")


def _device(window: MainWindow) -> None:
    _open(window, "view-again").open_stage("device", right=True)


def _point(window: MainWindow) -> None:
    """A clicked point at its last step, with its arithmetic, beside the unit square."""
    panel = _open(window, "view-house")
    panel.gesture.send((2.5, 3.75))
    window.session.update_state(step=4)
    panel.open_stage("normalise", right=False)
    window.arrangements.bring_forward("point")


def _empty(window: MainWindow) -> None:
    window.session.new()
    window.go("view")
