"""The text of a module that stands alone: what its functions need, and the functions."""

import ast
import inspect
import math
from types import ModuleType
from typing import Any

import numpy as np

from workbench.engine.choices import CHOSEN
from workbench.engine.parsing import parse_expression
from workbench.engine.places import BESIDE, PLACE
from workbench.engine.texts import STOPPED, Text
from workbench.language import _


def module_text(texts: list[Text], functions: list[str], inlined: bool) -> str:
    """The module of ``functions``, written of ``texts``, callees first; ``@part`` asks for inlining."""
    names: dict[str, str] = {}
    for text in texts:
        for name, value in text.constants.items():
            line = _binding(text, name, value)
            if names.setdefault(name, line) != line:
                raise text.error(
                    _("{name} means two things in the functions called; rename one").format(name=name)
                )
    imports = sorted(line for line in names.values() if line.startswith(("import ", "from ")))
    literals = sorted(set(names.values()) - set(imports))
    if any(" = numpy.array(" in line for line in literals):
        imports.insert(0, "import numpy")
    sinks = "from workbench.engine.sinks import emit, probe, tick"
    own = [
        f"from workbench.engine.sinks import stopped as {STOPPED}",
        f"from numpy import uint64 as {PLACE}",
        f"from workbench.engine.places import beside as {BESIDE}",
        f"from workbench.engine.choices import chosen as {CHOSEN}",
    ]
    head = "\n".join([*own, sinks, *imports, *literals])
    marks = ["@part\n" if inlined and _worth_inlining(text) else "@reading\n" for text in texts[:-1]]
    marks.append("@reading\n")
    written = [mark + function for mark, function in zip(marks, functions, strict=True)]
    return "\n\n".join([head, *written]) + "\n"


def _worth_inlining(text: Text) -> bool:
    """Whether a function goes into the one that calls it: when it emits, or calls none of the texts itself.

    Anything more would take registers from the caller's loops, and be compiled again with each driver.
    """
    return text.generator or not text.callees


def literal(value: Any) -> ast.expr:
    """The expression that has this value."""
    return parse_expression(repr(value))


def _binding(text: Text, name: str, value: Any) -> str:
    """The line that gives ``name`` its value in the new module."""
    if isinstance(value, ModuleType):
        return f"import {value.__name__} as {name}"
    if isinstance(value, np.ndarray):
        return f"{name} = numpy.array({value.tolist()!r}, dtype='{value.dtype}')"
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, type) and issubclass(value, tuple) and hasattr(value, "_fields"):
        if value.__module__ == "__main__" or "<" in value.__qualname__:
            raise text.error(_("the record {name} must be at the top level of a file").format(name=name))
        defaults = [repr(each) for each in getattr(value, "_field_defaults", {}).values() if _plain(each)]
        fields = " ".join([*value._fields, *defaults])
        return f"from {value.__module__} import {value.__name__} as {name}  # {fields}"
    if inspect.isbuiltin(value) and getattr(value, "__module__", "") == "math":
        return f"from math import {value.__name__} as {name}"
    if isinstance(value, float) and not math.isfinite(value):
        return f"{name} = float({str(value)!r})"
    if _plain(value):
        return f"{name} = {value!r}"
    raise text.error(_("{name} is not a number, a tuple, an array or a record").format(name=name))


def _plain(value: Any) -> bool:
    if type(value) is tuple:
        return all(_plain(item) for item in value)
    return value is None or isinstance(value, bool | int | float | str)
