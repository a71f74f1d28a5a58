"""A display list changed by hand, and what becomes of the figures that it was made of.

Figures of which every stroke is as it was stay what they are. A line whose stroke has changed stays that
line; of any other figure the strokes become lines of their own.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from msgspec.structs import replace

from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE
from workbench.document.addresses import sheet_with
from workbench.document.building import Edit, all_numbered, checked, remembering, with_sheet
from workbench.document.errors import DocumentError
from workbench.document.model import MAX_PALETTE, AnyFigure, Document, Line, Sheet, WorldPoint
from workbench.document.numbers import MAX_COORDINATE
from workbench.language import _
from workbench.rendering.display_program import DisplayProgram, Strokes
from workbench.rendering.mapping import view_map

NEW_STROKE = -1
_FULL = 255


class Row(NamedTuple):
    """One instruction: its place (device, pixels), the colour 0xRRGGBB that a DRAW has, and the stroke of the
    list that it draws or goes to.
    """

    operation: int
    x: float
    y: float
    colour: int = 0
    stroke: int = NEW_STROKE


class Drawn(NamedTuple):
    """A stroke that a list draws, device coordinates, and which one of the old list it is."""

    x0: float
    y0: float
    x1: float
    y1: float
    colour: int
    stroke: int = NEW_STROKE


def rows_of(program: DisplayProgram) -> list[Row]:
    """The instructions of a program, without the jump back."""
    colours = program.strokes.colours.tolist()
    places = zip(program.rows.tolist(), program.stroke_of.tolist(), strict=True)
    return [
        Row(int(operation), x, y, colours[stroke] if operation == DRAW else 0, stroke)
        for (operation, x, y, _intensity), stroke in places
        if operation != JUMP
    ]


def drawn_by(rows: Sequence[Row]) -> list[Drawn]:
    """What instructions draw: each DRAW from where the one before has left the beam."""
    x, y = (rows[-1].x, rows[-1].y) if rows else (0.0, 0.0)
    strokes = []
    for row in rows:
        if row.operation == DRAW:
            strokes.append(Drawn(x, y, row.x, row.y, row.colour, row.stroke))
        x, y = row.x, row.y
    return strokes


def with_place(rows: Sequence[Row], address: int, x: float, y: float) -> list[Row]:
    """The instruction at an address goes elsewhere; what is drawn from there begins there."""
    return [row._replace(x=x, y=y) if k == address else row for k, row in enumerate(rows)]


def with_colour(rows: Sequence[Row], address: int, colour: int) -> list[Row]:
    """The stroke drawn at an address has another colour."""
    return [row._replace(colour=colour) if k == address else row for k, row in enumerate(rows)]


def dimmed(colour: int, intensity: float) -> int:
    """A colour whose strongest channel is ``intensity``, 0 to 1, of full; black becomes grey."""
    channels = [colour >> shift & _FULL for shift in (16, 8, 0)]
    strongest = max(channels)
    shares = [channel / strongest for channel in channels] if strongest else [1.0] * 3
    red, green, blue = (round(share * intensity * _FULL) for share in shares)
    return red << 16 | green << 8 | blue


def without(rows: Sequence[Row], address: int) -> list[Row]:
    """The instruction is gone; what comes after it is drawn from where the beam then is.

    Raises: DocumentError for the first MOVE, without which nobody knows where the list begins.
    """
    if address == 0 and len(rows) > 2:
        sentence = _("The first MOVE places the beam, so it stays; delete the DRAW that follows it.")
        raise DocumentError("0", sentence)
    return [row for k, row in enumerate(rows) if k != address]


def inserted(rows: Sequence[Row], address: int, size: tuple[int, int], jump: bool, colour: int) -> list[Row]:
    """A short stroke after an address, or with ``jump`` one that begins apart, inside a picture of ``size``
    pixels; the next DRAW goes on from its end. Without rows it begins in the middle.
    """
    width, height = size
    x, y = (rows[address].x, rows[address].y) if rows else (width // 2, height // 2)
    step, rise = max(width // 8, 1), max(height // 8, 1) if jump and rows else 0
    along = x + (step if x + step < width else -step)
    y_new = y + (rise if y + rise < height else -rise)
    draw = Row(DRAW, along, y_new, (rows[address].colour if rows else 0) or colour)
    new = [Row(MOVE, x, y_new), draw] if jump or not rows else [draw]
    return [*rows[: address + 1], *new, *rows[address + 1 :]]


def swapped(rows: Sequence[Row], address: int, later: bool) -> list[Drawn] | None:
    """The strokes with that of an address drawn one place earlier or later; None at either end."""
    strokes = drawn_by(rows)
    drawn = [row.stroke for row in rows if row.operation == DRAW]
    place = drawn.index(rows[address].stroke)
    other = place + (1 if later else -1)
    if not 0 <= other < len(strokes):
        return None
    strokes[place], strokes[other] = strokes[other], strokes[place]
    return strokes


def set_strokes(sheet: Sheet, old: Strokes, new: Sequence[Drawn]) -> Edit:
    """Let a sheet, which was drawn by ``old`` in the order of its figures, be drawn by ``new``.

    Raises: DocumentError where a stroke is not one of a figure, or where several views draw the same one.
    """
    if len(sheet.views) > 1:
        sentence = _(
            "Several views draw the same figures, so a stroke is not one figure's; change it in Draw."
        )
        raise DocumentError(sheet.id, sentence)
    if (old.figures < 0).any():
        sentence = _("These strokes are edges of the scene; change them in Space.")
        raise DocumentError(sheet.id, sentence)
    for stroke in new:
        if max(map(abs, stroke[:4])) > MAX_COORDINATE:
            sentence = _("({x:g}, {y:g}) is too far away; the deflection goes up to {most:g}.")
            raise DocumentError(sheet.id, sentence.format(x=stroke.x1, y=stroke.y1, most=MAX_COORDINATE))
    palette = _palette_with(sheet, old, new)
    return _replace_figures(sheet.id, tuple(_figures(sheet, old, new, palette)), palette)


@checked
def _replace_figures(sheet: str, figures: tuple[AnyFigure, ...], palette: tuple[int, ...]) -> Edit:
    """Let a sheet have these figures; those without an id are numbered."""

    def edit(document: Document) -> Document:
        fresh = iter(all_numbered(document, [figure for figure in figures if not figure.id]))
        numbered = tuple(figure if figure.id else next(fresh) for figure in figures)
        on = sheet_with(document, sheet)
        if (numbered, palette) == (on.figures, on.palette):
            return document
        return remembering(document, with_sheet(document, replace(on, figures=numbered, palette=palette)))

    return edit


def _palette_with(sheet: Sheet, old: Strokes, new: Sequence[Drawn]) -> tuple[int, ...]:
    """The palette and every colour that a changed stroke has and that is not in it yet."""
    kept = {stroke.stroke for stroke in new if _is_as_before(old, stroke)}
    colours = [stroke.colour for stroke in new if stroke.stroke not in kept]
    more = [colour for colour in dict.fromkeys(colours) if colour not in sheet.palette]
    if len(sheet.palette) + len(more) > MAX_PALETTE:
        sentence = _("The palette is full: it has {most} colours. Choose one of them.")
        raise DocumentError(sheet.id, sentence.format(most=MAX_PALETTE))
    return *sheet.palette, *more


def _is_as_before(old: Strokes, stroke: Drawn) -> bool:
    if stroke.stroke == NEW_STROKE:
        return False
    ends = tuple(old.ends[stroke.stroke].ravel().tolist())
    return ends == stroke[:4] and int(old.colours[stroke.stroke]) == stroke.colour


def _figures(
    sheet: Sheet, old: Strokes, new: Sequence[Drawn], palette: tuple[int, ...]
) -> Iterator[AnyFigure]:
    """The figures from back to front; one that draws nothing stays behind those that it was behind."""
    figures_of = old.figures.tolist()
    whole = {
        figure: tuple(k for k, _figure in group)
        for figure, group in groupby(enumerate(figures_of), key=lambda pair: pair[1])
    }
    silent = [number for number in range(len(sheet.figures)) if number not in whole]
    at, used = 0, set()
    while at < len(new):
        stroke = new[at]
        figure = figures_of[stroke.stroke] if stroke.stroke != NEW_STROKE else -1
        while silent and figure > silent[0]:
            yield sheet.figures[silent.pop(0)]
        group = whole.get(figure, ())
        run = new[at : at + len(group)]
        same = tuple(each.stroke for each in run) == group and all(_is_as_before(old, each) for each in run)
        if group and same and figure not in used:
            used.add(figure)
            yield sheet.figures[figure]
            at += len(group)
            continue
        before = sheet.figures[figure] if figure >= 0 else None
        keeps = isinstance(before, Line) and not before.transforms and figure not in used
        if keeps:
            used.add(figure)
        yield _line(sheet, stroke, before if keeps else None, palette)  # type: ignore[arg-type]
        at += 1
    yield from (sheet.figures[number] for number in silent)


def _line(sheet: Sheet, stroke: Drawn, before: Line | None, palette: tuple[int, ...]) -> Line:
    """A line for a stroke, the one ``before`` where it stays itself."""
    scale = view_map(sheet.first_view)
    places = scale.world_point(stroke.x0, stroke.y0), scale.world_point(stroke.x1, stroke.y1)
    names = [point.id for point in before.points_world] if before else ["", ""]
    points = tuple(WorldPoint(name, x, y) for name, (x, y) in zip(names, places, strict=True))
    colour = palette.index(stroke.colour)
    if before is None:
        return Line("", points, Line.algorithms[0], colour)
    return replace(before, points_world=points, colour=colour)
