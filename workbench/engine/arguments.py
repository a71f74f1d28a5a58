"""Arguments of an algorithm in the one form that each of its compiled readings takes.

Whole numbers become int, the others float, arrays C-contiguous: points float64 (n, 2), lists of whole numbers
int64, pictures of integers or of float32 as they are, a depth buffer of integers int64. Another form would be
another signature, and so another compilation.
"""

import functools
import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry, Kind
from workbench.engine.containers import LARGEST_ARRAY
from workbench.engine.effects import text_of
from workbench.language import _

_MOST_EXPECTED = 2**24
_ANNOTATIONS: dict[Any, Kind] = {int: "int", float: "float", bool: "bool"}
LISTS = ("points", "floats", "ints", "matrix")
_LARGEST = 2**62


@functools.cache
def entry_of(function: Callable[..., Any]) -> Entry | None:
    """The catalogue's entry of this function; None for one that is not in it."""
    return next((entry for entry in catalogue.entries() if entry.function is function), None)


def considered(entry: Entry) -> tuple[tuple[str, str], ...]:
    """Each block of an entry that considers pixels, with the expression for one."""
    return tuple(dict.fromkeys((view.block, view.considers) for view in entry.views if view.considers))


@functools.cache
def kinds(function: Callable[..., Any]) -> tuple[tuple[str, Kind | None], ...]:
    """Name and kind of each parameter, from the entry or the annotations; None where neither tells."""
    entry = entry_of(function)
    if entry is not None:
        return tuple((parameter.name, parameter.kind) for parameter in entry.parameters)
    return tuple(
        (name, _ANNOTATIONS.get(parameter.annotation))
        for name, parameter in inspect.signature(function).parameters.items()
    )


def only_numbers(parameters: Iterable[tuple[str, str | None]]) -> bool:
    """Whether each parameter, (name, kind), is a number, so that many calls are the rows of one array."""
    return all(kind in ("int", "float", "bool", "colour") for _name, kind in parameters)


def table(function: Callable[..., Any], rows: Any) -> NDArray[Any]:
    """The arguments of many calls, one a row, (n, number of parameters): float64 where one is a float.

    Raises ValueError: the function takes more than numbers, or the rows are not as long as it asks.
    """
    parameters = kinds(function)
    name = function.__name__
    if not only_numbers(parameters):
        raise ValueError(_("{name} takes more than numbers; run it one call at a time").format(name=name))
    dtype = np.float64 if any(kind == "float" for _name, kind in parameters) else np.int64
    found = np.ascontiguousarray(rows, dtype=dtype)
    if found.ndim != 2 or found.shape[1] != len(parameters):
        raise ValueError(
            _("{name} takes {count} numbers in each row").format(name=name, count=len(parameters))
        )
    return found


def expected(function: Callable[..., Any], arguments: tuple[Any, ...]) -> int:
    """How many tuples are emitted for these arguments, where the entry knows; else a room that often does."""
    entry = entry_of(function)
    if entry is None or not entry.count:
        return 4096
    values = bind(function, arguments, False)
    names = (name for name, _kind in kinds(function))
    count = int(eval(entry.count, {}, dict(zip(names, values, strict=True))))
    return min(max(count, 1), _MOST_EXPECTED)


def bind(function: Callable[..., Any], arguments: tuple[Any, ...], copied: bool) -> tuple[Any, ...]:
    """``arguments`` with defaults filled in, each in its one form; arrays are new ones where ``copied``.

    Raises:
        TypeError: too many or too few arguments.
        ValueError: one cannot be brought into its form; the sentence names it.
    """
    parameters = kinds(function)
    if len(arguments) != len(parameters):
        bound = inspect.signature(function).bind(*arguments)
        bound.apply_defaults()
        arguments = tuple(bound.arguments[name] for name, _kind in parameters)
    pairs = zip(parameters, arguments, strict=True)
    return tuple(_formed(name, kind, value, copied) for (name, kind), value in pairs)


def _written(function: Callable[..., Any]) -> set[str]:
    """The names of the lists and arrays whose elements a text sets."""
    return {name for effects in text_of(function).effects.values() for name, _index in effects.stores}


def for_recording(function: Callable[..., Any], arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """``arguments`` with long lists of points and numbers that the text does not write as copies for reading.

    What cannot be written is recorded whole, however long it is.
    """
    kept = list(arguments)
    for number, (value, (name, kind)) in enumerate(zip(arguments, kinds(function), strict=False)):
        if not isinstance(value, np.ndarray) or value.size <= LARGEST_ARRAY:
            continue
        if kind in LISTS and name not in _written(function):
            kept[number] = value.copy()
            kept[number].setflags(write=False)
    return tuple(kept)


@dataclass(frozen=True, slots=True)
class Form:
    """The exact types of some arguments, for a quick look: forming them takes as long as a short run.

    ``arrays`` are place, items and number of axes of each array, ``integers`` the places of whole numbers.
    """

    types: tuple[type, ...]
    arrays: tuple[tuple[int, np.dtype[Any], int], ...]
    integers: tuple[int, ...]

    @staticmethod
    def of(values: tuple[Any, ...]) -> "Form":
        """That of arguments that ``bind`` has formed."""
        arrays = [(k, a.dtype, a.ndim) for k, a in enumerate(values) if isinstance(a, np.ndarray)]
        integers = [k for k, value in enumerate(values) if type(value) is int]
        return Form(tuple(map(type, values)), tuple(arrays), tuple(integers))

    def fits(self, values: tuple[Any, ...]) -> bool:
        """Whether ``values`` can be given, as they are, to what was compiled for this form."""
        if tuple(map(type, values)) != self.types:
            return False
        for k, items, axes in self.arrays:
            array = values[k]
            if array.dtype is not items or array.ndim != axes or not array.flags.carray:
                return False
        return not self.integers or all(-_LARGEST <= values[k] < _LARGEST for k in self.integers)


@dataclass(frozen=True, slots=True)
class Painter:
    """What has painted before, and the form of all it was given; ``most`` is the largest colour."""

    run: Callable[..., None]
    form: Form
    most: int

    def paints(self, image: Any, value: Any, values: tuple[Any, ...]) -> bool:
        """Paint, if the arguments have the form; whether they have."""
        if not self.form.fits((image, *values)):
            return False
        plain = type(value) is int and 0 <= value <= self.most
        self.run(image, value if plain else image.dtype.type(value), *values)
        return True


def _formed(name: str, kind: Kind | None, value: Any, copied: bool) -> Any:
    if kind is None and value is None:
        return None  # the text goes without, and is compiled so
    try:
        if kind is None:
            kind = _kind_of(value)
        match kind:
            case "int" | "colour":
                return _whole(value)
            case "float":
                return float(value)
            case "bool":
                return bool(value)
            case "points" | "floats":
                return _array(value, np.float64, copied)
            case "depth":
                return _array(value, np.int64 if _are_whole(value) else np.float64, copied)
            case "matrix":
                return _matrix(value, copied)
            case "ints":
                return _array(value, np.int64, copied)
            case "image":
                return _picture(value, copied)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(
            _("{name} cannot be {value!r}: {error}").format(name=name, value=value, error=error)
        ) from error


def _kind_of(value: Any) -> Kind:
    if isinstance(value, bool | np.bool_):
        return "bool"
    if isinstance(value, int | np.integer):
        return "int"
    if isinstance(value, float | np.floating):
        return "float"
    array = np.asarray(value)
    if array.dtype == np.float32 and array.ndim == 2:
        return "image"  # as it is: it would be twice as large
    if array.dtype.kind == "f":
        return "points"
    return "image" if array.ndim == 2 and isinstance(value, np.ndarray) else "ints"


def _whole(value: Any) -> int:
    whole = int(value)
    if whole != value:
        raise ValueError(_("it must be a whole number"))
    if not -_LARGEST <= whole < _LARGEST:
        raise ValueError(_("it is too large"))
    return whole


def _array(value: Any, dtype: type[np.generic], copied: bool) -> NDArray[Any]:
    return _own(np.ascontiguousarray(value, dtype=dtype), value, copied)


def _are_whole(value: Any) -> bool:
    """Whether a depth buffer holds whole numbers: writing a depth into it then cuts off what lies between."""
    return isinstance(value, np.ndarray) and value.dtype.kind in "iu"


def _matrix(value: Any, copied: bool) -> NDArray[Any]:
    array = _array(value, np.float64, copied)
    if array.ndim != 2:
        raise ValueError(_("a matrix is an array of numbers with rows and columns"))
    return array


def _picture(value: Any, copied: bool) -> NDArray[Any]:
    array = np.ascontiguousarray(value)
    if array.ndim != 2 or array.dtype.kind not in "iuf":
        raise ValueError(_("a picture is an array of numbers with rows and columns"))
    return _own(array, value, copied)


def _own(array: NDArray[Any], value: Any, copied: bool) -> NDArray[Any]:
    """``array``, or a copy where the caller's must stay as it is or must not be written."""
    shared = isinstance(value, np.ndarray) and np.may_share_memory(array, value)
    return array.copy() if (copied and shared) or not array.flags.writeable else array


def among(image: NDArray[Any], values: tuple[Any, ...]) -> bool:
    """Whether a picture that is to be painted is also given to the text, which then paints it itself."""
    return any(isinstance(item, np.ndarray) and np.may_share_memory(item, image) for item in values)
