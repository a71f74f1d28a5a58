"""What no field of a motion can say by itself; each law gives the first fault as ``check`` does."""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from workbench.document.faults import Fault
from workbench.document.motion.model import Motion, Track
from workbench.language import _


def _in_order(track: Track, before: Track | None) -> Fault | None:
    if before is not None and before.keys is track.keys:
        return None
    for index, (key, following) in enumerate(pairwise(track.keys), 1):
        if following.frame <= key.frame:
            problem = _("is {frame}, not after {before}, the key before it; move one of them in time")
            return f"keys[{index}].frame", problem.format(frame=following.frame, before=key.frame)
    return None


def _one_each(motion: Motion, before: Motion | None) -> Fault | None:
    if before is not None and before.tracks is motion.tracks:
        return None
    known: set[str] = set()
    for index, track in enumerate(motion.tracks):
        if track.target in known:
            problem = _("is {target}, which another track has too; put all the keys into one track")
            return f"tracks[{index}].target", problem.format(target=track.target)
        known.add(track.target)
    return None


LAWS: dict[type, tuple[Callable[[Any, Any], Fault | None], ...]] = {
    Track: (_in_order,),
    Motion: (_one_each,),
}
