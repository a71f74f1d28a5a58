"""Sums of products of named numbers, as the cells of a matrix have them: text in course notation, and value.

Like terms are collected, and cos² + sin² is 1 where that makes a sum shorter. A sum is written with the
coordinates of places taken out: x_p(1 − cos θ) + y_p sin θ.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import permutations
from typing import NamedTuple

from workbench.algorithms.numerals import numeral

FACTOR, PLACE, TURN = range(3)
"""The order of the symbols in a product: scale factors and shears, coordinates, sines and cosines."""

_SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class Symbol(NamedTuple):
    """A named number; ``angle`` is the name of the angle of a cosine or sine. One name means one number."""

    kind: int
    text: str
    value: float
    angle: str = ""


Product = tuple[tuple[Symbol, int], ...]
"""Symbols in the order of writing, each with its power."""


@dataclass(frozen=True, slots=True)
class Expression:
    """A sum of products, each with its number in front; the empty product is a constant."""

    terms: Mapping[Product, float]

    def __add__(self, other: "Expression") -> "Expression":
        return collected([*self.terms.items(), *other.terms.items()])

    def __neg__(self) -> "Expression":
        return Expression({product: -number for product, number in self.terms.items()})

    def __sub__(self, other: "Expression") -> "Expression":
        return self + -other

    def __mul__(self, other: "Expression") -> "Expression":
        return collected(
            (_joined(one, another), number * times)
            for one, number in self.terms.items()
            for another, times in other.terms.items()
        )

    @property
    def value(self) -> float:
        """What it comes to, rounded once."""
        return math.fsum(
            number * math.prod(symbol.value**power for symbol, power in product)
            for product, number in self.terms.items()
        )

    @property
    def text(self) -> str:
        """As the course writes it, with subscripts such as x_p, x_{min}."""
        places: dict[Symbol | None, dict[Product, float]] = {None: {}}
        for product, number in sorted(self.terms.items()):
            place = next((symbol for symbol, _power in product if symbol.kind == PLACE), None)
            places.setdefault(place, {})[product] = number
        constants = places.pop(None, {})
        in_order = [(place, places[place]) for place in sorted(filter(None, places))]
        long = [_taken_out(place, terms) for place, terms in in_order if len(terms) > 1]
        short = [_written(*term) for _place, terms in in_order if len(terms) == 1 for term in terms.items()]
        return _sum([*long, *short, *(_written(*term) for term in constants.items())])


def constant(number: float) -> Expression:
    """A number without a name."""
    return collected([((), float(number))])


def factor(text: str, value: float) -> Expression:
    """A scale factor or a shear."""
    return Expression({((Symbol(FACTOR, text, float(value)), 1),): 1.0})


def place(text: str, value: float) -> Expression:
    """A coordinate, or a distance along one."""
    return Expression({((Symbol(PLACE, text, float(value)), 1),): 1.0})


def cosine(angle: str, value: float) -> Expression:
    """The cosine of the angle with this name."""
    return Expression({((Symbol(TURN, f"cos {angle}", float(value), angle), 1),): 1.0})


def sine(angle: str, value: float) -> Expression:
    """The sine of the angle with this name."""
    return Expression({((Symbol(TURN, f"sin {angle}", float(value), angle), 1),): 1.0})


def collected(terms: Iterable[tuple[Product, float]]) -> Expression:
    """The sum of these terms, those with one product as one, none of them 0."""
    sums = _added(terms)
    for shorter in _without_squares(sums):
        if len(shorter) < len(sums):
            return collected(shorter.items())
    return Expression(sums)


def _added(terms: Iterable[tuple[Product, float]]) -> dict[Product, float]:
    sums: dict[Product, float] = {}
    for product, number in terms:
        sums[product] = sums.get(product, 0.0) + number
    return {product: number for product, number in sums.items() if number != 0.0}


def _without_squares(sums: Mapping[Product, float]) -> Iterator[dict[Product, float]]:
    """The same sum, by turns with cos² = 1 − sin² and with sin² = 1 − cos² of each angle."""
    turns = {symbol for product in sums for symbol, _power in product if symbol.angle}
    for square, other in permutations(sorted(turns), 2):
        if square.angle == other.angle:
            replaced = dict(sums)
            while any(dict(product).get(square, 0) >= 2 for product in replaced):
                replaced = _added(_replaced(replaced, square, other))
            yield replaced


def _replaced(
    sums: Mapping[Product, float], square: Symbol, other: Symbol
) -> Iterator[tuple[Product, float]]:
    for product, number in sums.items():
        powers = dict(product)
        if powers.get(square, 0) >= 2:
            rest = _joined(product, ((square, -2),))
            yield rest, number
            yield _joined(rest, ((other, 2),)), -number
        else:
            yield product, number


def _joined(one: Product, other: Product) -> Product:
    powers = dict(one)
    for symbol, power in other:
        powers[symbol] = powers.get(symbol, 0) + power
    return tuple(sorted((symbol, power) for symbol, power in powers.items() if power))


def _taken_out(place: Symbol, terms: Mapping[Product, float]) -> str:
    """All these terms have the place in them: x_p(1 − cos θ)."""
    rest = {_joined(product, ((place, -1),)): number for product, number in terms.items()}
    first = min(rest)
    sign = -1.0 if rest[first] < 0.0 else 1.0
    inner = _sum([_written(product, sign * number) for product, number in sorted(rest.items())])
    return f"{'−' if sign < 0 else ''}{place.text}({inner})"


def _written(product: Product, number: float) -> str:
    """One term: −x_p cos θ, 2s_x, 2 cos θ sin θ, 1."""
    if not product:
        return numeral(number)
    size = "" if abs(number) == 1.0 else numeral(abs(number)) + (" " if product[0][0].angle else "")
    return ("−" if number < 0 else "") + size + " ".join(_power(symbol, power) for symbol, power in product)


def _power(symbol: Symbol, power: int) -> str:
    if power == 1:
        return symbol.text
    raised = str(power).translate(_SUPERSCRIPTS)
    if symbol.angle:
        name, angle = symbol.text.split(" ", 1)
        return f"{name}{raised} {angle}"
    return symbol.text + raised


def _sum(terms: list[str]) -> str:
    """Terms behind one another, a minus sign of their own taking the place of the plus."""
    if not terms:
        return "0"
    return terms[0] + "".join(
        f" − {term[1:]}" if term.startswith("−") else f" + {term}" for term in terms[1:]
    )
