"""Edits: each function here returns a function from document to document.

An edit refuses what would not be sound with DocumentError, in one sentence, and never changes the document
it is given. What an edit adds may carry empty ids: it is given new ones.
"""

from collections.abc import Iterable, Mapping
from typing import Any

import msgspec
from msgspec.structs import replace

from workbench.document.addresses import (
    WHOLE,
    Address,
    declared_at,
    figure_with,
    figures_with,
    new_ids,
    owner,
    parse,
    point_with,
    sheet_with,
)
from workbench.document.building import (
    Edit,
    all_numbered,
    both,
    checked,
    like,
    moved_by,
    number,
    numbered,
    of_many_points,
    plain,
    polyline_with,
    position,
    remembering,
    replaced,
    with_changed,
    with_figures,
    with_owner,
    with_points,
    without_ids,
)
from workbench.document.curves.edits import moved_points
from workbench.document.errors import DocumentError
from workbench.document.grouping import group_figures, regrouped, shift_order, ungroup_figures
from workbench.document.model import AnyFigure, Curve, Document, Polygon, WorldPoint
from workbench.document.motion.model import Motion
from workbench.document.motion.tracks import tracks_of, with_copied_tracks, with_motion
from workbench.document.parts import ids_of_copy
from workbench.document.sheet_edits import (
    add_apart,
    add_sheet,
    remove_sheet,
    rename_sheet,
    reorder_sheet,
    set_clipper,
    set_palette,
    set_sheet_size,
)
from workbench.document.storage.blobs import Blob
from workbench.document.transforms.chains import is_singular
from workbench.document.view_edits import (
    add_view,
    pan,
    remove_view,
    rename_view,
    reorder_view,
    set_clip,
    set_mode,
    set_viewport,
    set_window,
    zoom,
)
from workbench.language import _

__all__ = [
    "Edit",
    "add_apart",
    "add_figure",
    "add_figures",
    "add_ring",
    "add_sheet",
    "add_view",
    "both",
    "duplicate_figures",
    "group_figures",
    "insert_point",
    "move_figures",
    "move_points",
    "pan",
    "remove_figures",
    "remove_point",
    "remove_sheet",
    "remove_view",
    "rename_figure",
    "rename_sheet",
    "rename_view",
    "reorder",
    "reorder_sheet",
    "reorder_view",
    "set_algorithm",
    "set_attribute",
    "set_attributes",
    "set_clip",
    "set_clipper",
    "set_closed",
    "set_mode",
    "set_palette",
    "set_sheet_size",
    "set_viewport",
    "set_window",
    "shift_order",
    "ungroup_figures",
    "zoom",
]


@checked
def add_figure(sheet: str, figure: AnyFigure, index: int | None = None) -> Edit:
    """Put ``figure`` on ``sheet``, at ``index`` from the back, by default in front of all others."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        at = position(len(on.figures) if index is None else index, len(on.figures), "figures")
        added = numbered(document, plain(figure))
        return with_figures(document, on, (*on.figures[:at], added, *on.figures[at:]))

    return edit


@checked
def add_figures(sheet: str, figures: Iterable[AnyFigure]) -> Edit:
    """Put ``figures`` on ``sheet``, in front of all others, the last one foremost, with ids and groups of
    their own.
    """
    chosen = tuple(figures)

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        return with_figures(
            document, on, (*on.figures, *all_numbered(document, regrouped(chosen, on.figures)))
        )

    return edit


@checked
def add_moving_figures(
    sheet: str, figures: Iterable[AnyFigure], originals: Iterable[AnyFigure], motion: Motion
) -> Edit:
    """As ``add_figures``; each moves as the one in its place among ``originals`` does in ``motion``.

    A sheet that has no motion yet gets the length and the rate of this one.
    """
    wanted, before = tuple(figures), tuple(originals)

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        added = all_numbered(document, regrouped(wanted, on.figures))
        document = with_figures(document, on, (*on.figures, *added))
        if on.motion is None:
            document = with_motion(document, sheet, replace(motion, tracks=()))
        pairs = map(ids_of_copy, before, added)
        renamed = {old: new for each in pairs for old, new in each.items()}
        there = replace(on, figures=before)
        return with_copied_tracks(document, sheet, motion.tracks, there, renamed)

    return edit


def add_drawing(sheet: str, figures: Iterable[AnyFigure], palette: Iterable[int] = ()) -> Edit:
    """Put ``figures`` on ``sheet``, whose palette, if one is given, they need."""
    colours = tuple(palette)
    added = add_figures(sheet, figures)
    return both(set_palette(sheet, colours), added) if colours else added


@checked
def remove_figures(figures: Iterable[str]) -> Edit:
    """Remove the figures with these ids."""
    gone = frozenset(figures)

    def edit(document: Document) -> Document:
        figures_with(document, gone)
        kept = document
        for sheet in document.sheets:
            if any(figure.id in gone for figure in sheet.figures):
                kept = with_figures(kept, sheet, tuple(f for f in sheet.figures if f.id not in gone))
        return remembering(document, kept)

    return edit


@checked
def duplicate_figures(figures: Iterable[str], dx_world: float = 1.0, dy_world: float = -1.0) -> Edit:
    """Put a copy of each figure right in front of it, or of its group, moved by (dx, dy) in every frame; the
    copies get ids and groups of their own, and tracks like its own.

    A figure that its transforms flatten is not moved.
    """
    chosen = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        others = [figure for sheet in document.sheets for figure in sheet.figures]
        for original in regrouped(figures_with(document, chosen), others):
            sheet, figure = figure_with(document, original.id)
            bare = without_ids(original)
            shifted = bare if is_singular(figure.matrix) else moved_by(bare, dx_world, dy_world)
            copy = numbered(document, shifted)
            at = sheet.figures.index(figure) + 1
            while at < len(sheet.figures) and sheet.figures[at].group in {figure.group, copy.group} - {0}:
                at += 1
            document = with_figures(document, sheet, (*sheet.figures[:at], copy, *sheet.figures[at:]))
            tracks = tracks_of(sheet, (figure.id,))
            document = with_copied_tracks(document, sheet.id, tracks, sheet, ids_of_copy(figure, copy))
        return document

    return edit


@checked
def reorder(figure: str, index: int) -> Edit:
    """Move ``figure`` to ``index`` on its sheet: 0 is behind all others, the last index in front of them."""

    def edit(document: Document) -> Document:
        sheet, moved = figure_with(document, figure)
        others = [other for other in sheet.figures if other.id != figure]
        others.insert(position(index, len(others), "figures"), moved)
        return with_figures(document, sheet, tuple(others))

    return edit


@checked
def move_points(points: Mapping[Address | str, tuple[float, float]]) -> Edit:
    """Put control points to coordinates before the chain; an address names its point, whatever its attribute.

    On a curve that is a path, handles follow as in ``curve_edits.move_curve_points``.
    """
    wanted: dict[str, dict[str, tuple[float, float]]] = {}
    for text, (x, y) in points.items():
        address = parse(text)
        wanted.setdefault(address.figure, {})[address.point] = (number(x), number(y))

    def edit(document: Document) -> Document:
        moved: list[AnyFigure] = []
        for figure in figures_with(document, wanted):
            places = wanted[figure.id]
            if isinstance(figure, Curve):
                moved.append(moved_points(figure, places))
                continue
            for point in places:
                point_with(figure, point)
            at = (
                replace(p, x=places[p.id][0], y=places[p.id][1]) if p.id in places else p
                for p in figure.points_world
            )
            moved.append(replace(figure, points_world=tuple(at)))
        return with_changed(document, moved)

    return edit


@checked
def move_figures(figures: Iterable[str], dx_world: float, dy_world: float) -> Edit:
    """Move these figures by (dx, dy): their control points by what takes them there through their chains."""
    chosen = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        those = figures_with(document, chosen)
        return with_changed(document, [moved_by(figure, dx_world, dy_world) for figure in those])

    return edit


@checked
def set_attribute(address: Address | str, value: Any) -> Edit:
    """Set one attribute: a number, a name, a truth, an algorithm; never an id, a list or a whole thing."""
    where = parse(address)

    def edit(document: Document) -> Document:
        kind, many = declared_at(document, where)
        if where.attribute in (WHOLE, "id", "last_id") or many or kind in (msgspec.Struct, Blob):
            sentence = _("{address} cannot be set by itself; set one of its attributes.")
            raise DocumentError(str(where), sentence.format(address=where))
        new = like(kind, value, str(where))
        holder = owner(document, where)
        return with_owner(document, where, replaced(holder, where.attribute.split("."), new))

    return edit


def set_attributes(values: Mapping[Address | str, Any]) -> Edit:
    """Set several attributes in one edit."""
    return both(*(set_attribute(address, value) for address, value in values.items()))


@checked
def set_algorithm(figures: str | Iterable[str], slug: str) -> Edit:
    """Let these figures be drawn by the algorithm ``slug``."""
    chosen = (figures,) if isinstance(figures, str) else tuple(figures)

    def edit(document: Document) -> Document:
        those = figures_with(document, chosen)
        return with_changed(document, [replace(figure, algorithm=slug) for figure in those])

    return edit


@checked
def insert_point(figure: str, index: int, x_world: float, y_world: float) -> Edit:
    """Insert a control point into a polyline or polygon, before the one that is now at ``index``.

    A polygon takes it into the ring of that one, at the very end into the last ring.
    """

    def edit(document: Document) -> Document:
        line = of_many_points(document, figure)
        at = position(index, len(line.points_world), "points_world")
        point = WorldPoint(new_ids(document, "p", 1)[0], number(x_world), number(y_world))
        points = (*line.points_world[:at], point, *line.points_world[at:])
        return with_changed(document, [with_points(line, points, at, 1)])

    return edit


@checked
def remove_point(address: Address | str) -> Edit:
    """Remove the control point that ``address`` names from its polyline or polygon."""
    where = parse(address)

    def edit(document: Document) -> Document:
        line = of_many_points(document, where.figure)
        gone = point_with(line, where.point)
        at = line.points_world.index(gone)
        points = (*line.points_world[:at], *line.points_world[at + 1 :])
        return remembering(document, with_changed(document, [with_points(line, points, at, -1)]))

    return edit


@checked
def add_ring(polygon: str, corners_world: Iterable[tuple[float, float]]) -> Edit:
    """Add a ring, of three corners or more, to a polygon."""
    corners = [(number(x), number(y)) for x, y in corners_world]

    def edit(document: Document) -> Document:
        old = figure_with(document, polygon)[1]
        if not isinstance(old, Polygon):
            sentence = _("Figure {id!r} is not a polygon, so it has no rings; choose a polygon.")
            raise DocumentError(polygon, sentence.format(id=polygon))
        fresh = new_ids(document, "p", len(corners))
        added = tuple(WorldPoint(name, x, y) for name, (x, y) in zip(fresh, corners, strict=True))
        count = len(old.points_world)
        ends = (*(old.ring_ends or (count,)), count + len(added))
        return with_changed(
            document, [replace(old, points_world=(*old.points_world, *added), ring_ends=ends)]
        )

    return edit


@checked
def set_closed(figure: str, closed: bool) -> Edit:
    """Close a polyline, or open it."""
    return lambda document: with_changed(document, [replace(polyline_with(document, figure), closed=closed)])


@checked
def rename_figure(figure: str, name: str) -> Edit:
    """Give a figure a name, or none."""
    return lambda document: with_changed(document, [replace(figure_with(document, figure)[1], name=name)])
