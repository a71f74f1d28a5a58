"""The matrices of an object in space: the seven of its rotation, the step, the whole, the quaternion."""

import math

import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix as Numbers
from workbench.algorithms.transforms.axis import STEP_NAMES, unit_axis
from workbench.document.scene.links import AnyLink3D, Rotate3D
from workbench.document.scene.model import Object
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Sign, Term, displayed, matrix
from workbench.geometry.quaternions import quaternion_about
from workbench.language import _
from workbench.panels.transform.rows import Row
from workbench.rendering.subjects.space_chain import acting, last_turn, upto

_LETTERS = {"Translate3D": "T", "Rotate3D": "R", "Scale3D": "S", "Reflect3D": "F", "Shear3D": "Sh"}


_ROUNDING = 1e-12


def _affine(*rows: tuple[str, str, str, str]) -> tuple[tuple[str, ...], ...]:
    return (*rows, ("0", "0", "0", "1"))


def _moved(sign: str) -> tuple[tuple[str, ...], ...]:
    x, y, z = (f"{sign}{axis}_1" for axis in "xyz")
    return _affine(("1", "0", "0", x), ("0", "1", "0", y), ("0", "0", "1", z))


_SYMBOLS = (
    _moved("−"),
    _affine(("1", "0", "0", "0"), ("0", "c/d", "−b/d", "0"), ("0", "b/d", "c/d", "0")),
    _affine(("d", "0", "−a", "0"), ("0", "1", "0", "0"), ("a", "0", "d", "0")),
    _affine(("cos θ", "−sin θ", "0", "0"), ("sin θ", "cos θ", "0", "0"), ("0", "0", "1", "0")),
    _affine(("d", "0", "a", "0"), ("0", "1", "0", "0"), ("−a", "0", "d", "0")),
    _affine(("1", "0", "0", "0"), ("0", "c/d", "b/d", "0"), ("0", "−b/d", "c/d", "0")),
    _moved(""),
)
"""The seven matrices as the course writes them; (a, b, c) is the direction of the axis, d² = b² + c²."""


def letter_of(link: AnyLink3D) -> str:
    """What the matrix of a link is called."""
    return _LETTERS.get(type(link).__name__, "B")


def space_rows(thing: Object, step: int) -> list[Row]:
    """What is written under an object of which ``step`` steps of its last rotation are done; none where no
    link is on."""
    links = acting(thing)
    if not links:
        return []
    turn = last_turn(thing)
    whole = upto(thing, len(links))
    first: list[Term] = [Phrase("M", strong=True), Sign("=")]
    if len(links) > 1:
        first += [Phrase(f"{letter_of(link)}_{len(links) - k}") for k, link in enumerate(reversed(links))]
        first.append(Sign("="))
    first.append(matrix(whole))
    if turn is None:
        return [Row(tuple(first))]
    at, link = turn
    name = f"R_{at + 1}" if len(links) > 1 else "R"
    return [_named(link, name, step), *_at_step(link, step), Row((*first, *_quaternion(link, whole, name)))]


def _named(link: Rotate3D, name: str, step: int) -> Row:
    """R as its seven matrices by name, in the order of writing; the one of the step stands out."""
    names = [Phrase(each, strong=number == step) for number, each in reversed([*enumerate(STEP_NAMES, 1)])]
    return Row((Phrase(name, strong=True), Sign("="), *names))


def _at_step(link: Rotate3D, step: int) -> list[Row]:
    """The matrix of the step that was taken last, and the product so far."""
    parts = link.unfolded()
    if not 0 < step <= len(parts):
        return []
    product = np.eye(4)
    for part in parts[:step]:
        product = part.matrix @ product
    now = parts[step - 1]
    symbols = tuple(tuple(Cell(text) for text in row) for row in _SYMBOLS[step - 1])
    terms: tuple[Term, ...] = (
        Phrase(now.name, strong=True),
        Sign("="),
        Matrix(symbols),
        Sign("="),
        matrix(now.matrix),
    )
    if step > 1:
        terms = (*terms, Phrase(f'"{_("so far")}"', note=True), matrix(product))
    return [Row(terms)]


def _quaternion(link: Rotate3D, whole: Numbers, name: str) -> tuple[Term, ...]:
    """The unit quaternion of a rotation, and how far its matrix is from the seven."""
    theta = math.radians(link.angle)
    w, x, y, z = quaternion_about(theta, unit_axis(link.pivot, link.second))
    other = transforms.rotation_by_quaternion(theta, link.pivot, link.second)
    apart = float(np.abs(other - link.matrix).max())
    if apart < _ROUNDING * max(1.0, float(np.abs(whole).max())):
        told = _("the same {name}").format(name=name)
    else:
        told = _("off by {apart:.0e}").format(apart=apart)
    numbers = ", ".join(displayed(part) for part in (w, x, y, z))
    return (
        Phrase(f'"{_("quaternion")}"', note=True),
        Phrase("q", strong=True),
        Sign("="),
        Phrase(f'"({numbers})"'),
        Phrase(f'"{told}"', note=True),
    )
