"""A derivation on paper: headings, lines of words and formulas, rows of matrices, grids, labelled drawings.

It is laid out into primitives, lengths in points, y downwards; ``diagram_svg`` and Qt's PDF write those.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np

from workbench.algorithms import marks
from workbench.algorithms.marks import Pattern, Points, Size, Weight
from workbench.exchange.formulas.folding import folded
from workbench.exchange.formulas.layout import Area, Disc, Glyphs, Line, Primitive, Typesetter, moved
from workbench.exchange.formulas.rows import lay_out
from workbench.exchange.formulas.terms import Shows, Terms, displayed
from workbench.exchange.grids import Grid, lay_out_grid

PAGE_PT = 480.0
MARGIN_PT = 18.0
SIZE_PT = 11.0
WORD_PT = 0.95 * SIZE_PT
"""The type of the words on a drawing."""
HEIGHT_PT = 240.0
BLACK, WHITE = "#000000", "#FFFFFF"
_HEADING, _SMALL = 1.3, 0.8
_BETWEEN = 0.8
_WIDTHS: dict[Weight, float] = {
    "hair": 0.5,
    "thin": 0.9,
    "medium": 1.6,
    "bold": 2.4,
    "heavy": 3.2,
    "pixel": 0.9,
}
_SIZES: dict[Size, float] = {"small": 1.6, "medium": 2.4, "large": 4.0, "pixel": 1.2}
_TINT, _CLEAR = 0.16, 0.65
_HEAD_PT, _HEAD_ANGLE = 7.0, math.radians(20)
_AWAY_PT, _TICK_PT = 5.0, 3.0
_MOST_TICKS = 9


class Arrow(NamedTuple):
    """A stroke (n, 2) with a head at its end."""

    points: Points
    ink: str = "text"
    weight: Weight = "thin"
    pattern: Pattern = "solid"


class Axes(NamedTuple):
    """The two axes of a drawing with their numbers; ``x`` and ``y`` are formulas."""

    x: str = "x"
    y: str = "y"


Item: TypeAlias = marks.Mark | Arrow | Axes


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """What lies in a window (xmin, ymin, xmax, ymax) of the plane, y upwards, at most ``height`` points high.

    The words of its marks are formulas; nothing is cut off at the window's edge. Raises ValueError for a
    window without area.
    """

    window: tuple[float, float, float, float]
    items: Sequence[Item]
    height: float = HEIGHT_PT

    def __post_init__(self) -> None:
        xmin, ymin, xmax, ymax = self.window
        if not (xmin < xmax and ymin < ymax and all(map(math.isfinite, self.window))):
            raise ValueError("A drawing's window must have xmin < xmax and ymin < ymax.")


@dataclass(frozen=True, slots=True)
class Heading:
    """A line of words, half bold."""

    text: str


@dataclass(frozen=True, slots=True)
class Sentence:
    """A line of words; what stands between dollar signs in it is a formula. It folds at the page's width."""

    text: str


@dataclass(frozen=True, slots=True)
class Formulas:
    """A row of matrices."""

    terms: Terms
    shows: Shows = "numbers"


Block: TypeAlias = Drawing | Heading | Sentence | Formulas | Grid


@dataclass(frozen=True, slots=True)
class Derivation:
    """A page of blocks, one below the other. ``inks`` are colours, "#RRGGBB"; an ink without one is black."""

    title: str
    blocks: Sequence[Block]
    inks: Mapping[str, str] = field(default_factory=dict)
    width: float = PAGE_PT

    def ink(self, name: str) -> str:
        """The colour of an ink; "canvas" is the paper."""
        return WHITE if name == "canvas" else self.inks.get(name, BLACK)


class Laid(NamedTuple):
    """A page of primitives, its width and height in points."""

    width: float
    height: float
    primitives: tuple[Primitive, ...]


def lay_out_derivation(derivation: Derivation, typesetter: Typesetter) -> Laid:
    """Every block below the one before. A row of matrices that is wider than the page widens it."""
    room = derivation.width - 2 * MARGIN_PT
    primitives: list[Primitive] = []
    y, width = MARGIN_PT, room
    for number, block in enumerate(derivation.blocks):
        y += _BETWEEN * SIZE_PT if number else 0.0
        laid = _block(block, typesetter, room)
        primitives += moved(laid.primitives, MARGIN_PT, y)
        y += laid.height
        width = max(width, laid.width)
    return Laid(width + 2 * MARGIN_PT, y + MARGIN_PT, tuple(primitives))


def _block(block: Block, typesetter: Typesetter, room: float) -> Laid:
    match block:
        case Heading():
            return Laid(*folded(typesetter, block.text, room, _HEADING * SIZE_PT, strong=True))
        case Sentence():
            return Laid(*folded(typesetter, block.text, room, SIZE_PT))
        case Formulas():
            row = lay_out(typesetter, block.terms, block.shows, SIZE_PT, room)
            return Laid(row.width, row.height, row.primitives)
        case Grid():
            return Laid(*lay_out_grid(typesetter, block, room, SIZE_PT))
        case Drawing():
            return _drawing(block, typesetter, room)


# Drawings


class _Map(NamedTuple):
    """From the window of a drawing to its box, the same scale both ways."""

    scale: float
    left: float
    bottom: float
    window: tuple[float, float, float, float]

    def point(self, x: float, y: float) -> tuple[float, float]:
        return self.left + (x - self.window[0]) * self.scale, self.bottom - (y - self.window[1]) * self.scale

    def points(self, points: Points) -> tuple[tuple[float, float], ...]:
        return tuple(self.point(x, y) for x, y in np.asarray(points, np.float64).tolist())


def _drawing(drawing: Drawing, typesetter: Typesetter, room: float) -> Laid:
    """The window as large as the room allows beside what is written left of it."""
    primitives = _in_room(drawing, typesetter, 0.0, room)
    beside = -min((each.x for each in primitives if isinstance(each, Glyphs)), default=0.0)
    if beside > 0:
        primitives = _in_room(drawing, typesetter, beside, room)
    glyphs = [each for each in primitives if isinstance(each, Glyphs)]
    over = max((each.size - each.y for each in glyphs), default=0.0)
    primitives = moved(primitives, 0.0, max(over, 0.0))
    low = max((each.y + typesetter.metrics.descent(each.size) for each in glyphs), default=0.0)
    return Laid(
        room, max(_scale(drawing, room - max(beside, 0.0))[1], low) + max(over, 0.0), tuple(primitives)
    )


def _scale(drawing: Drawing, room: float) -> tuple[float, float]:
    """Points for a unit of the plane, and the height of the window in points."""
    xmin, ymin, xmax, ymax = drawing.window
    scale = min(room / (xmax - xmin), drawing.height / (ymax - ymin))
    return scale, scale * (ymax - ymin)


def _in_room(drawing: Drawing, typesetter: Typesetter, left: float, room: float) -> list[Primitive]:
    """The window in the middle of what is between ``left`` and ``room``, words on top."""
    scale, height = _scale(drawing, room - left)
    wide = scale * (drawing.window[2] - drawing.window[0])
    place = _Map(scale, left + (room - left - wide) / 2, height, drawing.window)
    primitives: list[Primitive] = []
    words: list[Primitive] = []
    for item in drawing.items:
        if isinstance(item, marks.Word):
            words += _word(item, place, typesetter, room, height)
        else:
            primitives += _item(item, place, typesetter)
    return primitives + words


def _item(item: Item, place: _Map, typesetter: Typesetter) -> Iterator[Primitive]:
    match item:
        case marks.Stroke():
            yield Line(place.points(item.points), _WIDTHS[item.weight], item.ink, item.pattern)
        case Arrow():
            yield from _arrow(place.points(item.points), _WIDTHS[item.weight], item.ink, item.pattern)
        case marks.Ray():
            yield Line(_ray(item, place), _WIDTHS[item.weight], item.ink, item.pattern)
        case marks.Region():
            yield Area(place.points(item.points), item.ink, _TINT)
        case marks.Spot():
            yield from _spot(item, place)
        case Axes():
            yield from _axes(item, place, typesetter)


def _arrow(
    points: tuple[tuple[float, float], ...], width: float, ink: str, pattern: Pattern
) -> Iterator[Primitive]:
    """The line ends within its head, so that the tip is sharp."""
    tip = points[-1]
    before = next((point for point in reversed(points[:-1]) if point != tip), None)
    if before is None:
        return
    angle = math.atan2(tip[1] - before[1], tip[0] - before[0])
    length = _HEAD_PT + width
    neck = tip[0] - 0.7 * length * math.cos(angle), tip[1] - 0.7 * length * math.sin(angle)
    ends = (
        (tip[0] - length * math.cos(angle + turn), tip[1] - length * math.sin(angle + turn))
        for turn in (_HEAD_ANGLE, -_HEAD_ANGLE)
    )
    body = points[: points.index(before) + 1]
    if math.dist(before, tip) > 0.7 * length:
        yield Line((*body, neck), width, ink, pattern)
    elif len(body) > 1:
        yield Line(body, width, ink, pattern)
    yield Area((tip, *ends), ink)


def _ray(ray: marks.Ray, place: _Map) -> tuple[tuple[float, float], ...]:
    """From its place to the edge of the window, and back to the other edge where it goes both ways."""
    xmin, ymin, xmax, ymax = place.window

    def way(dx: float, dy: float) -> float:
        out = [
            ((high if step > 0 else low) - at) / step
            for at, step, low, high in ((ray.x, dx, xmin, xmax), (ray.y, dy, ymin, ymax))
            if step
        ]
        return max(min(out, default=0.0), 0.0)

    ahead = way(ray.dx, ray.dy)
    back = way(-ray.dx, -ray.dy) if ray.both_ways else 0.0
    return (
        place.point(ray.x - back * ray.dx, ray.y - back * ray.dy),
        place.point(ray.x + ahead * ray.dx, ray.y + ahead * ray.dy),
    )


def _spot(spot: marks.Spot, place: _Map) -> Iterator[Primitive]:
    x, y = place.point(spot.x, spot.y)
    half = _SIZES[spot.size]
    corners = ((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half))
    match spot.shape:
        case "square":
            yield Area(corners, spot.ink)
        case "cross":
            yield Line((corners[0], corners[2]), 1.2, spot.ink)
            yield Line((corners[1], corners[3]), 1.2, spot.ink)
        case shape:
            yield Disc(x, y, half, spot.ink, shape == "ring")


def _word(
    word: marks.Word, place: _Map, typesetter: Typesetter, room: float, height: float
) -> list[Primitive]:
    """A label beside its place, kept on the drawing and clear of what it lies on."""
    box = typesetter.formula(word.text, WORD_PT, word.strong, word.ink)
    x, y = place.point(word.x, word.y)
    left = x + word.right * _AWAY_PT - box.width * (1 - word.right) / 2
    top = y - word.up * _AWAY_PT - box.height * (1 + word.up) / 2
    left = min(max(left, 0.0), max(room - box.width, 0.0))
    top = min(max(top, 0.0), max(height - box.height, 0.0))
    right, bottom = left + box.width, top + box.height
    ground = Area(((left, top), (right, top), (right, bottom), (left, bottom)), "canvas", _CLEAR)
    return [ground, *moved(box.primitives, left, top + box.ascent)]


def _axes(axes: Axes, place: _Map, typesetter: Typesetter) -> Iterator[Primitive]:
    """Through the origin where it is in the window, else along its edges."""
    xmin, ymin, xmax, ymax = place.window
    x0, y0 = min(max(0.0, xmin), xmax), min(max(0.0, ymin), ymax)
    small = _SMALL * SIZE_PT
    for name, low, high, across in ((axes.x, xmin, xmax, True), (axes.y, ymin, ymax, False)):
        ends = [(low, y0), (high, y0)] if across else [(x0, low), (x0, high)]
        yield from _arrow(place.points(np.array(ends)), 0.6, "muted", "solid")
        tip = place.point(*ends[1])
        box = typesetter.formula(name, small, ink="muted")
        at = (-box.width - 2.0, -4.0 - box.descent) if across else (6.0, box.ascent)
        yield from moved(box.primitives, tip[0] + at[0], tip[1] + at[1])
        step = _step(high - low)
        for k in range(math.ceil(low / step), math.floor(high / step) + 1):
            value = k * step
            x, y = place.point(value, y0) if across else place.point(x0, value)
            near_the_tip = math.dist((x, y), tip) < 2.2 * small
            if near_the_tip or (k == 0 and x0 == y0 == 0.0):
                continue
            tick = ((x, y), (x, y + _TICK_PT)) if across else ((x - _TICK_PT, y), (x, y))
            yield Line(tick, 0.6, "muted")
            label = typesetter.text(displayed(value), small, ink="muted")
            dx, dy = (
                (-label.width / 2, _TICK_PT + 1 + label.ascent)
                if across
                else (-_TICK_PT - 2 - label.width, (label.ascent - label.descent) / 2)
            )
            yield from moved(label.primitives, x + dx, y + dy)


def _step(length: float) -> float:
    """1, 2 or 5 times a power of ten, for few numbers on an axis of this length."""
    power = 10.0 ** math.floor(math.log10(length / _MOST_TICKS))
    return next(factor * power for factor in (1, 2, 5, 10) if length / (factor * power) <= _MOST_TICKS)
