"""A run of one algorithm, recorded whole, and the tables that can be printed of it."""

from collections.abc import Callable
from typing import Any

from workbench.algorithms.entry import Entry
from workbench.cli.failure import WorkError
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.engine.recording import Recording
from workbench.exchange import run_tables
from workbench.exchange.tables import Table
from workbench.language import _


def run(entry: Entry, arguments: tuple[Any, ...]) -> Recording:
    """The whole run, recorded. Raises WorkError when it fails or is too long to record."""
    recording = record(entry.function, *arguments)
    if recording.error is not None:
        error = str(recording.error).rstrip(".")  # what a text says itself may be a sentence
        raise WorkError(_("{slug} stopped with an error, {error}.").format(slug=entry.slug, error=error))
    if recording.truncated:
        raise WorkError(
            _("{slug} is not done after {count} lines, the most that are recorded.").format(
                slug=entry.slug, count=len(recording)
            )
        )
    return recording


TABLES: dict[str, Callable[[Entry, Recording], Table]] = {
    "hand": lambda entry, recording: run_tables.hand(Steps(entry, recording)).computed(),
    "pixels": run_tables.emitted,
    "lines": lambda _entry, recording: run_tables.lines(recording).computed(),
}
