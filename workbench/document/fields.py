"""What the structs of a document declare of their fields, read from the annotations once for each type."""

from collections.abc import Callable
from functools import cache
from math import inf
from types import UnionType
from typing import Annotated, Any, Literal, NamedTuple, TypeVar, Union, get_args, get_origin, get_type_hints

import msgspec

from workbench.document.storage.blobs import Blob

Result = TypeVar("Result")


class Number(msgspec.Struct, frozen=True, kw_only=True):
    """What a numeric attribute may be: ``low`` to ``high``, both of them too, an int where it is ``whole``.

    ``label`` is what a sentence calls it, ``symbol`` how the course writes it; ``unit`` is "world", "px" or
    empty. ``keyed`` tells whether a key frame may hang on it. A number that is a place in a list of its sheet
    names the list in ``indexes``, which bounds it.
    """

    label: str
    keyed: bool
    low: float = -inf
    high: float = inf
    whole: bool = False
    unit: str = ""
    symbol: str = ""
    indexes: str = ""

    @property
    def type(self) -> type:
        """What its values are."""
        return int if self.whole else float


class Choice(msgspec.Struct, frozen=True):
    """A text that is one of ``names``."""

    names: tuple[str, ...]

    @property
    def type(self) -> type:
        """What its values are."""
        return str


class Field(NamedTuple):
    """``kind``, of the value or of each of ``many``: Number, Choice, bool, str, Blob or msgspec.Struct."""

    kind: Any
    many: bool = False


def once_per_type(make: Callable[[type], Result]) -> Callable[[type], Result]:
    """``make``, which is called only once for each type."""
    return cache(make)


@once_per_type
def fields_of(struct: type) -> dict[str, Field]:
    """The fields of a struct by name, in their order. Raises: TypeError where a number is not declared."""
    hints = get_type_hints(struct, include_extras=True)
    return {name: _field(struct, name, hints[name]) for name in struct.__struct_fields__}  # type: ignore[attr-defined]


def _field(struct: type, name: str, hint: Any) -> Field:
    if get_origin(hint) is tuple:
        return Field(_field(struct, name, get_args(hint)[0]).kind, many=True)
    if get_origin(hint) is Annotated:
        declared = hint.__metadata__[0]
        if isinstance(declared, Number | Choice) and declared.type is hint.__origin__:
            return Field(declared)
    if get_origin(hint) in (Union, UnionType):
        return _field(struct, name, get_args(hint)[0])
    if get_origin(hint) is Literal:
        return Field(Choice(get_args(hint)))
    if hint in (bool, str, Blob):
        return Field(hint)
    if isinstance(hint, type) and issubclass(hint, msgspec.Struct):
        return Field(msgspec.Struct)
    raise TypeError(f"{struct.__name__}.{name} does not say what it may be.")


@once_per_type
def numbers_of(struct: type) -> dict[str, Number]:
    """The numbers of a struct by name; of a list of numbers what each of them may be."""
    return {name: field.kind for name, field in fields_of(struct).items() if isinstance(field.kind, Number)}


@once_per_type
def parts_of(struct: type) -> tuple[str, ...]:
    """The names of the lists of a struct whose entries have ids."""
    return tuple(name for name, field in fields_of(struct).items() if field == (msgspec.Struct, True))


def structs_in(struct: type) -> dict[type, None]:
    """``struct`` and every struct that its fields may hold, however deep, each once."""
    kinds: dict[type, None] = {}
    waiting: list[Any] = [struct]
    while waiting:
        hint = waiting.pop()
        if not isinstance(hint, type) or get_origin(hint) is not None:
            waiting += get_args(hint)
        elif issubclass(hint, msgspec.Struct) and hint not in kinds:
            kinds[hint] = None
            waiting += get_type_hints(hint).values()
    return kinds
