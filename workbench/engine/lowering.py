"""The only rewriter: from the text that is shown to one that emits into a sink.

``yield a, b`` becomes ``emit(_sink, a, b)`` and ``yield from f(x)`` becomes ``f(_sink, x)``; nothing else of what
runs is touched. Everything that the function calls is found by its global name and written, callees first, into
one text that stands alone: constants as literals, records imported. The same rewriter adds the ticks of the
counting text and the probes of the probing text.
"""

import ast
import builtins
import copy
import inspect
import math
import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from workbench.engine.dialect import DialectError, refusals
from workbench.language import _

SINK = "_sink"
_RESERVED = {SINK, "emit", "tick", "probe"}


@dataclass(frozen=True, slots=True)
class Lowered:
    """One function and all it calls, as a text that stands alone.

    ``text`` is the module; ``name`` the function to call in it, with the sink as first argument. ``names`` are all
    functions in it, callees first, ``sources`` the text of each as it is shown. ``arity`` is how many numbers are
    emitted at a time. ``recursive`` tells whether one of them calls itself, directly or not.
    """

    name: str
    text: str
    names: tuple[str, ...]
    sources: tuple[str, ...]
    arity: int
    recursive: bool


@dataclass(slots=True)
class _Text:
    """One function on its way: its tree at the line numbers of its file."""

    function: FunctionType
    source: str
    tree: ast.FunctionDef
    generator: bool
    callees: dict[str, FunctionType]
    constants: dict[str, Any]

    @property
    def name(self) -> str:
        return self.function.__name__


@lru_cache(maxsize=512)
def lower(function: Callable[..., Any]) -> Lowered:
    """Lower a generator function.

    Raises:
        DialectError: the text, or one that it calls, is outside the dialect.
    """
    texts = _gather(function)
    generators = {text.function: text.generator for text in texts}
    functions = [_Rewriter(text, generators).rewritten() for text in texts]
    return Lowered(
        name=function.__name__,
        text=_module(texts, functions),
        names=tuple(text.name for text in texts),
        sources=tuple(text.source for text in texts),
        arity=_arity(texts),
        recursive=_recursive(texts),
    )


def _gather(function: Callable[..., Any]) -> list[_Text]:
    """The function and all it calls, callees first."""
    found: dict[FunctionType, _Text] = {}
    order: list[_Text] = []

    def follow(callee: FunctionType) -> None:
        text = found[callee] = _read(callee)
        for inner in text.callees.values():
            if inner not in found:
                follow(inner)
        order.append(text)

    if not isinstance(function, FunctionType):
        raise DialectError(str(function), 0, _("only a function written in Python can be lowered"))
    follow(function)
    names: dict[str, FunctionType] = {}
    for text in order:
        if names.setdefault(text.name, text.function) is not text.function:
            line = text.function.__code__.co_firstlineno
            raise DialectError(
                text.name, line, _("two functions of this name are called; give one of them another name")
            )
        if text.name in _RESERVED:
            raise DialectError(text.name, text.tree.lineno, _("this name is taken; give it another one"))
    if not found[function].generator:
        raise DialectError(
            function.__name__, found[function].tree.lineno, _("nothing is emitted; add a yield")
        )
    return order


def _read(function: FunctionType) -> _Text:
    try:
        lines, first = inspect.getsourcelines(function)
    except (OSError, TypeError) as error:
        raise DialectError(function.__name__, 0, _("its text cannot be found")) from error
    source = "".join(lines)
    module = ast.parse(textwrap.dedent(source))
    tree = module.body[0]
    if not isinstance(tree, ast.FunctionDef):
        raise DialectError(function.__name__, first, _("only a function written with def can be lowered"))
    ast.increment_lineno(module, first - 1)
    if function.__closure__:
        raise DialectError(
            function.__name__, first, _("it uses names of a function around it; pass them instead")
        )
    for refusal in refusals(tree):
        raise DialectError(function.__name__, refusal.line, refusal.sentence)
    callees, constants = _globals(function, tree)
    generator = any(isinstance(node, ast.Yield | ast.YieldFrom) for node in ast.walk(tree))
    return _Text(function, source, tree, generator, callees, constants)


def _globals(function: FunctionType, tree: ast.FunctionDef) -> tuple[dict[str, FunctionType], dict[str, Any]]:
    """What the global names of a text stand for: functions to lower, and everything else."""
    bound = {argument.arg for argument in _parameters(tree)}
    bound |= {
        node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    }
    bound |= {
        node.name for node in ast.walk(tree) if isinstance(node, ast.MatchAs | ast.MatchStar) and node.name
    }
    callees: dict[str, FunctionType] = {}
    constants: dict[str, Any] = {}
    for name, line in _loads(tree):
        if name in bound:
            if name in _RESERVED:
                raise DialectError(function.__name__, line, _("the name {name} is taken").format(name=name))
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


def _parameters(tree: ast.FunctionDef) -> list[ast.arg]:
    return [*tree.args.posonlyargs, *tree.args.args, *tree.args.kwonlyargs]


def _loads(tree: ast.FunctionDef) -> Iterator[tuple[str, int]]:
    """Names read by the body; annotations and defaults belong to the definition, not to what runs."""
    for statement in tree.body:
        annotations = {
            id(inner)
            for node in ast.walk(statement)
            if isinstance(node, ast.AnnAssign)
            for inner in ast.walk(node.annotation)
        }
        for node in ast.walk(statement):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and id(node) not in annotations:
                yield node.id, node.lineno


class _Rewriter(ast.NodeTransformer):
    """Rewrites one function; ``generators`` tells of every function in the text whether it emits."""

    def __init__(self, text: _Text, generators: dict[FunctionType, bool]) -> None:
        self.text = text
        self.generators = generators

    def rewritten(self) -> ast.FunctionDef:
        tree = copy.deepcopy(self.text.tree)
        tree.returns = None
        for argument in _parameters(tree):
            argument.annotation = None
        tree.args.defaults = []
        tree.args.kw_defaults = [None for _argument in tree.args.kwonlyargs]
        if self.text.generator:
            tree.args.args.insert(0, ast.arg(SINK))
        body = tree.body
        if ast.get_docstring(tree) is not None:
            body = body[1:]
        tree.body = [self.visit(statement) for statement in body] or [ast.Pass()]
        return ast.fix_missing_locations(tree)

    def visit_Expr(self, node: ast.Expr) -> ast.stmt:
        if isinstance(node.value, ast.Yield):
            value = node.value.value
            assert value is not None
            items = value.elts if isinstance(value, ast.Tuple) else [value]
            emitted = [self.visit(item) for item in items]
            call = ast.Call(ast.Name("emit", ast.Load()), [ast.Name(SINK, ast.Load()), *emitted], [])
            return ast.copy_location(ast.Expr(call), node)
        self.generic_visit(node)
        return node

    def visit_YieldFrom(self, node: ast.YieldFrom) -> ast.expr:
        call = node.value
        assert isinstance(call, ast.Call)
        callee = self._callee(call)
        if callee is None or not self.generators[callee]:
            raise self._error(node, _("yield from must call a generator function by its name"))
        arguments = [self.visit(argument) for argument in call.args]
        keywords = [self.visit(keyword) for keyword in call.keywords]
        return ast.copy_location(
            ast.Call(self.visit(call.func), [ast.Name(SINK, ast.Load()), *arguments], keywords), node
        )

    def visit_Call(self, node: ast.Call) -> ast.expr:
        callee = self._callee(node)
        if callee is not None and self.generators[callee]:
            raise self._error(node, _("{name} emits; take it with yield from").format(name=callee.__name__))
        if isinstance(node.func, ast.Attribute):
            self._check_attribute(node.func)
        self.generic_visit(node)
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.stmt:
        if node.value is None:
            return ast.copy_location(ast.Pass(), node)
        return ast.copy_location(ast.Assign([self.visit(node.target)], self.visit(node.value)), node)

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id in self.text.callees:
            return ast.copy_location(ast.Name(self.text.callees[node.id].__name__, node.ctx), node)
        return node

    def _callee(self, node: ast.Call) -> FunctionType | None:
        return self.text.callees.get(node.func.id) if isinstance(node.func, ast.Name) else None

    def _check_attribute(self, node: ast.Attribute) -> None:
        """A function in a module is only found under math and np."""
        if isinstance(node.value, ast.Name):
            value = self.text.constants.get(node.value.id)
            if isinstance(value, ModuleType) and value not in (math, np):
                raise self._error(node, _("import {name} by its own name").format(name=node.attr))

    def _error(self, node: ast.expr, sentence: str) -> DialectError:
        return DialectError(self.text.name, node.lineno, sentence)


def _module(texts: list[_Text], functions: list[ast.FunctionDef]) -> str:
    """The whole module: imports, constants, functions, callees first."""
    names: dict[str, str] = {}
    for text in texts:
        for name, value in text.constants.items():
            line = _binding(text, name, value)
            if names.setdefault(name, line) != line:
                raise DialectError(
                    text.name,
                    text.tree.lineno,
                    _("{name} means two things in the functions called; rename one").format(name=name),
                )
    imports = sorted(line for line in names.values() if line.startswith(("import ", "from ")))
    literals = sorted(set(names.values()) - set(imports))
    head = "\n".join(["from workbench.engine.sinks import emit", *imports, *literals])
    return "\n\n".join([head, *(READING + ast.unparse(function) for function in functions)]) + "\n"


READING = "@reading\n"


def _binding(text: _Text, name: str, value: Any) -> str:
    """The line that gives ``name`` its value in the new module."""

    def refused(sentence: str) -> DialectError:
        return DialectError(text.name, text.tree.lineno, sentence.format(name=name))

    if isinstance(value, ModuleType):
        return f"import {value.__name__} as {name}"
    if isinstance(value, np.ndarray):
        return f"{name} = np.array({value.tolist()!r}, dtype=np.{value.dtype})"
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, type) and issubclass(value, tuple) and hasattr(value, "_fields"):
        if value.__module__ == "__main__" or "<" in value.__qualname__:
            raise refused(_("the record {name} must stand at the head of a file"))
        return f"from {value.__module__} import {value.__name__} as {name}  # {' '.join(value._fields)}"
    if inspect.isbuiltin(value) and getattr(value, "__module__", "") == "math":
        return f"from math import {value.__name__} as {name}"
    if isinstance(value, float) and not math.isfinite(value):
        return f"{name} = float({str(value)!r})"
    if value is None or isinstance(value, bool | int | float | str) or _plain(value):
        return f"{name} = {value!r}"
    raise refused(_("{name} is neither a number, a tuple, an array nor a record"))


def _plain(value: Any) -> bool:
    return type(value) is tuple and all(
        item is None or isinstance(item, bool | int | float | str) or _plain(item) for item in value
    )


def _arity(texts: list[_Text]) -> int:
    """How many numbers are emitted at a time: the same at every yield."""
    arity = 0
    for text in texts:
        for node in ast.walk(text.tree):
            if isinstance(node, ast.Yield) and node.value is not None:
                here = len(node.value.elts) if isinstance(node.value, ast.Tuple) else 1
                if arity not in (0, here):
                    raise DialectError(
                        text.name,
                        node.lineno,
                        _("{here} numbers are emitted here, {there} elsewhere").format(
                            here=here, there=arity
                        ),
                    )
                arity = here
    return arity


def _recursive(texts: list[_Text]) -> bool:
    calls = {text.function: set(text.callees.values()) for text in texts}
    for function in calls:
        waiting, seen = list(calls[function]), set()
        while waiting:
            callee = waiting.pop()
            if callee is function:
                return True
            if callee not in seen:
                seen.add(callee)
                waiting.extend(calls[callee])
    return False
