"""The ``transform`` of SVG elements, in and out: its functions are links of a figure's chain.

In SVG y goes downwards, and the function that is written first acts last.
"""

import math
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.transforms import Matrix, product
from workbench.document.check import MAX_LINKS, number_problem
from workbench.document.fields import numbers_of
from workbench.document.transforms.chains import LARGEST, matrix_of
from workbench.document.transforms.links import (
    AboutPivot,
    Affine,
    AnyLink,
    Rotate,
    Scale,
    Shear,
    Translate,
)

Array = NDArray[np.float64]

_FUNCTION = re.compile(r"\s*([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")
_PART = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(px|deg|grad|rad|turn|%)?[\s,]*")
_LONGEST_NUMBER = 100
MOST_FUNCTIONS = 1_000
_COUNTS = {
    "matrix": (6,),
    "translate": (1, 2),
    "scale": (1, 2),
    "rotate": (1, 3),
    "skewx": (1,),
    "skewy": (1,),
}
# Those that only CSS has: the function they are, and where in it their number stands.
_ALONG = {
    "translatex": ("translate", "{} 0"),
    "translatey": ("translate", "0 {}"),
    "scalex": ("scale", "{} 1"),
    "scaley": ("scale", "1 {}"),
}
_UNITS = {"px": 1.0, "deg": 1.0, "grad": 0.9, "rad": math.degrees(1.0), "turn": 360.0}


class Function(NamedTuple):
    """One function of a ``transform``, its name in small letters, and its numbers; angles in degrees.

    Its name is "frame" for what is no ``transform``, such as the place of a ``use``: a matrix too.
    """

    name: str
    numbers: tuple[float, ...]

    @property
    def matrix(self) -> Array:
        """That of a matrix or frame (2, 3)."""
        return np.array(self.numbers).reshape(3, 2).T


class Placing(NamedTuple):
    """What all transforms around an element come to (2, 3), and the functions they are, outermost first."""

    matrix: Array
    functions: tuple[Function, ...] = ()

    def within(self, matrix: Array, functions: Sequence[Function] = ()) -> "Placing":
        """That of what lies under ``matrix`` inside, which these ``functions`` are, or else a frame."""
        frame = Function("frame", tuple(matrix.T.ravel().tolist()))
        return Placing(after(self.matrix, matrix), (*self.functions, *(functions or (frame,))))


def framed_inside(functions: tuple[Function, ...]) -> tuple[tuple[Function, ...], Array]:
    """Functions without the frames that are innermost, and the matrix (2, 3) of these."""
    inner: Array = np.eye(2, 3)
    while functions and functions[-1].name == "frame":
        inner = after(functions[-1].matrix, inner)
        functions = functions[:-1]
    return functions, inner


def after(outer: Array, inner: Array) -> Array:
    """The matrix (2, 3) of ``inner`` followed by ``outer``."""
    both: Array = outer[:, :2] @ inner
    both[:, 2] += outer[:, 2]
    return both


def functions_in(text: str, whole: tuple[float, float] = (0.0, 0.0)) -> tuple[Function, ...] | None:
    """The functions of a ``transform``, of SVG or CSS, ``whole`` being 100 % of a way across and down.

    None where it cannot be read.
    """
    functions: list[Function] = []
    at, text = 0, text.strip()
    if text.lower() in ("", "none"):
        return ()
    while at < len(text):
        match = _FUNCTION.match(text, at)
        if match is None or len(functions) == MOST_FUNCTIONS:
            return None
        name, inside = match[1].lower(), match[2]
        if name in _ALONG:
            name, places = _ALONG[name]
            inside = places.format(inside)
        numbers = _numbers_in(inside, whole)
        if numbers is None or len(numbers) not in _COUNTS.get(name, ()):
            return None
        functions.append(Function(name, numbers))
        at = match.end()
    return tuple(functions)


def _numbers_in(text: str, whole: tuple[float, float]) -> tuple[float, ...] | None:
    """The numbers between the brackets of a function; None where something else is there."""
    numbers: list[float] = []
    at = 0
    while at < len(text):
        match = _PART.match(text, at)
        if match is None or len(match[1]) > _LONGEST_NUMBER or len(numbers) == 6:
            return None
        unit = match[2] or "px"
        number = float(match[1]) * (whole[len(numbers) % 2] / 100 if unit == "%" else _UNITS[unit])
        if not math.isfinite(number):
            return None
        numbers.append(number)
        at = match.end()
    return tuple(numbers)


def matrix_in(functions: Sequence[Function]) -> Array:
    """The matrix (2, 3) of functions one inside the other, y downwards."""
    return product(np.eye(3), *map(_matrix, functions))[:2]


def chain_of(functions: Sequence[Function], scale: float, dx: float, dy: float) -> tuple[AnyLink, ...] | None:
    """The chain, without ids, of functions around a figure that stands in the world already.

    A place (x, y) of the drawing is (scale x + dx, dy - scale y) there. Too many functions, or such as a link
    has no room for, are one matrix; None where there is none.
    """
    frame = np.array([[scale, 0.0, dx], [0.0, -scale, dy], [0.0, 0.0, 1.0]])
    back = np.array([[1 / scale, 0.0, -dx / scale], [0.0, -1 / scale, dy / scale], [0.0, 0.0, 1.0]])
    links = tuple(_link(function, frame, back) for function in reversed(functions))
    if len(links) > MAX_LINKS or not all(map(_is_sound, links)):
        whole = product(frame, *map(_matrix, functions), back)
        links = (Affine.of("", whole),)
    matrix = matrix_of(links)
    sound = matrix is None or abs(matrix).max() <= LARGEST
    return links if sound and all(map(_is_sound, links)) else None


def _is_sound(link: AnyLink) -> bool:
    declared = numbers_of(type(link)).items()
    return not any(number_problem(number, getattr(link, name)) for name, number in declared)


def _link(function: Function, frame: Matrix, back: Matrix) -> AnyLink:
    name, numbers = function
    scale, (x0, y0) = float(frame[0, 0]), frame[:2, 2].tolist()
    match name, numbers:
        case "frame", (1.0, 0.0, 0.0, 1.0, tx, ty):
            return Translate("", tx=scale * tx, ty=0.0 - scale * ty)
        case "translate", (tx, *rest):
            return Translate("", tx=scale * tx, ty=0.0 - scale * (rest or [0.0])[0])
        case "rotate", (angle, *rest):
            cx, cy = rest or (0.0, 0.0)
            return Rotate("", angle=0.0 - angle, x_pivot=scale * cx + x0, y_pivot=y0 - scale * cy)
        case "scale", (sx, *rest):
            return Scale("", sx=sx, sy=(rest or [sx])[0], x_pivot=x0, y_pivot=y0)
        case "skewx", (angle,):
            return Shear("", sh_x=0.0 - math.tan(math.radians(angle)), y_ref=y0)
        case "skewy", (angle,):
            return Shear("", sh_y=0.0 - math.tan(math.radians(angle)), x_ref=x0)
    return Affine.of("", product(frame, _matrix(function), back))


def _matrix(function: Function) -> Matrix:
    """The matrix (3, 3), y downwards."""
    if function.name in ("matrix", "frame"):
        return np.vstack([function.matrix, (0.0, 0.0, 1.0)])
    flip = np.diag([1.0, -1.0, 1.0])
    link = _link(function, flip, flip)
    return product(flip, link.matrix, flip)


def framed(chain: Iterable[AnyLink], scale: float, dx: float, dy: float) -> tuple[AnyLink, ...]:
    """``chain`` for points that were scaled about the origin and then moved by (dx, dy), world."""
    frame = np.array([[scale, 0.0, dx], [0.0, scale, dy], [0.0, 0.0, 1.0]])
    back = np.array([[1 / scale, 0.0, -dx / scale], [0.0, 1 / scale, -dy / scale], [0.0, 0.0, 1.0]])

    def one(link: AnyLink) -> AnyLink:
        match link:
            case Translate():
                return replace(link, tx=scale * link.tx, ty=scale * link.ty)
            case AboutPivot():
                return replace(link, x_pivot=scale * link.x_pivot + dx, y_pivot=scale * link.y_pivot + dy)
            case Shear():
                return replace(link, x_ref=scale * link.x_ref + dx, y_ref=scale * link.y_ref + dy)
        own = Affine.of(link.id, product(frame, link.matrix, back))
        return replace(own, on=link.on)

    return tuple(map(one, chain))


def transform_text(chain: Sequence[AnyLink]) -> str:
    """The ``transform`` of a figure written with y downwards; empty where its chain does nothing."""
    return " ".join(_written(link) for link in reversed(chain) if link.on)


def _written(link: AnyLink) -> str:
    match link:
        case Translate():
            return _call("translate", link.tx, -link.ty)
        case Rotate():
            return _call("rotate", -link.angle, link.x_pivot, -link.y_pivot)
        case Scale(x_pivot=x, y_pivot=y):
            scale = _call("scale", link.sx, link.sy)
            return f"{_call('translate', x, -y)} {scale} {_call('translate', -x, y)}" if x or y else scale
    (m11, m12, m13), (m21, m22, m23) = link.matrix[:2].tolist()
    return _call("matrix", m11, -m21, -m12, m22, m13, -m23)


def _call(name: str, *numbers: float) -> str:
    return f"{name}({' '.join(map(number, numbers))})"


def number(value: float) -> str:
    """A number as short as it can be read back without loss."""
    text = repr(float(value) + 0.0)
    return text.removesuffix(".0")
