"""Helpers that read an item of an array and do nothing else, as expressions of the text that calls them.

A compiled call counts who holds the array, before and after: for one item that takes twice as long as all the
rest of a fill's step. What is read stays the same.
"""

import ast
import copy

_OWN_NAMES = (ast.ListComp, ast.GeneratorExp, ast.SetComp, ast.DictComp, ast.Lambda, ast.NamedExpr)


def item_read(call: ast.Call, helper: ast.FunctionDef, bound: set[str]) -> ast.expr | None:
    """What stands for a call of ``helper`` with plain names, or None where it must stay a call.

    ``bound`` are the names that the calling text binds: what else the helper names means the same there.
    """
    expression = _returned(helper)
    names = [argument.id for argument in call.args if isinstance(argument, ast.Name)]
    parameters = [argument.arg for argument in helper.args.args]
    if expression is None or call.keywords or not len(names) == len(call.args) == len(parameters):
        return None
    given = dict(zip(parameters, names, strict=True))
    read = [node for node in ast.walk(expression) if isinstance(node, ast.Name)]
    if any(node.id not in given and node.id in bound for node in read) or not _reads_item(expression, given):
        return None
    written = copy.deepcopy(expression)
    for node in ast.walk(written):
        if isinstance(node, ast.Name):
            node.id = given.get(node.id, node.id)
    return written


def _returned(helper: ast.FunctionDef) -> ast.expr | None:
    """What a function gives back as one expression, where it is nothing else, its docstring aside."""
    body = helper.body[1:] if ast.get_docstring(helper) is not None else helper.body
    match body:
        case [ast.Return(value=ast.expr() as value)]:
            pass
        case [
            ast.If(test=test, body=[ast.Return(value=ast.expr() as one)], orelse=[]),
            ast.Return(value=ast.expr() as other),
        ]:
            value = ast.IfExp(test, one, other)
        case _:
            return None
    return None if any(isinstance(node, _OWN_NAMES) for node in ast.walk(value)) else value


def _reads_item(expression: ast.expr, given: dict[str, str]) -> bool:
    return any(
        isinstance(node, ast.Subscript)
        and isinstance(node.slice, ast.Tuple)
        and isinstance(node.value, ast.Name)
        and node.value.id in given
        for node in ast.walk(expression)
    )
