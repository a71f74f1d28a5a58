"""What a person types into a number field: a number, or arithmetic such as 30/2 or 4 + 2*(3 - 1)."""

import ast
import math
import operator
import re
from collections.abc import Callable

from workbench.engine.parsing import parse_expression
from workbench.language import _

_BINARY: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
LONGEST = 100
_COMMA = re.compile(r"-?\d*,\d+")


def evaluate(text: str) -> float:
    """The finite value of ``text``; raises ValueError with one sentence that says what to type instead."""
    plain = text.strip().replace("−", "-").replace("×", "*").replace("·", "*").replace("÷", "/")
    if not plain:
        raise ValueError(_("The field is empty; type a number or arithmetic such as 30/2."))
    if len(plain) > LONGEST:
        raise ValueError(_("This is too long; type at most {count} characters.").format(count=LONGEST))
    if _COMMA.fullmatch(plain):
        pointed = plain.replace(",", ".")
        raise ValueError(_("{text!r} has a comma; write {pointed}.").format(text=text, pointed=pointed))
    try:
        value = _value(parse_expression(plain))
    except ZeroDivisionError:
        raise ValueError(_("This divides by zero; type another divisor.")) from None
    except (SyntaxError, TypeError, RecursionError, MemoryError):
        raise ValueError(
            _("{text!r} is not a number; type one, or arithmetic such as 30/2.").format(text=text)
        ) from None
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise ValueError(_("This is too large; type a smaller number."))
    return value + 0.0  # there is no other 0 for a person


def _value(node: ast.expr) -> float:
    if (
        isinstance(node, ast.Constant)
        and isinstance(node.value, (int, float))
        and not isinstance(node.value, bool)
    ):
        return float(node.value)
    if isinstance(node, ast.Name) and node.id in ("pi", "π"):
        return math.pi
    if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        return _BINARY[type(node.op)](_value(node.left), _value(node.right))
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        value = _value(node.operand)
        return -value if isinstance(node.op, ast.USub) else value
    raise TypeError(type(node).__name__)
