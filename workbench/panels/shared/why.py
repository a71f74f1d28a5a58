"""Why this pixel? Every step that wrote, tested or refused it, with its numbers; a click goes there."""

import html
from functools import partial
from threading import Event

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QListWidgetItem, QWidget

from workbench.algorithms import catalogue
from workbench.document.model import Sheet
from workbench.document.state import FIGURES, SessionState
from workbench.document.subjects import Subject
from workbench.language import _, ngettext
from workbench.panels.panel import DockPart, PlainPanel
from workbench.panels.shared.pixel_list import PixelList, line
from workbench.panels.stage.card import kind_title
from workbench.rendering.why_steps import MOST, Abandoned, Answer, nothing_happened, why_steps
from workbench.session.answers import Answers
from workbench.session.session import Session
from workbench.widgets.look.icons import icon

_SETTLE_MS = 150
_PLACE = "why"
_ICONS = {"wrote": ("pencil-simple", "text"), "tested": ("eye", "muted"), "refused": ("x", "warn")}
_Looked = tuple[Event, list[Answer], str]


class WhyList(PixelList):
    """The list over a session; it follows the pixel asked about, and looks only while it is seen."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, _("What happened to the pixel"), parent)
        self._given_up = Event()
        self._asked: tuple[Sheet, tuple[int, int]] | None = None
        self.answers: list[Answer] = []
        self._settle = QTimer(self)
        self._settle.setSingleShot(True)
        self._settle.setInterval(_SETTLE_MS)
        self._settle.timeout.connect(self._look)
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)
        session.changed.connect(self._stale)
        session.state_changed.connect(self._state_changed)
        self._say_empty()

    @property
    def looking(self) -> bool:
        """Whether an answer is still awaited."""
        return self._settle.isActive() or not self.list.isEnabled()

    def _state_changed(self, old: SessionState, new: SessionState) -> None:
        pixel = new.asked(FIGURES)
        if pixel != old.asked(FIGURES) or new.sheet != old.sheet:
            if pixel is not None:
                self.come_forward()
            self._stale()

    def showEvent(self, event: QShowEvent) -> None:
        """Look when it is seen."""
        super().showEvent(event)
        self._stale()

    def _stale(self, *_arguments: object) -> None:
        pixel = self._session.state.asked(FIGURES)
        if pixel is None:
            self._given_up.set()
            self._say_empty()
        elif self.isVisible() and self._asked != (self._session.sheet, pixel):
            self.list.setEnabled(False)
            self._settle.start()

    def _say_empty(self) -> None:
        self._asked = None
        self._settle.stop()
        self.list.clear()
        self.list.setEnabled(True)
        self.answers = []
        self.caption.setText(_("Point at a pixel and press Y, or click one on the tube: why is it as it is?"))

    def _look(self) -> None:
        """Ask, on a thread of its own; an older question is given up."""
        session, pixel = self._session, self._session.state.asked(FIGURES)
        if pixel is None or not self.isVisible():
            return
        self._given_up.set()
        self._given_up, sheet = Event(), session.sheet
        self._asked = (sheet, pixel)
        self.caption.setText(_("({x}, {y}): looking…").format(x=pixel[0], y=pixel[1]))
        work = partial(_looked, self._given_up, sheet, pixel)
        self._answers.ask(work, "why this pixel", self._given_up.set)

    def _take(self, looked: _Looked) -> None:
        question, answers, said = looked
        if question is not self._given_up or self._asked is None:
            return
        sheet, (x, y) = self._asked
        self.answers = answers
        self.list.clear()
        self.list.setEnabled(True)
        if not answers:
            self.caption.setText(f"<b>({x}, {y})</b><br>" + html.escape(said).replace("\n", "<br>"))
            return
        count = len(answers)
        text = ngettext("{n} step reached it.", "{n} steps reached it.", count)
        if count == MOST:
            text = _("The last {n} steps that reached it.")
        self.caption.setText(f"<b>({x}, {y})</b> " + text.format(n=count))
        for answer in answers:
            self.list.addItem(self._item(sheet, answer))

    def _item(self, sheet: Sheet, answer: Answer) -> QListWidgetItem:
        figure = sheet.figures[answer.figure]
        title = _(catalogue.get(figure.drawn_with).title)
        verb = {"wrote": _("wrote it"), "tested": _("tested it"), "refused": _("refused it")}[answer.verb]
        if answer.stands:
            verb = _("wrote it, and its colour remains")
        where = _("Step {n}").format(n=answer.step) if answer.step else _("Before the first step")
        head = f"{where}: {figure.name or kind_title(figure)}, {title}, {verb}."
        text = f"{head}\n{answer.sentence}".strip()
        return line(icon(*_ICONS[answer.verb]), text, (answer.figure_id, answer.step), answer.stands)

    def go(self, item: QListWidgetItem) -> None:
        """Let the stepper show this step; in a place of its own where a run of another kind is stepped."""
        figure, step = item.data(Qt.ItemDataRole.UserRole)
        if any(known.id == figure for known in self._session.sheet.figures):
            self._session.update_state(active=figure)
            if not self._session.subject.is_of(Subject(ids=(figure,))):
                self._session.visit(_PLACE, Subject())
            self._session.update_state(step=step, detail=False)


def _looked(given_up: Event, sheet: Sheet, pixel: tuple[int, int]) -> _Looked | None:
    try:
        answers = why_steps(sheet, *pixel, given_up.is_set)
        return given_up, answers, "" if answers else nothing_happened(sheet, *pixel)
    except Abandoned:
        return None


class WhyPanel(PlainPanel):
    """The list as a dock of a workspace that has its own middle."""

    def __init__(self, session: Session) -> None:
        self.title = _("Why this pixel?")
        self.why = WhyList(session)

    @property
    def center(self) -> QWidget:
        """The dock's content."""
        return self.why

    def docks(self) -> list[DockPart]:
        """The list at the right."""
        return [("why", self.title, self.why, Qt.DockWidgetArea.RightDockWidgetArea)]
