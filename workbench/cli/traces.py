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

    Raises BadInputError when it fails because the arrays given are not of the shapes that the text reads.
    """
    given = _shapes(entry, arguments)
    recording = record(entry.function, *arguments)
    if recording.error is not None:
        if given and _reads_beside(recording.error.exception):
            sentence = _(
                "{slug} cannot use arrays of these shapes, {given}; in its example they are {example}."
            )
            example = _shapes(entry, entry.example)
            raise BadInputError(sentence.format(slug=entry.slug, given=given, example=example))
        error = str(recording.error).rstrip(".")  # what a text says itself may be a sentence
        raise WorkError(_("{slug} stopped with an error, {error}.").format(slug=entry.slug, error=error))
    if recording.truncated:
        raise WorkError(
            _("{slug} is not done after {count} lines, the most that are recorded.").format(
                slug=entry.slug, count=len(recording)
            )
        )
    return recording


def _reads_beside(exception: BaseException) -> bool:
    """Whether a text read what an array does not have, or took a row apart into more or fewer numbers."""
    return isinstance(exception, IndexError) or (
        isinstance(exception, ValueError) and "values to unpack" in str(exception)
    )


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
