"""The matrices of a view as rows of terms, and what a changed number of theirs makes of the view."""

from functools import lru_cache

import numpy as np

from workbench.algorithms.transforms.symbols import SymbolicMatrix, multiplied_out
from workbench.algorithms.viewing import window_chain
from workbench.document.model import Rectangle, View
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Place, Sign, Term
from workbench.language import _
from workbench.panels.viewing.rectangles import moved
from workbench.rendering.mapping import box
from workbench.rendering.subjects.window import landing

PRODUCT, MOVE_TO_VIEWPORT, SCALE, MOVE_TO_ORIGIN = 1, 3, 4, 5
"""Where the matrices stand among the terms."""

_EDITABLE = {
    MOVE_TO_VIEWPORT: ((0, 2), (1, 2)),
    SCALE: ((0, 0), (1, 1)),
    MOVE_TO_ORIGIN: ((0, 2), (1, 2)),
}


def chain_of(view: View) -> tuple[SymbolicMatrix, ...]:
    """The three factors of the matrix of a view, in the order of writing."""
    return window_chain(box(view.window_world), box(view.viewport_device), view.mode)  # type: ignore[arg-type]


@lru_cache(maxsize=8)
def terms_of(view: View) -> tuple[Term, ...]:
    """M = T S T with symbols and numbers."""
    chain = chain_of(view)
    product = multiplied_out(chain)[-1]
    factors = [
        _matrix(factor, _EDITABLE[term])
        for factor, term in zip(chain, (MOVE_TO_VIEWPORT, SCALE, MOVE_TO_ORIGIN), strict=True)
    ]
    return (Phrase("M", strong=True), _matrix(product, ()), Sign("="), *factors)


def _matrix(symbolic: SymbolicMatrix, editable: tuple[tuple[int, int], ...]) -> Matrix:
    return Matrix(
        tuple(
            tuple(Cell(cell.text, float(cell.value), (i, j) in editable) for j, cell in enumerate(row))
            for i, row in enumerate(symbolic.cells)
        )
    )


def rewritten(view: View, place: Place, value: float) -> tuple[str, Rectangle]:
    """The rectangle, by name, that changes when a number of a factor becomes ``value``, and how.

    The other factors stay as they are: a translation moves the viewport or the window as a whole, a scale
    factor makes the viewport larger. Raises: ValueError, a sentence, for a scale factor that is not above 0.
    """
    term, row, _column = place
    way = np.array((1.0, 0.0) if row == 0 else (0.0, 1.0))
    corner = landing(view)[:2]
    if term == MOVE_TO_ORIGIN:
        at = (view.window_world.xmin, view.window_world.ymin)[row]
        return "window", moved(view.window_world, *((-value - at) * way).tolist())
    if term == MOVE_TO_VIEWPORT:
        return "viewport", moved(view.viewport_device, *((value - corner[row]) * way).tolist())
    if not value > 0.0:
        name = ("s_x", "s_y")[row]
        text = _("With {name} = {value:g} nothing of the picture is left; give a number above 0.")
        raise ValueError(text.format(name=name, value=value))
    ratio = value / float(chain_of(view)[1].cells[row][row].value)
    by = np.where(way, ratio, 1.0) if view.mode == "stretch" else np.full(2, ratio)
    ends = np.array(box(view.viewport_device)).reshape(2, 2)
    sides = np.array(corner) + (ends - corner) * by
    return "viewport", Rectangle(*(round(side, 9) + 0.0 for side in sides.ravel().tolist()))


def changed_cells(before: View, now: View) -> tuple[Place, ...]:
    """The cells whose numbers differ between two states of a view."""
    places: list[Place] = []
    for term, (old, new) in enumerate(zip(terms_of(before), terms_of(now), strict=True)):
        if isinstance(old, Matrix) and isinstance(new, Matrix):
            places += [
                (term, i, j)
                for i, row in enumerate(new.cells)
                for j, cell in enumerate(row)
                if cell.number != old.cells[i][j].number
            ]
    return tuple(places)
