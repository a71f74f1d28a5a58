"""The pictures of Animate in the tour."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from workbench.shell.workspaces import panel_of

if TYPE_CHECKING:
    from workbench.panels.animate.panel import AnimatePanel
    from workbench.shell.window import MainWindow

_TELLING = 34


def animate_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("animate-ball", partial(_open, slug="animate-ball", frame=_TELLING)),
        ("animate-spacing", partial(_open, slug="animate-ball", frame=_TELLING, dock="physics")),
        ("animate-letter", partial(_open, slug="animate-letter", frame=18)),
        ("animate-morph", partial(_open, slug="animate-letter", frame=18, dock="morphing")),
        ("animate-clock", partial(_open, slug="animate-clock", frame=20)),
        ("animate-pendulum", partial(_open, slug="animate-pendulum", frame=8)),
        ("animate-turning", partial(_open, slug="animate-pendulum", frame=12, dock="turning", track=-1)),
        ("animate-swing", partial(_open, slug="animate-pendulum", frame=8, dock="physics", track=-1)),
        ("animate-turn", partial(_open, slug="animate-turn", frame=32, dock="turning", track=-1)),
        ("animate-drive", partial(_open, slug="animate-drive", frame=22)),
        ("animate-curves", partial(_curves, slug="animate-ball", frame=_TELLING)),
        ("animate-stepped", _stepped),
        ("animate-tube", _on_the_tube),
        ("animate-empty", _empty),
    ]


def _open(window: MainWindow, slug: str, frame: int, dock: str = "between", track: int = 0) -> AnimatePanel:
    from workbench.panels.animate.panel import AnimatePanel

    window.open_example(slug)
    session = window.session
    session.frames.show(frame)
    panel = panel_of(window.panels("animate"), AnimatePanel)
    motion = session.frames.motion
    panel.timeline.track_chosen.emit(motion.tracks[track].target)
    window.arrangements.bring_forward(dock)
    return panel


def _curves(window: MainWindow, slug: str, frame: int) -> None:
    """The curve of a track with the handles of the easing around the frame."""
    _open(window, slug, frame).pages.show_curves(True)


def _stepped(window: MainWindow) -> None:
    """The falling of the ball, at the in-between in the middle."""
    panel = _open(window, "animate-ball", _TELLING)
    panel.between.step.click()
    window.arrangements.bring_forward("hand_table")


def _on_the_tube(window: MainWindow) -> None:
    """The ball on a slow phosphor, in the place of the canvas."""
    from msgspec.structs import replace

    panel = _open(window, "animate-ball", _TELLING)
    session = panel.session
    session.update_state(tube=replace(session.state.tube, phosphor="P7"))
    window.views.swap()


def _empty(window: MainWindow) -> None:
    window.session.new()
    window.go("animate")
