"""How the marks of a step look on a canvas: the widths and sizes, in logical pixels, of what they name."""

from workbench.algorithms import marks
from workbench.algorithms.marks import Shape, Size, Weight
from workbench.widgets.canvas.drawing import Drawn, Region, Sized, Spot, Stroke, Word

_WIDTHS: dict[Weight, float] = {"hair": 1.0, "thin": 1.5, "medium": 3.0, "bold": 4.0, "heavy": 5.0}
_SIZES: dict[Size, float] = {"small": 6.0, "medium": 8.0, "large": 13.0}
# A square has corners, a cross and a ring have no body: so they look alike.
_MORE: dict[Shape, float] = {"square": -1.0, "cross": 1.0, "ring": 2.0}
_TINT = 40


def sized(each: Drawn, cell: float) -> Sized:
    """A mark as it is painted where a pixel of the picture is ``cell`` logical pixels wide."""
    match each:
        case marks.Stroke():
            width = min(_WIDTHS["medium"], cell / 3) if each.weight == "pixel" else _WIDTHS[each.weight]
            fine = each.weight == "hair" or (each.weight == "thin" and each.pattern != "solid")
            return Stroke(each.points, each.ink, width, each.pattern, haloed=not fine)
        case marks.Region():
            return Region(each.points, each.ink, _TINT)
        case marks.Spot():
            if each.size == "pixel":
                return Spot(each.x, each.y, each.ink, each.shape, max(2.0, min(_SIZES["small"], cell / 2)))
            more = _MORE.get(each.shape, 0.0) if each.size == "medium" else 0.0
            return Spot(each.x, each.y, each.ink, each.shape, _SIZES[each.size] + more)
        case marks.Word():
            return Word(*each)
        case marks.Ray():
            raise ValueError("A ray ends at the edge of a picture: map it to the device first.")
        case marks.Matrix():
            raise ValueError("A matrix stands beside a picture, not in it.")
    return each
