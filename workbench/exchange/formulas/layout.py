"""Lays formulas and matrices out in what can be painted anywhere: runs of glyphs, lines, areas and discs.

Lengths are in one unit of the caller (logical pixels, or points on paper), y downwards. How wide a run is,
the caller's ``Metrics`` say, so that the same layout serves the screen, an image and a file.
"""

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple, Protocol, TypeAlias

from workbench.exchange.formulas.notation import Formula, Piece, parse, parted
from workbench.exchange.formulas.terms import ABSENT, HIDDEN, Cell, Matrix, Shows

Style = Literal["upright", "italic", "bold", "bold italic", "figures"]
Pattern = Literal["solid", "dash", "dot"]
Point = tuple[float, float]

SCRIPT = 0.72
_LOWER, _RAISE = 0.28, 0.38
_GAP, _THIN = 0.24, 0.18
_LEADING = 0.42
_COLUMN_GAP, _PAD, _LIP = 1.1, 0.7, 0.3
_BRACKET = 0.1
_SMALL = 0.85
_KEPT_FORMULAS, _KEPT_MATRICES = 2048, 64
_STRUT = "x_p"
_USUAL = ("−0", ".0000")


class Metrics(Protocol):
    """How large type is."""

    def width(self, text: str, size: float, style: Style) -> float:
        """How far a run goes."""

    def ascent(self, size: float) -> float:
        """How far letters go up from the base line."""

    def descent(self, size: float) -> float:
        """How far letters go down from the base line."""


class Glyphs(NamedTuple):
    """A run of text; x is its left end, y its base line."""

    x: float
    y: float
    text: str
    size: float
    style: Style = "upright"
    ink: str = "text"
    width: float = 0.0


class Line(NamedTuple):
    """A polyline."""

    points: tuple[Point, ...]
    width: float = 1.0
    ink: str = "text"
    pattern: Pattern = "solid"


class Area(NamedTuple):
    """The inside of a polygon, filled by a share of its ink, 0 to 1."""

    points: tuple[Point, ...]
    ink: str = "accent"
    share: float = 1.0


class Disc(NamedTuple):
    """A round place, hollow or filled."""

    x: float
    y: float
    radius: float
    ink: str = "text"
    hollow: bool = False


Primitive: TypeAlias = Glyphs | Line | Area | Disc


class Box(NamedTuple):
    """Something laid out about (0, 0), the left end of its base line."""

    width: float
    ascent: float
    descent: float
    primitives: tuple[Primitive, ...] = ()

    @property
    def height(self) -> float:
        """From top to bottom."""
        return self.ascent + self.descent


class Rectangle(NamedTuple):
    """A part of the layout."""

    x: float
    y: float
    width: float
    height: float

    def moved(self, dx: float, dy: float) -> "Rectangle":
        """The same elsewhere."""
        return Rectangle(self.x + dx, self.y + dy, self.width, self.height)


class MatrixBox(NamedTuple):
    """A matrix about (0, 0), the left end of the line through the middle of its rows.

    ``cells`` are the rectangles of its elements by row and column; ``columns`` how wide its columns are.
    """

    width: float
    above: float
    below: float
    primitives: tuple[Primitive, ...]
    cells: dict[tuple[int, int], Rectangle]
    columns: tuple[float, ...]


def moved(primitives: Iterable[Primitive], dx: float, dy: float) -> list[Primitive]:
    """The same elsewhere."""
    result: list[Primitive] = []
    for each in primitives:
        if isinstance(each, Glyphs | Disc):
            result.append(each._replace(x=each.x + dx, y=each.y + dy))
        else:
            result.append(each._replace(points=tuple((x + dx, y + dy) for x, y in each.points)))
    return result


class Typesetter:
    """Lays out with one kind of type; formulas and matrices that come again are laid out once."""

    def __init__(self, metrics: Metrics) -> None:
        self.metrics = metrics
        self._formulas: dict[tuple[str, float, bool, str], Box] = {}
        self._matrices: dict[tuple[Matrix, Shows, float, tuple[float, ...], str], MatrixBox] = {}

    def formula(self, text: str, size: float, strong: bool = False, ink: str = "text") -> Box:
        """A formula in the notation, half bold where ``strong``."""
        key = text, size, strong, ink
        box = self._formulas.get(key)
        if box is None:
            if len(self._formulas) > _KEPT_FORMULAS:
                self._formulas.clear()
            box = self._formulas[key] = self._run(parse(text), size, size, strong, ink)
        return box

    def text(self, text: str, size: float, style: Style = "upright", ink: str = "text") -> Box:
        """Words as they are."""
        wide = self.metrics.width(text, size, style)
        glyphs = Glyphs(0.0, 0.0, text, size, style, ink, wide)
        return Box(wide, self.metrics.ascent(size), self.metrics.descent(size), (glyphs,))

    def _run(self, formula: Formula, size: float, base: float, strong: bool, ink: str) -> Box:
        metrics = self.metrics
        x, primitives = 0.0, []
        ascent, descent = metrics.ascent(size), metrics.descent(size)
        before: Piece | None = None
        for piece in formula:
            if parted(before, piece):
                assert before is not None
                wide = _GAP if "operator" in (before.kind, piece.kind) else _THIN
                x += wide * size
            style = _style(piece, strong)
            advance = metrics.width(piece.text, size, style)
            primitives.append(Glyphs(x, 0.0, piece.text, size, style, ink, advance))
            x += advance
            scripts = 0.0
            for script, shift in ((piece.below, _LOWER * size), (piece.above, -_RAISE * size)):
                if script:
                    small = self._run(script, max(SCRIPT * size, SCRIPT**2 * base), base, strong, ink)
                    primitives += moved(small.primitives, x + 0.03 * size, shift)  # type: ignore[arg-type]
                    scripts = max(scripts, small.width + 0.06 * size)
                    ascent, descent = max(ascent, small.ascent - shift), max(descent, small.descent + shift)
            x += scripts
            before = piece
        return Box(x, ascent, descent, tuple(primitives))

    # Matrices

    def matrix(
        self, term: Matrix, shows: Shows, size: float, least: Sequence[float] = (), ink: str = "text"
    ) -> MatrixBox:
        """A matrix in brackets. Columns are at least as wide as ``least`` says; one that holds numbers
        alone stands on its decimal points, with symbols over them at its right, any other in its middle.
        """
        key = term, shows, size, tuple(least), ink
        box = self._matrices.get(key)
        if box is None:
            if len(self._matrices) > _KEPT_MATRICES:
                self._matrices.clear()
            box = self._matrices[key] = self._matrix(term, shows, size, least, ink)
        return box

    def _matrix(self, term: Matrix, shows: Shows, size: float, least: Sequence[float], ink: str) -> MatrixBox:
        rows, columns = term.shape
        laid = [[self._cell(cell, shows, size, ink) for cell in row] for row in term.cells]
        # Rows of all matrices beside one another are as high
        least_high = self._row_height(shows, size)
        high = max(least_high, *(box.height for row in laid for box, _point in row)) + _LEADING * size
        widths, points = [], []
        for j in range(columns):
            column = [row[j] for row in laid]
            aligned = all(point is not None for _box, point in column)
            left = max(point or 0.0 for _box, point in column) if aligned else 0.0
            right = max(box.width - (point or 0.0) for box, point in column) if aligned else 0.0
            wide = left + right if aligned else max(box.width for box, _point in column)
            kept = max(wide, least[j] if j < len(least) else 0.0)
            widths.append(kept)
            points.append((kept - wide) / 2 + left if aligned else None)
        primitives: list[Primitive] = []
        cells: dict[tuple[int, int], Rectangle] = {}
        pad, gap = _PAD * size, _COLUMN_GAP * size
        top = -rows * high / 2
        for i, row in enumerate(laid):
            x = pad
            for j, (box, point) in enumerate(row):
                at = points[j]
                left = x + (
                    at - point if at is not None and point is not None else (widths[j] - box.width) / 2
                )
                base = top + i * high + (high + box.ascent - box.descent) / 2
                primitives += moved(box.primitives, left, base)
                cells[i, j] = Rectangle(x - gap / 2, top + i * high, widths[j] + gap, high)
                x += widths[j] + gap
        width = sum(widths) + gap * (columns - 1) + 2 * pad
        lip, stroke = _LIP * size, _BRACKET * size
        for edge, inward in ((stroke / 2, lip), (width - stroke / 2, -lip)):
            ends = (edge + inward, top), (edge, top), (edge, -top), (edge + inward, -top)
            primitives.append(Line(ends, stroke, ink))
        above, below = -top, -top
        if term.name:
            name = self.formula(term.name, 0.85 * size, ink="muted")
            x = (width - name.width) / 2
            if term.named == "over":
                primitives += moved(name.primitives, x, top - 0.25 * size - name.descent)
                above += name.height + 0.25 * size
            else:
                primitives += moved(name.primitives, x, -top + 0.25 * size + name.ascent)
                below += name.height + 0.25 * size
            if x < 0:  # the name is wider than the matrix
                primitives = moved(primitives, -x, 0.0)
                cells = {place: cell.moved(-x, 0.0) for place, cell in cells.items()}
                width = name.width
        return MatrixBox(width, above, below, tuple(primitives), cells, tuple(widths))

    def _row_height(self, shows: Shows, size: float) -> float:
        figures = self.text("0", size, "figures").height
        if shows == "numbers":
            return figures
        over = self.formula(_STRUT, size if shows == "symbols" else _SMALL * size)
        return over.height + (figures if shows == "both" else 0.0)

    def _cell(self, cell: Cell, shows: Shows, size: float, ink: str) -> tuple[Box, float | None]:
        """A cell, and where in it what the numbers of a column stand on is; None for what shows no number."""
        symbol, figure = cell.seen(shows)
        if not figure:
            return self.formula(symbol, size, ink=ink), None
        whole, _sign, _rest = figure.partition(".")
        before = self.metrics.width(whole, size, "figures")
        under = self._figures(figure, size, ink)
        if figure in (HIDDEN, ABSENT):
            # With the room that a number takes, so that nothing moves when it comes
            before, after = (self.metrics.width(part, size, "figures") for part in _USUAL)
            place = moved(under.primitives, before - under.width, 0.0)
            return Box(before + after, under.ascent, under.descent, tuple(place)), before
        if not symbol:
            return under, before if shows != "both" else under.width
        over = self.formula(symbol, _SMALL * size, ink="muted")
        width = max(over.width, under.width)
        primitives = [
            *moved(over.primitives, width - over.width, 0.0),
            *moved(under.primitives, width - under.width, over.descent + under.ascent),
        ]
        box = Box(width, over.ascent, over.descent + under.height, tuple(primitives))
        return box, width

    def _figures(self, figure: str, size: float, ink: str) -> Box:
        return self.text(figure, size, "figures", ink)


def _style(piece: Piece, strong: bool) -> Style:
    if piece.kind == "variable":
        return "bold italic" if strong else "italic"
    return "bold" if strong else "upright"
