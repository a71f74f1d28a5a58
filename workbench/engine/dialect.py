"""The part of Python that an algorithm may use, so that its compiled reading does what the text says.

Refused is what numba cannot compile, and, worse, what compiles but gives other numbers. Only the text is
looked at, no types; the readings test finds the rest. For the catalogue and for functions a person writes.
"""

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from workbench.language import _


class DialectError(ValueError):
    """A text that cannot be lowered: ``function`` and ``line`` (in its file) tell where."""

    def __init__(self, function: str, line: int, sentence: str) -> None:
        super().__init__(
            _("{function}, line {line}: {sentence}").format(function=function, line=line, sentence=sentence)
        )
        self.function = function
        self.line = line
        self.sentence = sentence


class NotCompilable(ValueError):  # noqa: N818 - says what the text is, as DialectError does
    """The compiler refuses a text; the message has its words."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """One place that is outside the dialect: line of the text given (from 1) and what to write instead."""

    line: int
    sentence: str


_STATEMENTS: dict[type[ast.AST], str] = {
    ast.Try: _("try cannot be compiled; test the case before it happens"),
    ast.With: _("with cannot be compiled"),
    ast.ClassDef: _("a class inside a function cannot be compiled; put a NamedTuple at the top of the file"),
    ast.Lambda: _("lambda cannot be compiled; write a function of its own"),
    ast.Global: _("global cannot be compiled; pass the value as an argument"),
    ast.Nonlocal: _("nonlocal cannot be compiled; pass the value as an argument"),
    ast.Import: _("import belongs at the top of the file"),
    ast.ImportFrom: _("import belongs at the top of the file"),
    ast.GeneratorExp: _("a generator expression cannot be compiled; write a list, [... for ...]"),
    ast.DictComp: _("a dictionary cannot be compiled here; use a list"),
    ast.Dict: _("a dictionary cannot be compiled here; use a list"),
    ast.SetComp: _("a set has no order that both readings share; use a list"),
    ast.Set: _("a set has no order that both readings share; use a list"),
    ast.NamedExpr: _(":= cannot be compiled; assign on a line of its own"),
    ast.Starred: _("a starred name cannot be compiled; unpack every item by name"),
    ast.JoinedStr: _("an algorithm does not make text"),
    ast.AsyncFunctionDef: _("async cannot be compiled"),
    ast.Await: _("await cannot be compiled"),
}
_CALLS = {
    "reversed": _("reversed cannot be compiled; write range(n - 1, -1, -1)"),
    "any": _("any cannot be compiled; write a loop"),
    "all": _("all cannot be compiled; write a loop"),
    "sum": _("sum adds in another way in newer Pythons; write a loop"),
    "map": _("map cannot be compiled; write a list, [... for ...]"),
    "filter": _("filter cannot be compiled; write a list, [... for ... if ...]"),
    "print": _("print has no place here; yield what is to be drawn"),
    "set": _("a set has no order that both readings share; use a list"),
    "dict": _("a dictionary cannot be compiled here; use a list"),
}
_ROOTS = {"hypot", "dist"}
_NUMPY = {
    "dot", "matmul", "linalg", "random", "einsum", "vdot", "inner", "tensordot", "sum", "mean", "cross",
    "argpartition",
}  # fmt: skip


def refusals(function: ast.FunctionDef) -> list[Refusal]:
    """Everything in the text of ``function`` that the dialect refuses, in order of lines."""
    found = [*_nodes(function), *_empty_lists(function)]
    return sorted(set(found), key=lambda refusal: (refusal.line, refusal.sentence))


def _nodes(function: ast.FunctionDef) -> Iterator[Refusal]:
    if function.decorator_list:
        yield Refusal(function.lineno, _("a decorator changes what is run; take it off"))
    arguments = function.args
    if arguments.vararg or arguments.kwarg:
        yield Refusal(function.lineno, _("arguments behind a star cannot be compiled; name each of them"))
    nodes = list(_walk(function))
    lines = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    assigned = {id(node.value) for node in nodes if isinstance(node, ast.Assign)}
    for node in nodes:
        if isinstance(node, ast.expr_context | ast.Name | ast.operator):
            continue  # most of a text, and never refused
        line = getattr(node, "lineno", function.lineno)
        if type(node) in _STATEMENTS:
            yield Refusal(line, _STATEMENTS[type(node)])
        match node:
            case ast.FunctionDef():
                yield Refusal(
                    line, _("a function inside a function cannot be compiled; write it beside this one")
                )
            case ast.BinOp(op=ast.MatMult()):
                yield Refusal(line, _("@ is not part of the dialect; write the product as a loop"))
            case (
                ast.BinOp(left=base, op=ast.Pow(), right=power)
                | ast.AugAssign(target=base, op=ast.Pow(), value=power)
            ):
                if not (_is_float(power) or (_is_integer(base) and isinstance(node, ast.BinOp))):
                    yield Refusal(
                        line, _("** with a whole power rounds differently when compiled; write x * x")
                    )
            case ast.Delete():
                yield Refusal(line, _("del cannot be compiled; use pop, or while len(l) > kept: l.pop()"))
            case ast.Yield(value=value):
                if id(node) not in lines:
                    yield Refusal(line, _("yield must be a line of its own"))
                elif value is None:
                    yield Refusal(line, _("yield must emit something, such as yield x, y"))
            case ast.YieldFrom(value=value):
                if id(node) not in lines | assigned or not isinstance(value, ast.Call):
                    yield Refusal(
                        line, _("yield from must be a line of its own and call a generator function")
                    )
            case ast.Attribute(attr="_replace" | "_asdict" | "_make"):
                yield Refusal(line, _("a record cannot be changed in place; build it again"))
            case ast.Attribute(value=ast.Name(id="np" | "numpy"), attr=attribute) if attribute in _NUMPY:
                yield Refusal(
                    line, _("np.{name} is not part of the dialect; write a loop").format(name=attribute)
                )
            case ast.Call():
                yield from _call(node)


def _walk(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """Every node of the body, but for annotations: they say nothing to either reading."""
    waiting: list[ast.AST] = list(reversed(function.body))
    while waiting:
        node = waiting.pop()
        yield node
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Lambda):
            continue
        children = list(ast.iter_child_nodes(node))
        if isinstance(node, ast.AnnAssign):
            children = [child for child in children if child is not node.annotation]
        waiting.extend(reversed(children))


def _call(node: ast.Call) -> Iterator[Refusal]:
    keywords = {keyword.arg: keyword.value for keyword in node.keywords}
    if None in keywords:
        yield Refusal(node.lineno, _("arguments behind two stars cannot be compiled; name each of them"))
    match node.func:
        case ast.Name(id=name) if name in _CALLS:
            yield Refusal(node.lineno, _CALLS[name])
        case ast.Name(id=name) | ast.Attribute(attr=name) if name in _ROOTS:
            sentence = _("{name} differs in its last bit when compiled; write sqrt(x * x + y * y)")
            yield Refusal(node.lineno, sentence.format(name=name))
        case ast.Name(id="sorted") | ast.Attribute(attr="sort") if "key" in keywords:
            yield Refusal(
                node.lineno, _("sorting by key orders equals differently when compiled; sort whole tuples")
            )
        case ast.Attribute(attr="argsort"):
            kind = keywords.get("kind")
            if not (isinstance(kind, ast.Constant) and kind.value in ("mergesort", "stable")):
                yield Refusal(node.lineno, _('argsort needs kind="mergesort", else equals change places'))


def _is_float(node: ast.expr) -> bool:
    match node:
        case ast.Constant(value=float()) | ast.UnaryOp(operand=ast.Constant(value=float())):
            return True
        case ast.BinOp(op=ast.Div()):
            return True
    return False


def _is_integer(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) is int


def _empty_lists(function: ast.FunctionDef) -> Iterator[Refusal]:
    """An empty list takes its type from what is appended in the same function."""
    filled = {
        node.func.value.id
        for node in ast.walk(function)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in ("append", "insert", "extend")
        and isinstance(node.func.value, ast.Name)
    }
    for node in ast.walk(function):
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.List(elts=[])) if name not in filled:
                yield Refusal(
                    node.lineno,
                    _(
                        "nothing is appended to {name} in this function; say what it is a list of, as in "
                        "{name}: list[int] = []"
                    ).format(name=name),
                )
