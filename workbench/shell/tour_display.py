"""The pictures of Display in the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.document.subjects import Argument
    from workbench.shell.window import MainWindow


def display_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("display-flicker", _flicker),
        ("display-flicker-trail", _trail),
        ("display-colour-models", _models),
        ("display-shadow-mask", _mask),
        ("display-convergence", _convergence),
        ("display-penetration", _penetration),
    ]


def _page(window: MainWindow, example: str, slug: str, step: int = 0, **arguments: Argument) -> None:
    """A page of Display over an example, with some of its numbers set."""
    from msgspec.structs import replace

    window.open_example(example)
    window.go("display")
    window.panels("display")[0].show_page(slug)
    subject = window.session.state.subject
    changed = replace(subject, arguments={**subject.arguments, **arguments})
    window.session.update_state(subject=changed, step=step)


def _flicker(window: MainWindow) -> None:
    """A fast phosphor refreshed too seldom."""
    _page(window, "house", "flicker", 4, refresh_hz=45.0)


def _trail(window: MainWindow) -> None:
    """A spot that moves over a slow phosphor."""
    _page(window, "house", "flicker", 0, phosphor="P39", figure="spot")


def _models(window: MainWindow) -> None:
    """An orange in three solids, half-way to its hue."""
    _page(window, "house", "colour", 3, part="models", red=0.95, green=0.55, blue=0.2)


def _mask(window: MainWindow) -> None:
    """A shadow mask close up."""
    _page(window, "colour-bars", "colour", 0, part="mask", pitch_mm=0.6, width_mm=14.0)


def _convergence(window: MainWindow) -> None:
    """Red and blue beside their places, on a tube with a grille."""
    errors = {"red_x": -1.6, "blue_x": 1.6, "blue_y": 0.8}
    _page(window, "house", "colour", 0, part="mask", mask="grille", pitch_mm=0.9, width_mm=20.0, **errors)


def _penetration(window: MainWindow) -> None:
    """Each stroke in the colour of its voltage."""
    _page(window, "house", "colour", 0, part="penetration", by_stroke=True, kilovolts=6.3)
