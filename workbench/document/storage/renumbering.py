"""Ids from 1 again, where those of a file are so high that there would soon be no higher ones."""

from itertools import count

from msgspec.structs import replace

from workbench.document.addresses import highest
from workbench.document.building import with_ids, without_ids
from workbench.document.model import Document
from workbench.document.motion.tracks import with_new_ids
from workbench.document.scene.renaming import with_fresh_ids
from workbench.document.state import SessionState
from workbench.document.subjects import Position

_HIGHEST = 10**14
"""An id has at most 15 digits last; from here on there is still room for all the edits of a life."""


def with_room(document: Document, state: SessionState) -> tuple[Document, SessionState]:
    """Both as they are, or, where ids are too high, with new ones throughout."""
    if max(document.last_id, highest(document)) <= _HIGHEST:
        return document, state
    fresh = count(1)
    renamed: dict[str, str] = {}
    sheets = []
    for sheet in document.sheets:
        renamed[sheet.id] = f"s{next(fresh)}"
        figures = tuple(with_ids(without_ids(figure), fresh, fresh) for figure in sheet.figures)
        for old, new in zip(sheet.figures, figures, strict=True):
            renamed |= zip(old.ids, new.ids, strict=True)
        views = tuple(replace(view, id=f"v{next(fresh)}") for view in sheet.views)
        renamed |= {old.id: new.id for old, new in zip(sheet.views, views, strict=True)}
        scene = sheet.scene and with_fresh_ids(sheet.scene, lambda _thing: True, fresh)
        if sheet.scene and scene:
            for thing, renewed in zip(sheet.scene.things, scene.things, strict=True):
                renamed |= zip(thing.ids, renewed.ids, strict=True)
        motion = sheet.motion and with_new_ids(sheet.motion, renamed, fresh)
        lists = {"figures": figures, "views": views}
        sheets.append(replace(sheet, id=renamed[sheet.id], scene=scene, motion=motion, **lists))
    selection = tuple(renamed[figure] for figure in state.selection)
    named = {"sheet": renamed.get(state.sheet, ""), "active": renamed.get(state.active, "")}
    positions = {workspace: _renamed(there, renamed) for workspace, there in state.positions.items()}
    return Document(tuple(sheets)), replace(state, selection=selection, positions=positions, **named)


def _renamed(position: Position, renamed: dict[str, str]) -> Position:
    subject = position.subject
    ids = tuple(renamed.get(identity, identity) for identity in subject.ids)
    return replace(position, subject=replace(subject, ids=ids))
