"""Which whole numbers are never negative, as their loops prove.

An array indexed by whole numbers asks at each access whether they count from the end. A loop variable of
``range(n)`` or ``range(max(..., 0), ...)`` that nothing else binds is never negative: as an unsigned number
it says so, and the loop runs two to three times as fast. Beside a floating number it becomes one: of 32 bits
where it stays below the side of an array, which nobody's memory has room for 2^31 of. Without AVX-512 that is
four at a time instead of one after the other. What it means stays the same.
"""

import ast
from collections.abc import Container

PLACE, BESIDE = "_place", "_beside"


_COUNTING = {"range", "max"}


def beside(count: int, other: float) -> int:
    """A number below the side of an array, where it meets another in a sum or a product."""
    return count


def counted_up(tree: ast.FunctionDef, own_names: Container[str]) -> frozenset[str]:
    """The names that loops of this function count up from 0 or more, and that nothing else binds.

    ``own_names`` are the global names that are not Python's.
    """
    bound: dict[str, int] = {}
    counted: dict[str, int] = {}
    for node in ast.walk(tree):
        match node:
            case ast.arg(arg=name) | ast.Name(id=name, ctx=ast.Store()):
                bound[name] = bound.get(name, 0) + 1
            case ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
                bound[name] = bound.get(name, 0) + 1
            case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=limits)):
                if _from_zero(limits):
                    counted[name] = counted.get(name, 0) + 1
    if any(name in bound or name in own_names for name in _COUNTING):
        return frozenset()
    return frozenset(name for name, times in counted.items() if bound[name] == times)


def _from_zero(limits: list[ast.expr]) -> bool:
    """Whether a range with these limits counts up by 1 from 0 or more."""
    return len(limits) == 1 or (len(limits) == 2 and _never_negative(limits[0]))


def _never_negative(node: ast.expr) -> bool:
    match node:
        case ast.Constant(value=int()):
            return True  # the sign of a number is an operation on it
        case ast.Call(func=ast.Name(id="max"), args=items):
            return any(_never_negative(item) for item in items)
    return False


def unsigned(subscript: ast.Subscript, counted: frozenset[str]) -> ast.Subscript:
    """``subscript`` with the names in ``counted`` unsigned, where it has several items, as only arrays do."""
    if isinstance(subscript.slice, ast.Tuple):
        subscript.slice.elts = [
            ast.Call(ast.Name(PLACE, ast.Load()), [item], [])
            if isinstance(item, ast.Name) and item.id in counted
            else item
            for item in subscript.slice.elts
        ]
    return subscript


def met(node: ast.BinOp, small: Container[str]) -> ast.BinOp:
    """``node`` with a name in ``small`` on its left beside the name or field on its right."""
    match node:
        case ast.BinOp(
            left=ast.Name(id=name), op=ast.Add() | ast.Sub() | ast.Mult(), right=ast.Name() | ast.Attribute()
        ) if name in small:
            node.left = ast.Call(ast.Name(BESIDE, ast.Load()), [node.left, node.right], [])
    return node
