"""How the subjects of each kind become calls: the one place that is asked, and the only one that knows kinds.

A kind is registered by the module of this package that bears its name; that is all there is to adding one.
"""

import pkgutil
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Frame, Mark
from workbench.document.building import Edit
from workbench.document.check import number_problem
from workbench.document.errors import DocumentError
from workbench.document.faults import shown
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.marks import on_device
from workbench.rendering.raster import emitted, pixels

Cells = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Given:
    """An argument that subjects of a kind may have: ``usual`` where it is left out, and its range."""

    usual: Argument
    number: Number | None = None


def nothing(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    """No slugs."""
    return ()


def in_the_subject(sheet: Sheet, subject: Subject, slug: str) -> Edit | None:
    """No edit: the subject itself names what it is run under."""
    return None


def mapped(sheet: Sheet, subject: Subject, frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """Marks in device coordinates, by the sheet's own window and viewport."""
    return on_device(sheet, frame, marks)


def no_landmarks(sheet: Sheet, subject: Subject) -> tuple[int, ...]:
    """None: where a decision changed is marked."""
    return ()


def as_it_is(sheet: Sheet, subject: Subject) -> str:
    """Nothing: the calls get all of the subject."""
    return ""


def painted_by_calls(sheet: Sheet, subject: Subject) -> Cells:
    """The pixels (n, 2) of the picture that the calls of a subject emit, in their order."""
    whole = 0, sheet.width_px - 1, 0, sheet.height_px - 1
    parts = [pixels(call.entry, emitted(call), whole) for call in calls_of(sheet, subject)]
    return np.concatenate(parts) if parts else np.empty((0, 2), np.int64)


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparing:
    """How subjects of a kind are compared under two entries.

    ``choices`` are the slugs that it can be compared under, its own first. ``painted`` gives the pixels
    (n, 2) that the picture has of it, ``before`` those of them that are painted before its calls can begin.
    ``alike`` are the subjects of the sheet that are compared with it when all are. ``of_sheet`` tells whether
    the entry is one of the whole sheet, so that all are compared at first; ``example`` shows a comparison.
    """

    choices: Callable[[Sheet, Subject], tuple[str, ...]] = nothing
    painted: Callable[[Sheet, Subject], Cells] = painted_by_calls
    before: Callable[[Sheet, Subject], Cells | None] = lambda sheet, subject: None
    alike: Callable[[Sheet, Subject], tuple[Subject, ...]] = lambda sheet, subject: (subject,)
    of_sheet: bool = False
    example: str = "slopes"


@dataclass(frozen=True, slots=True, kw_only=True)
class SubjectKind:
    """How subjects of one kind are run. Where a sheet comes with a subject, the latter names its ids.

    ``title`` says in a few words what is run. ``calls`` are one run of it, the first entry's all in a row,
    none where there is nothing to run; an empty ``entry`` of a subject is its own one. ``choices`` are the
    slugs that it can be run under, its own first. ``choose`` is the edit by which the document names another;
    None where the subject does. ``entries`` are all slugs that a subject may name, ``arguments`` what it may
    be given. ``on_device`` brings marks from the frame of the entry to the device. ``landmarks`` are steps
    with which a part of the run begins, which are marked rather than each change of a decision.
    ``before`` is one sentence where the calls get less than the subject, or nothing of it.
    ``compared_as`` is another kind, of the same ids, that is compared in place of this one.
    ``invitation`` is what to do where there is nothing to run. ``whole`` tells whether the calls are made of
    all figures, ``as_seen`` whether of the picture as it is seen: in its frame, from where one looks.
    """

    title: str
    calls: Callable[[Sheet, Subject], list[Call]]
    invitation: str = _("Draw a figure to see how the algorithm works, step by step.")
    choices: Callable[[Sheet, Subject], tuple[str, ...]] = nothing
    choose: Callable[[Sheet, Subject, str], Edit | None] = in_the_subject
    entries: tuple[str, ...] = ()
    arguments: Mapping[str, Given] = field(default_factory=dict)
    on_device: Callable[[Sheet, Subject, Frame, Iterable[Mark]], tuple[Mark, ...]] = mapped
    landmarks: Callable[[Sheet, Subject], tuple[int, ...]] = no_landmarks
    before: Callable[[Sheet, Subject], str] = as_it_is
    comparing: Comparing = Comparing()
    compared_as: str = ""
    whole: bool = False
    as_seen: bool = False


_REGISTERED: dict[str, SubjectKind] = {}


def register(kind: str, how: SubjectKind) -> None:
    """Let subjects of this kind be run; called by the module of this package that is named like it."""
    _REGISTERED[kind] = how


@cache
def _modules() -> frozenset[str]:
    path = import_module(__package__).__path__
    return frozenset(module.name for module in pkgutil.iter_modules(path)) - {__name__.rpartition(".")[2]}


def known(kind: str) -> bool:
    """Whether there is such a kind of subject."""
    return kind in _REGISTERED or kind in _modules()


def kind_of(subject: Subject) -> SubjectKind:
    """How a subject is run; its module is imported when it is first asked for. LookupError: unknown kind."""
    if not known(subject.kind):
        raise LookupError(f"There is no kind of subject named {subject.kind!r}.")
    if subject.kind not in _REGISTERED:
        import_module(f"{__package__}.{subject.kind}")
    return _REGISTERED[subject.kind]


def checked(subject: Subject) -> Subject:
    """``subject`` itself when its kind, entry and arguments are known; raises DocumentError."""
    if not known(subject.kind):
        problem = _("This version of the program cannot step “{kind}”.")
        raise DocumentError("kind", problem.format(kind=subject.kind))
    how = kind_of(subject)
    if subject.entry and subject.entry not in how.entries:
        problem = _("entry is {value}; choose one of {choices}.")
        raise DocumentError("entry", problem.format(value=subject.entry, choices=", ".join(how.entries)))
    for name, value in subject.arguments.items():
        given = how.arguments.get(name)
        if given is None or (given.number is None and type(value) is not type(given.usual)):
            problem = _("{name} = {value} cannot be given here.")
            raise DocumentError(name, problem.format(name=name, value=shown(value)))
        if given.number is not None and (problem := number_problem(given.number, value)):
            raise DocumentError(name, f"{name} {problem}.")
    return subject


def calls_of(sheet: Sheet, subject: Subject) -> list[Call]:
    """The calls of one run of a subject, device coordinates where its entry takes them."""
    return kind_of(subject).calls(sheet, subject)


def marks_on_device(sheet: Sheet, subject: Subject, frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """What an entry draws of a subject, in device coordinates."""
    return kind_of(subject).on_device(sheet, subject, frame, marks)


def comparing(subject: Subject) -> Comparing:
    """How a subject is compared."""
    return kind_of(subject).comparing


def compared(subject: Subject) -> Subject:
    """What is compared of a subject, under its own entry."""
    other = kind_of(subject).compared_as
    return Subject(other or subject.kind, subject.ids, arguments={} if other else subject.arguments)


def own_entry(sheet: Sheet, subject: Subject) -> str:
    """The slug that what is compared of a subject runs under by itself; empty where nothing does."""
    base = compared(subject)
    return next(iter(comparing(base).choices(sheet, base)), "")


def rivals(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    """The slugs that a subject can be compared with."""
    base, own = compared(subject), own_entry(sheet, subject)
    return tuple(
        slug for slug in comparing(base).choices(sheet, base) if slug != own and catalogue.known(slug)
    )
