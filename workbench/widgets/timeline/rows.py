"""What a timeline shows, as values: tracks with keys, how a value moves beside each key, and a curve."""

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Handles = tuple[float, float, float, float]
Pace = Literal["none", "fast", "slow", "held"]


class KeyShown(NamedTuple):
    """One key; ``arriving`` and ``leaving`` tell how fast the value moves just before and just after it.

    ``easing`` is the name of the one that leads to the next key, ``words`` what a person calls it.
    """

    id: str
    frame: int
    arriving: Pace
    leaving: Pace
    easing: str = ""
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


class CurveKey(NamedTuple):
    """A key on a curve: its values, and the handles of the easing to the next key, in parts of the way there.

    ``handles`` is None where there is nothing to bend.
    """

    id: str
    frame: int
    values: tuple[float, ...]
    handles: Handles | None = None


class CurveShown(NamedTuple):
    """The numbers of one track over the frames: their ``names``, the keys, and ``sampled``, which gives their
    values (n, numbers) at frames (n,).

    ``raised``: whether keys can be dragged in value; else ``note`` says why not.
    """

    names: tuple[str, ...] = ()
    keys: tuple[CurveKey, ...] = ()
    sampled: Callable[[Floats], Floats] = lambda frames: np.zeros((len(frames), 0))
    raised: bool = True
    note: str = ""
