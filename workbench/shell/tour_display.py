"""The pictures of the pages of Display for the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.document.subjects import Argument
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
        ("display-raster", lambda window: _raster(window, 20, "raster_sums")),
        ("display-raster-pixel", lambda window: _raster(window, 700, "source", detail=True, depth=4)),
        ("display-raster-beam", _raster_beam),
        (
            "display-raster-table",
            lambda window: _raster(window, 0, "raster_buffer", example="raster-card", depth=4),
        ),
        (
            "display-raster-interlaced",
            lambda window: _raster(window, 30, "raster_mode", mode="ntsc-525i", path=True),
        ),
        ("display-random-scan", _random_scan),
        ("display-overloaded", _overloaded),
        ("display-storage", _storage),
        ("display-raster-or-random", _raster_or_random),
        ("display-flicker", _flicker),
        ("display-flicker-trail", _trail),
        ("display-colour-models", _models),
        ("display-shadow-mask", _mask),
        ("display-convergence", _convergence),
        ("display-penetration", _penetration),
    ]


def _raster(
    window: MainWindow,
    step: int,
    dock: str,
    path: bool = False,
    detail: bool = False,
    example: str = "house",
    **arguments: Argument,
) -> None:
    """A picture on its way to the beam."""
    from workbench.document.subjects import Subject
    from workbench.panels.display.panel import DisplayPanel
    from workbench.panels.display.raster.page import RasterPage
    from workbench.shell.workspaces import panel_of

    window.open_example(example)

    def arrive() -> None:
        panel = panel_of(window.panels("display"), DisplayPanel)
        panel.show_page("raster")
        page = panel.page_of("raster")
        assert isinstance(page, RasterPage)
        page.path.setChecked(path)
        subject = Subject("raster", arguments=dict(arguments))
        window.session.update_state(subject=subject, step=step, detail=detail)
        window.arrangements.bring_forward(dock)

    window.enter("display", arrive)


def _raster_beam(window: MainWindow) -> None:
    """The beam caught in the middle of a line, on a phosphor that still glows where it was."""
    from msgspec.structs import replace
    from PySide6.QtCore import QTimer

    from workbench.panels.display.panel import DisplayPanel
    from workbench.panels.display.raster.page import RasterPage
    from workbench.shell.workspaces import panel_of

    _raster(window, 0, "raster_sums")

    def catch() -> None:
        page = panel_of(window.panels("display"), DisplayPanel).page_of("raster")
        assert isinstance(page, RasterPage)
        if page.setting.scan is None or not window.session.run.done:
            QTimer.singleShot(50, catch)
            return
        window.session.update_state(tube=replace(window.session.state.tube, phosphor="P7"))
        page.catch_beam()

    QTimer.singleShot(250, catch)


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
    from workbench.rendering.subjects import random_scan

    def arrive() -> None:
        window.session.update_state(subject=Subject(random_scan.KIND), step=0)
        window.arrangements.bring_forward("random_scan_architecture")

    _page(window, "vector", "overloaded-list", arrive)


def _storage(window: MainWindow) -> None:
    """The same list, written once."""
    from workbench.document.subjects import Subject
    from workbench.rendering.subjects import random_scan

    def arrive() -> None:
        window.session.update_state(subject=Subject(random_scan.KIND, arguments={"storage": True}), step=0)

    _page(window, "vector", "overloaded-list", arrive)


def _raster_or_random(window: MainWindow) -> None:
    from workbench.shell.questions import questions

    window.open_question(next(each for each in questions() if each.number == 10))


def _numbers(window: MainWindow, example: str, slug: str, step: int = 0, **arguments: Argument) -> None:
    """A page of Display over an example, with some of its numbers set."""
    from msgspec.structs import replace

    def arrive() -> None:
        subject = window.session.state.subject
        changed = replace(subject, arguments={**subject.arguments, **arguments})
        window.session.update_state(subject=changed, step=step)

    _page(window, slug, example, arrive)


def _flicker(window: MainWindow) -> None:
    """A fast phosphor refreshed too seldom."""
    _numbers(window, "house", "flicker", 4, refresh_hz=45.0)


def _trail(window: MainWindow) -> None:
    """A spot that moves over a slow phosphor."""
    _numbers(window, "house", "flicker", 0, phosphor="P39", figure="spot")


def _models(window: MainWindow) -> None:
    """An orange in three solids, half-way to its hue."""
    _numbers(window, "house", "colour", 3, part="models", red=0.95, green=0.55, blue=0.2)


def _mask(window: MainWindow) -> None:
    """A shadow mask close up."""
    _numbers(window, "colour-bars", "colour", 0, part="mask", pitch_mm=0.6, width_mm=14.0)


def _convergence(window: MainWindow) -> None:
    """Red and blue beside their places, on a tube with a grille."""
    errors = {"red_x": -1.6, "blue_x": 1.6, "blue_y": 0.8}
    _numbers(window, "house", "colour", 0, part="mask", mask="grille", pitch_mm=0.9, width_mm=20.0, **errors)


def _penetration(window: MainWindow) -> None:
    """Each stroke in the colour of its voltage."""
    _numbers(window, "house", "colour", 0, part="penetration", by_stroke=True, kilovolts=6.3)


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
