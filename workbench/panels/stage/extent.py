"""Rectangles that are dragged: their grips, and what is said of one without area."""

from workbench.document.model import Rectangle
from workbench.language import _

# Where each grip of a rectangle lies, as shares of its width and height; and the side of each direction
GRIPS = {
    "left bottom": (0.0, 0.0),
    "right bottom": (1.0, 0.0),
    "right top": (1.0, 1.0),
    "left top": (0.0, 1.0),
    "left": (0.0, 0.5),
    "right": (1.0, 0.5),
    "bottom": (0.5, 0.0),
    "top": (0.5, 1.0),
}
SIDE_OF = {"left": "xmin", "right": "xmax", "bottom": "ymin", "top": "ymax"}


def no_extent(rectangle: Rectangle, viewport: bool = False) -> str:
    """What is wrong with a window, or a viewport, without area; empty when nothing is."""
    tail = _("Drag one of its sides, or type another value.")
    no_width = _("The viewport has no width") if viewport else _("The window has no width")
    no_height = _("The viewport has no height") if viewport else _("The window has no height")
    for low, high, missing, low_name, high_name in (
        (rectangle.xmin, rectangle.xmax, no_width, "x_min", "x_max"),
        (rectangle.ymin, rectangle.ymax, no_height, "y_min", "y_max"),
    ):
        if low == high:
            text = _("{missing}: {low_name} and {high_name} are both {low:g}.")
        elif low > high:
            text = _("{missing}: {low_name} = {low:g} is beyond {high_name} = {high:g}.")
        else:
            continue
        said = text.format(missing=missing, low_name=low_name, high_name=high_name, low=low, high=high)
        return f"{said} {tail}"
    return ""
