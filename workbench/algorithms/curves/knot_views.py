"""What is shown of knots and basis values around one knot span while de Boor's construction is stepped."""

from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.geometry.curves.basis_functions import basis_functions


def knot_rows(knots: NDArray[Any], degree: int, span: int) -> list[tuple[int, float, str]]:
    """The knots that matter in a span: (i, t_i, and whether the span begins or ends there)."""
    ends = {span: "from", span + 1: "to"}
    return [(i, float(knots[i]), ends.get(i, "")) for i in range(span - degree + 1, span + degree + 1)]


def basis_rows(knots: NDArray[Any], degree: int, span: int, u: float) -> list[tuple[int, float]]:
    """The basis functions that are not 0 in the span: (i, N_i(u))."""
    _span, values = basis_functions(knots, degree, u)
    return [(span - degree + j, float(value)) for j, value in enumerate(values)]


KNOT_TABLES = {
    "Basis values": ("basis_rows(knots, degree, span, u)", ("i", "N_{i,p}(u)")),
    "Knot span": ("knot_rows(knots, degree, span)", ("i", "t_i", "in the span")),
}
NEXT_SPAN = View(
    block="Go on to the next knot span",
    sentence="u = {u} is not before {knots[span]}: go on to span {span}.",
)
IN_SPAN = (
    "u = {u} lies in span {span}, {knots[span]} to {knots[span + 1]}: only the points {span - degree} to "
    "{span} matter."
)
