"""The frame in which the current sheet is shown: chosen, played by a clock, and what an edit does in it."""

import math
from collections.abc import Callable
from time import perf_counter
from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from workbench.document.building import Edit
from workbench.document.model import AnyFigure, Sheet
from workbench.document.motion.auto_key import auto_key
from workbench.document.motion.evaluation import at
from workbench.document.motion.model import Motion
from workbench.document.motion.tracks import motion_of
from workbench.document.state import as_seen

if TYPE_CHECKING:
    from workbench.session.session import Session

Mode = Literal["once", "loop", "ping_pong"]
_TICK_MS = 8


class Frames(QObject):
    """The frames of the current sheet. ``played``: the clock was started or stopped. ``settled``: somebody
    went to a frame, or it stopped in one.

    ``mode`` says what comes after the last frame, ``speed`` how many times as fast as the rate says it plays.
    """

    played = Signal(bool)
    settled = Signal()

    def __init__(self, session: "Session", clock: Callable[[], float] = perf_counter) -> None:
        super().__init__(session)
        self._session, self._clock = session, clock
        self.mode: Mode = "loop"
        self.speed = 1.0
        self._since = (0.0, 0.0)
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(_TICK_MS)
        self._timer.timeout.connect(self.tick)
        session.opened.connect(self.stop)

    @property
    def motion(self) -> Motion:
        """That of the current sheet, or the one that it would begin with."""
        return motion_of(self._session.sheet)

    @property
    def count(self) -> int:
        """How many frames there are."""
        return self.motion.frames

    @property
    def number(self) -> int:
        """The frame that is shown, from 0."""
        return min(self._session.state.frames.get(self._session.sheet.id, 0), self.count - 1)

    @property
    def sheet(self) -> Sheet:
        """The current sheet in its frame; one without motion is the sheet itself."""
        sheet = self._session.sheet
        return sheet if sheet.motion is None else at(sheet, self.number)

    @property
    def seen(self) -> Sheet:
        """The current sheet in its frame, its scene from where one looks at it now."""
        return as_seen(self._session.state, self.sheet)

    @property
    def figure(self) -> AnyFigure | None:
        """The active figure as it is in the frame."""
        active = self._session.active_figure
        if active is None or self._session.sheet.motion is None:
            return active
        return next(figure for figure in self.sheet.figures if figure.id == active.id)

    def show(self, number: int) -> None:
        """Show a frame, or the nearest that there is; playing goes on from there."""
        self._put(number)
        self._since = self._clock(), float(self.number)
        self.settled.emit()

    def _put(self, number: int) -> None:
        session = self._session
        shown = min(max(number, 0), self.count - 1)
        session.update_state(frames={**session.state.frames, session.sheet.id: shown})

    def edited(self, edit: Edit) -> Edit:
        """``edit`` done to what is seen: what has a track gets a key in the frame that is shown.

        With auto-key on so does whatever else can have one.
        """
        session = self._session
        motion, new_tracks = session.sheet.motion, session.state.auto_key
        if not new_tracks and (motion is None or not motion.tracks):
            return edit
        return auto_key(edit, session.sheet.id, self.number, new_tracks)

    # Playing

    @property
    def playing(self) -> bool:
        """Whether the clock runs."""
        return self._timer.isActive()

    def play(self) -> None:
        """Play from the frame that is shown; from the last one, unless it goes round, from the first."""
        start = self.number
        if self.mode == "once" and start == self.count - 1:
            start = 0
        self._since = self._clock(), float(start)
        self._timer.start()
        self.played.emit(True)

    def stop(self) -> None:
        """Stay where it is."""
        if self.playing:
            self._timer.stop()
            self.played.emit(False)
            self.settled.emit()

    def toggle(self) -> None:
        """Play, or stop."""
        if self.playing:
            self.stop()
        else:
            self.play()

    def set_speed(self, speed: float) -> None:
        """Play so many times as fast, from the frame that is shown on."""
        self.speed = speed
        self._since = self._clock(), float(self.number)

    def tick(self) -> None:
        """Show the frame whose time it is."""
        began, first = self._since
        passed = first + (self._clock() - began) * self.motion.rate * self.speed
        if self.mode == "once" and passed >= self.count:
            self._put(self.count - 1)
            self.stop()
        else:
            self._put(frame_after(passed, self.count, self.mode))


def frame_after(passed: float, count: int, mode: Mode) -> int:
    """The frame that is shown when so many frames have passed since frame 0, of ``count``."""
    number = math.floor(passed)
    if mode == "ping_pong" and count > 1:
        number %= 2 * count - 2
        return min(number, 2 * count - 2 - number)
    return number % count if mode == "loop" else min(number, count - 1)
