"""What each line of a text can change, read from its syntax, so that a recorder looks nowhere else."""

import ast
import builtins
import inspect
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import CodeType, FunctionType
from typing import Any, NamedTuple

from workbench.engine.parsing import parse_module

_PURE = frozenset(vars(builtins)) - {"delattr", "eval", "exec", "next", "setattr"}
_PURE_MODULES = frozenset(("math", "np", "numpy"))
_NESTED = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.Lambda)
_HEADERS = (ast.For, ast.While, ast.If, ast.With, ast.Match, ast.Try)


class Effects(NamedTuple):
    """What a line can change.

    ``stores`` are lists and arrays in which it sets one element, with the compiled index: nothing else of
    them needs a look.
    ``binds`` are names it can bind. ``tails`` are lists that it only appends to and pops from, with the
    number of pops. ``touches`` are names through which it can change a container in some other way.
    """

    binds: tuple[str, ...]
    tails: tuple[tuple[str, int], ...]
    touches: tuple[str, ...]
    stores: tuple[tuple[str, CodeType], ...] = ()


@dataclass(frozen=True, slots=True)
class Text:
    """One function as the recorder knows it: its names in order of appearance, the effects of its lines.

    ``varying`` are the names that are bound inside a loop.
    """

    function: Callable[..., Any]
    code: CodeType
    name: str
    names: tuple[str, ...]
    parameters: tuple[str, ...]
    varying: frozenset[str]
    effects: Mapping[int, Effects]
    otherwise: Effects | None


class _Found:
    def __init__(self, harmless: Callable[[str], bool]) -> None:
        self._harmless = harmless
        self.binds: dict[str, None] = {}
        self.tails: dict[str, int] = {}
        self.touches: dict[str, None] = {}
        self.stores: list[tuple[str, ast.expr]] = []

    def effects(self) -> Effects | None:
        if not (self.binds or self.tails or self.touches or self.stores):
            return None
        stores = []
        for name, index in self.stores:
            moving = {part.id for part in ast.walk(index) if isinstance(part, ast.Name)} & self.binds.keys()
            if moving or name in self.binds or name in self.tails:
                self.touches[name] = None
            else:
                stores.append((name, compile(ast.Expression(index), "<index>", "eval")))
        tails = tuple((name, pops) for name, pops in self.tails.items() if name not in self.touches)
        kept = tuple((name, index) for name, index in stores if name not in self.touches)
        return Effects(tuple(self.binds), tails, tuple(self.touches), kept)

    def look(self, node: ast.AST, nested: bool) -> None:
        """Collect what evaluating ``node`` can change; names of a comprehension are its own."""
        if isinstance(node, ast.Name):
            if isinstance(node.ctx, ast.Store | ast.Del) and not nested:
                self.binds[node.id] = None
        elif isinstance(node, ast.Subscript | ast.Attribute):
            if isinstance(node.ctx, ast.Store) and isinstance(node, ast.Subscript) and _is_element(node):
                self.stores.append((node.value.id, node.slice))  # type: ignore[attr-defined]
            elif isinstance(node.ctx, ast.Store | ast.Del):
                self._touch(node)
        elif isinstance(node, ast.MatchAs | ast.MatchStar):
            if node.name is not None:
                self.binds[node.name] = None
        elif isinstance(node, ast.Call):
            self._call(node, nested)
        elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
            self._touch(node.target)
        deeper = nested or isinstance(node, _NESTED)
        for child in ast.iter_child_nodes(node):
            self.look(child, deeper)

    def _call(self, node: ast.Call, nested: bool) -> None:
        called = node.func
        if isinstance(called, ast.Name):
            if not self._harmless(called.id):
                for argument in (*node.args, *(keyword.value for keyword in node.keywords)):
                    self._touch(argument)
        elif isinstance(called, ast.Attribute):
            owner = called.value
            if isinstance(owner, ast.Name) and owner.id in _PURE_MODULES:
                for keyword in node.keywords:
                    self._touch(keyword.value)
                return
            append = called.attr == "append" and len(node.args) == 1
            pop = called.attr == "pop" and not node.args
            if isinstance(owner, ast.Name) and (append or pop) and not nested:
                self.tails[owner.id] = self.tails.get(owner.id, 0) + pop
            else:
                self._touch(node)

    def _touch(self, node: ast.AST) -> None:
        for part in ast.walk(node):
            if isinstance(part, ast.Name):
                self.touches[part.id] = None


_COUNTED = (ast.Name, ast.Constant, ast.BinOp, ast.UnaryOp, ast.Tuple, ast.operator, ast.unaryop, ast.Load)


def _is_element(node: ast.Subscript) -> bool:
    """Whether the subscript is of a plain name, by an index that is a sum of names and numbers."""
    return isinstance(node.value, ast.Name) and all(
        isinstance(part, _COUNTED) for part in ast.walk(node.slice)
    )


def _headers(node: ast.stmt) -> Iterator[ast.AST]:
    """The parts of a compound statement that its own lines evaluate."""
    if isinstance(node, ast.For):
        yield from (node.target, node.iter)
    elif isinstance(node, ast.While | ast.If):
        yield node.test
    elif isinstance(node, ast.With):
        yield from node.items
    elif isinstance(node, ast.Match):
        yield node.subject
        for case in node.cases:
            yield case.pattern
            if case.guard is not None:
                yield case.guard


def line_effects(tree: ast.AST, harmless: Callable[[str], bool]) -> dict[int, Effects]:
    """Effects of each line of the function definition ``tree``; lines that change nothing are absent.

    ``harmless`` tells whether a call by this name changes nothing unseen.
    """
    found: dict[int, _Found] = {}

    def note(part: ast.AST, first: int, last: int) -> None:
        for line in range(first, last + 1):
            found.setdefault(line, _Found(harmless)).look(part, nested=False)

    for node in ast.walk(tree):
        if node is tree or not isinstance(node, ast.stmt):
            continue
        if isinstance(node, _HEADERS):
            for part in _headers(node):
                first = min(node.lineno, getattr(part, "lineno", node.lineno))
                note(part, first, getattr(part, "end_lineno", None) or node.lineno)
            if isinstance(node, ast.Try):
                for handler in node.handlers:
                    if handler.name:
                        found.setdefault(handler.lineno, _Found(harmless)).binds[handler.name] = None
        else:
            note(node, node.lineno, node.end_lineno or node.lineno)
    return {line: effects for line, look in found.items() if (effects := look.effects()) is not None}


@lru_cache(maxsize=256)
def text_of(function: FunctionType) -> Text:
    """Read one function; without its source every line is taken to change everything."""
    code = function.__code__
    count = code.co_argcount + code.co_kwonlyargcount
    count += bool(code.co_flags & inspect.CO_VARARGS) + bool(code.co_flags & inspect.CO_VARKEYWORDS)
    parameters = code.co_varnames[:count]
    try:
        source, first = inspect.getsourcelines(function)
        tree = parse_module(textwrap.dedent("".join(source)))
    except (OSError, SyntaxError):
        names = tuple(code.co_varnames)
        everything = Effects(names, (), names)
        return Text(function, code, function.__name__, names, parameters, frozenset(), {}, everything)
    ast.increment_lineno(tree, first - 1)
    effects = line_effects(tree.body[0], lambda name: _is_harmless(function, name))
    bound = dict.fromkeys(parameters)
    for line in sorted(effects):
        bound.update(dict.fromkeys(effects[line].binds))
    varying = _bound_in_loops(tree, effects)
    return Text(function, code, function.__name__, tuple(bound), parameters, varying, effects, None)


def _is_harmless(caller: FunctionType, name: str) -> bool:
    """Whether the line of a call need not be looked at for what the call changes.

    A function of ours is recorded itself: its own lines tell what they change, also of its arguments.
    """
    value = caller.__globals__.get(name)
    if value is None:
        return name in _PURE
    if isinstance(value, type):
        return issubclass(value, tuple)
    return isinstance(value, FunctionType) and _is_ours(value)


def _bound_in_loops(tree: ast.AST, effects: Mapping[int, Effects]) -> frozenset[str]:
    loops = (node for node in ast.walk(tree) if isinstance(node, ast.For | ast.While))
    lines = {line for loop in loops for line in range(loop.lineno, (loop.end_lineno or loop.lineno) + 1)}
    return frozenset(name for line in lines & effects.keys() for name in effects[line].binds)


def _global_names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _global_names(constant)


def texts_of(function: Callable[..., Any]) -> tuple[Text, ...]:
    """The entry's text and those of all functions of ours that it can call, by global name.

    Raises TypeError when ``function`` is not a Python function.
    """
    if not isinstance(function, FunctionType):
        raise TypeError(f"{function!r} is not a Python function, so its lines cannot be recorded.")
    found: dict[CodeType, FunctionType] = {}
    waiting = [function]
    while waiting:
        current = waiting.pop(0)
        if current.__code__ in found:
            continue
        found[current.__code__] = current
        for name in _global_names(current.__code__):
            value = current.__globals__.get(name)
            if isinstance(value, FunctionType) and _is_ours(value):
                waiting.append(value)
    return tuple(text_of(each) for each in found.values())


def _is_ours(function: FunctionType) -> bool:
    package = (function.__module__ or "").partition(".")[0]
    return package not in sys.stdlib_module_names and package != "numpy"
