"""Auto-key: one function around any edit, which turns what the edit changes in a frame into keys there."""

from collections.abc import Collection, Iterable, Iterator
from typing import Any

from msgspec.structs import replace

from workbench.document.addresses import Address, changed, sheet_with
from workbench.document.building import Edit, checked, with_sheet
from workbench.document.laws import places_of
from workbench.document.model import AnyFigure, Document, Sheet
from workbench.document.motion.edits import with_key
from workbench.document.motion.evaluation import at
from workbench.document.motion.groups import (
    CAMERA,
    OUTLINE,
    WHOLE,
    group_of,
    read,
    value_of,
    written,
)
from workbench.document.motion.tracks import motion_of, track_on


@checked
def auto_key(edit: Edit, sheet: str, frame: int, new_tracks: bool = True) -> Edit:
    """``edit`` done to the sheet as it is in a frame: what has a track gets a key there.

    With ``new_tracks`` so does every other number that can be keyed; it has its old value in frame 0 then.
    What cannot be keyed changes in all frames. Raises: DocumentError, as the edit does.
    """

    def keyed(document: Document) -> Document:
        base = sheet_with(document, sheet)
        seen = at(base, frame)
        moved = with_sheet(document, seen)
        after = edit(moved)
        result = next((other for other in after.sheets if other.id == sheet), None)
        if result is None or (seen is base and not new_tracks):
            return after
        tracked = [track.target for track in motion_of(base).tracks]
        touched = {thing.id for thing in _changed_things(seen, result)}
        targets = [
            target for target in tracked if target.split("/")[0] in touched or target.startswith(CAMERA)
        ]
        if new_tracks:
            targets += _new_targets(result, changed(moved, after), tracked)
        done = with_sheet(after, _as_it_stands(base, seen, result, touched, targets))
        for target in targets:
            before, now = group_of(seen, target), group_of(result, target)
            if before is None or now is None or value_of(seen, before) == value_of(result, now):
                continue
            if track_on(base, target) is None and frame > 0:
                done = with_key(done, sheet, target, 0, value_of(seen, before))
            done = with_key(done, sheet, target, frame, value_of(result, now))
        return done

    return keyed


def _changed_things(seen: Sheet, result: Sheet) -> Iterator[Any]:
    known = {thing.id: thing for thing in seen.things}
    return (thing for thing in result.things if known.get(thing.id) is not thing)


def _as_it_stands(
    base: Sheet, seen: Sheet, result: Sheet, touched: Collection[str], targets: Iterable[str]
) -> Sheet:
    """``result`` with the numbers that tracks give as ``base`` has them."""
    own = {figure.id: figure for figure in base.figures}
    figures = tuple(figure if figure.id in touched else own[figure.id] for figure in result.figures)
    scene = base.scene if result.scene is seen.scene else result.scene
    result = replace(result, figures=figures, scene=scene)
    for target in targets:
        before, group = group_of(base, target), group_of(result, target)
        if before is None or group is None:
            continue
        if target.endswith(f"/{OUTLINE}"):
            result = _with_outline(base, seen, result, target.split("/")[0])
        elif len(before.slots) == len(group.slots):
            for slot, other in zip(group.slots, before.slots, strict=True):
                result = written(result, slot.path, read(base, other.path))
    return result if result.palette != seen.palette else _without_passing_colours(result, len(base.palette))


def _without_passing_colours(sheet: Sheet, own: int) -> Sheet:
    """``sheet`` with its ``own`` first colours, and of those of this frame alone what figures still use."""
    used = (getattr(figure, name) for figure in sheet.figures for name, _list in places_of(type(figure)))
    return replace(sheet, palette=sheet.palette[: max(own, max(used, default=0) + 1)])


def _with_outline(base: Sheet, seen: Sheet, result: Sheet, name: str) -> Sheet:
    """The points of a figure as the base has them; where the edit made or took away some, those it left."""
    was, is_now = _figure(seen, name), _figure(result, name)
    if [point.id for point in was.points_world] != [point.id for point in is_now.points_world]:
        return result
    kept = replace(is_now, points_world=_figure(base, name).points_world)
    return replace(result, figures=tuple(kept if each.id == name else each for each in result.figures))


def _figure(sheet: Sheet, name: str) -> AnyFigure:
    return next(figure for figure in sheet.figures if figure.id == name)


def _new_targets(result: Sheet, addresses: Iterable[Address], tracked: Iterable[str]) -> list[str]:
    """Targets of what changed on a sheet and has no track: of several points of a figure all of them."""
    covered = set(tracked)
    moved: dict[str, list[str]] = {}
    targets: dict[str, None] = {}
    for address in sorted(addresses):
        if address.sheet != result.id or address.attribute == WHOLE:
            continue
        target = "/".join(part for part in (address.figure, address.point, address.attribute) if part)
        if address.point.startswith("p") and address.attribute in ("x", "y", "z"):
            moved.setdefault(address.figure, []).append(address.point)
            continue
        if target.startswith(CAMERA):
            target = ".".join(target.split(".")[:3])
        if target not in covered and group_of(result, target) is not None:
            targets[target] = None
    for name, points in moved.items():
        several = len(set(points)) > 1 and group_of(result, f"{name}/{OUTLINE}") is not None
        for target in [f"{name}/{OUTLINE}"] if several else [f"{name}/{point}/{WHOLE}" for point in points]:
            if not {target, f"{name}/{OUTLINE}", f"{target[:-1]}x", f"{target[:-1]}y"} & covered:
                targets[target] = None
    return [*targets]
