"""Edits of whole sheets: their order and size, what clips on them, their palette."""

from collections.abc import Iterable
from itertools import count

from msgspec.structs import replace

from workbench.document.addresses import highest, new_ids, sheet_with
from workbench.document.building import (
    Edit,
    checked,
    ids_on,
    plain,
    position,
    remembering,
    whole_number,
    with_figures,
    with_ids,
    with_sheet,
    without_ids,
)
from workbench.document.model import (
    MAX_SIDE_PX,
    POLYGON_CLIPPERS,
    AnyFigure,
    Document,
    Sheet,
    View,
    whole_sheet,
)
from workbench.document.motion.tracks import with_new_ids
from workbench.document.names import free_name
from workbench.document.parts import number_of
from workbench.document.scene.renaming import with_fresh_ids


@checked
def add_sheet(sheet: Sheet, index: int | None = None) -> Edit:
    """Add ``sheet``, by default after the others; every id in it that is empty or taken is replaced."""

    def edit(document: Document) -> Document:
        at = position(len(document.sheets) if index is None else index, len(document.sheets), "sheets")
        identity = sheet.id
        if not identity or any(identity == other.id for other in document.sheets):
            identity = new_ids(document, "s", 1)[0]
        mine = set(ids_on(sheet))
        taken = {known for other in document.sheets for known in mine.intersection(ids_on(other))}
        taken.add(identity)
        own = (number_of(name) for name in (identity, *mine))
        fresh = count(max(document.last_id, highest(document), *own) + 1)
        views = []
        for view in map(plain, sheet.views):
            if not view.id or view.id in taken:
                view = replace(view, id=f"{view.letter}{next(fresh)}")
            taken.add(view.id)
            views.append(view)
        added = replace(sheet, id=identity, views=tuple(views), figures=(), scene=None, motion=None)
        document = replace(document, sheets=(*document.sheets[:at], added, *document.sheets[at:]))
        figures: list[AnyFigure] = []
        renamed: dict[str, str] = {}
        for figure in sheet.figures:
            old, figure = figure.ids, plain(figure)
            if not all(figure.ids) or not taken.isdisjoint(figure.ids):
                figure = with_ids(without_ids(figure), fresh, fresh)
                renamed |= zip(old, figure.ids, strict=True)
            taken.update(figure.ids)
            figures.append(figure)
        if sheet.scene is not None:
            scene = with_fresh_ids(
                plain(sheet.scene), lambda thing: not all(thing.ids) or not taken.isdisjoint(thing.ids), fresh
            )
            added = replace(added, scene=scene)
            pairs = zip(sheet.scene.things, scene.things, strict=True)
            renamed |= {old: new for was, thing in pairs for old, new in zip(was.ids, thing.ids, strict=True)}
        if sheet.motion is not None:
            added = replace(added, motion=with_new_ids(plain(sheet.motion), renamed, fresh))
        return with_figures(document, added, tuple(figures))

    return edit


def add_apart(sheet: Sheet, index: int | None = None) -> Edit:
    """Add ``sheet`` as ``add_sheet`` does, under a name that no other sheet has."""

    def edit(document: Document) -> Document:
        name = free_name(sheet.name, {other.name for other in document.sheets})
        return add_sheet(replace(sheet, name=name), index)(document)

    return edit


@checked
def remove_sheet(sheet: str) -> Edit:
    """Remove a sheet; the last one stays."""

    def edit(document: Document) -> Document:
        gone = sheet_with(document, sheet)
        return remembering(
            document, replace(document, sheets=tuple(s for s in document.sheets if s is not gone))
        )

    return edit


@checked
def rename_sheet(sheet: str, name: str) -> Edit:
    """Give a sheet a name."""
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), name=name))


@checked
def reorder_sheet(sheet: str, index: int) -> Edit:
    """Move a sheet to ``index`` among the others."""

    def edit(document: Document) -> Document:
        moved = sheet_with(document, sheet)
        others = [other for other in document.sheets if other is not moved]
        others.insert(position(index, len(others), "sheets"), moved)
        return replace(document, sheets=tuple(others))

    return edit


@checked
def set_sheet_size(sheet: str, width_px: int, height_px: int) -> Edit:
    """Set a sheet's size. Viewports over the whole sheet follow, and their windows at their scale."""

    def edit(document: Document) -> Document:
        old = sheet_with(document, sheet)
        sizes = (old.width_px, old.height_px, width_px, height_px)
        views = old.views
        if all(type(size) is int and 0 < size <= MAX_SIDE_PX for size in sizes):
            views = tuple(_grown(view, *sizes) for view in views)
        return with_sheet(document, replace(old, width_px=width_px, height_px=height_px, views=views))

    return edit


def _grown(view: View, old_width: int, old_height: int, width: int, height: int) -> View:
    """``view`` on a sheet of another size, if its viewport is the whole sheet."""
    if view.viewport_device != whole_sheet(old_width, old_height):
        return view
    window = view.window_world
    wide = (window.xmax - window.xmin) * (width / old_width)
    high = (window.ymax - window.ymin) * (height / old_height)
    grown = replace(window, xmax=window.xmin + wide, ymax=window.ymin + high)
    return replace(view, viewport_device=whole_sheet(width, height), window_world=grown)


@checked
def set_clipper(sheet: str, slug: str) -> Edit:
    """Choose the algorithm that clips lines, or that which clips polygons: whichever this one is."""
    return lambda document: with_sheet(document, with_clipper(sheet_with(document, sheet), slug))


def with_clipper(sheet: Sheet, slug: str) -> Sheet:
    """``sheet`` with this algorithm in the place of the one that clips the same figures."""
    if slug in POLYGON_CLIPPERS:
        return replace(sheet, polygon_clipper=slug)
    return replace(sheet, line_clipper=slug)


@checked
def set_palette(sheet: str, palette: Iterable[int]) -> Edit:
    """Set the palette (0xRRGGBB); it must hold every colour that the sheet uses."""
    colours = tuple(whole_number(colour) for colour in palette)

    def edit(document: Document) -> Document:
        # The figures are looked at again, since a shorter palette may lack a colour of theirs.
        return with_sheet(document, replace(sheet_with(document, sheet), palette=colours))

    return edit
