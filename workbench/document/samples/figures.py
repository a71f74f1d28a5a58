"""What the built-in documents are made of: figures without ids, numbered when their sheet is made."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, count

from workbench.document.building import with_ids, without_ids
from workbench.document.model import (
    AnyFigure,
    Document,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    View,
    WorldPoint,
    whole_sheet,
)

# The paper, then colours that keep a contrast of 3:1 on white and on near-black, then a grey.
PALETTE = (0x000000, 0x0072B2, 0xD55E00, 0x00805C, 0xC2417C, 0xA97400, 0x1F86BF, 0x7F7F7F)

Places = Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class Example:
    """A built-in document: ``slug`` names it in links, ``workspace`` is the one it opens in.

    ``page`` is the one of that workspace's pages, where it has several and this is not the first; ``frame``
    is the one to begin in, ``dock`` the one that tells of what it is about; ``entry`` is the slug that it is
    run under where the page has several and this is not the first.
    """

    slug: str
    title: str
    description: str
    workspace: str
    document: Document
    page: str = ""
    frame: int = 0
    dock: str = ""
    entry: str = ""


def document_of(
    name: str,
    width_px: int,
    height_px: int,
    figures: Sequence[AnyFigure],
    clip_world: Rectangle | None = None,
) -> Document:
    """One sheet, whose world is its pixels, with these figures from back to front."""
    whole = whole_sheet(width_px, height_px)
    own, parts = count(1), count(1)
    numbered = tuple(with_ids(without_ids(figure), own, parts) for figure in figures)
    view = View("v1", whole, whole, clip_world=clip_world)
    return Document((Sheet("s1", name, width_px, height_px, (view,), PALETTE, numbered),))


def points_at(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    """Control points at these places."""
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


def line(
    start: tuple[float, float],
    end: tuple[float, float],
    colour: int = 1,
    algorithm: str = "bresenham_line",
    name: str = "",
) -> Line:
    """A line."""
    return Line("", points_at(start, end), algorithm, colour, name)


def polyline(places: Places, colour: int, name: str, closed: bool) -> Polyline:
    """A polyline by Bresenham's algorithm."""
    return Polyline("", points_at(*places), "bresenham_line", colour, name, closed=closed)


def polygon(
    rings: Sequence[Places],
    colour: int,
    name: str,
    closed: bool = False,
    nonzero: bool = False,
    algorithm: str = "scan_line_exact",
) -> Polygon:
    """A filled polygon of one or more rings."""
    ends = tuple(accumulate(len(ring) for ring in rings)) if len(rings) > 1 else ()
    corners = points_at(*(place for ring in rings for place in ring))
    return Polygon(
        "", corners, algorithm, colour, name, ring_ends=ends, closed_interior=closed, nonzero=nonzero
    )


def seed_fill(
    seed: tuple[float, float],
    colour: int,
    boundary: int,
    name: str,
    algorithm: str = "boundary_fill_4",
    recursion_limit: int = 1000,
) -> SeedFill:
    """A fill from a seed."""
    return SeedFill(
        "",
        points_at(seed),
        algorithm,
        colour,
        name,
        boundary=boundary,
        recursion_limit=recursion_limit,
    )
