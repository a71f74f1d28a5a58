"""The rows of matrices of a chain: its product with symbols, then every product with numbers."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from workbench.algorithms.transforms import Matrix as Numbers
from workbench.algorithms.transforms.symbols import written_out
from workbench.document.transforms.stages import Stage, products
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Shows, Sign, Term, matrix
from workbench.language import _
from workbench.panels.transform.told import in_numbers, product_name
from workbench.widgets.formulas.row_surface import Highlight

MOST_WITH_SYMBOLS = 3
_CELLS = 9


@dataclass(frozen=True, slots=True)
class Progress:
    """How far the products are: ``known`` cells of product ``number`` (from 0), and the ``current`` one.

    ``asked`` is a cell whose number is asked for. ``point``: a point is multiplied, ``known`` of its rows.
    """

    number: int
    known: int
    current: tuple[int, int] | None = None
    asked: tuple[int, int] | None = None
    point: bool = False


@dataclass(frozen=True, slots=True)
class Row:
    """One row of terms. ``of`` tells the stage whose matrix a term is, ``upto`` after which stage a product
    stands; ``product`` numbers the product that is worked out in term 1, from 0, or is None."""

    terms: tuple[Term, ...]
    shows: Shows = "numbers"
    of: dict[int, Stage] = field(default_factory=dict)
    upto: dict[int, int] = field(default_factory=dict)
    product: int | None = None
    highlights: tuple[Highlight, ...] = ()


def rows(
    chain: Sequence[Stage],
    progress: Progress | None = None,
    point: tuple[float, float] | None = None,
    notes: bool = True,
) -> list[Row]:
    """Every row of a chain that has a stage; the last one takes ``point`` through it, where there is one.

    Without ``notes`` nothing small stands behind a row.
    """
    made = products(list(chain))
    count = len(chain)
    listed = [_symbols(chain, made[-1]), *(_product(chain, made, k, progress) for k in range(count - 1))]
    if point is not None:
        listed.append(_point(made[-1], point, progress, count))
    return listed if notes else [replace(row, terms=_without_notes(row.terms)) for row in listed]


def _without_notes(terms: tuple[Term, ...]) -> tuple[Term, ...]:
    return tuple(term for term in terms if not (isinstance(term, Phrase) and term.note))


def _factor(stage: Stage) -> Matrix:
    """The matrix of a stage with its numbers; those that are numbers of its link can be changed."""
    shown = matrix(stage.elementary.matrix)
    cells = tuple(
        tuple(replace(cell, editable=(i, j) in stage.entries) for j, cell in enumerate(row))
        for i, row in enumerate(shown.cells)
    )
    return replace(shown, cells=cells)


def _symbols(chain: Sequence[Stage], whole: Numbers) -> Row:
    """M = ... with symbols, as long as it can be read; of a single stage its numbers beside them."""
    name = Phrase("M", strong=True)
    if len(chain) == 1:
        stage = chain[0]
        symbols = matrix(whole, stage.symbols.texts)
        terms: tuple[Term, ...] = (
            name,
            Sign("="),
            replace(symbols, cells=tuple(tuple(Cell(c.symbol) for c in row) for row in symbols.cells)),
            Sign("="),
            _factor(stage),
            Phrase(in_numbers(stage), note=True),
        )
        return Row(terms, "numbers", {2: stage, 4: stage})
    written = list(reversed(chain))
    if len(chain) > MOST_WITH_SYMBOLS:
        factors = [Phrase(stage.symbols.name) for stage in written]
        return Row((name, Sign("="), *factors), of=dict(enumerate(written, 2)))
    *factors_written, product = written_out([stage.symbols for stage in written])
    terms = (
        name,
        matrix(whole, product),
        Sign("="),
        *(
            matrix(stage.elementary.matrix, texts)
            for stage, texts in zip(written, factors_written, strict=True)
        ),
        Phrase(f'"{_("in symbols")}"', note=True),
    )
    return Row(terms, "symbols", dict(enumerate(written, 3)), {1: len(chain)})


def _product(chain: Sequence[Stage], made: list[Numbers], k: int, progress: Progress | None) -> Row:
    """The product of the matrix of stage k + 2 and what stands before it."""
    count, stage = len(chain), chain[k + 1]
    name = product_name(k + 2, count)
    known = _known(k, progress)
    right = _factor(chain[0]) if k == 0 else _partly(made[k], _known(k - 1, progress))
    here = progress is not None and not progress.point and progress.number == k
    result = _partly(made[k + 1], known, progress.asked if here and progress is not None else None)
    before = in_numbers(chain[0]) if k == 0 else product_name(k + 1, count)
    note = f"A = {in_numbers(stage)}, B = {before}"
    if here:
        note = f'{note}, "{_("{known} of {all}").format(known=known, all=_CELLS)}"'
    terms = (
        Phrase(name, strong=True),
        result,
        Sign("="),
        _factor(stage),
        right,
        Phrase(note, note=True),
    )
    highlights: tuple[Highlight, ...] = ()
    if here and progress is not None and progress.current is not None:
        i, j = progress.current
        highlights = (
            Highlight(3, i, None, "accent", "solid"),
            Highlight(4, None, j, "data2", "dash"),
            Highlight(1, i, j, "text", "double"),
        )
    of = {3: stage, **({4: chain[0]} if k == 0 else {})}
    upto = {1: k + 2, **({} if k == 0 else {4: k + 1})}
    return Row(terms, "numbers", of, upto, k, highlights)


def _known(k: int, progress: Progress | None) -> int:
    if progress is None or progress.point or k < progress.number:
        return _CELLS
    return progress.known if k == progress.number else 0


def _partly(values: Numbers, known: int, asked: tuple[int, int] | None = None) -> Matrix:
    """A product of which the first ``known`` cells are there."""
    columns = values.shape[1]
    return Matrix(
        tuple(
            tuple(
                Cell(value=value if i * columns + j < known else None, hidden=(i, j) == asked)
                for j, value in enumerate(row)
            )
            for i, row in enumerate(np.asarray(values).tolist())
        )
    )


def _point(whole: Numbers, point: tuple[float, float], progress: Progress | None, count: int) -> Row:
    """P′ = M P."""
    column = np.array([[point[0]], [point[1]], [1.0]])
    image = whole @ column
    here = progress if progress is not None and progress.point else None
    known = 3 if here is None else here.known
    highlights: tuple[Highlight, ...] = ()
    if here is not None and here.current is not None:
        i = here.current[0]
        highlights = (
            Highlight(3, i, None, "accent", "solid"),
            Highlight(4, None, 0, "data2", "dash"),
            Highlight(1, i, 0, "text", "double"),
        )
    terms = (
        Phrase("P′", strong=True),
        _partly(image, known),
        Sign("="),
        matrix(whole),
        matrix(column),
        Phrase(f'"{_("the matrix times the point")}"', note=True),
    )
    return Row(terms, "numbers", {}, {3: count}, None, highlights)
