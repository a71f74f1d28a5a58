"""What is said of the first thing that is wrong with a part of a document."""

from typing import Any

from workbench.language import _, ngettext

Fault = tuple[str, str]
"""A path below a struct, empty for the struct itself, and what is said of it, which begins with a verb."""


def shown(value: Any) -> str:
    """``value`` as an error shows it: at most forty characters."""
    try:
        text = repr(value)
    except ValueError:
        return _("a number of thousands of digits")
    return text if len(text) <= 40 else text[:39] + "…"


def below(name: str, fault: Fault) -> Fault:
    """The same fault, told from the struct around, of which ``name`` is a field or a place in a list."""
    path, problem = fault
    return f"{name}{path}" if path[:1] in ("", "[") else f"{name}.{path}", problem


def count_problem(values: Any, least: int, most: float, what: str) -> str:
    """What is wrong with a list of what is called ``what``; empty when nothing is."""
    if not isinstance(values, tuple):
        return _("is not a list; give one")
    if len(values) < least:
        problem = ngettext(
            "has {count} of at least {least} {what}; add what is missing",
            "has {count} of at least {least} {what}s; add what is missing",
            least,
        )
        return problem.format(count=len(values), least=least, what=what)
    if len(values) > most:
        problem = _("has {count:,} entries of at most {most:,}; remove some")
        return problem.format(count=len(values), most=most)
    return ""
