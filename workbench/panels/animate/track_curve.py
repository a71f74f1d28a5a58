"""The numbers of a track over the frames, as the curve editor shows them."""

from functools import lru_cache, partial

from msgspec.structs import replace

from workbench.algorithms.animation.easings import NEAREST_HANDLES
from workbench.document.model import Sheet
from workbench.document.motion.evaluation import values_along
from workbench.document.motion.groups import Group
from workbench.document.motion.model import BEZIER_NAME, EASINGS, LINEAR, SPLINE, Key, Track
from workbench.document.motion.tracks import group_moved, track_on
from workbench.language import _
from workbench.widgets.timeline.rows import CurveKey, CurveShown, Handles


@lru_cache(maxsize=4)
def curve_of(sheet: Sheet, target: str) -> CurveShown:
    """The curve of the track on a target; without numbers where there is none to show."""
    track = track_on(sheet, target)
    group = None if track is None else group_moved(sheet, track)
    if track is None:
        return CurveShown()
    if group is None:
        return CurveShown(note=_("This track moves nothing: what it belongs to has been removed."))
    whole = group.kind in ("outline", "turn")
    drawn = _by_keys(track) if whole else track
    keys = tuple(
        CurveKey(own.id, own.frame, shown.value, _handles(own))
        for own, shown in zip(track.keys, drawn.keys, strict=True)
    )
    names = (_("from key to key"),) if whole else _names(group)
    return CurveShown(names, keys, partial(values_along, drawn), not whole)


def _by_keys(track: Track) -> Track:
    """The way of what is no number by itself: at key k it is k, and from there a part of the way to k + 1."""
    return replace(
        track,
        keys=tuple(
            replace(key, value=(float(k),), easing=LINEAR if key.easing == SPLINE else key.easing)
            for k, key in enumerate(track.keys)
        ),
    )


def _handles(key: Key) -> Handles | None:
    """The handles of a key's easing, of the Bézier easing that is nearest to it; None where none is near."""
    if key.easing in ("constant", SPLINE):
        return None
    return key.handles if key.easing == BEZIER_NAME else NEAREST_HANDLES[EASINGS.index(key.easing)]


def _names(group: Group) -> tuple[str, ...]:
    if group.kind == "colour":
        return _("red"), _("green"), _("blue")
    names = [slot.number.symbol or slot.number.label for slot in group.slots]
    if len(set(names)) == len(names):
        return tuple(names)
    return tuple(f"{name}{names[:place].count(name)}" for place, name in enumerate(names))
