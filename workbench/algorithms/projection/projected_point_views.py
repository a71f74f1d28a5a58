"""What the projection of a point shows of its blocks."""

from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.numerals import settled
from workbench.algorithms.projection.classification import classify
from workbench.algorithms.transforms.products import factors_text, row_of

Array = NDArray[Any]


def keeps_depth(projection: Array) -> bool:
    """Whether z after the division tells the points of a line of sight apart."""
    return classify(projection).keeps_depth


_W = "factors_text(projection[3], (x_v, y_v, z_v, 1.0))"
_OPTIONS = "('divide by w', 'nothing to divide: w is 1', 'no image: w is not positive')"


def _projected_view(when: str, answer: str, sentence: str) -> View:
    """The view of the projection's matrix, where w tells what is left to do."""
    return View(
        block="Multiply by the projection",
        when=when,
        row="('projection', *settled(x_h, y_h, z_h), w)",
        options=_OPTIONS,
        answer=repr(answer),
        marks="(row_of('P', projection, 3),)",
        sentence=f"The last row gives w = {{{_W}}} = {{w}}{sentence}",
    )


VIEW_FUNCTIONS = (factors_text, keeps_depth, row_of, settled)

VIEWS = (
    View(
        block="Place the point in the world",
        row="('world', *settled(x, y, z), one)",
        sentence="The model's matrix takes the point to {settled(x, y, z)} in the world.",
    ),
    View(
        block="Turn to view coordinates",
        row="('view', *settled(x_v, y_v, z_v), one)",
        sentence="Seen from the eye it is at {settled(x_v, y_v, z_v)}: right, up, and {z_v} "
        "into the picture.",
    ),
    _projected_view("w == 1.0", "nothing to divide: w is 1", ": the division changes nothing."),
    _projected_view(
        "w == 0.0",
        "no image: w is not positive",
        ": the point is level with the centre of projection, and its projector never meets the plane.",
    ),
    _projected_view(
        "w < 0.0",
        "no image: w is not positive",
        ": the point is behind the centre of projection, and has to be clipped away before the division.",
    ),
    _projected_view("True", "divide by w", ": divide by it."),
    View(
        block="Divide by w",
        when="keeps_depth(projection)",
        row="('view plane', *settled(x_p, y_p, z_p), 1.0)",
        sentence="{settled(x_h, y_h, z_h)}/{w} = {settled(x_p, y_p, z_p)}; its z is left for "
        "hidden surfaces.",
    ),
    View(
        block="Divide by w",
        row="('view plane', *settled(x_p, y_p, z_p), 1.0)",
        sentence="{settled(x_h, y_h, z_h)}/{w} = {settled(x_p, y_p, z_p)}: on this line of sight "
        "z comes out so at any depth, and says nothing of what hides what.",
    ),
    View(
        block="Map to the viewport",
        row="('device', *settled(x_d, y_d, z_p), 1.0)",
        sentence="On the device that is {x_d}, {y_d}, in pixels.",
    ),
)
