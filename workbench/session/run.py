"""The stepped run of one figure: recorded, with a cursor that plays by itself and can ask for each step."""

from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from workbench.session.cursor import Cursor

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
_FASTEST_TICK_MS = 33


class Run(Cursor):
    """A run as a person steps it.

    ``played``: playing began or ended. ``asked``: asking was switched, or an answer was counted.
    """

    played = Signal(bool)
    asked = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.ask_first = False
        self.right = 0
        self.wrong = 0
        self._speed = 4.0
        self._tick = QTimer(self)
        self._tick.timeout.connect(self._play_on)

    def _leaving(self, same: bool) -> None:
        self.pause()
        super()._leaving(same)
        if not same:
            self.right = self.wrong = 0

    def _furthest(self) -> int:
        if self.ask_first and not self.detail and self.questioned(self._seen + 1):
            return min(self.last_position, self._seen)
        return self.last_position

    # Playing

    @property
    def playing(self) -> bool:
        """Whether the cursor moves by itself."""
        return self._tick.isActive()

    @property
    def speed(self) -> float:
        """Steps a second."""
        return self._speed

    def set_speed(self, speed: float) -> None:
        """Set how many steps a second are played."""
        self._speed = speed
        self._tick.setInterval(max(round(1000 / speed), _FASTEST_TICK_MS))

    def play(self) -> None:
        """Play from here, at the end from the start."""
        if self.recording is None or self.playing:
            return
        if self._position >= self.last_position and self.done:
            self.first()
        self.set_speed(self._speed)
        self._tick.start()
        self.played.emit(True)

    def pause(self) -> None:
        """Stop playing."""
        if self.playing:
            self._tick.stop()
            self.played.emit(False)

    def toggle_play(self) -> None:
        """Play, or pause."""
        if self.playing:
            self.pause()
        else:
            self.play()

    def _play_on(self) -> None:
        before = self._position
        self.go(before + max(round(self._tick.interval() * self._speed / 1000), 1))
        if self._position == before and (self.done or self.waiting):
            self.pause()

    # Ask first

    def set_ask_first(self, ask: bool) -> None:
        """Show a step only after it was guessed, from here on."""
        if ask != self.ask_first:
            self.ask_first = ask
            self.right = self.wrong = 0
            self._seen = self._position if not self.detail else (self.step.number if self.step else 0)
            self.asked.emit()

    @property
    def tellable(self) -> int:
        """How many steps may be told: all that are recorded, or, asked first, those that were seen."""
        recorded = 0 if self.steps is None else len(self.steps)
        return min(recorded, self.seen) if self.ask_first else recorded

    def questioned(self, number: int) -> bool:
        """Whether step ``number`` has a pixel or a choice that can be asked for."""
        if self.steps is None or not 1 <= number <= len(self.steps):
            return False
        return bool(self.steps[number].options or self.steps[number].chosen)

    @property
    def waiting(self) -> bool:
        """Whether the next step is shown only after an answer."""
        return (
            self.ask_first
            and not self.detail
            and self._position == self._seen
            and self.questioned(self._seen + 1)
        )

    def answer(self, x: int, y: int) -> bool:
        """The pixel (x, y) is said to come next: show the step, tell whether that was right, and count."""
        if not self.waiting or self.options or self.steps is None:
            return False
        return self._answered((x, y) in self.steps[self._seen + 1].chosen)

    @property
    def options(self) -> tuple[Any, ...]:
        """What a person may choose from now; () when a pixel is asked for, or nothing."""
        return self.steps.options_next(self._seen) if self.waiting and self.steps is not None else ()

    def choose(self, option: Any) -> bool:
        """``option`` is said to come next: as ``answer``."""
        if option not in self.options or self.steps is None:
            return False
        return self._answered(option == self.steps[self._seen + 1].answer)

    def _answered(self, right: bool) -> bool:
        number = self._seen + 1
        self.right += right
        self.wrong += not right
        self._seen = number
        self._position = number
        self.moved.emit()
        self.asked.emit()
        return right
