"""Operations as they are written, taken from the syntax tree.

Both sides of ``and`` and of a choice count, and what a loop's header adds and compares unseen does not.
"""

import ast
from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

_ADDING = (ast.Add, ast.Sub)
_DIVIDING = (ast.Div, ast.FloorDiv, ast.Mod)


class Operations(NamedTuple):
    """How many are written in one place."""

    tests: int = 0
    additions: int = 0
    multiplications: int = 0
    divisions: int = 0
    stores: int = 0
    yields: int = 0

    def and_in(self, nodes: Iterable[ast.AST]) -> "Operations":
        """These, and those written in ``nodes``."""
        counted = Counter(self._asdict())
        for node in (inner for outer in nodes for inner in ast.walk(outer)):
            match node:
                case ast.Compare():
                    counted["tests"] += len(node.ops)
                case ast.BinOp(op=operator) | ast.AugAssign(op=operator):
                    if isinstance(operator, _ADDING):
                        counted["additions"] += 1
                    elif isinstance(operator, ast.Mult):
                        counted["multiplications"] += 1
                    elif isinstance(operator, _DIVIDING):
                        counted["divisions"] += 1
                case ast.Subscript(ctx=ast.Store()):
                    counted["stores"] += 1
                case ast.Yield():
                    counted["yields"] += 1
        return Operations(**counted)
