"""Matrices with symbols: each cell as the course writes it and as a number, and chains multiplied out.

Where a chain has two links of one kind, an ``index`` tells their symbols apart: t_{x1} and t_{x2}.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from workbench.algorithms.transforms.chain import Matrix
from workbench.algorithms.transforms.terms import Expression, Product, constant, cosine, factor, place, sine
from workbench.geometry.angles import cosine_and_sine

Cells = tuple[tuple[Expression, ...], ...]
Texts = tuple[tuple[str, ...], ...]
Notation = tuple[tuple[Product, float], ...]
"""The terms of an expression without the values of their symbols."""
_ZERO, _ONE = constant(0), constant(1)


class SymbolicMatrix(NamedTuple):
    """A matrix (3, 3) of expressions, and what the course calls it: R(θ)."""

    name: str
    cells: Cells

    @property
    def texts(self) -> Texts:
        """Its cells in course notation."""
        return tuple(tuple(cell.text for cell in row) for row in self.cells)

    @property
    def matrix(self) -> Matrix:
        """Its cells as numbers."""
        return np.array([[cell.value for cell in row] for row in self.cells], np.float64)

    def __matmul__(self, other: "SymbolicMatrix") -> "SymbolicMatrix":
        """The product, of which ``other`` acts first."""
        columns = list(zip(*other.cells, strict=True))
        cells = tuple(tuple(_sum_of_products(row, column) for column in columns) for row in self.cells)
        return SymbolicMatrix(f"{self.name} {other.name}", cells)


def multiplied_out(chain: Sequence[SymbolicMatrix]) -> tuple[SymbolicMatrix, ...]:
    """The products of a chain as written, worked out from right to left; the last one is the whole chain."""
    products = [chain[-1]]
    for link in reversed(chain[:-1]):
        products.append(link @ products[-1])
    return tuple(products[1:]) or tuple(products)


def written_out(chain: Sequence[SymbolicMatrix]) -> tuple[Texts, ...]:
    """The texts of the matrices of a chain as written, then those of their product.

    They are the same whatever the symbols stand for, so they are worked out once for all values.
    """
    return _written_out(tuple(tuple(tuple(map(_notation, row)) for row in link.cells) for link in chain))


def _notation(cell: Expression) -> Notation:
    return tuple(
        (tuple((symbol._replace(value=0.0), power) for symbol, power in product), number)
        for product, number in cell.terms.items()
    )


@lru_cache(maxsize=64)
def _written_out(chain: tuple[tuple[tuple[Notation, ...], ...], ...]) -> tuple[Texts, ...]:
    links = [
        SymbolicMatrix("", tuple(tuple(Expression(dict(cell)) for cell in row) for row in rows))
        for rows in chain
    ]
    return *(link.texts for link in links), multiplied_out(links)[-1].texts


def row_times_column(left: SymbolicMatrix, right: SymbolicMatrix, row: int, column: int) -> str:
    """A cell of the product before it is worked out: cos θ·(−x_p) + (−sin θ)·(−y_p) + 0·1."""
    pairs = zip(left.cells[row], (cells[column] for cells in right.cells), strict=True)
    return " + ".join(f"{_bracketed(a.text)}·{_bracketed(b.text)}" for a, b in pairs)


def translation_by(tx: Expression, ty: Expression) -> SymbolicMatrix:
    """T(tx, ty) of any expressions, such as −x_p and −y_p."""
    return SymbolicMatrix(f"T({tx.text}, {ty.text})", _affine((_ONE, _ZERO, tx), (_ZERO, _ONE, ty)))


def scaling_by(sx: Expression, sy: Expression) -> SymbolicMatrix:
    """S(sx, sy) of any expressions."""
    return SymbolicMatrix(f"S({sx.text}, {sy.text})", _affine((sx, _ZERO, _ZERO), (_ZERO, sy, _ZERO)))


def symbolic_translation(tx: float, ty: float, index: str = "") -> SymbolicMatrix:
    """T(t_x, t_y)."""
    return translation_by(place(_name("t", "x", index), tx), place(_name("t", "y", index), ty))


def symbolic_rotation(theta: float, index: str = "") -> SymbolicMatrix:
    """R(θ)."""
    angle = _indexed("θ", index)
    cos, sin = _turn(angle, theta)
    return SymbolicMatrix(f"R({angle})", _affine((cos, -sin, _ZERO), (sin, cos, _ZERO)))


def symbolic_scaling(sx: float, sy: float, index: str = "") -> SymbolicMatrix:
    """S(s_x, s_y)."""
    return scaling_by(factor(_name("s", "x", index), sx), factor(_name("s", "y", index), sy))


def symbolic_shear(
    sh_x: float, sh_y: float, x_ref: float = 0.0, y_ref: float = 0.0, index: str = ""
) -> SymbolicMatrix:
    """Sh(sh_x, sh_y), relative to the lines x = x_ref and y = y_ref."""
    along_x, along_y = factor(_name("sh", "x", index), sh_x), factor(_name("sh", "y", index), sh_y)
    left, low = place(_name("x", "ref", index), x_ref), place(_name("y", "ref", index), y_ref)
    cells = _affine((_ONE, along_x, -along_x * low), (along_y, _ONE, -along_y * left))
    return SymbolicMatrix(f"Sh({along_x.text}, {along_y.text})", cells)


def symbolic_reflection(x: float, y: float, angle: float, index: str = "") -> SymbolicMatrix:
    """F(φ): in the line through (x_p, y_p) that makes the angle φ with the x axis."""
    phi = _indexed("φ", index)
    cos, sin = _turn(f"2{phi}", 2 * angle)
    xp, yp = _pivot(x, y, index)
    cells = _affine(
        (cos, sin, xp * (_ONE - cos) - yp * sin),
        (sin, -cos, yp * (_ONE + cos) - xp * sin),
    )
    return SymbolicMatrix(f"F({phi})", cells)


def rotation_about_chain(theta: float, x: float, y: float, index: str = "") -> tuple[SymbolicMatrix, ...]:
    """T(x_p, y_p), R(θ) and T(−x_p, −y_p), in the order of writing."""
    xp, yp = _pivot(x, y, index)
    return translation_by(xp, yp), symbolic_rotation(theta, index), translation_by(-xp, -yp)


def scaling_about_chain(
    sx: float, sy: float, x: float, y: float, index: str = ""
) -> tuple[SymbolicMatrix, ...]:
    """T(x_p, y_p), S(s_x, s_y) and T(−x_p, −y_p), in the order of writing."""
    xp, yp = _pivot(x, y, index)
    return translation_by(xp, yp), symbolic_scaling(sx, sy, index), translation_by(-xp, -yp)


def reflection_chain(x: float, y: float, angle: float, index: str = "") -> tuple[SymbolicMatrix, ...]:
    """T(x_p, y_p), R(φ), S(1, −1), R(−φ) and T(−x_p, −y_p): the line brought onto the x axis, and back."""
    xp, yp = _pivot(x, y, index)
    phi = _indexed("φ", index)
    cos, sin = _turn(phi, angle)
    there = SymbolicMatrix(f"R(−{phi})", _affine((cos, sin, _ZERO), (-sin, cos, _ZERO)))
    back = SymbolicMatrix(f"R({phi})", _affine((cos, -sin, _ZERO), (sin, cos, _ZERO)))
    return translation_by(xp, yp), back, scaling_by(_ONE, -_ONE), there, translation_by(-xp, -yp)


def symbolic_matrix(matrix: Matrix, name: str = "M", index: str = "") -> SymbolicMatrix:
    """An affine (3, 3) matrix of which only the numbers are known: m_{11} and so on."""
    first, second = (
        tuple(
            (place if column == 2 else factor)(_name("m", f"{row + 1}{column + 1}", index), value)
            for column, value in enumerate(matrix[row].tolist())
        )
        for row in (0, 1)
    )
    return SymbolicMatrix(_indexed(name, index), _affine(first, second))


def _affine(first: tuple[Expression, ...], second: tuple[Expression, ...]) -> Cells:
    return first, second, (_ZERO, _ZERO, _ONE)


def _turn(angle: str, theta: float) -> tuple[Expression, Expression]:
    cos, sin = cosine_and_sine(theta)
    return cosine(angle, cos), sine(angle, sin)


def _pivot(x: float, y: float, index: str) -> tuple[Expression, Expression]:
    return place(_name("x", "p", index), x), place(_name("y", "p", index), y)


def _name(letter: str, subscript: str, index: str) -> str:
    whole = subscript + index
    return f"{letter}_{whole}" if len(whole) == 1 else f"{letter}_{{{whole}}}"


def _indexed(name: str, index: str) -> str:
    return name if not index else f"{name}_{index}" if len(index) == 1 else f"{name}_{{{index}}}"


def _sum_of_products(row: Sequence[Expression], column: Sequence[Expression]) -> Expression:
    total = _ZERO
    for a, b in zip(row, column, strict=True):
        total += a * b
    return total


def _bracketed(text: str) -> str:
    """A factor, in parentheses where it is a sum or negative."""
    return f"({text})" if text.startswith("−") or " + " in text or " − " in text else text
