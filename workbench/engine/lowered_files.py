"""Lowered texts as they are kept beside the kernels, so that a later process need not lower anything anew.

One is named by all that lowering looks at: the files of the functions that take part, what their global names
stand for, and the engine itself. A name that is too exact only costs time.
"""

import hashlib
import inspect
import json
import os
import sys
import time
import types
import typing
from collections.abc import Callable, Iterator
from dataclasses import astuple
from functools import cache, lru_cache
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from workbench.engine import kernel_files
from workbench.engine.lowering import Lowered, Slot, Variant, lower
from workbench.engine.operations import Operations

_FILE = "lowered.json"
_BEGUN = time.time_ns()
_WRITTEN = (bool, int, float, str, tuple, np.generic, types.BuiltinFunctionType)


def lowered(
    function: Callable[..., Any],
    variant: Variant = "plain",
    considers: tuple[tuple[str, str], ...] = (),
    painter: Callable[..., Any] | None = None,
) -> Lowered:
    """As ``lower``, read from where it was kept before, or else kept. Raises DialectError."""
    name = _name(function, variant, considers, painter)
    kept = None if name is None else _decoded(kernel_files.read(name, _FILE))
    if kept is not None:
        return kept
    result = lower(function, variant, considers, painter)
    # A file or a value may have changed meanwhile: what came of it must not bear the name of the old one.
    if name is not None and name == _name(function, variant, considers, painter):
        kernel_files.write(json.dumps(astuple(result)), name, _FILE)
    return result


def _decoded(kept: str | None) -> Lowered | None:
    """What was kept; None where that is not whole."""
    try:
        name, text, names, sources, arity, recursive, slots, titles = json.loads(kept or "")
        read = tuple(Slot(owner, tuple(lines), block, Operations(*ops)) for owner, lines, block, ops in slots)
    except (ValueError, TypeError):
        return None
    return Lowered(name, text, tuple(names), tuple(sources), arity, recursive, read, tuple(titles))


def _name(
    function: Callable[..., Any],
    variant: Variant,
    considers: tuple[tuple[str, str], ...],
    painter: Callable[..., Any] | None,
) -> str | None:
    """The name of what comes of lowering; None where that hangs on more than can be looked at."""
    if not __debug__:  # then what only assertions name is not in the code
        return None
    further = {name for _title, pixel in considers for name in _global_names(compile(pixel, "", "eval"))}
    begun = [each for each in (function, painter) if isinstance(each, FunctionType)]
    try:
        parts = [_engine(), variant, repr(considers), str(len(begun)), *_all_of(begun, further)]
    except OSError:
        return None
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def _all_of(begun: list[FunctionType], further: set[str]) -> Iterator[str]:
    """All that the lowered texts of these functions depend on, callees included, in one order."""
    waiting, seen, scopes = list(begun), set(begun), set[int]()
    for function in waiting:
        code, scope = function.__code__, function.__globals__
        yield f"{function.__module__} {function.__qualname__} {function.__name__} {code.co_firstlineno}"
        yield _digest(code.co_filename)
        yield f"{function.__defaults__!r} {function.__kwdefaults__!r}"
        callees = [inspect.unwrap(function)]
        for name in sorted({*_global_names(code), *further} & scope.keys()):
            value = scope[name]
            yield f"{name} = {_meaning(value)}"
            if isinstance(value, FunctionType):
                callees.append(value)
        if id(scope) not in scopes:  # annotations name types, of which the code knows nothing
            scopes.add(id(scope))
            yield from (f"{name} = {_meaning(value)}" for name, value in scope.items() if _is_type(value))
        waiting += [callee for callee in dict.fromkeys(callees) if callee not in seen]
        seen.update(callees)


def _global_names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _global_names(constant)


def _is_type(value: Any) -> bool:
    return isinstance(value, type) or typing.get_origin(value) is not None


def _meaning(value: Any, within: tuple[Any, ...] = ()) -> str:
    """What tells a global name's value from any other one that lowering would write otherwise."""
    if isinstance(value, FunctionType):
        return f"{value.__module__} {value.__qualname__}"
    if isinstance(value, ModuleType):
        return value.__name__
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {hashlib.sha256(value.tobytes()).hexdigest()}"
    if typing.get_origin(value) is not None:
        return " ".join([repr(value), *(_meaning(item, within) for item in typing.get_args(value))])
    if isinstance(value, type):
        said = f"{value.__module__} {value.__qualname__}"
        if value in within or not issubclass(value, tuple) or not hasattr(value, "_fields"):
            return said
        kinds = (_meaning(kind, (*within, value)) for kind in _kinds(value))
        defaults = map(_meaning, getattr(value, "_field_defaults", {}).values())
        return " ".join([said, *value._fields, *defaults, *kinds])
    if value is None or isinstance(value, _WRITTEN):
        return f"{type(value).__qualname__} {value!r}"
    return type(value).__qualname__  # nothing else can be written


def _kinds(record: type) -> list[Any]:
    """The types of a record's fields, where they can be known."""
    try:
        return list(typing.get_type_hints(record).values())
    except (NameError, TypeError):
        return []


def _digest(file: str) -> str:
    """That of a file. Raises OSError, also where it has changed since it may have been imported."""
    status = os.stat(file)
    if status.st_mtime_ns > _BEGUN:
        raise FileNotFoundError(file)
    return _digest_of(file, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=1024)
def _digest_of(file: str, _changed: int, _size: int) -> str:
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


@cache
def _engine() -> str:
    """What lowers, and what Python and NumPy write of numbers."""
    files = sorted(Path(__file__).parent.glob("*.py"))
    return " ".join([sys.version, np.__version__, *(_digest(str(file)) for file in files)])
