"""The variables of a moment: in which order they are read, and which became others."""

from typing import Any

from workbench.engine.containers import same
from workbench.engine.recording import Moment, Recording


def in_order(recording: Recording, moment: Moment) -> dict[str, Any]:
    """The variables: those that a loop changes, then those that are set once."""
    varying = next(text.varying for text in recording.texts if text.name == moment.function)
    order = sorted(moment.variables, key=lambda name: name not in varying)
    return {name: moment.variables[name] for name in order}


def differing(before: Moment, now: Moment | None) -> frozenset[str]:
    """Names whose value is another than ``before``; none across calls of another depth."""
    if now is None or before.depth != now.depth:
        return frozenset()
    return frozenset(
        name for name, value in now.variables.items() if not same(before.variables.get(name), value)
    )
