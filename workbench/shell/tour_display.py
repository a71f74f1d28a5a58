"""The pictures of Display for the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.document.subjects import Argument
    from workbench.shell.window import MainWindow


def display_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
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
        window.session.update_state(tube=replace(window.session.state.tube, phosphor="P7"))
        page.catch_beam()

    QTimer.singleShot(250, catch)
