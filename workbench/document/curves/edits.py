"""Edits of curves, from document to document: ids and addresses of what stays are kept.

An edit refuses with DocumentError, in one sentence, what would not be sound or cannot be done.
"""

from collections.abc import Iterable, Mapping

from msgspec.structs import replace

from workbench.document.addresses import Address, figure_with, parse, point_with
from workbench.document.building import (
    Edit,
    checked,
    number,
    position,
    remembering,
    with_changed,
    with_figures,
)
from workbench.document.check import refuse
from workbench.document.curves.changes import changing, curve_with
from workbench.document.curves.knots import closed, opened, refitted, with_points, without_point
from workbench.document.curves.paths import (
    Place,
    Places,
    closed_path,
    is_path,
    joint_moves,
    joint_of,
    moved,
    opened_path,
    with_followers,
    with_joints_added,
    without_points,
)
from workbench.document.curves.settings import (
    set_beside,
    set_degree,
    set_knot,
    set_knot_rule,
    set_spline,
    set_weights,
)
from workbench.document.faults import shown
from workbench.document.model import Curve, CurvePoint, Document
from workbench.language import _

__all__ = [
    "add_path_point",
    "add_points",
    "curve_with",
    "joints_made",
    "move_curve_points",
    "moved_points",
    "remove_points",
    "set_beside",
    "set_curve_closed",
    "set_degree",
    "set_joint",
    "set_knot",
    "set_knot_rule",
    "set_spline",
    "set_weights",
]


def _by_figure(addresses: Iterable[Address | str]) -> dict[str, list[str]]:
    """Ids of points, or knots, by the figure that they are on."""
    by_figure: dict[str, list[str]] = {}
    for text in addresses:
        where = parse(text)
        by_figure.setdefault(where.figure, []).append(where.point)
    return by_figure


@checked
def move_curve_points(points: Mapping[Address | str, tuple[float, float]]) -> Edit:
    """Put control points to world coordinates; on a path, handles follow their point and one another.

    An address names its point, whatever its attribute. See ``curve_paths.with_followers``.
    """
    by_figure: dict[str, Places] = {}
    for text, (x, y) in points.items():
        where = parse(text)
        by_figure.setdefault(where.figure, {})[where.point] = (number(x), number(y))

    def edit(document: Document) -> Document:
        return with_changed(
            document, [moved_points(curve_with(document, figure), by_figure[figure]) for figure in by_figure]
        )

    return edit


def moved_points(curve: Curve, places: Places) -> Curve:
    """``curve`` with points at these places, by id, and what follows them; raises DocumentError."""
    known = {point.id for point in curve.points_world}
    for identity, where in places.items():
        if identity not in known:
            point_with(curve, identity)
        for value in where:
            if type(value) is not float:
                raise refuse(
                    f"{curve.id}/{identity}", _("is {value}; give a number").format(value=shown(value))
                )
    return moved(curve, with_followers(curve, places))


@checked
def add_points(figure: str, places_world: Iterable[tuple[float, float]], index: int | None = None) -> Edit:
    """Put points, one after the other, before the one at ``index``, by default behind the last one.

    On a path each is a corner, at the end or, for index 0, at the begin. Free knots grow with them.
    """
    places = [(number(x), number(y)) for x, y in places_world]

    def change(curve: Curve) -> Curve:
        count = len(curve.points_world)
        at = position(count if index is None else index, count, "points_world")
        if not is_path(curve):
            return with_points(curve, at, tuple(CurvePoint("", *where) for where in places))
        if 0 < at < count:
            raise ValueError(
                _("A path takes new points at its ends only; elsewhere, insert a point on the curve.")
            )
        return _grown(curve, [(where, None) for where in (places if at else places[::-1])], at == 0)

    return changing(figure, change)


@checked
def add_path_point(
    figure: str,
    x_world: float,
    y_world: float,
    handle: tuple[float, float] | None = None,
    first: bool = False,
) -> Edit:
    """Put a point to the end of a path, or before its ``first`` one, as a pen does.

    ``handle`` is where the pen was dragged to: the handle beyond the point, which is symmetric then.
    """
    where = number(x_world), number(y_world)
    dragged = None if handle is None else (number(handle[0]), number(handle[1]))

    def change(curve: Curve) -> Curve:
        if not is_path(curve):
            raise ValueError(_("This curve is not a path of Bézier pieces, so its points have no handles."))
        return _grown(curve, [(where, dragged)], first)

    return changing(figure, change)


def _grown(curve: Curve, added: list[tuple[Place, Place | None]], first: bool) -> Curve:
    if curve.closed:
        raise ValueError(_("The path is closed, so it has no end to continue from; insert a point on it."))
    return refitted(with_joints_added(curve, added, first))


@checked
def remove_points(addresses: Iterable[Address | str]) -> Edit:
    """Remove control points; a curve that loses all of them goes, too.

    On a path a point takes its handles with it, and a handle alone is drawn into its point.
    """
    by_figure = _by_figure(addresses)

    def edit(document: Document) -> Document:
        after = document
        for figure, points in by_figure.items():
            curve = curve_with(document, figure)
            for point in points:
                point_with(curve, point)
            left = _without(curve, frozenset(points))
            if left is None:
                sheet = figure_with(after, figure)[0]
                kept = tuple(other for other in sheet.figures if other.id != figure)
                after = with_figures(after, sheet, kept)
            else:
                after = with_changed(after, [left])
        return remembering(document, after)

    return edit


def _without(curve: Curve, gone: frozenset[str]) -> Curve | None:
    """``curve`` without these points; None where nothing is left of it."""
    if is_path(curve):
        points = without_points(curve, gone)
        return refitted(replace(curve, points_world=points)) if points else None
    for index in range(len(curve.points_world) - 1, -1, -1):
        if curve.points_world[index].id in gone:
            if len(curve.points_world) == 1:
                return None
            curve = without_point(curve, index)
    return curve


@checked
def set_joint(addresses: Iterable[Address | str], joint: str) -> Edit:
    """Make points of a path corners, smooth or symmetric; ``joints_made`` tells which handles move.

    An address of a handle means its point.
    """
    by_figure = _by_figure(addresses)

    def edit(document: Document) -> Document:
        return with_changed(
            document,
            [joints_made(curve_with(document, f), points, joint)[0] for f, points in by_figure.items()],
        )

    return edit


def joints_made(curve: Curve, points: Iterable[str], joint: str) -> tuple[Curve, Places]:
    """``curve`` with points of a path, by id, as such joints, and where that moved which handles."""
    places: Places = {}
    kinds: dict[str, str] = {}
    for identity in points:
        index = curve.points_world.index(point_with(curve, identity))
        owner = joint_of(curve, index) if is_path(curve) else index
        if owner is None:
            continue
        kinds[curve.points_world[owner].id] = joint
        if is_path(curve):
            places |= joint_moves(curve, owner, joint)
    changed = tuple(
        replace(point, joint=kinds[point.id]) if point.id in kinds else point for point in curve.points_world
    )
    return moved(replace(curve, points_world=changed), places), places


@checked
def set_curve_closed(figure: str, close: bool) -> Edit:
    """Close a curve, or open it.

    A path is closed by a piece from its end to its begin, or by one point where both are the same; it is
    opened by a cut at its first point, and looks as before.
    """

    def change(curve: Curve) -> Curve:
        if close == curve.closed:
            return curve
        if is_path(curve) and len(curve.points_world) >= (4 if close else 3):
            return refitted(closed_path(curve) if close else opened_path(curve))
        return closed(curve) if close else opened(curve)

    return changing(figure, change)
