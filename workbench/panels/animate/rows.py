"""The tracks of a session as the timeline shows them."""

from functools import lru_cache
from itertools import pairwise

from workbench.document.model import Sheet
from workbench.document.motion.evaluation import loose
from workbench.document.motion.groups import packed
from workbench.document.motion.model import Key, Track
from workbench.document.motion.tracks import group_moved, motion_of
from workbench.language import _
from workbench.panels.animate.names import easing_titles, label_of, owners_of
from workbench.widgets.timeline.rows import KeyShown, Pace, TrackShown

_SLOW_LEAVING = ("ease_in", "ease_in_out", "ease_in_cubic", "ease_in_out_cubic", "spline")
_SLOW_ARRIVING = ("ease_out", "ease_in_out", "ease_out_cubic", "ease_in_out_cubic", "spline")
_SLOWER = 0.5


@lru_cache(maxsize=4)
def rows_of(sheet: Sheet) -> tuple[TrackShown, ...]:
    """The tracks of a sheet; they are the same in every frame."""
    astray, titles, owners = set(loose(sheet)), easing_titles(), owners_of(sheet)
    return tuple(
        _row(sheet, track, label_of(sheet, track.target, owners), track.target in astray, titles)
        for track in motion_of(sheet).tracks
    )


def _row(sheet: Sheet, track: Track, label: str, astray: bool, titles: dict[str, str]) -> TrackShown:
    keys = []
    before: Key | None = None
    for key, following in pairwise((*track.keys, None)):
        assert key is not None
        leaving = "none" if following is None else leaving_pace(key)
        arriving = "none" if before is None else arriving_pace(before)
        keys.append(KeyShown(key.id, key.frame, arriving, leaving, key.easing, titles[key.easing]))
        before = key
    group = group_moved(sheet, track)
    colours: tuple[str, ...] = ()
    if group is not None and group.kind == "colour":
        colours = tuple(f"#{packed(*key.value):06X}" for key in track.keys)
    problem = _("nothing there") if astray else ""
    return TrackShown(track.target, label, tuple(keys), colours, problem)


def leaving_pace(key: Key) -> Pace:
    """How fast the value moves just after a key."""
    if key.easing == "constant":
        return "held"
    if key.easing == "bezier":
        return "slow" if key.y1 < _SLOWER * key.x1 or key.x1 == key.y1 == 0.0 else "fast"
    return "slow" if key.easing in _SLOW_LEAVING else "fast"


def arriving_pace(before: Key) -> Pace:
    """How fast it moves just before the next key."""
    if before.easing == "constant":
        return "held"
    if before.easing == "bezier":
        return "slow" if 1.0 - before.y2 < _SLOWER * (1.0 - before.x2) else "fast"
    return "slow" if before.easing in _SLOW_ARRIVING else "fast"
