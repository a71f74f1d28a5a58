"""The pictures of the Transform workspace on the tour."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from workbench.shell.workspaces import panel_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from workbench.shell.window import MainWindow


def transform_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("transform-pivot", partial(_transform, slug="pivot", step=15)),
        ("transform-axes", partial(_transform, slug="pivot", axes=True, dock="whole")),
        ("transform-order", partial(_transform, slug="order", beside=True)),
        ("transform-beside", partial(_transform, slug="pivot", compared=True)),
        ("transform-parts", partial(_transform, slug="shear", dock="whole", part=1)),
        ("transform-homogeneous", partial(_transform, slug="shear", dock="whole", part=2)),
        ("transform-leaf", partial(_transform, slug="leaf")),
        ("transform-clock", partial(_transform, slug="clock", figure=-2)),
        ("transform-shear", partial(_transform, slug="shear")),
        ("transform-axis-in-space", _in_space),
        ("transform-asked", partial(_transform, slug="pivot", asks=True)),
        ("transform-empty", _empty),
    ]


def _transform(
    window: MainWindow,
    slug: str,
    step: int = 0,
    figure: int = -1,
    axes: bool = False,
    beside: bool = False,
    asks: bool = False,
    compared: bool = False,
    part: int = 0,
    dock: str = "chain",
) -> None:
    from workbench.panels.transform.panel import TransformPanel

    window.open_example(f"transform-{slug}")
    session, panel = window.session, panel_of(window.panels("transform"), TransformPanel)
    chosen = session.sheet.figures[figure].id
    panel.show_page()
    panel.choose_tool("select")
    session.update_state(active=chosen, selection=(chosen,), step=step, ask_first=asks)
    card = panel.card
    (card.axes if axes else card.both if compared else card.points).setChecked(True)
    panel.card.reversed.setChecked(beside)
    panel.whole.buttons[part].click()
    window.arrangements.bring_forward(dock)


def _in_space(window: MainWindow) -> None:
    """The house at the turn itself, its axis on z."""
    from workbench.panels.transform.panel import TransformPanel

    window.open_example("transform-axis")
    panel_of(window.panels("transform"), TransformPanel).show_page("space")
    window.session.update_state(step=4, ask_first=False)
    window.arrangements.bring_forward("chain")
    window.arrangements.bring_forward("hand_table")


def _empty(window: MainWindow) -> None:
    from workbench.panels.transform.panel import TransformPanel

    window.session.update_state(ask_first=False)
    window.session.new()
    window.go("transform")
    panel_of(window.panels("transform"), TransformPanel).show_page()
