"""Whether ids are ids, and no two in a document the same; after an edit by the new ones alone."""

import re
from collections.abc import Iterable, Iterator
from itertools import chain
from operator import attrgetter
from typing import Any

from workbench.document.addresses import highest
from workbench.document.differences import between
from workbench.document.fields import parts_of
from workbench.document.model import Document, Sheet
from workbench.document.parts import number_of

_ID = re.compile(r"(?!.*[0-9]{16}$)[A-Za-z][A-Za-z0-9_-]{0,31}")


def all_ids(sheets: Iterable[Sheet]) -> Iterator[str]:
    """The ids of some sheets and of all that is on them."""
    for sheet in sheets:
        yield sheet.id
        yield from map(attrgetter("id"), sheet.views)
        yield from chain.from_iterable(map(attrgetter("ids"), sheet.things))


def are_ids(identities: Iterable[str]) -> bool:
    """Whether each is a letter and up to 31 letters, digits, - or _, at most 15 digits last."""
    return all(isinstance(identity, str) and _ID.fullmatch(identity) for identity in identities)


def ids_sound(document: Document) -> bool:
    """Whether all are ids, and none is there twice."""
    identities = list(all_ids(document.sheets))
    return are_ids(identities) and len(set(identities)) == len(identities)


def new_ids_sound(before: Document, document: Document) -> bool:
    """Whether all are ids, and none is there twice, where ``before`` is sound: looks at the new ones only."""
    gone: list[str] = []
    come: list[str] = []
    sheets = {sheet.id: sheet for sheet in before.sheets}
    for sheet in document.sheets:
        old = sheets.pop(sheet.id, None)
        if old is None:
            come += all_ids([sheet])
        elif old is not sheet:
            _exchanged(old.figures, sheet.figures, gone, come)
            if old.views is not sheet.views:
                gone += map(attrgetter("id"), old.views)
                come += map(attrgetter("id"), sheet.views)
            if old.scene is not sheet.scene:
                before_it, after_it = (each.scene.things if each.scene else () for each in (old, sheet))
                _exchanged(before_it, after_it, gone, come)
            if old.motion is not sheet.motion:
                old_tracks, tracks = (each.motion.tracks if each.motion else () for each in (old, sheet))
                _exchanged(old_tracks, tracks, gone, come)
    gone += all_ids(sheets.values())
    new = set(come).difference(gone)
    if len(set(come)) != len(come) or not are_ids(new):
        return False
    # Whatever ends in a higher number than every id of ``before`` is none of them.
    fresh = not new or min(map(number_of, new)) > highest(before)
    return fresh or new.isdisjoint(all_ids(before.sheets))


def _exchanged(old: tuple[Any, ...], new: tuple[Any, ...], gone: list[str], come: list[str]) -> None:
    """Add the ids of figures and their parts that only ``old`` has to ``gone``, those of ``new`` to ``come``.

    Ids that both have may be in both lists; what both share is in none.
    """
    start, old_end, new_end = between(old, new)
    before = {figure.id: figure for figure in old[start:old_end]}
    for figure in new[start:new_end]:
        other = before.pop(figure.id, None)
        if other is None:
            come += figure.ids
        elif other is not figure:
            old_parts, new_parts = other.parts, figure.parts
            first, old_part, new_part = between(old_parts, new_parts)
            gone += [part.id for part in old_parts[first:old_part]]
            come += [part.id for part in new_parts[first:new_part]]
    gone += chain.from_iterable(figure.ids for figure in before.values())


def ids(document: Document) -> Iterator[tuple[str, str]]:
    """(path, id) of everything in ``document`` that has an id."""
    return _ids_below("", document)


def _ids_below(above: str, holder: Any) -> Iterator[tuple[str, str]]:
    if isinstance(holder, Sheet):
        for name in ("scene", "motion"):
            if (inner := getattr(holder, name)) is not None:
                yield from _ids_below(f"{above}{name}.", inner)
    for name in parts_of(type(holder)):
        for index, part in enumerate(getattr(holder, name)):
            yield f"{above}{name}[{index}].id", part.id
            yield from _ids_below(f"{above}{name}[{index}].", part)
