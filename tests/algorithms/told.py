"""A run in the words that a student reads, as text: what an entry declares of itself, then step after step.

Of each step: its caption, its sentence, what is told in detail only, its row with the headings, what is
drawn, and the tables that are others than those before. Of a long run the first steps, the last ones and the
first of every view; what is left out is said.
"""

import string
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from workbench.algorithms.entry import Entry, View
from workbench.algorithms.marks import Mark
from workbench.engine.calls import own_call
from workbench.engine.observation import Step, Steps, Table
from workbench.engine.recorder import record
from workbench.engine.sentences import Part, number_text

MOST_STEPS, FIRST_STEPS, LAST_STEPS = 16, 6, 2
MOST_ROWS = 12
MOST_EMITTED = 12
MOST_NUMBERS = 24
DEPTH_LIMIT = 200  # enough for every example, and none of them is there to overflow

# What ``_step`` writes in words of its own; whatever else a step comes to hold is written under its name.
_WRITTEN = frozenset(
    (
        *("number", "title", "first", "last", "row", "tables", "sentence", "emitted_from", "emitted_to"),
        *("view", "options", "answer"),
    )
)

Run = tuple[Any, ...]


def steps_of(entry: Entry, run: Run) -> Steps:
    """The steps of ``entry`` with the arguments ``run``."""
    return Steps(entry, record(entry.function, *run, depth_limit=DEPTH_LIMIT))


def told(entry: Entry, runs: Sequence[Run]) -> str:
    """All of the text for one entry."""
    lines = [*_declared(entry)]
    for run in runs:
        lines += ["", "", *_run(entry, run)]
    return "\n".join(line.rstrip() for line in lines) + "\n"


def _declared(entry: Entry) -> Iterator[str]:
    """What the entry says of itself."""
    yield entry.title
    yield entry.summary
    for parameter in entry.parameters:
        words = [parameter.label, parameter.meaning, f"[{parameter.unit}]" if parameter.unit else ""]
        yield f"  {parameter.name}: {', '.join(word for word in words if word)}"
    laws = tuple(law.sentence for law in entry.laws)
    for heading, sentences in (("So it is", laws), ("Not so", entry.not_laws), ("Labs", entry.labs)):
        yield from (f"  {heading}: {sentence}" for sentence in sentences)
    for heading, words in (
        ("Works in", entry.works_in),
        ("Source", entry.source),
        ("Ties", entry.tie),
        ("Stepped only", entry.compiles),
    ):
        if words:
            yield f"  {heading}: {words}"


def _run(entry: Entry, run: Run) -> Iterator[str]:
    steps = steps_of(entry, run)
    names = (parameter.name for parameter in entry.parameters)
    yield f"== {entry.slug}({', '.join(map(_argument, names, run))})"
    recording = steps.recording
    yield f"   {len(steps)} steps, {len(recording.emitted)} emitted"
    if recording.error is not None:
        yield f"   breaks off with {type(recording.error.exception).__name__}"
    kept = telling(steps)
    shown: dict[str, Table] = {}
    before = -1
    for number in kept:
        yield ""
        if number > before + 1:
            titles = Counter(steps[left_out].title for left_out in range(before + 1, number))
            counted = ", ".join(f"{title} ({times})" for title, times in titles.items())
            yield from (f"… left out: steps {before + 1} to {number - 1}: {counted}", "")
        yield from _step(entry, run, steps, steps[number], shown)
        shown |= steps[number].tables
        before = number


def telling(steps: Steps) -> list[int]:
    """Numbers of the steps that are written: of a long run both ends and the first of every view."""
    last = len(steps)
    if last <= MOST_STEPS:
        return list(range(last + 1))
    kept = {*range(FIRST_STEPS + 1), *range(last + 1 - LAST_STEPS, last + 1)}
    unseen = list(steps.entry.views)
    for step in steps:
        first = [
            view for view in unseen if tells(view, step.view, (words(step.sentence), *_asides(steps, step)))
        ]
        if first:
            kept.add(step.number)
            unseen = [view for view in unseen if view not in first]
    return sorted(kept)


def tells(view: View, shown: View | None, sentences: Iterable[str]) -> bool:
    """Whether a step with the view ``shown`` and these sentences is one in which ``view`` holds."""
    return view is shown or (bool(view.sentence) and any(is_sentence_of(view, one) for one in sentences))


def _step(entry: Entry, run: Run, steps: Steps, step: Step, shown: dict[str, Table]) -> Iterator[str]:
    yield (
        f"{step.number}. {step.title}".rstrip(". ") if step.number else f"Before the first step. {step.title}"
    )
    sentence = words(step.sentence)
    if sentence:
        yield f"   {sentence}"
    for aside in _asides(steps, step):
        yield f"   in detail: {aside}"
    if step.row:
        yield "   row: " + " | ".join(map(_cell, entry.columns, step.row))
    for field in fields(step):
        value = getattr(step, field.name)
        if field.name not in _WRITTEN and value:
            yield f"   {field.name}: {_places(value)}"
    if step.options:
        yield f"   asked first: {' / '.join(map(str, step.options))}; right is {step.answer}"
    emitted = [steps.recording.emitted[n] for n in range(step.emitted_from, step.emitted_to)]
    if emitted:
        yield f"   emits: {_places(emitted)}"
    for mark in _marks(entry, run, steps, step):
        yield f"   draws: {_text(mark)}"
    for title, table in step.tables.items():
        if shown.get(title) != table:
            yield from _table(title, *table)


def words(sentence: Iterable[Part]) -> str:
    """A sentence without its links."""
    return "".join(part.text for part in sentence)


def _asides(steps: Steps, step: Step) -> list[str]:
    """What is told in detail only: no part of this step's sentence or of the one before."""
    whole = words(step.sentence)
    before = words(steps[step.number - 1].sentence) if step.number else ""
    events = range(step.first + 1, step.last + 2)
    told_in_detail = dict.fromkeys(words(steps.told(event)) for event in events)
    return [told for told in told_in_detail if told not in whole and told not in before]


def _marks(entry: Entry, run: Run, steps: Steps, step: Step) -> list[Mark]:
    """What the entry draws at the end of a step."""
    recording = steps.recording
    if not len(recording):
        return []
    over = recording.complete and step.last == len(recording) - 1
    call = own_call(recording, max(step.first, 0), max(step.last, 0), step.emitted_to, over)
    return list(entry.marks(run, call.variables, call.emitted, call.ended))


def _cell(heading: str, value: object) -> str:
    return f"{heading} = {number_text(value)}"


def _text(value: Any) -> str:
    """A value with its numbers as a student sees them, and the name of its kind where it has one."""
    if isinstance(value, np.ndarray):
        return number_text(value.tolist())
    if isinstance(value, tuple):
        kind = "" if type(value) is tuple else type(value).__name__
        return f"{kind}({', '.join(map(_text, value))})"
    return number_text(value)


def _places(places: Sequence[Any]) -> str:
    told = " ".join(map(_text, places[:MOST_EMITTED]))
    left_out = len(places) - MOST_EMITTED
    return f"{told} … and {left_out} more" if left_out > 0 else told


def _table(title: str, headings: tuple[str, ...], rows: Sequence[Sequence[Any]]) -> Iterator[str]:
    yield f"   {title}: {' | '.join(headings)}"
    for row in rows[:MOST_ROWS]:
        yield f"     {' | '.join(map(number_text, row))}"
    if len(rows) > MOST_ROWS:
        yield f"     … and {len(rows) - MOST_ROWS} more rows"
    elif not rows:
        yield "     (empty)"


def _argument(name: str, value: Any) -> str:
    if not isinstance(value, np.ndarray):
        return f"{name}={value!r}"
    if value.size > MOST_NUMBERS:
        return f"{name}={' x '.join(map(str, value.shape))}"
    return f"{name}={number_text(value.tolist())}"


def is_sentence_of(view: View, sentence: str) -> bool:
    """Whether ``sentence`` holds all the fixed words of the view's template, in their order."""
    place = 0
    for text, *_field in string.Formatter().parse(view.sentence):
        place = sentence.find(text, place)
        if place < 0:
            return False
        place += len(text)
    return True
