"""Undo and redo show the sheet that they bring back; where the one seen goes, the one seen before it."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from workbench.document.model import Document
from workbench.session.undo import Step

if TYPE_CHECKING:
    from workbench.session.session import Session


class ShownSheets(QObject):
    """Follows which sheets of ``session`` are shown, the last one last."""

    def __init__(self, session: "Session") -> None:
        super().__init__(session)
        self._session = session
        self._shown = [session.sheet.id]
        session.opened.connect(self._remember)
        session.undo_stack.undone.connect(self._undone)
        session.undo_stack.redone.connect(self._redone)

    def _remember(self) -> None:
        now, there = self._session.sheet.id, {sheet.id for sheet in self._session.document.sheets}
        self._shown = [sheet for sheet in self._shown if sheet in there and sheet != now] + [now]

    def _undone(self, step: Step) -> None:
        self._went(step.new, step.old)

    def _redone(self, step: Step) -> None:
        self._went(step.old, step.new)

    def _went(self, before: Document, now: Document) -> None:
        known, there = ({sheet.id for sheet in document.sheets} for document in (before, now))
        back = [sheet.id for sheet in now.sheets if sheet.id not in known]
        if not back and self._shown[-1] not in there:
            back = [sheet for sheet in reversed(self._shown) if sheet in there] or [now.sheets[0].id]
        if back:
            self._session.show_sheet(back[0])
