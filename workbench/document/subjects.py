"""What is run, as a value: the subject of a run, and where a workspace stands in it.

What a kind of subject means is registered where it is rendered; here it is only a word.
"""

import math
import re

import msgspec

from workbench.document.faults import shown
from workbench.language import _

MAX_STEP = 2**53
MAX_ARGUMENTS = 64
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}")

Argument = bool | int | float | str | tuple[float, ...]


class Subject(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """What is run: ``kind`` says how it becomes calls of an entry.

    ``ids`` are those of the document that it is made of, none for the active figure; ``entry`` is the slug
    that it is run under, empty for its own; ``arguments`` are numbers and choices that no figure holds, by
    name, those left out as they usually are.
    """

    kind: str = "figure"
    ids: tuple[str, ...] = ()
    entry: str = ""
    arguments: dict[str, Argument] = {}

    def is_of(self, other: "Subject | None") -> bool:
        """Whether both run the same thing, under whatever entry and arguments."""
        return other is not None and (self.kind, self.ids) == (other.kind, other.ids)


class Position(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """What is stepped in a workspace, and how far: in rows of the hand table, or lines in ``detail``."""

    subject: Subject = Subject()
    step: int = 0
    detail: bool = False


Fault = tuple[str, str]
"""A path below the position, and what is said of it, which begins with a verb."""


def fault_in(position: Position, ids: frozenset[str]) -> Fault | None:
    """The first thing wrong with a position in a document that has these ``ids``; None where it is sound."""
    subject = position.subject
    if not 0 <= position.step < MAX_STEP:
        return "step", _("is {value}; give a whole number from 0").format(value=position.step)
    for name, word in (("kind", subject.kind), ("entry", subject.entry or "none")):
        if not is_word(word):
            return f"subject.{name}", _("is {value}, which is not a name").format(value=shown(word))
    for number, identity in enumerate(subject.ids):
        if identity not in ids:
            return f"subject.ids[{number}]", missing(identity)
    if len(subject.arguments) > MAX_ARGUMENTS:
        problem = _("has {count} entries; give at most {most}")
        return "subject.arguments", problem.format(count=len(subject.arguments), most=MAX_ARGUMENTS)
    for name, value in subject.arguments.items():
        if not is_word(name):
            return "subject.arguments", _("has the name {value}, which is not a valid name").format(
                value=shown(name)
            )
        numbers = value if isinstance(value, tuple) else (value,)
        if not all(isinstance(number, str) or math.isfinite(number) for number in numbers):
            problem = _("is {value}; give a finite number")
            return f"subject.arguments.{name}", problem.format(value=shown(value))
    return None


def is_word(text: str) -> bool:
    """Whether it can name a kind, an entry, an argument or a workspace: at most 64 letters, digits and _."""
    return _WORD.fullmatch(text) is not None


def missing(identity: str) -> str:
    """What is said of a field that names an id that the document does not have."""
    problem = _("is {value}, which does not exist; remove it or name one that does")
    return problem.format(value=shown(identity))
