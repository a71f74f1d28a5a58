"""Edits of the views of a sheet: which there are, their window and viewport, and what clips in them."""

from msgspec.structs import replace

from workbench.document.addresses import new_ids, sheet_with, view_with
from workbench.document.building import (
    Edit,
    checked,
    number,
    plain,
    position,
    remembering,
    with_sheet,
    with_view,
)
from workbench.document.errors import DocumentError
from workbench.document.model import Document, Rectangle, View, whole_sheet
from workbench.language import _


@checked
def add_view(sheet: str, view: View, index: int | None = None) -> Edit:
    """Add ``view`` to a sheet, by default painted after the others; with an empty id it is given one."""

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        at = position(len(on.views) if index is None else index, len(on.views), "views")
        added = plain(view)
        if not added.id:
            added = replace(added, id=new_ids(document, View.letter, 1)[0])
        return with_sheet(document, replace(on, views=(*on.views[:at], added, *on.views[at:])))

    return edit


@checked
def remove_view(view: str) -> Edit:
    """Remove a view; the last one stays."""

    def edit(document: Document) -> Document:
        sheet, gone = view_with(document, view)
        kept = tuple(other for other in sheet.views if other is not gone)
        return remembering(document, with_sheet(document, replace(sheet, views=kept)))

    return edit


@checked
def reorder_view(view: str, index: int) -> Edit:
    """Move a view to ``index`` in the order of painting: the last one is painted over the others."""

    def edit(document: Document) -> Document:
        sheet, moved = view_with(document, view)
        others = [other for other in sheet.views if other is not moved]
        others.insert(position(index, len(others), "views"), moved)
        return with_sheet(document, replace(sheet, views=tuple(others)))

    return edit


@checked
def resize_device(sheet: str, width_px: int, height_px: int) -> Edit:
    """Show the same picture on a device of another size: every viewport keeps its place in normalised device
    coordinates, where the device is the unit square.
    """

    def edit(document: Document) -> Document:
        old = sheet_with(document, sheet)
        whole = whole_sheet(old.width_px, old.height_px)
        across, up = width_px / old.width_px, height_px / old.height_px
        views = tuple(
            replace(view, viewport_device=_on_another(view.viewport_device, whole, across, up))
            for view in old.views
        )
        return with_sheet(document, replace(old, width_px=width_px, height_px=height_px, views=views))

    return edit


def _on_another(viewport: Rectangle, whole: Rectangle, across: float, up: float) -> Rectangle:
    """A viewport on a device ``across`` times as wide and ``up`` times as high; both edges begin there."""
    sides = (
        whole.xmin + (viewport.xmin - whole.xmin) * across,
        whole.ymin + (viewport.ymin - whole.ymin) * up,
        whole.xmin + (viewport.xmax - whole.xmin) * across,
        whole.ymin + (viewport.ymax - whole.ymin) * up,
    )
    return Rectangle(*(round(side, 9) + 0.0 for side in sides))


def _changing(view: str, **changes: object) -> Edit:
    return lambda document: with_view(document, replace(view_with(document, view)[1], **changes))


@checked
def rename_view(view: str, name: str) -> Edit:
    """Give a view a name, or none."""
    return _changing(view, name=name)


@checked
def set_mode(view: str, mode: str) -> Edit:
    """Stretch the window onto the viewport, fit it in as a whole, or let it fill the viewport."""
    return _changing(view, mode=mode)


@checked
def set_window(view: str, window_world: Rectangle) -> Edit:
    """Set the window, in world coordinates."""
    return _changing(view, window_world=plain(window_world))


@checked
def set_viewport(view: str, viewport_device: Rectangle) -> Edit:
    """Set the viewport, in device coordinates."""
    return _changing(view, viewport_device=plain(viewport_device))


@checked
def set_clip(view: str, clip_world: Rectangle | None) -> Edit:
    """Set the window that figures are clipped to, in world coordinates; None clips nothing."""
    return _changing(view, clip_world=None if clip_world is None else plain(clip_world))


@checked
def pan(view: str, dx_world: float, dy_world: float) -> Edit:
    """Move the window over the world by (dx, dy)."""
    dx, dy = number(dx_world), number(dy_world)

    def edit(document: Document) -> Document:
        window = view_with(document, view)[1].window_world
        sides = window.xmin + dx, window.ymin + dy, window.xmax + dx, window.ymax + dy
        return _changing(view, window_world=Rectangle(*sides))(document)

    return edit


@checked
def zoom(view: str, factor: float, x_world: float, y_world: float) -> Edit:
    """Show the world ``factor`` times as large by a smaller window, in which (x, y) keeps its place."""
    factor, x, y = number(factor), number(x_world), number(y_world)

    def edit(document: Document) -> Document:
        if not factor > 0.0:
            sentence = _("A zoom by {factor:g} shows nothing; give a factor above 0.")
            raise DocumentError(view, sentence.format(factor=factor))
        window = view_with(document, view)[1].window_world
        sides = [
            at + (side - at) / factor
            for side, at in zip(
                (window.xmin, window.ymin, window.xmax, window.ymax), (x, y, x, y), strict=True
            )
        ]
        return _changing(view, window_world=Rectangle(*sides))(document)

    return edit
