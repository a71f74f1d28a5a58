"""The pictures of the pages of Display for the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


def display_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("display-random-scan", _random_scan),
        ("display-overloaded", _overloaded),
        ("display-storage", _storage),
        ("display-raster-or-random", _raster_or_random),
    ]


def _page(window: MainWindow, slug: str, example: str, arrive: Callable[[], object]) -> None:
    """A page of Display over an example."""

    def on_page() -> None:
        window.panels("display")[0].show_page(slug)
        arrive()

    window.open_example(example)
    window.enter("display", on_page)


def _random_scan(window: MainWindow) -> None:
    """A frame half drawn, the beam on its way in the dark."""

    def arrive() -> None:
        window.session.update_state(step=15)
        window.arrangements.bring_forward("random_scan_architecture")

    _page(window, "vector", "house", arrive)


def _overloaded(window: MainWindow) -> None:
    """A list that takes three times as long as the eye will wait."""
    from workbench.document.subjects import Subject

    def arrive() -> None:
        window.session.update_state(subject=Subject("random_scan"), step=0)
        window.arrangements.bring_forward("random_scan_architecture")

    _page(window, "vector", "overloaded-list", arrive)


def _storage(window: MainWindow) -> None:
    """The same list, written once."""
    from workbench.document.subjects import Subject

    def arrive() -> None:
        window.session.update_state(subject=Subject("random_scan", arguments={"storage": True}), step=0)

    _page(window, "vector", "overloaded-list", arrive)


def _raster_or_random(window: MainWindow) -> None:
    from workbench.shell.questions import questions

    window.open_question(next(each for each in questions() if each.number == 10))
