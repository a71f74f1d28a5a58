"""The texts that take part in a run: a function and all it calls, found by global names, callees first."""

import ast
import builtins
import inspect
import textwrap
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from types import FunctionType
from typing import Any

from workbench.engine import sinks
from workbench.engine.blocks import blocks
from workbench.engine.choices import CHOSEN, TAKEN
from workbench.engine.dialect import DialectError, refusals
from workbench.engine.empty_lists import empty_lists, records_in
from workbench.engine.parsing import parse_expression, parse_module
from workbench.engine.places import BESIDE, PLACE
from workbench.language import _

# Names that the rewritten text brings with it.
SINK, STOPPED, VISIT = "_sink", "_stopped", "_visit"
ENTER, READING, LEAVE = "_enter", "_reading", "_leave"
RESERVED = {
    *(SINK, STOPPED, VISIT, PLACE, BESIDE, CHOSEN, TAKEN, ENTER, READING, LEAVE),
    *("emit", "tick", "probe"),
}

# Names at the top of its module: decorators, the drivers behind it, and the sinks that those hand over.
DECORATORS = {"driver", "part", "reading"}
DRIVEN = {
    *("_collect", "_collect_many", "_run", "_painted", "_extent", "_paint", "_paint_many", "_paint_batch"),
    *("_hits", "_count", "_probe"),
    *(name for name, value in vars(sinks).items() if hasattr(value, "_fields")),
}


@dataclass(frozen=True, slots=True)
class Text:
    """One function: its source as it is shown, which begins at line ``first`` of its file, and its tree.

    ``callees`` and ``constants`` are what its global names stand for. ``considers`` are the expressions, by
    title of block, that are to be probed when such a block is left.
    """

    function: FunctionType
    source: str
    first: int
    tree: ast.FunctionDef
    generator: bool
    callees: dict[str, FunctionType]
    constants: dict[str, Any]
    considers: dict[str, tuple[ast.expr, ...]]

    @property
    def name(self) -> str:
        return self.function.__name__

    def error(self, sentence: str, line: int | None = None) -> DialectError:
        """What to raise about this text."""
        return DialectError(self.name, self.tree.lineno if line is None else line, sentence)


def gather(
    function: Callable[..., Any],
    considers: Mapping[str, tuple[str, ...]],
    painter: Callable[..., Any] | None = None,
) -> list[Text]:
    """The function and all it calls, callees first; before them its painter with all that calls.

    Raises:
        DialectError: one of them is outside the dialect, or two have one name.
    """
    found: dict[FunctionType, Text | None] = {}
    order: list[Text] = []

    def follow(callee: FunctionType) -> None:
        found[callee] = None
        text = _read(callee, considers)
        for inner in text.callees.values():
            if inner not in found:
                follow(inner)
        order.append(text)

    if not isinstance(function, FunctionType):
        raise DialectError(str(function), 0, _("only a function written in Python can be lowered"))
    if isinstance(painter, FunctionType):
        follow(painter)
    follow(function)
    names: dict[str, FunctionType] = {}
    taken = RESERVED | DECORATORS | DRIVEN
    for text in order:
        if names.setdefault(text.name, text.function) is not text.function:
            raise text.error(_("two functions of this name are called; give one of them another name"))
        if text.name in taken:
            raise text.error(_("this name is taken; give it another one"))
        for name in sorted(text.constants.keys() & taken):
            raise text.error(_("the name {name} is taken").format(name=name))
    for name in (argument.arg for argument in parameters(order[-1].tree)):
        if name.startswith("_") or name in DRIVEN:
            raise order[-1].error(_("the name {name} is taken").format(name=name))
    if not order[-1].generator:
        raise order[-1].error(_("nothing is emitted; add a yield"))
    return order


def _read(function: FunctionType, considers: Mapping[str, tuple[str, ...]]) -> Text:
    try:
        lines, first = inspect.getsourcelines(function)
    except (OSError, TypeError) as error:
        raise DialectError(function.__name__, 0, _("its text cannot be found")) from error
    source = "".join(lines)
    tree = parse(source, first)
    if not isinstance(tree, ast.FunctionDef):
        raise DialectError(function.__name__, first, _("only a function written with def can be lowered"))
    if function.__closure__:
        raise DialectError(
            function.__name__, first, _("it uses names of a function around it; pass them instead")
        )
    for refusal in refusals(tree):
        raise DialectError(function.__name__, refusal.line, refusal.sentence)
    probed = {
        block.title: tuple(parse_expression(expression) for expression in considers[block.title])
        for block in (blocks(function) if considers else ())
        if block.title in considers
    }
    callees, constants = _globals(function, tree, [item for found in probed.values() for item in found])
    for node in empty_lists(tree):
        try:
            constants |= records_in(node, function.__globals__)
        except TypeError as error:
            raise DialectError(function.__name__, node.lineno, str(error)) from error
    emits = inspect.isgeneratorfunction(function)
    return Text(function, source, first, tree, emits, callees, constants, probed)


def parse(source: str, first: int) -> ast.stmt:
    """The tree of a function's source, new each time, at the line numbers of its file."""
    behind = "\n" * (max(first, 1) - 1)
    return parse_module(behind + textwrap.dedent(source)).body[0]


def _globals(
    function: FunctionType, tree: ast.FunctionDef, further: list[ast.expr]
) -> tuple[dict[str, FunctionType], dict[str, Any]]:
    """What the global names of a text stand for: functions to lower, and everything else."""
    bound = bound_names(tree)
    for name in bound & RESERVED:
        raise DialectError(function.__name__, tree.lineno, _("the name {name} is taken").format(name=name))
    callees: dict[str, FunctionType] = {}
    constants: dict[str, Any] = {}
    for name, line in _loads([*tree.body, *further]):
        if name in bound:
            continue
        if name in function.__globals__:
            value = function.__globals__[name]
            if isinstance(value, FunctionType):
                callees[name] = value
            else:
                constants[name] = value
        elif not hasattr(builtins, name):
            raise DialectError(function.__name__, line, _("{name} is not known here").format(name=name))
    return callees, constants


def bound_names(tree: ast.FunctionDef) -> set[str]:
    """The names of a function's own: its parameters and all that it assigns."""
    bound = {argument.arg for argument in parameters(tree)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            bound.add(node.id)
        elif isinstance(node, ast.MatchAs | ast.MatchStar) and node.name:
            bound.add(node.name)
    return bound


def parameters(tree: ast.FunctionDef) -> list[ast.arg]:
    """The parameters of a function, in order."""
    return [*tree.args.posonlyargs, *tree.args.args, *tree.args.kwonlyargs]


def _loads(nodes: list[ast.AST]) -> Iterator[tuple[str, int]]:
    """Names that are read; annotations and defaults belong to the definition, not to what runs."""
    waiting = list(reversed(nodes))
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
            yield node.id, node.lineno
        children = list(ast.iter_child_nodes(node))
        if isinstance(node, ast.AnnAssign):
            children.remove(node.annotation)
        waiting.extend(reversed(children))


def arity(texts: list[Text]) -> int:
    """How many numbers are emitted at a time: the same at every yield."""
    found = 0
    for text in texts:
        for node in ast.walk(text.tree):
            if isinstance(node, ast.Yield) and node.value is not None:
                here = len(node.value.elts) if isinstance(node.value, ast.Tuple) else 1
                if found not in (0, here):
                    raise text.error(
                        _("{here} numbers are emitted here, {there} elsewhere").format(
                            here=here, there=found
                        ),
                        node.lineno,
                    )
                found = here
    return found


def recursive(texts: list[Text]) -> bool:
    """Whether one of them calls itself, directly or through others."""
    calls = {text.function: set(text.callees.values()) for text in texts}
    for function in calls:
        waiting, seen = list(calls[function]), set[FunctionType]()
        while waiting:
            callee = waiting.pop()
            if callee is function:
                return True
            if callee not in seen:
                seen.add(callee)
                waiting.extend(calls[callee])
    return False
