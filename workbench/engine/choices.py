"""Branches that only write items of arrays, as choices: where the test fails, what is there is written again.

Vector code writes such items through a mask, and processors without AVX-512 take three times as long for that
as for reading, choosing and writing all. What is written stays the same.
"""

import ast
from typing import Any

CHOSEN, TAKEN = "_chosen", "_taken"


def chosen(taken: bool, new: Any, old: Any) -> Any:
    """What an item becomes that is ``old`` so far: ``new`` where the branch is taken."""
    return new if taken else old


def bounded(tree: ast.FunctionDef, counted: frozenset[str]) -> dict[str, tuple[str, int]]:
    """The names that loops count to below the side of an array: its name, and the number of the axis.

    ``counted`` are the names that loops alone bind, from 0 or more.
    """
    sides: dict[str, tuple[str, int]] = {}
    bound: dict[str, int] = {}
    limits: dict[str, list[str]] = {}
    for node in ast.walk(tree):
        match node:
            case ast.arg(arg=name) | ast.Name(id=name, ctx=ast.Store()):
                bound[name] = bound.get(name, 0) + 1
            case ast.Assign(
                targets=[ast.Tuple(elts=names)], value=ast.Attribute(value=ast.Name(id=array), attr="shape")
            ):
                for axis, each in enumerate(names):
                    if isinstance(each, ast.Name):
                        sides[each.id] = array, axis
            case ast.For(target=ast.Name(id=name), iter=ast.Call(args=[*_start, limit])):
                limits.setdefault(name, []).append(_upper(limit))
    if "min" in bound:
        return {}
    once = {side: place for side, place in sides.items() if bound[side] == bound[place[0]] == 1}
    found = {name: {once.get(limit) for limit in limits[name]} for name in counted}
    return {name: place for name, (place, *others) in found.items() if place is not None and not others}


def _upper(limit: ast.expr) -> str:
    """The name of what ``limit`` never exceeds."""
    match limit:
        case ast.Name(id=name) | ast.Call(func=ast.Name(id="min"), args=[_, ast.Name(id=name)]):
            return name
    return ""


def choices(node: ast.If, within: dict[str, tuple[str, int]]) -> list[ast.stmt] | None:
    """What stands for a branch that begins by writing items, or None where it must stay as it is.

    An item may be written where the test fails only if it is there: when the test reads it, or when its
    subscripts stay ``within`` the sides of its array.
    """
    if node.orelse or not isinstance(node.test, ast.Compare) or len(node.test.ops) > 1:
        return None
    read = {ast.dump(each) for each in ast.walk(node.test) if isinstance(each, ast.Subscript)}
    written: list[ast.stmt] = [ast.Assign([ast.Name(TAKEN, ast.Store())], node.test)]
    for statement in node.body:
        match statement:
            case ast.Assign(
                targets=[ast.Subscript(value=ast.Name(id=array), slice=ast.Tuple(elts=items)) as place],
                value=ast.Name() | ast.Constant() as value,
            ):
                there = ast.Subscript(place.value, place.slice, ast.Load())
                axes = [within.get(item.id) if isinstance(item, ast.Name) else None for item in items]
                if ast.dump(there) not in read and axes != [(array, axis) for axis in range(len(items))]:
                    break
                names: list[ast.expr] = [ast.Name(TAKEN, ast.Load()), value, there]
                written.append(ast.Assign([place], ast.Call(ast.Name(CHOSEN, ast.Load()), names, [])))
            case _:
                break
    rest = node.body[len(written) - 1 :]
    if len(written) == 1:
        return None
    return [*written, ast.If(ast.Name(TAKEN, ast.Load()), rest, [])] if rest else written
