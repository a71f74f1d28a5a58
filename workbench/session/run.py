"""The stepped run of one subject: recorded, with a cursor that plays by itself and can ask for each step."""

from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from workbench.session.asking import Answer, Verdict, verdict
from workbench.session.cursor import Cursor

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
_FASTEST_TICK_MS = 33


class Run(Cursor):
    """A run as a person steps it.

    ``played``: playing began or ended. ``asked``: asking was switched, or an answer was given or let go.
    ``landmarks`` are steps with which a part of it begins; without any the decisions tell where it turns.
    """

    played = Signal(bool)
    asked = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.landmarks: tuple[int, ...] = ()
        self.ask_first = False
        self.right = 0
        self.wrong = 0
        self.answered: Answer | None = None
        self._scored: set[int] = set()
        self.moved.connect(self._leave_answer)
        self._speed = 4.0
        self._tick = QTimer(self)
        self._tick.timeout.connect(self._play_on)

    def _leaving(self, same: bool) -> None:
        self.pause()
        super()._leaving(same)
        self.answered = None
        if not same:
            self._begin_score()

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
            self.answered = None
            self._begin_score()
            self._seen = self._position if not self.detail else (self.step.number if self.step else 0)
            self.asked.emit()

    @property
    def tellable(self) -> int:
        """How many steps may be told: all that are recorded, or, asked first, those that were seen."""
        recorded = 0 if self.steps is None else len(self.steps)
        return min(recorded, self.seen) if self.ask_first else recorded

    @property
    def kept_back(self) -> bool:
        """Whether steps are recorded, and none may be told before the first answer."""
        return self.ask_first and bool(self.steps) and not self.tellable

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
        """The pixel (x, y) is said to come next; tell whether that is right, which shows the step.

        A wrong answer can be followed by another, by ``try_again`` or by ``show_answer``. Only the first to a
        step is counted, and none that lies far from all pixels in question.
        """
        if not self.waiting or self.options or self.steps is None:
            return False
        return self._take_answer((x, y), verdict(self.steps[self._seen + 1], x, y))

    @property
    def options(self) -> tuple[Any, ...]:
        """What a person may choose from now; () when a pixel is asked for, or nothing."""
        return self.steps.options_next(self._seen) if self.waiting and self.steps is not None else ()

    def choose(self, option: object) -> bool:
        """``option`` is said to come next: as ``answer``."""
        if option not in self.options or self.steps is None:
            return False
        right = option == self.steps[self._seen + 1].answer
        return self._take_answer(option, "right" if right else "wrong")

    @property
    def refused(self) -> bool:
        """Whether a wrong answer stands, to be tried again or shown."""
        return self.answered is not None and self.answered.verdict == "wrong"

    def try_again(self) -> None:
        """Take a wrong answer away and ask anew."""
        if self.refused:
            self.answered = None
            self.asked.emit()

    def show_answer(self) -> None:
        """After a wrong answer, show the step that was asked for."""
        if self.refused:
            self.answered = None
            self._show_asked()
            self.asked.emit()

    def _begin_score(self) -> None:
        self.right = self.wrong = 0
        self._scored.clear()

    def _take_answer(self, given: object, worth: Verdict) -> bool:
        number = self.passed + self._seen + 1
        if worth != "far" and number not in self._scored:
            self._scored.add(number)
            self.right += worth == "right"
            self.wrong += worth == "wrong"
        if worth == "right":
            self.answered = Answer(given, worth, number)
            self._show_asked()
        else:
            self.answered = Answer(given, worth, number - 1)
        self.asked.emit()
        return worth == "right"

    def _show_asked(self) -> None:
        self._seen += 1
        self._position = self._seen
        self.moved.emit()

    def _leave_answer(self) -> None:
        """An answer stands as long as the cursor does."""
        if self.answered is not None and (self.detail or self.number != self.answered.number):
            self.answered = None
            self.asked.emit()
