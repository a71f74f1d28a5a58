"""A run of one algorithm, recorded whole, and the tables that can be printed of it."""

from collections.abc import Callable
from typing import Any

import numpy as np

from workbench.algorithms.entry import Entry
from workbench.cli.failure import BadInputError, WorkError
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.engine.recording import Recording
from workbench.exchange import run_tables
from workbench.exchange.tables import Table
from workbench.language import _


def run(entry: Entry, arguments: tuple[Any, ...]) -> Recording:
    """The whole run, recorded. Raises WorkError when it fails or is too long to record.

    Raises BadInputError when it fails because of the values, shapes or indexes given.
    """
    recording = record(entry.function, *arguments)
    if recording.error is not None:
        refusal = _refusal(entry, arguments, recording.error.exception)
        if refusal:
            raise BadInputError(refusal)
        raise WorkError(
            _("{slug} stopped with an error, {error}.").format(slug=entry.slug, error=recording.error)
        )
    if recording.truncated:
        raise WorkError(
            _("{slug} is not done after {count} lines, the most that are recorded.").format(
                slug=entry.slug, count=len(recording)
            )
        )
    return recording


def _refusal(entry: Entry, arguments: tuple[Any, ...], exception: BaseException) -> str:
    """What is wrong with what was given, where that is why the text failed; else an empty text."""
    given = _shapes(entry, arguments)
    if given and isinstance(exception, IndexError):
        sentence = _(
            "{slug} asks for an item that is not there ({error}): its arrays are {given}; in its example "
            "they are {example}."
        )
    elif given and isinstance(exception, ValueError) and "values to unpack" in str(exception):
        sentence = _("{slug} cannot use arrays of these shapes, {given}; in its example they are {example}.")
    elif isinstance(exception, ValueError):
        sentence = _("{slug} cannot use what it was given: {error}.")
    else:
        return ""
    error = str(exception).rstrip(".")  # what a text says itself may be a sentence
    example = _shapes(entry, entry.example)
    return sentence.format(slug=entry.slug, error=error, given=given, example=example)


def _shapes(entry: Entry, arguments: tuple[Any, ...]) -> str:
    """The arrays among the arguments as a person tells them: “vertices 5 × 2, ends 1”."""
    return ", ".join(
        f"{name} {' × '.join(map(str, value.shape))}"
        for name, value in zip(entry.parameter_names, arguments, strict=False)
        if isinstance(value, np.ndarray)
    )


TABLES: dict[str, Callable[[Entry, Recording], Table]] = {
    "hand": lambda entry, recording: run_tables.hand(Steps(entry, recording)).computed(),
    "pixels": run_tables.emitted,
    "lines": lambda _entry, recording: run_tables.lines(recording).computed(),
}
