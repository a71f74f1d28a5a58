"""What edits are made of: a document with something replaced, figures with ids, plain numbers."""

import operator
from collections.abc import Callable, Iterable, Iterator
from functools import wraps
from itertools import chain
from typing import Any, ParamSpec, SupportsFloat, SupportsIndex, TypeVar

import msgspec
import numpy as np
from msgspec.structs import replace

from workbench.document.addresses import Address, figure_with, highest, new_ids, owner, view_with
from workbench.document.check import check
from workbench.document.errors import DocumentError
from workbench.document.faults import shown
from workbench.document.fields import Choice, Number, fields_of, once_per_type, parts_of
from workbench.document.model import (
    AnyFigure,
    Document,
    Polygon,
    Polyline,
    Sheet,
    View,
    WorldPoint,
)
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import with_track, without_orphans
from workbench.document.numbers import COORDINATE
from workbench.document.scene.model import Scene, Thing
from workbench.document.transforms.chains import read_only_reason
from workbench.language import _

Edit = Callable[[Document], Document]
Arguments = ParamSpec("Arguments")
Holder = TypeVar("Holder", bound=msgspec.Struct)
Numbered = TypeVar("Numbered", bound=AnyFigure | Thing)


def checked(change: Callable[Arguments, Edit]) -> Callable[Arguments, Edit]:
    """``change``, whose edits are checked before anybody sees them; tracks go with what they hang on."""

    @wraps(change)
    def make(*args: Arguments.args, **kwargs: Arguments.kwargs) -> Edit:
        unchecked = change(*args, **kwargs)
        return lambda document: check(without_orphans(document, unchecked(document)), document)

    return make


def both(*edits: Edit) -> Edit:
    """One edit that does ``edits`` one after the other, or none of them."""

    def edit(document: Document) -> Document:
        for each in edits:
            document = each(document)
        return document

    return edit


def foreseen(edit: Edit, document: Document) -> Edit:
    """``edit`` with what it makes of ``document`` made now, perhaps beside the interface.

    Raises: DocumentError.
    """
    after = edit(document)
    return lambda now: after if now is document else edit(now)


def ids_on(sheet: Sheet) -> list[str]:
    """Every id on ``sheet``, its own first."""
    own = [sheet.id, *(view.id for view in sheet.views)]
    return [*own, *chain.from_iterable(map(operator.attrgetter("ids"), sheet.things))]


def with_sheet(document: Document, sheet: Sheet) -> Document:
    """``document`` with ``sheet`` in place of the one that has its id."""
    return replace(document, sheets=tuple(sheet if old.id == sheet.id else old for old in document.sheets))


def with_view(document: Document, view: View) -> Document:
    """``document`` with ``view`` in place of the one that has its id."""
    sheet = view_with(document, view.id)[0]
    views = tuple(view if old.id == view.id else old for old in sheet.views)
    return with_sheet(document, replace(sheet, views=views))


def with_figures(document: Document, sheet: Sheet, figures: tuple[AnyFigure, ...]) -> Document:
    """``document`` with these figures on ``sheet``."""
    return with_sheet(document, replace(sheet, figures=figures))


def with_changed(document: Document, figures: Iterable[AnyFigure]) -> Document:
    """``document`` with these in place of the figures that have their ids."""
    changed = {figure.id: figure for figure in figures}
    for sheet in document.sheets:
        if any(figure.id in changed for figure in sheet.figures):
            kept = tuple(changed.get(figure.id, figure) for figure in sheet.figures)
            document = with_figures(document, sheet, kept)
    return document


def scene_with(document: Document, thing: str) -> tuple[Sheet, Scene, Thing]:
    """The object, material or light with this id, its sheet and its scene; raises DocumentError."""
    for sheet in document.sheets:
        for candidate in sheet.scene.things if sheet.scene else ():
            if sheet.scene and candidate.id == thing:
                return sheet, sheet.scene, candidate
    raise DocumentError(
        thing, _("There is nothing called {id!r} in the scene; it may have been removed.").format(id=thing)
    )


def with_thing(document: Document, thing: Thing) -> Document:
    """``document`` with ``thing`` in its scene in place of the one that has its id."""
    sheet, scene, _old = scene_with(document, thing.id)
    lists = _of_parts(scene, lambda old: thing if old.id == thing.id else old)
    return with_sheet(document, replace(sheet, scene=replace(scene, **lists)))


def with_owner(document: Document, where: Address, changed: Any) -> Document:
    """``document`` with ``changed`` in place of what the attribute ``where`` belongs to."""
    if where.point:
        holder = owner(document, replace(where, point="", attribute="*"))
        lists = _of_parts(holder, lambda old: changed if old.id == where.point else old)
        changed = replace(holder, **lists)
    if isinstance(changed, Track):
        return with_track(document, where.sheet, changed)
    if isinstance(changed, Thing):
        return with_thing(document, changed)
    if where.figure:
        return (
            with_view(document, changed) if isinstance(changed, View) else with_changed(document, [changed])
        )
    return with_sheet(document, changed)


def replaced(holder: Any, path: list[str], value: Any) -> Any:
    """``holder`` with ``value`` at ``path``, a name followed by the name or index inside it, if any."""
    if not path:
        return value
    if isinstance(holder, tuple):
        at = int(path[0])
        return (*holder[:at], replaced(holder[at], path[1:], value), *holder[at + 1 :])
    return replace(holder, **{path[0]: replaced(getattr(holder, path[0]), path[1:], value)})


def remembering(before: Document, after: Document) -> Document:
    """``after``, which will not give the ids again that ``before`` had."""
    return replace(after, last_id=max(before.last_id, highest(before)))


def numbered(document: Document, figure: Numbered) -> Numbered:
    """``figure`` with new ids where its own are empty."""
    if all(figure.ids):
        return figure
    fresh = iter(new_ids(document, "", len(figure.ids)))
    return with_ids(figure, fresh, fresh)


def with_ids(figure: Numbered, own: Iterator[object], parts: Iterator[object]) -> Numbered:
    """``figure`` with ids where they are empty: numbers from ``own``, for its parts from ``parts``."""
    identity = figure.id or f"{figure.letter}{next(own)}"
    return replace(figure, id=identity, **_of_parts(figure, lambda part: _with_id(part, parts)))


def _with_id(part: Any, numbers: Iterator[object]) -> Any:
    return part if part.id else replace(part, id=f"{part.letter}{next(numbers)}")


def _of_parts(figure: Any, change: Callable[[Any], Any]) -> dict[str, tuple[Any, ...]]:
    """The lists of parts of ``figure`` by name, with ``change(part)`` in place of each part."""
    return {name: tuple(map(change, getattr(figure, name))) for name in parts_of(type(figure))}


def all_numbered(document: Document, figures: Iterable[AnyFigure]) -> tuple[AnyFigure, ...]:
    """``figures`` with Python's own numbers and new ids, whatever ids they had."""
    bare = [without_ids(plain(figure)) for figure in figures]
    fresh = iter(new_ids(document, "", sum(len(figure.ids) for figure in bare)))
    return tuple(with_ids(figure, fresh, fresh) for figure in bare)


def without_ids(figure: Numbered) -> Numbered:
    """``figure`` with empty ids, to be numbered anew."""
    return replace(figure, id="", **_of_parts(figure, lambda part: replace(part, id="")))


def moved_by(figure: AnyFigure, dx: float, dy: float) -> AnyFigure:
    """``figure`` moved by (dx, dy), world: its control points by what its chain makes that of.

    Raises: DocumentError, also where the chain cannot be undone.
    """
    dx, dy = like(COORDINATE, dx, "dx_world"), like(COORDINATE, dy, "dy_world")
    if figure.matrix is not None:
        if reason := read_only_reason(figure):
            raise DocumentError(figure.id, reason)
        dx, dy = np.linalg.solve(figure.matrix[:2, :2], (dx, dy)).tolist()
    points = tuple(replace(p, x=p.x + dx, y=p.y + dy) for p in figure.points_world)
    return replace(figure, points_world=points)


def polyline_with(document: Document, figure: str) -> Polyline:
    """The polyline with this id; raises DocumentError."""
    figure_there = figure_with(document, figure)[1]
    if not isinstance(figure_there, Polyline):
        sentence = _("Figure {id!r} is not a polyline, so it is neither open nor closed; choose a polyline.")
        raise DocumentError(figure, sentence.format(id=figure))
    return figure_there


def of_many_points(document: Document, figure: str) -> Polyline | Polygon:
    """The polyline or polygon with this id; raises DocumentError."""
    figure_there = figure_with(document, figure)[1]
    if not isinstance(figure_there, Polyline | Polygon):
        sentence = _(
            "Figure {id!r} is not a polyline or polygon, so its number of points is fixed; choose one."
        )
        raise DocumentError(figure, sentence.format(id=figure))
    return figure_there


def with_points(
    figure: Polyline | Polygon, points: tuple[WorldPoint, ...], at: int, more: int
) -> Polyline | Polygon:
    """``figure`` with ``points``, of which ``more`` are new (negative: gone) in the ring around ``at``."""
    if isinstance(figure, Polyline) or not figure.ring_ends:
        return replace(figure, points_world=points)
    ring = next((k for k, end in enumerate(figure.ring_ends) if at < end), len(figure.ring_ends) - 1)
    ends = tuple(end + more if k >= ring else end for k, end in enumerate(figure.ring_ends))
    return replace(figure, points_world=points, ring_ends=ends)


def position(index: int, most: int, field: str) -> int:
    """``index`` when it is a place from 0 to ``most``; raises DocumentError."""
    if type(index) is not int or not 0 <= index <= most:
        sentence = _("{field}: there is no position {index!r}; choose one from 0 to {most}.")
        raise DocumentError(field, sentence.format(field=field, index=index, most=most))
    return index


def plain(holder: Holder) -> Holder:
    """``holder``, a struct, and all in it, with Python's own numbers, whatever type they are made with."""
    values = {}
    for name, own, many in _coercions(type(holder)):
        value = getattr(holder, name)
        if value is not None:
            values[name] = tuple(map(own, value)) if many and isinstance(value, Iterable) else own(value)
    return replace(holder, **values)


@once_per_type
def _coercions(struct: type) -> list[tuple[str, Callable[[Any], Any], bool]]:
    """Name of each number and struct in a struct, what makes it plain, and whether it is a list of them."""
    return [
        (name, coercion(kind) if isinstance(kind, Number) else plain, many)
        for name, (kind, many) in fields_of(struct).items()
        if isinstance(kind, Number) or kind is msgspec.Struct
    ]


def coercion(declared: Number) -> Callable[[Any], Any]:
    """What makes Python's own number of one of any type, and leaves what is none for the check to refuse."""
    return whole_number if declared.whole else number


def like(declared: Any, value: Any, field: str) -> Any:
    """``value`` as the Number, Choice, bool or str that is declared; raises DocumentError if it is none."""
    kind = declared.type if isinstance(declared, Number | Choice) else declared
    own = coercion(declared)(value) if isinstance(declared, Number) else value
    if type(own) is kind:
        return own
    what = {bool: _("true or false"), str: _("a text"), int: _("a whole number"), float: _("a number")}[kind]
    raise DocumentError(
        field,
        _("{field} is {value}; give {what}.").format(field=field, value=shown(value), what=what),
        _("This is {value}; give {what}.").format(value=shown(value), what=what),
    )


def number(value: SupportsFloat | Any) -> Any:
    """``value`` as a float where it is a number of any kind; else itself, for the check to refuse."""
    if isinstance(value, (bool, str)):
        return value
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return value


def whole_number(value: SupportsIndex | Any) -> Any:
    """``value`` as an int where it is whole; else itself, for the check to refuse."""
    if isinstance(value, bool):
        return value
    try:
        return int(value) if isinstance(value, float) and value.is_integer() else operator.index(value)
    except TypeError:
        return value
