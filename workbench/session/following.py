"""Makes the runs of a session follow its subject, and keeps the lead's cursor in the session's state."""

from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import zip_longest
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer

from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import calls_of, compared, kind_of, own_entry, rivals
from workbench.session.ahead import is_large
from workbench.session.run import Run

if TYPE_CHECKING:
    from workbench.session.session import Session


class Following(QObject):
    """``lead`` runs the subject of ``session``, ``followers`` the same under other entries, step for step.

    Step, detail and asking first are the session's: what is switched on the lead is written into its state at
    once, and ``update`` makes the runs as the state is, whoever changed it last.
    """

    def __init__(self, session: "Session", lead: Run, followers: Sequence[Run]) -> None:
        super().__init__(session)
        self._session, self._lead, self._followers = session, lead, followers
        self._telling = False
        self._reached: tuple[str, int] | None = None
        lead.moved.connect(self._moved)
        lead.grown.connect(self._lock)
        lead.asked.connect(lambda: session.update_state(ask_first=lead.ask_first))
        session.ahead.arrived.connect(self.update)
        QTimer.singleShot(0, self.update)

    def begin_anew(self) -> None:
        """Another document is open: the step in its state is where its run stands."""
        self._reached = None

    def switch(self, stays: bool) -> None:
        """Ask first and count as the state says, at once: the lead is never otherwise than the state.

        Where the lead ``stays`` in its step, the state takes the number that this has as it counts now.
        """
        before, self._telling = self._telling, self._telling or not stays
        try:
            self._lead.set_ask_first(self._session.state.ask_first)
            self._lead.set_detail(self._session.state.detail)
        finally:
            self._telling = before

    def update(self) -> None:
        """Run what is to be run now; the session calls this before it tells what changed."""
        session, lead, subject = self._session, self._lead, self._session.subject
        calls = self._calls_ahead(subject)
        if calls is None:
            return
        before = lead.subject, lead.entry
        self._telling = True
        try:
            lead.before = cache(partial(kind_of(subject).before, session.sheet, subject))
            self._follow(lead, subject, calls)
            lead.landmarks = kind_of(subject).landmarks(session.sheet, subject)
            self.switch(stays=False)
            here = self._here
            if not subject.is_of(before[0]) or here != self._reached:
                lead.go_to_number(session.state.step)
            elif lead.entry is not before[1]:  # another text on the same figure begins at its start
                session.update_state(step=0)
                here = self._here
            self._reached = here  # and not where somebody who was told of it goes next
        finally:
            self._telling = False
        for follower, other in zip_longest(self._followers, self._compared(subject)):
            if other is None:
                follower.clear()
            else:
                self._follow(follower, other, self._calls(other))
        self._lock()

    def _sheet_of(self, subject: Subject) -> Sheet:
        """The sheet that a run of the subject is of."""
        return self._session.frames.seen if kind_of(subject).as_seen else self._session.sheet

    def _calls(self, subject: Subject) -> Callable[[], Sequence[Call]]:
        return partial(calls_of, self._sheet_of(subject), subject)

    def _calls_ahead(self, subject: Subject) -> Callable[[], Sequence[Call]] | None:
        """Gives the calls when they are asked for. None while those of all of a large sheet are worked on:
        ``update`` follows when they are there.
        """
        calls, sheet = self._calls(subject), self._sheet_of(subject)
        if not kind_of(subject).whole or not is_large(sheet):
            return calls
        there = self._session.ahead.of(sheet, "calls", calls, subject)
        return None if there is None else lambda: there

    def _follow(self, run: Run, subject: Subject, calls: Callable[[], Sequence[Call]]) -> None:
        sheet = self._sheet_of(subject)
        run.follow_unheld(subject, calls, (sheet.width_px, sheet.height_px))

    @property
    def _here(self) -> tuple[str, int]:
        """The workspace that is stepped in, and the step there."""
        return self._session.state.workspace, self._session.state.step

    def _compared(self, subject: Subject) -> list[Subject]:
        """What the followers run: what is compared of the subject, where the lead runs that itself."""
        sheet, slug, entry = self._session.sheet, self._session.state.compare, self._lead.entry
        itself = bool(slug) and entry is not None and entry.slug == own_entry(sheet, subject)
        return [replace(compared(subject), entry=slug)] if itself and slug in rivals(sheet, subject) else []

    def _moved(self) -> None:
        self._lock()
        lead = self._lead
        if self._reached is None or self._reached[0] != self._session.state.workspace:
            return  # what is entered has not its run yet: this is still the one before
        if not self._telling and lead.entry is not None and lead.target is not None:
            self._reached = self._session.state.workspace, lead.target
            self._session.update_state(step=lead.target, detail=lead.detail)

    def _lock(self) -> None:
        """Followers show as many steps as the lead, all of them when that is at its end."""
        followers = [follower for follower in self._followers if follower.entry is not None]
        step = self._lead.step if followers else None
        if step is None:
            return
        number = self._lead.passed + step.number
        for follower in followers:
            if follower.detail:
                follower.set_detail(False)
            follower.go(number if not self._lead.ended else follower.last_position)
