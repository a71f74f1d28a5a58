"""Where the test that a law names is, and whether it runs on the algorithm whose law it is."""

import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry

TESTS = Path(__file__).resolve().parents[1]
_PROOF = re.compile(r"(?P<module>[a-z_]+/test_[a-z_0-9]+)\.py::(?P<name>test_\w+)")
_SUBJECTS = {
    **{entry.slug: entry.slug for entry in catalogue.entries()},
    **{entry.function: entry.slug for entry in catalogue.entries()},
}


def proof_of(proof: str) -> Callable[..., Any] | None:
    """The test that ``proof`` names under ``tests/``; None if there is none."""
    parts = _PROOF.fullmatch(proof)
    if parts is None or not (TESTS / f"{parts['module']}.py").is_file():
        return None
    module = import_module(f"tests.{parts['module'].replace('/', '.')}")
    test = getattr(module, parts["name"], None)
    return test if callable(test) else None


def runs_on(test: Callable[..., Any], entry: Entry) -> bool:
    """Whether the test runs on the entry: it is among its parameters, or else named where the test looks.

    A test that is parametrised over algorithms runs on those alone. Any other runs on the algorithms that its
    code names, and the code of what it calls in its own module or in another module of tests.
    """
    parametrised = {slug for values in _parametrised(test) for slug in _subjects(values)}
    if parametrised:
        return entry.slug in parametrised
    inner = getattr(getattr(test, "hypothesis", None), "inner_test", test)
    return entry.slug in _named(inner, set())


def _parametrised(test: Callable[..., Any]) -> Iterator[Any]:
    for mark in getattr(test, "pytestmark", []):
        if mark.name == "parametrize":
            yield list(mark.args[1])


def _subjects(value: Any) -> set[str]:
    """The slugs of all algorithms in a value: functions, slugs and entries, also in what it holds."""
    if isinstance(value, Entry):
        return {value.slug}
    if isinstance(value, str | FunctionType):
        return {_SUBJECTS[value]} if value in _SUBJECTS else set()
    if isinstance(value, dict):
        return _subjects([*value, *value.values()])
    if isinstance(value, list | tuple | set):
        return {slug for each in value for slug in _subjects(each)}
    return set()


def _named(function: FunctionType, seen: set[FunctionType]) -> set[str]:
    """The algorithms that the code of a function names, in itself or in the tests' code that it calls."""
    if function in seen:
        return set()
    seen.add(function)
    names, constants = _contents(function.__code__)
    slugs = _subjects(constants)
    for value in (function.__globals__[name] for name in names if name in function.__globals__):
        slugs |= _subjects(value)
        if isinstance(value, FunctionType) and value.__module__.startswith("tests."):
            slugs |= _named(value, seen)
    return slugs


def _contents(code: CodeType) -> tuple[set[str], list[Any]]:
    """The names and the constants of a piece of code, and of those that are written inside it."""
    names, constants = set(code.co_names), []
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            inner_names, inner_constants = _contents(constant)
            names |= inner_names
            constants += inner_constants
        else:
            constants.append(constant)
    return names, constants
