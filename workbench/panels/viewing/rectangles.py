"""The rectangles of a view, by name: window, clip window, viewport; their grips, and how they are dragged."""

from collections.abc import Callable
from typing import NamedTuple

from msgspec.structs import replace

from workbench.document.building import Edit
from workbench.document.model import Rectangle, View
from workbench.document.view_edits import set_clip, set_viewport, set_window
from workbench.language import _
from workbench.panels.stage.extent import GRIPS, SIDE_OF
from workbench.widgets.canvas.overlay import Handle

SIDES = ("xmin", "ymin", "xmax", "ymax")


class Named(NamedTuple):
    """A rectangle of a view: what it is called, its ink and how it is edited."""

    slug: str
    title: str
    ink: str
    of: Callable[[View], Rectangle | None]
    edit: Callable[[str, Rectangle], Edit]


def rectangles() -> dict[str, Named]:
    """All three, by slug."""
    return {
        "window": Named("window", _("window"), "data1", lambda view: view.window_world, set_window),
        "clip": Named("clip", _("clip window"), "data4", lambda view: view.clip_world, set_clip),
        "viewport": Named(
            "viewport", _("viewport"), "data2", lambda view: view.viewport_device, set_viewport
        ),
    }


def grips(name: Named, rectangle: Rectangle, held: str) -> list[Handle]:
    """Corners and sides to take hold of; ``id`` is "window/left top"."""
    wide, high = rectangle.xmax - rectangle.xmin, rectangle.ymax - rectangle.ymin
    made = []
    for grip, (u, v) in GRIPS.items():
        identity = f"{name.slug}/{grip}"
        x, y = rectangle.xmin + u * wide, rectangle.ymin + v * high
        made.append(Handle(identity, "", x, y, identity == held, "square", name.ink))
    return made


def inside(rectangle: Rectangle, x: float, y: float, reach: float = 0.0) -> bool:
    """Whether a point lies in a rectangle, or no farther than ``reach`` from it."""
    return (
        rectangle.xmin - reach <= x <= rectangle.xmax + reach
        and rectangle.ymin - reach <= y <= rectangle.ymax + reach
    )


def moved(rectangle: Rectangle, dx: float, dy: float) -> Rectangle:
    """The rectangle somewhere else."""
    sides = rectangle.xmin + dx, rectangle.ymin + dy, rectangle.xmax + dx, rectangle.ymax + dy
    return Rectangle(*(_tidy(side) for side in sides))


def stretched(rectangle: Rectangle, grip: str, x: float, y: float, least: float) -> Rectangle:
    """The rectangle with the sides of a grip at (x, y), at least ``least`` wide and high."""
    for word in grip.split():
        side = SIDE_OF[word]
        value = x if side in ("xmin", "xmax") else y
        if side.endswith("min"):
            value = min(value, getattr(rectangle, side.replace("min", "max")) - least)
        else:
            value = max(value, getattr(rectangle, side.replace("max", "min")) + least)
        rectangle = replace(rectangle, **{side: _tidy(value)})
    return rectangle


def between(x0: float, y0: float, x1: float, y1: float, least: float) -> Rectangle | None:
    """The rectangle between two corners; None where it is narrower or lower than ``least``."""
    sides = min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)
    if sides[2] - sides[0] < least or sides[3] - sides[1] < least:
        return None
    return Rectangle(*(_tidy(side) for side in sides))


def snapped(value: float, step: float) -> float:
    """The nearest multiple of ``step``."""
    return _tidy(round(value / step) * step)


def _tidy(value: float) -> float:
    """A number without what rounding has left in it, never -0."""
    return round(value, 9) + 0.0
