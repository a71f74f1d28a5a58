"""The only rewriter: from the text that is shown to one that emits into a sink.

``yield a, b`` becomes ``emit(_sink, a, b)`` and ``yield from f(x)`` becomes ``f(_sink, x)``; see also
``places``, ``choices``, ``empty_lists``, ``reading_items`` and ``ways_out``. Nothing else of what runs is
touched. All that the function calls is found by its global name and written, callees first, into one text
that stands alone.

Two variants add to that. The *counting* text ticks before statements, with the number of their slot, and so
finds the runs of each line and the visits of each titled block exactly as a tracer would. The *probing* text
also asks, when a block is left whose view considers a pixel, which pixel that was.
"""

import ast
import copy
import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import FunctionType, ModuleType
from typing import Any, Literal

import numpy as np

from workbench.engine.blocks import blocks
from workbench.engine.choices import bounded, choices
from workbench.engine.empty_lists import is_empty_list, typed_empty_list
from workbench.engine.module_text import literal, module_text
from workbench.engine.operations import Operations
from workbench.engine.places import counted_up, met, unsigned
from workbench.engine.reading_items import item_read
from workbench.engine.texts import SINK, VISIT, Text, arity, bound_names, gather, parameters, parse, recursive
from workbench.engine.ways_out import WayOut, ways_out
from workbench.language import _

Variant = Literal["plain", "counting", "probing"]

NO_BLOCK = -1


@dataclass(frozen=True, slots=True)
class Slot:
    """One place that ticks: statements of ``function`` that run one after another, in one block.

    ``lines`` are those of its file on which they begin, ``block`` the number of their titled block or
    ``NO_BLOCK``, ``written`` the operations that run there.
    """

    function: str
    lines: tuple[int, ...]
    block: int
    written: Operations


@dataclass(frozen=True, slots=True)
class Lowered:
    """One function and all it calls, as a text that stands alone.

    ``text`` is the module; ``name`` the function to call in it, with the sink as first argument. ``names``
    are all functions in it, callees first, ``sources`` the text of each as it is shown. ``arity`` is how many
    numbers are emitted at a time; ``recursive`` tells whether one of them calls itself, directly or not. Only
    where it ticks there are ``slots``, and ``titles``: the title of each block by its number.
    """

    name: str
    text: str
    names: tuple[str, ...]
    sources: tuple[str, ...]
    arity: int
    recursive: bool
    slots: tuple[Slot, ...] = ()
    titles: tuple[str, ...] = ()


def lower(
    function: Callable[..., Any],
    variant: Variant = "plain",
    considers: tuple[tuple[str, str], ...] = (),
    painter: Callable[..., Any] | None = None,
) -> Lowered:
    """Lower a generator function; ``considers`` are (title of a block, expression for a pixel) to probe.

    The ``painter`` of an entry is lowered with it.

    Raises:
        DialectError: the text, or one that it calls, is outside the dialect.
    """
    probed: dict[str, tuple[str, ...]] = {}
    for title, expression in considers:
        probed[title] = (*probed.get(title, ()), expression)
    texts = gather(function, probed, painter)
    slots: list[Slot] = []
    titles: list[str] = []
    plain = variant == "plain"
    trees = {text.function: text.tree for text in texts}
    sinks = {text.function for text in texts if text.generator or not plain}
    ways = ways_out(texts, sinks)
    functions = [
        _Rewriter(text, sinks, ways, trees) if plain else _Ticking(text, sinks, ways, slots, titles)
        for text in texts
    ]
    written = [ast.unparse(function.rewritten()) for function in functions]
    return Lowered(
        name=function.__name__,
        text=module_text(texts, written, inlined=plain and not recursive(texts)),
        names=tuple(text.name for text in texts),
        sources=tuple(text.source for text in texts),
        arity=arity(texts),
        recursive=recursive(texts),
        slots=tuple(slots),
        titles=tuple(titles),
    )


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), [ast.Name(SINK, ast.Load()), *arguments], [])


class _Rewriter(ast.NodeTransformer):
    """Rewrites one function; ``sinks`` take a sink first, ``helpers`` may be written in their place."""

    def __init__(
        self,
        text: Text,
        sinks: set[FunctionType],
        ways: Mapping[FunctionType, str],
        helpers: Mapping[FunctionType, ast.FunctionDef],
    ) -> None:
        self.text = text
        self.sinks = sinks
        self.helpers = helpers
        self.out = WayOut(text.function, ways)
        self.bound = bound_names(text.tree)
        own_names = {*text.callees, *text.constants}
        self.counted = counted_up(text.tree, own_names)
        self.within = {} if "min" in own_names else bounded(text.tree, self.counted)

    def rewritten(self) -> ast.FunctionDef:
        tree = parse(self.text.source, self.text.first)  # far cheaper than a deep copy
        assert isinstance(tree, ast.FunctionDef)
        tree.returns = None
        for argument in parameters(tree):
            argument.annotation = None
        function = self.text.function
        tree.args.defaults = [literal(value) for value in function.__defaults__ or ()]
        named = function.__kwdefaults__ or {}
        tree.args.kw_defaults = [
            literal(named[argument.arg]) if argument.arg in named else None
            for argument in tree.args.kwonlyargs
        ]
        if self.text.function in self.sinks:
            (tree.args.posonlyargs or tree.args.args).insert(0, ast.arg(SINK))
        if ast.get_docstring(tree, clean=False) is not None:
            del tree.body[0]
        tree.body = self.body(tree.body)
        return ast.fix_missing_locations(tree)

    def body(self, statements: list[ast.stmt]) -> list[ast.stmt]:
        """The body of the whole function."""
        return [each for statement in statements for each in self.visit(statement)] or [ast.Pass()]

    def visit(self, node: ast.AST) -> Any:
        """What is written for an expression, or the list of what is written for a statement."""
        written = super().visit(node)
        return self.out.after(written) if isinstance(node, ast.stmt) else written

    def visit_Expr(self, node: ast.Expr) -> ast.stmt:
        if isinstance(node.value, ast.Yield) and node.value.value is not None:
            value = node.value.value
            items = value.elts if isinstance(value, ast.Tuple) else [value]
            return ast.Expr(_call("emit", *(self.visit(item) for item in items)))
        self.generic_visit(node)
        return node

    def visit_YieldFrom(self, node: ast.YieldFrom) -> ast.expr:
        assert isinstance(node.value, ast.Call)
        callee = self._callee(node.value)
        if callee is None or not inspect.isgeneratorfunction(callee):
            raise self.text.error(_("yield from must call a generator function by its name"), node.lineno)
        return self._with_sink(node.value, callee)

    def visit_Call(self, node: ast.Call) -> ast.expr:
        callee = self._callee(node)
        if callee is not None and inspect.isgeneratorfunction(callee):
            raise self.text.error(
                _("{name} emits; take it with yield from").format(name=callee.__name__), node.lineno
            )
        if callee is not None and callee in self.sinks:
            return self._with_sink(node, callee)
        helper = None if callee is None else self.helpers.get(callee)
        if helper is not None and (written := item_read(node, helper, self.bound)):
            return self.visit(written)  # type: ignore[no-any-return]
        if isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Name):
            module = self.text.constants.get(node.func.value.id)
            if isinstance(module, ModuleType) and module not in (math, np):
                raise self.text.error(
                    _("import {name} by its own name").format(name=node.func.attr), node.lineno
                )
        self.generic_visit(node)
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        self.generic_visit(node)
        return unsigned(node, self.counted)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        return met(node, self.within)

    def visit_If(self, node: ast.If) -> ast.stmt | list[ast.stmt]:
        written = choices(node, self.within)
        if written is None:
            return self.generic_visit(node)  # type: ignore[return-value]
        return [each for statement in written for each in self.visit(statement)]

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.stmt:
        if node.value is None:
            return ast.Pass()
        value = node.value
        if is_empty_list(node):
            value = typed_empty_list(node, self.text.function.__globals__)
        return ast.Assign([self.visit(node.target)], self.visit(value))

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id in self.text.callees:
            return ast.Name(self.text.callees[node.id].__name__, node.ctx)
        return node

    def _callee(self, node: ast.Call) -> FunctionType | None:
        return self.text.callees.get(node.func.id) if isinstance(node.func, ast.Name) else None

    def _with_sink(self, node: ast.Call, callee: FunctionType) -> ast.Call:
        call = _call(callee.__name__, *(self.visit(argument) for argument in node.args))
        call.keywords = [self.visit(keyword) for keyword in node.keywords]
        return call


_Again = Callable[[int], list[ast.stmt]]


def _nowhere(_line: int) -> list[ast.stmt]:
    """What runs where a loop goes on, outside of all loops."""
    return []


def _after(loop: ast.For | ast.While) -> int:
    """A line behind the body of a loop."""
    return (loop.body[-1].end_lineno or loop.body[-1].lineno) + 1


class _Ticking(_Rewriter):
    """Adds the ticks and probes. ``slots`` and ``titles`` are those of the whole text, and grow here."""

    def __init__(
        self,
        text: Text,
        sinks: set[FunctionType],
        ways: Mapping[FunctionType, str],
        slots: list[Slot],
        titles: list[str],
    ) -> None:
        super().__init__(text, sinks, ways, {})
        self.slots = slots
        self.of_line: dict[int, int] = {}
        self.probed: list[tuple[int, int, tuple[ast.expr, ...]]] = []
        for block in blocks(text.function):
            if block.title in text.considers:
                self.probed.append((len(titles), block.first_line, text.considers[block.title]))
            self.of_line.update(dict.fromkeys(block.lines, len(titles)))
            titles.append(block.title)
        self.open = -1

    def body(self, statements: list[ast.stmt]) -> list[ast.stmt]:
        start = ast.Assign([ast.Name(VISIT, ast.Store())], ast.Constant(NO_BLOCK))
        end = self.text.tree.end_lineno or self.text.tree.lineno
        return [start, *self._suite(statements, _nowhere), *self._probes(end + 1)]

    def _suite(self, statements: list[ast.stmt], again: _Again) -> list[ast.stmt]:
        """``statements`` with their ticks; ``again`` gives what runs where the loop around them goes on."""
        lines: list[ast.stmt] = []
        self.open = -1
        for statement in statements:
            lines += self._ticked(statement, again)
        self.open = -1
        return lines

    def _ticked(self, node: ast.stmt, again: _Again) -> list[ast.stmt]:
        match node:
            case ast.If():
                tick = self._tick(node, node.test)
                body, other = self._suite(node.body, again), self._suite(node.orelse, again)
                return [*tick, *self.out.after(ast.If(self.visit(node.test), body, other))]
            case ast.While():
                # The header runs before each turn, so the test moves inside
                self.open = -1
                tick = self._tick(node, node.test)
                block = self.slots[-1].block
                leave = [*self._suite(node.orelse, again), ast.Break()]
                test = ast.If(ast.UnaryOp(ast.Not(), self.visit(node.test)), leave, [])
                body = self._suite(node.body, lambda line: self._probes(line, block))
                last = self._probes(_after(node), block)
                out = self.out.taken()
                return [ast.While(ast.Constant(True), [*tick, *out, test, *body, *last], []), *out]
            case ast.For():
                tick = self._tick(node, node.target, node.iter)
                block = self.slots[self.open].block
                number = len(self.slots)
                self.slots.append(Slot(self.text.name, (node.lineno,), block, Operations()))
                body = self._suite(node.body, lambda line: self._mark(number, line))
                last = self._mark(number, _after(node))
                other = self._suite(node.orelse, again)
                turn = [*self.out.taken(), *body, *last]
                return [*tick, ast.For(self.visit(node.target), self.visit(node.iter), turn, other)]
            case ast.Match():
                tick = self._tick(node, node.subject)
                for case in node.cases:
                    case.body = self._suite(case.body, again)
                node.subject = self.visit(node.subject)
                return [*tick, node]
            case ast.Return():
                return [*self._tick(node, node), *self._probes(node.lineno), *self.visit(node)]
            case ast.Continue():
                return [*self._tick(node), *again(node.lineno), node]
            case ast.AnnAssign(value=None):
                return []
        return [*self._tick(node, node), *self.visit(node)]

    def _tick(self, node: ast.stmt, *expressions: ast.AST) -> list[ast.stmt]:
        """The lines that note that ``node`` runs: none where the slot before it runs as often."""
        block = self.of_line.get(node.lineno, NO_BLOCK)
        if self.open >= 0 and self.slots[self.open].block == block:
            before = self.slots[self.open]
            lines = before.lines if node.lineno in before.lines else (*before.lines, node.lineno)
            self.slots[self.open] = replace(before, lines=lines, written=before.written.and_in(expressions))
            return []
        self.open = len(self.slots)
        self.slots.append(Slot(self.text.name, (node.lineno,), block, Operations().and_in(expressions)))
        return self._mark(self.open, node.lineno)

    def _mark(self, number: int, line: int) -> list[ast.stmt]:
        """The tick of a slot, standing at ``line``, behind the probes of the blocks that it leaves."""
        call = _call("tick", ast.Constant(number), ast.Name(VISIT, ast.Load()))
        tick = ast.Assign([ast.Name(VISIT, ast.Store())], call)
        return [*self._probes(line, self.slots[number].block), tick]

    def _probes(self, line: int, block: int | None = None) -> list[ast.stmt]:
        """Ask for the pixel of each block left at ``line``, for ``block`` or, without one, for good."""
        found: list[ast.stmt] = []
        for number, first_line, expressions in self.probed:
            if block != number and line > first_line:
                asked = [_call("probe", self.visit(copy.deepcopy(pixel))) for pixel in expressions]
                test = ast.Compare(ast.Name(VISIT, ast.Load()), [ast.Eq()], [ast.Constant(number)])
                found.append(ast.If(test, [ast.Expr(call) for call in asked], []))
        return found
