"""What a timeline shows, as values: tracks with their keys, and how a value moves beside each key."""

from collections.abc import Mapping
from typing import Literal, NamedTuple

Pace = Literal["none", "fast", "slow", "held"]


class KeyShown(NamedTuple):
    """One key; ``arriving`` and ``leaving`` tell how fast the value moves just before and just after it."""

    id: str
    frame: int
    arriving: Pace
    leaving: Pace
    words: str = ""


class TrackShown(NamedTuple):
    """One track: what it moves, and its keys in their order.

    ``colours`` are those along the track, from its first key to its last, as #RRGGBB; none where it is no
    colour. A track that moves nothing says in ``problem`` why.
    """

    target: str
    label: str
    keys: tuple[KeyShown, ...]
    colours: tuple[str, ...] = ()
    problem: str = ""


class TimelineShown(NamedTuple):
    """All of it. ``reach`` is how many frames before and after the one that is shown are seen as ghosts.

    ``values`` has the value in the frame of each track that is seen, by its target.
    """

    tracks: tuple[TrackShown, ...] = ()
    frames: int = 1
    frame: int = 0
    reach: int = 0
    chosen: str = ""
    values: Mapping[str, str] = {}
