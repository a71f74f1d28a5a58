"""What edits are made of: a document with something replaced, figures with ids, plain numbers."""

import operator
from collections.abc import Callable, Iterable, Iterator
from functools import wraps
from itertools import chain
from typing import Any, ParamSpec, SupportsFloat, SupportsIndex

from msgspec.structs import replace

from workbench.document.addresses import Address, figure_with, highest, new_ids
from workbench.document.check import check, shown
from workbench.document.errors import DocumentError
from workbench.document.model import (
    AnyFigure,
    Curve,
    CurvePoint,
    Document,
    Knot,
    Polygon,
    Polyline,
    Rectangle,
    Sheet,
    WorldPoint,
)
from workbench.language import _

Edit = Callable[[Document], Document]
Arguments = ParamSpec("Arguments")


def checked(change: Callable[Arguments, Edit]) -> Callable[Arguments, Edit]:
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


def foreseen(edit: Edit, document: Document) -> Edit:
    """``edit`` with what it makes of ``document`` made now, perhaps beside the interface.

    Raises: DocumentError.
    """
    after = edit(document)
    return lambda now: after if now is document else edit(now)


def ids_on(sheet: Sheet) -> list[str]:
    """Every id on ``sheet``, its own first."""
    return [sheet.id, *chain.from_iterable(map(operator.attrgetter("ids"), sheet.figures))]


def with_sheet(document: Document, sheet: Sheet) -> Document:
    """``document`` with ``sheet`` in place of the one that has its id."""
    return replace(document, sheets=tuple(sheet if old.id == sheet.id else old for old in document.sheets))


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


def with_owner(document: Document, where: Address, changed: Any) -> Document:
    """``document`` with ``changed`` in place of the sheet, figure or point that ``where`` is on."""
    if where.point:
        figure = figure_with(document, where.figure)[1]
        if isinstance(changed, Knot) and isinstance(figure, Curve):
            knots = tuple(changed if old.id == where.point else old for old in figure.knots)
            return with_changed(document, [replace(figure, knots=knots)])
        points = tuple(changed if old.id == where.point else old for old in figure.points_world)
        return with_changed(document, [replace(figure, points_world=points)])
    if where.figure:
        return with_changed(document, [changed])
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


def numbered(document: Document, figure: AnyFigure) -> AnyFigure:
    """``figure`` with new ids where its own are empty."""
    if all(figure.ids):
        return figure
    fresh = iter(new_ids(document, "", len(figure.ids)))
    return with_ids(figure, fresh, fresh)


def with_ids(figure: AnyFigure, own: Iterator[object], parts: Iterator[object]) -> AnyFigure:
    """``figure`` with ids where they are empty: numbers from ``own``, for points and knots from ``parts``."""
    identity = figure.id or f"f{next(own)}"
    points = tuple(p if p.id else replace(p, id=f"p{next(parts)}") for p in figure.points_world)
    made = replace(figure, id=identity, points_world=points)
    if isinstance(made, Curve):
        knots = tuple(k if k.id else replace(k, id=f"k{next(parts)}") for k in made.knots)
        made = replace(made, knots=knots)
    return made


def all_numbered(document: Document, figures: Iterable[AnyFigure]) -> tuple[AnyFigure, ...]:
    """``figures`` with Python's own numbers and new ids, whatever ids they had."""
    bare = [without_ids(plain(figure)) for figure in figures]
    fresh = iter(new_ids(document, "", sum(len(figure.ids) for figure in bare)))
    return tuple(with_ids(figure, fresh, fresh) for figure in bare)


def without_ids(figure: AnyFigure) -> AnyFigure:
    """``figure`` with empty ids, to be numbered anew."""
    bare = replace(figure, id="", points_world=tuple(replace(p, id="") for p in figure.points_world))
    if isinstance(bare, Curve):
        bare = replace(bare, knots=tuple(replace(knot, id="") for knot in bare.knots))
    return bare


def moved_by(figure: AnyFigure, dx: float, dy: float) -> AnyFigure:
    """``figure`` with every control point moved by (dx, dy), world; raises DocumentError."""
    dx, dy = like(0.0, dx, "dx_world"), like(0.0, dy, "dy_world")
    points = tuple(replace(p, x=p.x + dx, y=p.y + dy) for p in figure.points_world)
    return replace(figure, points_world=points)


def polyline_with(document: Document, figure: str) -> Polyline:
    """The polyline with this id; raises DocumentError."""
    found = figure_with(document, figure)[1]
    if not isinstance(found, Polyline):
        sentence = _("Figure {id!r} is not a polyline, so it is neither open nor closed; choose a polyline.")
        raise DocumentError(figure, sentence.format(id=figure))
    return found


def of_many_points(document: Document, figure: str) -> Polyline | Polygon:
    """The polyline or polygon with this id; raises DocumentError."""
    found = figure_with(document, figure)[1]
    if not isinstance(found, Polyline | Polygon):
        sentence = _(
            "Figure {id!r} is not a polyline or polygon, so its number of points is fixed; choose one."
        )
        raise DocumentError(figure, sentence.format(id=figure))
    return found


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
        sentence = _("{field}: there is no place {index!r}; choose one from 0 to {most}.")
        raise DocumentError(field, sentence.format(field=field, index=index, most=most))
    return index


def plain(figure: AnyFigure) -> AnyFigure:
    """``figure`` with Python's own numbers, whatever number type it was made with."""
    points = tuple(_plain_point(point) for point in figure.points_world)
    names = (
        _CURVE_NUMBERS
        if isinstance(figure, Curve)
        else [name for name in figure.__struct_fields__ if name.startswith("radius")]
    )
    numbers = {name: number(getattr(figure, name)) for name in names}
    made = replace(figure, points_world=points, **numbers)
    if isinstance(made, Curve):
        made = replace(made, knots=tuple(replace(knot, u=number(knot.u)) for knot in made.knots))
    return made


_CURVE_NUMBERS = ("tension", "continuity", "bias", "alpha", "tolerance_px")


def _plain_point(point: WorldPoint) -> WorldPoint:
    fields = ("x", "y", "weight", "tangent_x", "tangent_y") if isinstance(point, CurvePoint) else ("x", "y")
    return replace(point, **{name: number(getattr(point, name)) for name in fields})


def plain_rectangle(rectangle: Rectangle) -> Rectangle:
    """``rectangle`` with Python's own numbers."""
    return Rectangle(*(number(getattr(rectangle, side)) for side in rectangle.__struct_fields__))


def like(old: Any, value: Any, field: str) -> Any:
    """``value`` as the kind that ``old`` is; raises DocumentError where it is not of that kind."""
    if isinstance(old, (bool, str)):
        if type(value) is type(old):
            return value
    elif isinstance(old, int):
        whole = whole_number(value)
        if type(whole) is int:
            return whole
    elif type(real := number(value)) is float:
        return real
    what = {bool: _("true or false"), str: _("a text"), int: _("a whole number"), float: _("a number")}[
        type(old)
    ]
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
