"""The commands that transform what is selected: for tool bar, menus, keys and the list of commands."""

from collections.abc import Callable
from functools import partial

from workbench.language import _
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.boxing import Boxing

BOX = "box"
MOTIONS = ("turn_left", "turn_right", "mirror_x", "mirror_y")
ON_CHAINS = ("bake", "remove_transforms")
"""Those that act on chains alone."""


def transform_commands(boxing: Boxing, toggle_box: Callable[[], object]) -> list[PanelCommand]:
    """Name, text, icon, key and what it does; the box comes first."""
    return [
        (BOX, _("Transform box"), "bounding-box", "Ctrl+T", toggle_box),
        ("turn_left", _("Rotate 90° left"), "arrow-counter-clockwise", "", partial(boxing.turn, True)),
        ("turn_right", _("Rotate 90° right"), "arrow-clockwise", "", partial(boxing.turn, False)),
        ("mirror_x", _("Flip horizontally"), "arrows-left-right", "Shift+H", partial(boxing.flip, "x")),
        ("mirror_y", _("Flip vertically"), "arrows-down-up", "Shift+V", partial(boxing.flip, "y")),
        ("bake", _("Bake transforms"), "push-pin", "", boxing.bake),
        ("remove_transforms", _("Remove transforms"), "eraser", "", boxing.remove),
    ]
