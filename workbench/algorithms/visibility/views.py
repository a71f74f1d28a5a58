"""What the depth buffer shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.depth_marks import depth_mark, scan_line_marks
from workbench.algorithms.visibility.device_plane import Corner, crossing

_ROW = "(x, y, z, stored, won)"
_PIXEL = "((x, y),)"
_OPTIONS = "('nearer: write z and the colour', 'not nearer: leave both as they are')"
_SCAN_LINE = "scan_line_marks(low, middle, high, y, x_left, x_right)"
_MARKS = f"(*{_SCAN_LINE}, depth_mark(x, y, z))"
_TABLES = {
    "Plane of the triangle, in device coordinates": (
        "((A, B, C, D, dz_dx, up_left_edge(low, middle, high, y, A, B, C)),)",
        ("A", "B", "C", "D", "−A/C along the scan line", "−(A/m + B)/C up the left edge"),
    )
}


def left_slope(low: Corner, middle: Corner, high: Corner, y: int) -> float:
    """1/m of the edge at which the scan line y enters the triangle."""
    start, end = (low, middle) if y < middle.y else (middle, high)
    x_long = crossing(low.x, low.y, high.x, high.y, y)
    if x_long <= crossing(start.x, start.y, end.x, end.y, y):
        start, end = low, high
    return (end.x - start.x) / (end.y - start.y)


def up_left_edge(low: Corner, middle: Corner, high: Corner, y: int, A: float, B: float, C: float) -> float:
    """How z changes up the left edge from a scan line to the next: -(A/m + B)/C."""
    return -(A * left_slope(low, middle, high, y) + B) / C


VIEW_FUNCTIONS = (left_slope, up_left_edge, scan_line_marks, depth_mark)

VIEWS = (
    View(
        block="Find the plane Ax + By + Cz + D = 0 of the surface",
        when="C == 0.0",
        sentence="C = {C}: triangle {face} is seen edge on and covers no pixel.",
    ),
    View(
        block="Find the plane Ax + By + Cz + D = 0 of the surface",
        sentence="Triangle {face}, in device coordinates: A = {A}, B = {B}, C = {C}, D = {D}, so z changes "
        "by −A/C = {dz_dx} from a pixel to the next.",
    ),
    View(
        block="Find where the scan line enters and leaves the surface",
        tables=_TABLES,
        marks=_SCAN_LINE,
        sentence="Scan line y = {y} runs from x = {x_left} to {x_right}. Up the left edge 1/m = "
        "{left_slope(low, middle, high, y)}, so z changes by −(A/m + B)/C = "
        "{up_left_edge(low, middle, high, y, A, B, C)} per scan line.",
    ),
    View(
        block="Keep the nearer one",
        when="won == 1",
        candidates=_PIXEL,
        chosen=_PIXEL,
        row=_ROW,
        considers="(x, y)",
        tables=_TABLES,
        marks=_MARKS,
        options=_OPTIONS,
        answer="'nearer: write z and the colour'",
        sentence="At {(x, y)} z = {z} < {stored}, the depth stored there: it is nearer, so the depth "
        "buffer takes z, and the pixel takes the colour of triangle {face}.",
    ),
    View(
        block="Keep the nearer one",
        candidates=_PIXEL,
        rejected=_PIXEL,
        row=_ROW,
        considers="(x, y)",
        tables=_TABLES,
        marks=_MARKS,
        options=_OPTIONS,
        answer="'not nearer: leave both as they are'",
        sentence="At {(x, y)} z = {z} is not less than {stored}, the depth stored there: the pixel stays "
        "as it is.",
    ),
)
