"""From the world to the device: the arguments that a figure's algorithm gets.

A figure's points go through its chain, then the window of the sheet's first view is mapped onto its
viewport, lines and polygons are clipped; only then are coordinates rounded, by ``round_half_up``. The corners
of a polygon, whose algorithm takes fractions, are ``snapped``. A circle whose device radii differ (the scale
of the view is not the same in x and y) is drawn as an ellipse; what its chain makes of it stands in
``rounds``.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.document.model import (
    AnyFigure,
    Ellipse,
    Polygon,
    Polyline,
    SeedFill,
    Sheet,
)
from workbench.engine.batches import Lists, Values
from workbench.geometry.conventions import snapped
from workbench.rendering.clipping import drawn_rings, line_ends
from workbench.rendering.limits import REACH_PX
from workbench.rendering.mapping import Call, device_points, device_radii, figure_map
from workbench.rendering.rounds import Area, Lines, Round, is_area, is_lines
from workbench.rendering.segments import rounded

Index = NDArray[np.int64]


class Batch(NamedTuple):
    """All calls of one text for some figures: for each parameter their ``values``, and the number of the
    figure, among those given, that each call is ``of`` (n,), ascending."""

    entry: Entry
    values: tuple[Values, ...]
    of: Index

    def calls(self, first: int = 0, last: int | None = None) -> list[Call]:
        """The calls from ``first`` to before ``last``, one by one."""
        last = len(self.of) if last is None else last
        columns: list[list[Any]] = []
        for value in self.values:
            if isinstance(value, Lists):
                starts = value.starts.tolist()
                columns.append([value.items[starts[k] : starts[k + 1]] for k in range(first, last)])
            else:
                columns.append(value[first:last].tolist())
        return [Call(self.entry, arguments) for arguments in zip(*columns, strict=True)]


Named = tuple[dict[str, Values], Index]
"""Arguments of the calls for some figures by the names that the catalogue uses, and whose each call is."""


def batches(sheet: Sheet, figures: Sequence[AnyFigure], algorithm: str | None = None) -> list[Batch]:
    """The calls of all figures that read nothing of what lies below them; a batch for each text.

    They are drawn by their own algorithm or by another of the catalogue. Raises LookupError when it has no
    such algorithm.
    """
    groups: dict[tuple[Callable[..., Named], str], list[int]] = {}
    for number, figure in enumerate(figures):
        if figure.points_world and not fills(figure):
            groups.setdefault(_text_of(figure, algorithm or figure.drawn_with), []).append(number)
    laid_out: list[Batch] = []
    for (named, slug), numbers in groups.items():
        values, of = named(sheet, [figures[k] for k in numbers])
        laid_out += _by_text(catalogue.get(slug), values, np.array(numbers)[of])
    return laid_out


def _text_of(figure: AnyFigure, slug: str) -> tuple[Callable[..., Named], str]:
    """What lays a figure out, and what draws it: ``slug``, unless only lines or a polygon are left of it."""
    if is_lines(figure):
        return _of_lines, slug if slug in Polyline.algorithms else Polyline.algorithms[0]
    if is_area(figure):
        return _of_polygons, slug if slug in Polygon.algorithms else Polygon.algorithms[0]
    return _of_rounds, slug


def _by_text(entry: Entry, values: dict[str, Values], of: Index) -> list[Batch]:
    """The calls of one text; where it takes one radius, those of two radii are calls of its sister."""
    if "r" not in values or all(p.name != "r" for p in entry.parameters):
        return [_batch(entry, values, of)]
    unequal = np.not_equal(values["rx"], values["ry"])
    return [
        _batch(text, {name: np.asarray(value)[chosen] for name, value in values.items()}, of[chosen])
        for text, chosen in ((entry, ~unequal), (_of_ellipses(entry), unequal))
        if chosen.any()
    ]


def _batch(entry: Entry, values: dict[str, Values], of: Index) -> Batch:
    columns = tuple(
        values[p.name] if p.name in values else np.full(len(of), p.example) for p in entry.parameters
    )
    return Batch(entry, columns, of)


def _of_lines(sheet: Sheet, figures: Sequence[Lines]) -> Named:
    ends, of = line_ends(sheet, figures)
    return dict(zip(("x0", "y0", "x1", "y1"), ends.T, strict=True)), of


def _of_polygons(sheet: Sheet, figures: Sequence[Area]) -> Named:
    rings, whose = drawn_rings(sheet, figures)
    of, rings_of = np.unique(whose, return_counts=True)
    lengths = np.array([len(ring) for ring in rings], np.int64)
    ring_starts, starts = _starts(rings_of), _starts(lengths)[_starts(rings_of)]
    # The ends of rings are counted from the first corner of their own polygon.
    ends = np.cumsum(lengths) - np.repeat(starts[:-1], rings_of)
    filled = [figures[k] for k in of.tolist()]
    return {
        "vertices": Lists(snapped(np.concatenate(rings)) if rings else np.empty((0, 2)), starts),
        "ring_ends": Lists(ends, ring_starts),
        "closed": np.array([isinstance(f, Polygon) and f.closed_interior for f in filled], np.bool_),
        "nonzero": np.array([isinstance(f, Polygon) and f.nonzero for f in filled], np.bool_),
    }, of


def faster(call: Call) -> Call:
    """The call that paints for this one: of the entry that draws for its own, where their law holds."""
    by = call.entry.drawn_by
    if by is None or not by.holds(*call.arguments):
        return call
    return call._replace(entry=catalogue.get(by.slug))


def law_holds(batch: Batch) -> NDArray[np.bool_]:
    """For which calls (n,) of a batch the law holds by which another entry draws for its own."""
    by = batch.entry.drawn_by
    if by is None:
        return np.zeros(len(batch.of), np.bool_)
    if any(isinstance(value, Lists) for value in batch.values):
        return np.array([by.holds(*call.arguments) for call in batch.calls()], np.bool_)
    return np.broadcast_to(by.holds(*batch.values), len(batch.of))


def _starts(lengths: Index) -> Index:
    """Where each of some lists begins that stand one after the other, and where the last ends."""
    return np.append(0, np.cumsum(lengths))


def _of_rounds(sheet: Sheet, figures: Sequence[Round]) -> Named:
    centres = device_points(sheet, figures, [figure.points_world for figure in figures])
    radii = np.array([device_radii(sheet, figure) for figure in figures])
    near = np.maximum(np.abs(centres), radii).max(axis=1) <= REACH_PX
    (xc, yc), (rx, ry) = rounded(centres[near]).T, rounded(radii[near]).T
    return {"xc": xc, "yc": yc, "rx": rx, "ry": ry, "r": rx}, np.flatnonzero(near)


def reach_of(sheet: Sheet, figure: AnyFigure) -> float:
    """How far the centre, the radii or the seed of a figure reach, in pixels; 0 for one that is clipped."""
    if not figure.points_world or is_lines(figure) or is_area(figure):
        return 0.0
    x, y = figure_map(sheet, figure).point(figure.points_world[0].x, figure.points_world[0].y)
    return max(abs(x), abs(y), *device_radii(sheet, figure))


def colour_of(sheet: Sheet, figure: AnyFigure) -> int:
    """The figure's colour as 0xRRGGBB."""
    return sheet.palette[figure.colour % len(sheet.palette)]


def _of_ellipses(circle: Entry) -> Entry:
    """What draws a circle that the scale makes an ellipse: as an outline or as an area, like its own text."""
    entries = [catalogue.get(slug) for slug in Ellipse.algorithms]
    return next(entry for entry in entries if entry.emits == circle.emits)


def calls(
    sheet: Sheet,
    figure: AnyFigure,
    algorithm: str | None = None,
    below: NDArray[np.uint32] | None = None,
) -> list[Call]:
    """What runs to draw ``figure`` in the first view, by its own algorithm or another of the catalogue.

    ``below`` is the picture (h, w) beneath a seed fill, which copies nothing: hand it a copy where the text
    writes. Raises LookupError when the catalogue has no such algorithm.
    """
    entry = catalogue.get(algorithm or figure.drawn_with)
    if not isinstance(figure, SeedFill):
        return [call for batch in batches(sheet, [figure], algorithm) for call in batch.calls()]
    if not figure.points_world or reach_of(sheet, figure) > REACH_PX:
        return []
    ((x, y),) = rounded(device_points(sheet, [figure], [figure.points_world[:1]])).tolist()
    boundary = sheet.palette[figure.boundary % len(sheet.palette)]
    values = {"image": below, "x": x, "y": y, "fill": colour_of(sheet, figure), "boundary": boundary}
    limit = figure.recursion_limit if entry.compiles else 0
    return [Call(entry, tuple(values.get(p.name, p.example) for p in entry.parameters), limit)]


def fills(figure: AnyFigure) -> bool:
    """Whether the figure reads what lies below it."""
    return isinstance(figure, SeedFill)
