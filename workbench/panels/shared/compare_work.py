"""What two entries do with the same input, as the rows of a table."""

from collections.abc import Callable
from functools import partial
from typing import Any

from workbench.algorithms import catalogue
from workbench.language import _
from workbench.rendering.work import Outcome, Work

ComparedCount = tuple[str, Any, Any]


def _counted(label: str, work: Work) -> int | None:
    return work.counted.get(label)


def table_rows(outcome: Outcome) -> list[ComparedCount]:
    """Label and the number of each side; rows in which neither did anything are left out."""
    first, second = outcome.first, outcome.second
    emits = catalogue.get(outcome.job.first).emits
    what = {"segments": _("Lines kept"), "points": _("Points handed on"), "spans": _("Spans")}
    paints = emits not in ("segments", "points")
    labels = dict.fromkeys(label for work in (first, second) if work is not None for label in work.counted)
    readers: list[tuple[str, Callable[[Work], Any]]] = [
        *((_(label), partial(_counted, label)) for label in labels),
        (_("Tests"), lambda work: work.tests),
        (_("Additions"), lambda work: work.additions),
        (_("Multiplications"), lambda work: work.multiplications),
        (_("Divisions"), lambda work: work.divisions),
        (_("Writes"), lambda work: work.writes),
        (what.get(emits, ""), lambda work: work.emitted if emits in what else None),
        (_("Pixels"), lambda work: len(work.cells) if paints and second is not None else None),
        (_("Outline first"), lambda work: work.before),
        (_("Runs"), lambda work: work.calls if work.calls > 1 else None),
    ]
    kept = {_("Tests"), _("Additions"), _("Multiplications"), _("Divisions")}
    kept |= {_(label) for label in labels}
    rows: list[ComparedCount] = []
    for label, read in readers:
        values = read(first), read(second) if second is not None else None
        if any(values) or label in kept:
            rows.append((label, *values))
    if first.deepest or (second is not None and second.deepest):
        rows.append((_("Largest stack"), first.deepest, second.deepest if second is not None else ""))
    if second is not None and outcome.classes is not None:
        rows.append((_("This one only"), outcome.only_first, outcome.only_second))
        rows.append((_("The same"), outcome.both, outcome.both))
        if outcome.ties:
            rows.append((_("Ties"), outcome.ties, outcome.ties))
    return rows
