"""What clipping to the view volume shows of its blocks."""

from workbench.algorithms.entry import View

_PLANES = ("near", "far", "left", "right", "bottom", "top")


def plane_name(plane: int) -> str:
    """What the course calls a plane of the view volume."""
    return _PLANES[plane]


TAKEN, HANDED_ON = "Corners taken", "Corners handed on"
"""The tables of a step: the polygon as a plane takes it, and as far as it hands it on."""

_SIDE = "Clip the side that ends at this corner"
_OPTIONS = "('in → in', 'in → out', 'out → in', 'out → out')"


def _side_view(when: str, case: str, sentence: str) -> View:
    """The view of one of the four cases."""
    return View(
        block=_SIDE,
        when=when,
        row=f"(ring, plane_name(plane), tuple(start), tuple(end), d_start, d_end, {case!r})",
        tables={
            TAKEN: ("polygon", ("x", "y", "z", "w")),
            HANDED_ON: ("clipped", ("x", "y", "z", "w")),
        },
        options=_OPTIONS,
        answer=repr(case),
        sentence=f"{{plane_name(plane)}} plane: the start is {{d_start}} inside and the end {{d_end}}: "
        f"{sentence}",
    )


VIEW_FUNCTIONS = (plane_name,)

VIEWS = (
    View(
        block="Take the whole polygon",
        sentence="Polygon {ring} has {len(polygon)} corners; the near plane clips it first, so that what "
        "is behind the eye is gone before the division.",
    ),
    _side_view("d_start >= 0.0 and d_end >= 0.0", "in → in", "hand on the end."),
    _side_view("d_start >= 0.0", "in → out", "hand on the intersection, {tuple(clipped[-1])}."),
    _side_view("d_end >= 0.0", "out → in", "hand on the intersection, {tuple(clipped[-2])}, and the end."),
    _side_view("True", "out → out", "hand on nothing."),
    View(
        block="Hand the list on to the next plane",
        sentence="The {plane_name(plane)} plane leaves {len(polygon)} corners.",
    ),
    View(
        block="Emit the corners that are left",
        when="not polygon",
        sentence="Nothing of polygon {ring} is in the view volume.",
    ),
    View(
        block="Emit the corners that are left",
        sentence="{len(polygon)} corners of polygon {ring} are left; now w > 0, and they can be divided "
        "by it.",
    ),
)
