"""Every algorithm there is, in teaching order. A new one is its file and one line here."""

import difflib

from workbench.algorithms.circles import midpoint_circle, midpoint_ellipse
from workbench.algorithms.entry import Entry
from workbench.algorithms.lines import bresenham, dda, dda_fixed, dda_single, midpoint, wu
from workbench.algorithms.seed_fill import boundary_fill_4
from workbench.algorithms.visibility import depth_buffer

_ENTRIES: tuple[Entry, ...] = (
    dda.ENTRY,
    dda_single.ENTRY,
    dda_fixed.ENTRY,
    bresenham.ENTRY,
    midpoint.ENTRY,
    wu.ENTRY,
    midpoint_circle.ENTRY,
    midpoint_ellipse.ENTRY,
    boundary_fill_4.ENTRY,
    depth_buffer.ENTRY,
)

_BY_SLUG = {entry.slug: entry for entry in _ENTRIES}


def entries() -> tuple[Entry, ...]:
    """All entries, in teaching order."""
    return _ENTRIES


def topic(name: str) -> tuple[Entry, ...]:
    """The entries of one topic, in teaching order; none for a topic without algorithms."""
    return tuple(entry for entry in _ENTRIES if entry.topic == name)


def get(slug: str) -> Entry:
    """The entry named ``slug``.

    Raises:
        LookupError: there is none; the message names the nearest ones.
    """
    if slug in _BY_SLUG:
        return _BY_SLUG[slug]
    close = difflib.get_close_matches(slug, _BY_SLUG, n=3) or list(_BY_SLUG)
    raise LookupError(f"There is no algorithm named {slug!r}; did you mean {', '.join(close)}?")
