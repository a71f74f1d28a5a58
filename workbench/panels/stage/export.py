"""What a panel gives to be taken out: its steps as pages, and the picture as it is."""

from collections.abc import Callable
from functools import partial
from typing import Any, Protocol

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.stage.pages import PICTURE_WIDTH, Pages, Paintable
from workbench.session.run import Run
from workbench.session.session import Session

MOST_PAGES = 500


def _here(do: Callable[[], Any]) -> Any:
    return do()


class ChangedError(ValueError):
    """What was being written is no longer what is open."""


class Stepped(Protocol):
    """What shows the steps of a run."""

    session: Session

    def stepped_run(self) -> Run | None:
        """The run whose steps it shows, if any."""

    def page(self, number: int | None, caption: str) -> Paintable:
        """What is seen now, or at one step of the run, over a sentence."""

    def grab_picture(self) -> QImage:
        """What is seen now, as it is seen."""


class Exporter(QObject):
    """Gets a picture out. ``said`` sends one sentence about what became of it.

    Pages are made by ``ask``, which may bring each to the interface from the thread that writes them.
    """

    said = Signal(str)

    def __init__(self, view: Stepped, owner: QWidget) -> None:
        super().__init__(owner)
        self._view = view
        self._owner = owner

    @property
    def steps(self) -> int:
        """How many steps of the run may be shown; 0 without a run."""
        run = self._view.stepped_run()
        return 0 if run is None else run.tellable

    @property
    def kept_back(self) -> bool:
        """Whether there are steps, and all of them are asked for first."""
        run = self._view.stepped_run()
        return run is not None and run.kept_back

    def page(self, number: int | None = None) -> Paintable:
        """What is seen now, or one step of the run, with its sentence."""
        run = self._view.stepped_run()
        steps = None if run is None else run.steps
        at = run.step if run is not None and number is None else None
        step = steps[number] if steps is not None and number is not None else at
        caption = "" if step is None else "".join(part.text for part in step.sentence)
        return self._view.page(number, caption)

    def this_step(self) -> Pages:
        """What the canvas shows now, as one page."""
        page = self.page()
        return Pages(1, lambda _number: page, self._view.session.sheet.name, self._owner.font())

    def this_run(
        self,
        ask: Callable[[Callable[[], Any]], Any] = _here,
        width: int = PICTURE_WIDTH,
        seconds: float = 1.0,
    ) -> Pages:
        """The picture before the first step and after each, at most ``MOST_PAGES``.

        A page raises ChangedError once the picture or the run is another one.
        """
        begun = self._what_is_shown()

        def page(number: int) -> Paintable:
            if self._what_is_shown() != begun:
                raise ChangedError(
                    _("The picture changed before all its steps were written, so nothing was written.")
                )
            return self.page(number)

        return Pages(
            min(self.steps + 1, MOST_PAGES),
            lambda number: ask(partial(page, number)),
            self._view.session.sheet.name,
            self._owner.font(),
            width,
            seconds,
        )

    def _what_is_shown(self) -> tuple[object, ...]:
        """What the pages of a run depend on."""
        session, run = self._view.session, self._view.stepped_run()
        recording = None if run is None else run.recording
        return session.revision, session.state.compare, session.subject, recording

    def copy_picture(self) -> None:
        """Put what the canvas shows on the clipboard."""
        QGuiApplication.clipboard().setImage(self._view.grab_picture())
        self.said.emit(_("The picture is on the clipboard."))
