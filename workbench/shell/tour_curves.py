"""The pictures of the Curves workspace on the tour."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from workbench.shell.workspaces import panel_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from workbench.shell.window import MainWindow

_USUAL = frozenset({"polygon", "names", "construction"})


def curve_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("curves-interpolation", partial(_curves, slug="interpolation", dock="kinds")),
        ("curves-bezier", partial(_curves, slug="bezier", u=0.4)),
        ("curves-stepped", partial(_curves, slug="bezier", u=0.4, step=4)),
        ("curves-local", partial(_curves, slug="local-control", points=(4,), shown={"influence"})),
        (
            "curves-circle",
            partial(_curves, slug="circle", shown={"hull", "circle", "tangent"}, dock="insight"),
        ),
        ("curves-alphas", partial(_curves, slug="alphas", shown={"comb"}, hidden=_USUAL, dock="curvature")),
        ("curves-letter", partial(_curves, slug="letter", points=(3,), hidden=_USUAL, dock="continuity")),
        (
            "curves-steps",
            partial(_curves, slug="bezier", shown={"steps_u", "steps_length"}, dock="hodograph"),
        ),
        ("curves-pen", _pen),
        ("curves-empty", _empty),
    ]


def _curves(
    window: MainWindow,
    slug: str,
    u: float = 0.5,
    step: int = 0,
    points: tuple[int, ...] = (),
    shown: frozenset[str] | set[str] = frozenset(),
    hidden: frozenset[str] = frozenset(),
    dock: str = "basis",
) -> None:
    from workbench.panels.curves.panel import CurvesPanel

    window.open_example(f"curve-{slug}")
    session, panel = window.session, panel_of(window.panels("curves"), CurvesPanel)
    front = session.sheet.figures[-1]
    panel.choose_tool("select")
    session.update_state(active=front.id, selection=(front.id,), step=step)
    panel.focus.set_u(u)
    panel.focus.choose(front.points_world[k].id for k in points)
    wanted = (_USUAL | shown) - (hidden - shown) | {"polygon"}
    for name in panel.focus.shown | wanted:
        panel.focus.switch(name, name in wanted)
    window.arrangements.bring_forward(dock)


def _pen(window: MainWindow) -> None:
    from PySide6.QtCore import Qt

    from workbench.panels.curves.panel import CurvesPanel

    _empty(window)
    panel = panel_of(window.panels("curves"), CurvesPanel)
    for x, y in ((6.0, 10.0), (20.0, 36.0), (36.0, 8.0), (46.0, 12.0)):
        panel.pen.press(x, y, Qt.KeyboardModifier.NoModifier, 0.75)
        panel.pen.release(x, y)
    panel.pen.move(58.0, 34.0)


def _empty(window: MainWindow) -> None:
    from workbench.panels.curves.panel import CurvesPanel

    window.session.new()
    window.go("curves")
    panel_of(window.panels("curves"), CurvesPanel).choose_tool("pen")
