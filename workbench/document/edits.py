"""Edits: each function here returns a function from document to document.

An edit refuses what would not be sound with DocumentError, in one sentence, and never changes the document
it is given. What an edit adds may carry empty ids: it is given new ones.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import Any, ParamSpec

from msgspec.structs import replace

from workbench.document.addresses import (
    WHOLE,
    Address,
    figure_with,
    figures_with,
    new_ids,
    owner,
    parse,
    point_with,
    resolve,
    sheet_with,
)
from workbench.document.building import (
    ids_of,
    ids_on,
    like,
    moved_by,
    number,
    numbered,
    of_many_points,
    plain,
    plain_rectangle,
    polyline_with,
    position,
    remembering,
    replaced,
    whole_number,
    with_changed,
    with_figures,
    with_owner,
    with_points,
    with_sheet,
    without_ids,
)
from workbench.document.check import MAX_SIDE_PX, check
from workbench.document.errors import DocumentError
from workbench.document.model import (
    AnyFigure,
    Document,
    Polygon,
    Rectangle,
    Sheet,
    WorldPoint,
    whole_sheet,
)
from workbench.language import _

Edit = Callable[[Document], Document]
Arguments = ParamSpec("Arguments")


def _edit(change: Callable[Arguments, Edit]) -> Callable[Arguments, Edit]:
    """``change``, whose edits are checked before anybody sees their result."""

    @wraps(change)
    def make(*args: Arguments.args, **kwargs: Arguments.kwargs) -> Edit:
        unchecked = change(*args, **kwargs)
        return lambda document: check(unchecked(document), document)

    return make


def both(*edits: Edit) -> Edit:
    """One edit that does ``edits`` one after the other, or none of them."""

    def edit(document: Document) -> Document:
        for each in edits:
            document = each(document)
        return document

    return edit


@_edit
def add_figure(sheet: str, figure: AnyFigure, index: int | None = None) -> Edit:
    """Put ``figure`` on ``sheet``, at ``index`` from the back, by default in front of all others."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        at = position(len(on.figures) if index is None else index, len(on.figures), "figures")
        added = numbered(document, plain(figure))
        return with_figures(document, on, (*on.figures[:at], added, *on.figures[at:]))

    return edit


@_edit
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


@_edit
def duplicate_figures(figures: Iterable[str], dx_world: float = 1.0, dy_world: float = -1.0) -> Edit:
    """Put a copy of each figure right in front of it, moved by (dx, dy); the copies get ids of their own."""
    wanted = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        for identity in wanted:
            sheet, figure = figure_with(document, identity)
            copy = numbered(document, moved_by(without_ids(figure), dx_world, dy_world))
            at = sheet.figures.index(figure) + 1
            document = with_figures(document, sheet, (*sheet.figures[:at], copy, *sheet.figures[at:]))
        return document

    return edit


@_edit
def reorder(figure: str, index: int) -> Edit:
    """Move ``figure`` to ``index`` on its sheet: 0 is behind all others, the last index in front of them."""

    def edit(document: Document) -> Document:
        sheet, moved = figure_with(document, figure)
        others = [other for other in sheet.figures if other.id != figure]
        others.insert(position(index, len(others), "figures"), moved)
        return with_figures(document, sheet, tuple(others))

    return edit


@_edit
def move_points(points: Mapping[Address | str, tuple[float, float]]) -> Edit:
    """Put control points to world coordinates; an address names its point, whatever its attribute."""
    wanted: dict[str, dict[str, tuple[float, float]]] = {}
    for text, (x, y) in points.items():
        address = parse(text)
        wanted.setdefault(address.figure, {})[address.point] = (number(x), number(y))

    def edit(document: Document) -> Document:
        moved: list[AnyFigure] = []
        for figure in figures_with(document, wanted):
            places = wanted[figure.id]
            for point in places:
                point_with(figure, point)
            at = (
                replace(p, x=places[p.id][0], y=places[p.id][1]) if p.id in places else p
                for p in figure.points_world
            )
            moved.append(replace(figure, points_world=tuple(at)))
        return with_changed(document, moved)

    return edit


@_edit
def move_figures(figures: Iterable[str], dx_world: float, dy_world: float) -> Edit:
    """Move every control point of these figures by (dx, dy)."""
    wanted = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        found = figures_with(document, wanted)
        return with_changed(document, [moved_by(figure, dx_world, dy_world) for figure in found])

    return edit


@_edit
def set_attribute(address: Address | str, value: Any) -> Edit:
    """Set one attribute: a number, a name, a truth, an algorithm; never an id, a list or a whole thing."""
    where = parse(address)

    def edit(document: Document) -> Document:
        old = resolve(document, where)
        if where.attribute in (WHOLE, "id", "last_id") or not isinstance(old, (bool, int, float, str)):
            sentence = _("{address} cannot be set by itself; set one of its attributes.")
            raise DocumentError(str(where), sentence.format(address=where))
        new = like(old, value, str(where))
        holder = owner(document, where)
        return with_owner(document, where, replaced(holder, where.attribute.split("."), new))

    return edit


def set_attributes(values: Mapping[Address | str, Any]) -> Edit:
    """Set several attributes in one edit."""
    return both(*(set_attribute(address, value) for address, value in values.items()))


@_edit
def set_algorithm(figures: str | Iterable[str], slug: str) -> Edit:
    """Let these figures be drawn by the algorithm ``slug``."""
    wanted = (figures,) if isinstance(figures, str) else tuple(figures)

    def edit(document: Document) -> Document:
        found = figures_with(document, wanted)
        return with_changed(document, [replace(figure, algorithm=slug) for figure in found])

    return edit


@_edit
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


@_edit
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


@_edit
def add_ring(polygon: str, corners_world: Iterable[tuple[float, float]]) -> Edit:
    """Add a ring, of three corners or more, to a polygon."""
    corners = [(number(x), number(y)) for x, y in corners_world]

    def edit(document: Document) -> Document:
        old = figure_with(document, polygon)[1]
        if not isinstance(old, Polygon):
            sentence = _("Figure {id!r} is no polygon, so it has no rings; choose a polygon.")
            raise DocumentError(polygon, sentence.format(id=polygon))
        fresh = new_ids(document, "p", len(corners))
        added = tuple(WorldPoint(name, x, y) for name, (x, y) in zip(fresh, corners, strict=True))
        count = len(old.points_world)
        ends = (*(old.ring_ends or (count,)), count + len(added))
        return with_changed(
            document, [replace(old, points_world=(*old.points_world, *added), ring_ends=ends)]
        )

    return edit


@_edit
def set_closed(figure: str, closed: bool) -> Edit:
    """Close a polyline, or open it."""
    return lambda document: with_changed(document, [replace(polyline_with(document, figure), closed=closed)])


@_edit
def rename_figure(figure: str, name: str) -> Edit:
    """Give a figure a name, or none."""
    return lambda document: with_changed(document, [replace(figure_with(document, figure)[1], name=name)])


@_edit
def add_sheet(sheet: Sheet, index: int | None = None) -> Edit:
    """Add ``sheet``, by default after the others; every id in it that is empty or taken is replaced."""

    def edit(document: Document) -> Document:
        at = position(len(document.sheets) if index is None else index, len(document.sheets), "sheets")
        identity = sheet.id
        if not identity or any(identity == other.id for other in document.sheets):
            identity = new_ids(document, "s", 1)[0]
        added = replace(sheet, id=identity, figures=())
        document = replace(document, sheets=(*document.sheets[:at], added, *document.sheets[at:]))
        taken = {known for other in document.sheets for known in ids_on(other)}
        figures: list[AnyFigure] = []
        for figure in sheet.figures:
            figure = plain(figure)
            mine = ids_of(figure)
            if taken.intersection(mine) or not all(mine):
                figure = numbered(with_figures(document, added, tuple(figures)), without_ids(figure))
            taken.update(ids_of(figure))
            figures.append(figure)
        return with_figures(document, added, tuple(figures))

    return edit


@_edit
def remove_sheet(sheet: str) -> Edit:
    """Remove a sheet; the last one stays."""

    def edit(document: Document) -> Document:
        gone = sheet_with(document, sheet)
        return remembering(
            document, replace(document, sheets=tuple(s for s in document.sheets if s is not gone))
        )

    return edit


@_edit
def rename_sheet(sheet: str, name: str) -> Edit:
    """Give a sheet a name."""
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), name=name))


@_edit
def reorder_sheet(sheet: str, index: int) -> Edit:
    """Move a sheet to ``index`` among the others."""

    def edit(document: Document) -> Document:
        moved = sheet_with(document, sheet)
        others = [other for other in document.sheets if other is not moved]
        others.insert(position(index, len(others), "sheets"), moved)
        return replace(document, sheets=tuple(others))

    return edit


@_edit
def set_sheet_size(sheet: str, width_px: int, height_px: int) -> Edit:
    """Set a sheet's size. A viewport over the whole sheet follows, and the window at its scale."""

    def edit(document: Document) -> Document:
        old = sheet_with(document, sheet)
        new = replace(old, width_px=width_px, height_px=height_px)
        sizes = (old.width_px, old.height_px, width_px, height_px)
        if old.viewport_device == whole_sheet(*sizes[:2]) and all(
            type(size) is int and 0 < size <= MAX_SIDE_PX for size in sizes
        ):
            window = old.window_world
            wide = (window.xmax - window.xmin) * (width_px / old.width_px)
            high = (window.ymax - window.ymin) * (height_px / old.height_px)
            grown = replace(window, xmax=window.xmin + wide, ymax=window.ymin + high)
            new = replace(new, viewport_device=whole_sheet(width_px, height_px), window_world=grown)
        return with_sheet(document, new)

    return edit


@_edit
def set_window(sheet: str, window_world: Rectangle) -> Edit:
    """Set the window, in world coordinates."""
    window = plain_rectangle(window_world)
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), window_world=window))


@_edit
def set_clip(sheet: str, clip_world: Rectangle | None) -> Edit:
    """Set the window that figures are clipped to, in world coordinates; None clips nothing."""
    clip = None if clip_world is None else plain_rectangle(clip_world)
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), clip_world=clip))


@_edit
def set_clippers(sheet: str, line: str | None = None, polygon: str | None = None) -> Edit:
    """Choose the algorithms that clip lines and polygons; None keeps the one that is chosen."""

    def edit(document: Document) -> Document:
        old = sheet_with(document, sheet)
        changed = replace(
            old, line_clipper=line or old.line_clipper, polygon_clipper=polygon or old.polygon_clipper
        )
        return with_sheet(document, changed)

    return edit


@_edit
def set_viewport(sheet: str, viewport_device: Rectangle) -> Edit:
    """Set the viewport, in device coordinates."""
    viewport = plain_rectangle(viewport_device)
    return lambda document: with_sheet(
        document, replace(sheet_with(document, sheet), viewport_device=viewport)
    )


@_edit
def set_palette(sheet: str, palette: Iterable[int]) -> Edit:
    """Set the palette (0xRRGGBB); it must hold every colour that the sheet uses."""
    colours = tuple(whole_number(colour) for colour in palette)

    def edit(document: Document) -> Document:
        # The figures are looked at again, since a shorter palette may lack a colour of theirs.
        return with_sheet(document, replace(sheet_with(document, sheet), palette=colours))

    return edit
