"""Edits of the chains of figures, and what transforms their points instead.

Numbers of a link are set by their addresses, as ``s1/f2/t4/angle``, with ``edits.set_attribute``.
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.transforms import Matrix
from workbench.document.addresses import Address, figure_with, figures_with, new_ids, parse, point_with
from workbench.document.building import (
    Edit,
    checked,
    numbered,
    plain,
    position,
    remembering,
    with_changed,
    with_ids,
)
from workbench.document.curves.paths import handles_of, is_path, moved, with_followers
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Curve, Document
from workbench.document.transforms.chains import inverse_of, read_only_reason
from workbench.document.transforms.expressing import expressed, moved_points
from workbench.document.transforms.links import Affine, AnyLink, Rotate, Scale, Shear, Translate
from workbench.document.transforms.recognizing import link_of
from workbench.language import _


@checked
def add_transform(figure: str, link: AnyLink, index: int | None = None) -> Edit:
    """Put ``link`` into a figure's chain, at ``index`` from the first to act, by default to act last."""

    def edit(document: Document) -> Document:
        old = figure_with(document, figure)[1]
        chain = old.transforms
        at = position(len(chain) if index is None else index, len(chain), "transforms")
        added = numbered(document, _with_chain(old, (*chain[:at], plain(link), *chain[at:])))
        return with_changed(document, [added])

    return edit


@checked
def remove_transform(address: Address | str) -> Edit:
    """Remove the link that ``address`` names, whatever its attribute."""

    def edit(document: Document) -> Document:
        figure, at = _link_at(document, address)
        chain = (*figure.transforms[:at], *figure.transforms[at + 1 :])
        return remembering(document, with_changed(document, [_with_chain(figure, chain)]))

    return edit


@checked
def reorder_transform(address: Address | str, index: int) -> Edit:
    """Let the link that ``address`` names act as the one at ``index``: 0 is the first to act."""

    def edit(document: Document) -> Document:
        figure, at = _link_at(document, address)
        others = [*figure.transforms[:at], *figure.transforms[at + 1 :]]
        others.insert(position(index, len(others), "transforms"), figure.transforms[at])
        return with_changed(document, [_with_chain(figure, tuple(others))])

    return edit


@checked
def switch_transform(address: Address | str, on: bool) -> Edit:
    """Switch the link that ``address`` names on or off."""

    def edit(document: Document) -> Document:
        figure, at = _link_at(document, address)
        return with_changed(document, [_with_link(figure, at, replace(figure.transforms[at], on=on))])

    return edit


@checked
def replace_transform(address: Address | str, link: AnyLink) -> Edit:
    """Put ``link``, of whatever kind, in the place of the one that ``address`` names; the id stays."""

    def edit(document: Document) -> Document:
        figure, at = _link_at(document, address)
        new = replace(plain(link), id=figure.transforms[at].id)
        return with_changed(document, [_with_link(figure, at, new)])

    return edit


@checked
def extend(figures: Iterable[str], link: AnyLink) -> Edit:
    """Let ``link`` act last on figures: in the last link that is on, where that is of its kind and about the
    same pivot, so that a drag leaves one link and not hundreds; else as a new one.
    """
    chosen = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        longer = replace(plain(link), id="")
        return _with_new(document, [_extended(figure, longer) for figure in figures_with(document, chosen)])

    return edit


def _extended(figure: AnyFigure, link: AnyLink) -> AnyFigure:
    acting = [k for k, old in enumerate(figure.transforms) if old.on]
    both = _merged(figure.transforms[acting[-1]], link) if acting else None
    if both is not None:
        return _with_link(figure, acting[-1], both)
    return _with_chain(figure, (*figure.transforms, link))


def _merged(first: AnyLink, second: AnyLink) -> AnyLink | None:
    """``first`` and then ``second`` as one link with the id of ``first``; None where there is none."""
    match first, second:
        case Translate(), Translate():
            return replace(first, tx=first.tx + second.tx, ty=first.ty + second.ty)
        case Rotate(), Rotate() if _pivot(first) == _pivot(second):
            return replace(first, angle=first.angle + second.angle)
        case Scale(), Scale() if _pivot(first) == _pivot(second):
            return replace(first, sx=first.sx * second.sx, sy=first.sy * second.sy)
        case Shear(), Shear() if (first.x_ref, first.y_ref) == (second.x_ref, second.y_ref):
            if first.sh_y == second.sh_y == 0.0 or first.sh_x == second.sh_x == 0.0:
                return replace(first, sh_x=first.sh_x + second.sh_x, sh_y=first.sh_y + second.sh_y)
        case Affine(), Affine():
            return Affine.of(first.id, second.matrix @ first.matrix)
    return None


def _pivot(link: Rotate | Scale) -> tuple[float, float]:
    return link.x_pivot, link.y_pivot


class Applied(NamedTuple):
    """The document, and for each figure that could not take all by itself its id and why, a sentence."""

    document: Document
    told: tuple[tuple[str, str], ...]


def apply_matrix(figures: Iterable[str], matrix: Matrix) -> Edit:
    """Transform figures, as they are seen, by an affine matrix (3, 3); see ``applied``."""
    chosen = tuple(figures)
    return lambda document: applied(document, chosen, matrix).document


def applied(document: Document, figures: Iterable[str], matrix: Matrix) -> Applied:
    """Figures, as they are seen, under an affine ``matrix`` (3, 3), world.

    Points and radii take it as far as they can express it; what they cannot, such as a turned ellipse, goes
    to the end of the figure's chain as the plainest link, as ``extend`` does it, and is told. Raises:
    DocumentError, also for another last row.
    """
    _refuse_other_than_affine(matrix)
    told: list[tuple[str, str]] = []

    link = link_of(matrix)

    def edit(before: Document) -> Document:
        changed: list[AnyFigure] = []
        for figure in figures_with(before, tuple(dict.fromkeys(figures))):
            own = _before_the_chain(figure, matrix)
            new = own if isinstance(own, str) else expressed(figure, own)
            if isinstance(new, str):
                told.append((figure.id, new))
                new = _extended(figure, link)
            changed.append(new)
        return _with_new(before, changed)

    return Applied(checked(lambda: edit)()(document), tuple(told))


@checked
def apply_to_points(addresses: Iterable[Address | str], matrix: Matrix) -> Edit:
    """Transform chosen control points, as they are seen, by an affine ``matrix`` (3, 3).

    Derivatives turn with their points, and a point of a path takes its handles along. Radii stay. An address
    names its point, whatever its attribute.
    """
    chosen: dict[str, set[str]] = {}
    for where in map(parse, addresses):
        chosen.setdefault(where.figure, set()).add(where.point)

    def edit(document: Document) -> Document:
        _refuse_other_than_affine(matrix)
        changed: list[AnyFigure] = []
        for figure in figures_with(document, chosen):
            for point in chosen[figure.id]:
                point_with(figure, point)
            own = _before_the_chain(figure, matrix)
            if isinstance(own, str):
                raise DocumentError(figure.id, read_only_reason(figure))
            changed.append(_with_points_moved(figure, chosen[figure.id], own))
        return with_changed(document, changed)

    return edit


def _with_points_moved(figure: AnyFigure, chosen: set[str], matrix: Matrix) -> AnyFigure:
    points = figure.points_world
    numbers = {k for k, point in enumerate(points) if point.id in chosen}
    path = figure if isinstance(figure, Curve) and is_path(figure) else None
    if path is not None:
        carried = [handles_of(path, k) for k in numbers if k % 3 == 0]
        numbers |= {handle for both in carried for handle in both if handle is not None}
    order = sorted(numbers)
    new = dict(zip(order, moved_points(tuple(points[k] for k in order), matrix), strict=True))
    after = replace(figure, points_world=tuple(new.get(k, point) for k, point in enumerate(points)))
    if path is None:
        return after
    return moved(path, with_followers(path, {point.id: (point.x, point.y) for point in new.values()}))


@checked
def remove_transforms(figures: Iterable[str]) -> Edit:
    """Take figures out of their chains, so that they are seen where their points are."""
    chosen = tuple(dict.fromkeys(figures))

    def edit(document: Document) -> Document:
        chained = [figure for figure in figures_with(document, chosen) if figure.transforms]
        bare = [_with_chain(figure, ()) for figure in chained]
        return remembering(document, with_changed(document, bare)) if bare else document

    return edit


def bake(figures: Iterable[str]) -> Edit:
    """Let the points of figures be where their chains take them, without the chains; see ``baked``."""
    chosen = tuple(figures)
    return lambda document: baked(document, chosen).document


def baked(document: Document, figures: Iterable[str]) -> Applied:
    """Figures with their chains put into points and radii, and what cannot be, told, as it was.

    Links that are switched off stay. Raises: DocumentError.
    """
    told: list[tuple[str, str]] = []

    def edit(before: Document) -> Document:
        changed: list[AnyFigure] = []
        for figure in figures_with(before, tuple(dict.fromkeys(figures))):
            if figure.matrix is None:
                continue
            new = expressed(figure, figure.matrix)
            if isinstance(new, str):
                told.append((figure.id, _not_baked()))
            else:
                changed.append(_with_chain(new, tuple(link for link in figure.transforms if not link.on)))
        return remembering(before, with_changed(before, changed)) if changed else before

    return Applied(checked(lambda: edit)()(document), tuple(told))


def _not_baked() -> str:
    return _("No points and radii of this figure would look the same, so its transforms stay.")


def _before_the_chain(figure: AnyFigure, matrix: Matrix) -> Matrix | str:
    """What points must do so that the figure is seen under ``matrix``; a sentence where nothing does."""
    if figure.matrix is None:
        return matrix
    if reason := read_only_reason(figure):
        return reason
    own: Matrix = inverse_of(figure.matrix) @ matrix @ figure.matrix
    return own


def _refuse_other_than_affine(matrix: Matrix) -> None:
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all() or matrix[2].tolist() != [0.0, 0.0, 1.0]:
        sentence = _("This matrix is not affine; give three rows of three numbers, the last one 0 0 1.")
        raise DocumentError("matrix", sentence)


def _link_at(document: Document, address: Address | str) -> tuple[AnyFigure, int]:
    """The figure of a link, and its place in the chain; raises DocumentError."""
    where = parse(address)
    figure = figure_with(document, where.figure)[1]
    for at, link in enumerate(figure.transforms):
        if link.id == where.point:
            return figure, at
    sentence = _("Figure {figure!r} has no transform {id!r}; it may have been removed.")
    raise DocumentError(str(where), sentence.format(figure=figure.id, id=where.point))


def _with_new(document: Document, figures: list[AnyFigure]) -> Document:
    """``document`` with these in place of the figures of their ids, and ids for their new links."""
    fresh = iter(new_ids(document, "", len(figures)))
    return with_changed(
        document, [figure if all(figure.ids) else with_ids(figure, fresh, fresh) for figure in figures]
    )


def _with_link(figure: AnyFigure, at: int, link: AnyLink) -> AnyFigure:
    return _with_chain(figure, (*figure.transforms[:at], link, *figure.transforms[at + 1 :]))


def _with_chain(figure: AnyFigure, chain: tuple[AnyLink, ...]) -> AnyFigure:
    return replace(figure, transforms=chain)
