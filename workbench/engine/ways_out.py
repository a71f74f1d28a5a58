"""Where a lowered text returns from a run that was stopped.

An exception would leave all functions at once. But numba lets go of nothing that a function holds when one
passes through it: each list and array of a run that was stopped, its arguments too, would stay for good. So a
text looks behind all that it gives to its sink, and returns.
"""

import ast
from collections.abc import Iterable, Mapping
from types import FunctionType

from workbench.engine.parsing import parse_statement
from workbench.engine.texts import SINK, STOPPED, Text

_SIMPLE = ast.Expr | ast.Assign | ast.AugAssign | ast.AnnAssign


def ways_out(texts: Iterable[Text], sinks: set[FunctionType]) -> dict[FunctionType, str]:
    """The statement by which each function with a sink leaves a run that was stopped.

    It returns nothing, or the constant that it returns first. A function that returns more than that has no
    way out, as nobody knows what it would have worked out; nor has what it calls, as it would go on with what
    that left undone.
    """
    texts = [text for text in texts if text.function in sinks]
    out = {text.function: way for text in texts if (way := _way_out(text))}
    while True:
        staying = {callee for text in texts if text.function not in out for callee in text.callees.values()}
        if not staying & out.keys():
            return out
        out = {function: way for function, way in out.items() if function not in staying}


def _way_out(text: Text) -> str:
    values = [each.value for each in ast.walk(text.tree) if isinstance(each, ast.Return) and each.value]
    if not values:
        return "return"
    first = values[0]
    return f"return {first.value!r}" if text.generator and isinstance(first, ast.Constant) else ""


class WayOut:
    """The way out of one function, of those ``ways_out`` gives."""

    def __init__(self, function: FunctionType, ways: Mapping[FunctionType, str]) -> None:
        self._way = ways.get(function, "")
        self._giving = {"emit", *(each.__name__ for each in ways)}

    def taken(self) -> list[ast.stmt]:
        """The lines that take it where the run was stopped."""
        return [parse_statement(f"if {STOPPED}({SINK}): {self._way}")] if self._way else []

    def behind(self, node: ast.AST) -> list[ast.stmt]:
        """The same behind what may have ended before its time, nothing behind anything else."""
        return self.taken() if any(map(self._gives, ast.walk(node))) else []

    def after(self, written: ast.AST | list[ast.stmt]) -> list[ast.stmt]:
        """What is ``written`` for one statement, with the way out where one is needed."""
        if isinstance(written, list):  # of statements that were looked at one by one
            return written
        assert isinstance(written, ast.stmt)
        if isinstance(written, ast.If) and (out := self.behind(written.test)):
            written.body, written.orelse = [*out, *written.body], [*out, *written.orelse]
        elif isinstance(written, ast.While) and (out := self.behind(written.test)):
            written.body = [*out, *written.body]
            return [written, *out]
        elif isinstance(written, _SIMPLE):
            return [written, *self.behind(written)]
        return [written]

    def _gives(self, node: ast.AST) -> bool:
        return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in self._giving
