"""The matrices of an object in space: the seven of its rotation, the step, the whole, the quaternion."""

import math

import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms.axis import STEP_NAMES, unit_axis
from workbench.document.scene.links import AnyLink3D, Rotate3D
from workbench.document.scene.model import Object
from workbench.exchange.formulas.terms import Phrase, Sign, Term, displayed, matrix
from workbench.geometry.quaternions import quaternion_about
from workbench.language import _
from workbench.panels.transform.rows import Row
from workbench.rendering.subjects.space_chain import acting, last_turn, upto

_LETTERS = {"Translate3D": "T", "Rotate3D": "R", "Scale3D": "S", "Reflect3D": "F", "Shear3D": "Sh"}


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
    listed = [Row((*first, matrix(whole)))]
    if turn is None:
        return listed
    at, link = turn
    return [_named(link, f"R_{at + 1}" if len(links) > 1 else "R", step), *_at_step(link, step), *listed,
            _by_quaternion(link)]  # fmt: skip


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
    terms: tuple[Term, ...] = (Phrase(now.name, strong=True), Sign("="), matrix(now.matrix))
    if step > 1:
        note = Phrase(f'"{_("and so far")}"', note=True)
        terms = (*terms, note, matrix(product))
    return [Row(terms)]


def _by_quaternion(link: Rotate3D) -> Row:
    """The same rotation by a unit quaternion, and how far the two matrices are apart."""
    theta = math.radians(link.angle)
    w, x, y, z = quaternion_about(theta, unit_axis(link.pivot, link.second))
    other = transforms.rotation_by_quaternion(theta, link.pivot, link.second)
    apart = float(np.abs(other - link.matrix).max())
    same = _("the same to {apart:.0e}").format(apart=apart) if apart else _("the same to the last digit")
    numbers = ", ".join(displayed(part) for part in (w, x, y, z))
    return Row(
        (
            Phrase("q", strong=True),
            Sign("="),
            Phrase(f'"({numbers})"'),
            Phrase(f'"{_("as a matrix")}"', note=True),
            matrix(other),
            Phrase(f'"{same}"', note=True),
        )
    )
