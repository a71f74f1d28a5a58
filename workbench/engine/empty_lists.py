"""Empty lists that say what they are lists of: ``stack: list[tuple[int, int]] = []``.

numba learns the type of a list from an item, so the lowered text makes the list from none of one that is
like what is named: ``[(0, 0) for _none in range(0)]``.
"""

import ast
import builtins
import typing
from collections.abc import Iterator, Mapping
from typing import Any

from workbench.engine.parsing import parse_expression
from workbench.language import _

_NUMBERS = {bool: "False", int: "0", float: "0.0"}


def empty_lists(tree: ast.AST) -> Iterator[ast.AnnAssign]:
    """The statements of a text that make an empty list of what they say."""
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign) and is_empty_list(node):
            yield node


def is_empty_list(node: ast.AnnAssign) -> bool:
    """Whether the statement makes an empty list."""
    return isinstance(node.value, ast.List) and not node.value.elts


def typed_empty_list(node: ast.AnnAssign, scope: Mapping[str, Any]) -> ast.expr:
    """What makes such a list; ``scope`` has the global names of the text. Raises TypeError as below."""
    return parse_expression(_example(_type_of(node.annotation, scope)))


def records_in(node: ast.AnnAssign, scope: Mapping[str, Any]) -> dict[str, type]:
    """The named tuples, by name, that such a statement needs.

    Raises TypeError where it does not say ``list`` of numbers, tuples, named tuples or lists of these.
    """
    kind = _type_of(node.annotation, scope)
    if typing.get_origin(kind) is not list:
        raise _unknown()
    _example(kind)
    return {record.__name__: record for record in _records(kind)}


def _type_of(node: ast.expr, scope: Mapping[str, Any]) -> Any:
    """The type that an annotation names; nothing of it is run."""
    match node:
        case ast.Name(id=name):
            return scope.get(name, getattr(builtins, name, None))
        case ast.Subscript(value=ast.Name(id="list"), slice=item):
            return list[_type_of(item, scope)]  # type: ignore[misc]
        case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=items)):
            return tuple[tuple(_type_of(item, scope) for item in items)]  # type: ignore[misc]
    raise _unknown()


def _example(kind: Any) -> str:
    """A value of this type, as it is written; of a list one without items."""
    if kind in _NUMBERS:
        return _NUMBERS[kind]
    items = typing.get_args(kind)
    if typing.get_origin(kind) is list:
        return f"[{_example(items[0])} for _none in range(0)]"
    if typing.get_origin(kind) is tuple and Ellipsis not in items:
        return f"({', '.join(map(_example, items))},)"
    if _is_record(kind):
        return f"{kind.__name__}({', '.join(map(_example, typing.get_type_hints(kind).values()))})"
    raise _unknown()


def _records(kind: Any) -> Iterator[type]:
    if _is_record(kind):
        yield kind
    for item in typing.get_type_hints(kind).values() if _is_record(kind) else typing.get_args(kind):
        yield from _records(item)


def _is_record(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, tuple) and hasattr(kind, "_fields")


def _unknown() -> TypeError:
    return TypeError(
        _("this empty list does not say what it is of; name numbers, tuples, named tuples or lists of these")
    )
