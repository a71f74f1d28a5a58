"""Source text to syntax tree, one thread at a time.

CPython 3.11 counts the depth of the tree it builds in one place for all threads: two that parse at once may
be told "AST constructor recursion depth mismatch" (python/cpython#106905).
"""

import ast
import threading

_one_at_a_time = threading.Lock()


def parse_module(source: str) -> ast.Module:
    """The tree of a module's text. Raises SyntaxError."""
    with _one_at_a_time:
        return ast.parse(source)


def parse_expression(source: str) -> ast.expr:
    """The tree of one expression. Raises SyntaxError."""
    with _one_at_a_time:
        return ast.parse(source, mode="eval").body


def parse_statement(source: str) -> ast.stmt:
    """The tree of one statement. Raises SyntaxError."""
    (statement,) = parse_module(source).body
    return statement
