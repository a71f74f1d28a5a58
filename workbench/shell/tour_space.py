"""The pictures of Space for the tour."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


def space_scenes() -> list[tuple[str, Callable[[MainWindow], object]]]:
    """Name of each picture, and what brings the window there."""
    return [
        ("space-perspective", lambda window: _open(window, "space-house")),
        ("space-isometric", lambda window: _open(window, "space-isometric")),
        ("space-cabinet", lambda window: _open(window, "space-cabinet")),
        ("space-empty", _empty),
        ("space-visibility", lambda window: _visibility(window, "overlapping-triangles", 684)),
        ("space-piercing", lambda window: _visibility(window, "piercing-planes", 860)),
        ("space-fighting", _fighting),
        ("space-arena", lambda window: _arena(window, "arena-ring")),
        ("space-arena-piercing", lambda window: _arena(window, "piercing-planes")),
        ("space-shading", lambda window: _visibility(window, "shading-ball", 120)),
        ("space-materials", lambda window: _shading(window, "shading-materials", False)),
        ("space-four-shadings", lambda window: _shading(window, "shading-ball", True)),
        ("space-lamps", lambda window: _shading(window, "shading-lamps", False)),
        ("space-question-7", _question_7),
        ("space-painter", _painter),
    ]


def _open(window: MainWindow, slug: str) -> None:
    """An example, whose picture does not wait until the depth buffer is loaded."""
    from workbench.document.samples.examples import example
    from workbench.rendering.scene import render_scene

    scene = example(slug).document.sheets[0].scene
    if scene is not None:
        render_scene(scene, "depth_buffer", (16, 16))
    window.open_example(slug)


def _visibility(window: MainWindow, slug: str, step: int) -> None:
    from workbench.shell.opening import open_example

    open_example(window, slug, step)


def _fighting(window: MainWindow) -> None:
    """Two surfaces so close that eight bits do not tell them apart."""
    from workbench.document.subjects import Subject

    _visibility(window, "almost-one-plane", 0)
    window.session.update_state(subject=Subject("visibility", arguments={"bits": 8}), step=1796)


def _arena(window: MainWindow, slug: str) -> None:
    """All methods on a scene, which may belong to another page."""

    def arrive() -> None:
        window.panels("space")[0].show_page("arena")
        window.arrangements.bring_forward("growth")

    _visibility(window, slug, 0)
    window.enter("space", arrive)


def _shading(window: MainWindow, slug: str, four: bool) -> None:
    """A scene in its light, in one shading or in all four."""
    from workbench.algorithms.shading import phong
    from workbench.document.subjects import Subject
    from workbench.panels.space.panel import SpacePanel

    def arrive() -> None:
        panel = window.panels("space")[0]
        assert isinstance(panel, SpacePanel)
        panel.page_of("shading").commands()[0].setChecked(four)
        subject = Subject("shading", entry=phong.__name__, arguments={"shadows": slug == "shading-lamps"})
        window.session.update_state(subject=subject, step=400)
        window.arrangements.bring_forward("lamps")

    _visibility(window, slug, 0)
    window.enter("space", arrive)


def _question_7(window: MainWindow) -> None:
    from workbench.shell.questions import questions

    window.open_question(next(each for each in questions() if each.number == 7))


def _painter(window: MainWindow) -> None:
    """The painter's algorithm on a ring that has no order, and what came to a pixel that is wrong."""
    from workbench.algorithms.visibility import painter
    from workbench.document.subjects import Subject

    def arrive() -> None:
        window.panels("space")[0].show_page("visibility")
        subject = Subject("visibility", entry=painter.__name__)
        window.session.update_state(subject=subject, step=5, pixel=(10, 5), pixel_of="visibility")
        window.arrangements.bring_forward("fragments")

    _visibility(window, "arena-ring", 0)
    window.enter("space", arrive)


def _empty(window: MainWindow) -> None:
    window.session.new()
    window.go("space")
