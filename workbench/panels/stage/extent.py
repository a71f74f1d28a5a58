"""What is said of a rectangle without area."""

from workbench.document.model import Rectangle
from workbench.language import _


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
