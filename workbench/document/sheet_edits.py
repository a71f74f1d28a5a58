"""Edits of whole sheets: their size, their window and viewport, what clips on them, their palette."""

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
    Rectangle,
    Sheet,
    whole_sheet,
)


@checked
def add_sheet(sheet: Sheet, index: int | None = None) -> Edit:
    """Add ``sheet``, by default after the others; every id in it that is empty or taken is replaced."""

    def edit(document: Document) -> Document:
        at = position(len(document.sheets) if index is None else index, len(document.sheets), "sheets")
        identity = sheet.id
        if not identity or any(identity == other.id for other in document.sheets):
            identity = new_ids(document, "s", 1)[0]
        added = replace(sheet, id=identity, figures=())
        document = replace(document, sheets=(*document.sheets[:at], added, *document.sheets[at:]))
        mine = set(ids_on(sheet))
        taken = {known for other in document.sheets for known in mine.intersection(ids_on(other))}
        numbers = (document.last_id, highest(document), *(figure.highest for figure in sheet.figures))
        fresh = count(max(numbers) + 1)
        figures: list[AnyFigure] = []
        for figure in sheet.figures:
            figure = plain(figure)
            if not all(figure.ids) or not taken.isdisjoint(figure.ids):
                figure = with_ids(without_ids(figure), fresh, fresh)
            taken.update(figure.ids)
            figures.append(figure)
        return with_figures(document, added, tuple(figures))

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


@checked
def set_window(sheet: str, window_world: Rectangle) -> Edit:
    """Set the window, in world coordinates."""
    window = plain(window_world)
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), window_world=window))


@checked
def set_clip(sheet: str, clip_world: Rectangle | None) -> Edit:
    """Set the window that figures are clipped to, in world coordinates; None clips nothing."""
    clip = None if clip_world is None else plain(clip_world)
    return lambda document: with_sheet(document, replace(sheet_with(document, sheet), clip_world=clip))


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
def set_viewport(sheet: str, viewport_device: Rectangle) -> Edit:
    """Set the viewport, in device coordinates."""
    viewport = plain(viewport_device)
    return lambda document: with_sheet(
        document, replace(sheet_with(document, sheet), viewport_device=viewport)
    )


@checked
def set_palette(sheet: str, palette: Iterable[int]) -> Edit:
    """Set the palette (0xRRGGBB); it must hold every colour that the sheet uses."""
    colours = tuple(whole_number(colour) for colour in palette)

    def edit(document: Document) -> Document:
        # The figures are looked at again, since a shorter palette may lack a colour of theirs.
        return with_sheet(document, replace(sheet_with(document, sheet), palette=colours))

    return edit
