"""The page Gun: a tube cut open beside its screen; everything on it can be turned, dragged and stepped."""

from collections.abc import Sequence
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QMenu, QVBoxLayout, QWidget

from workbench.display.cutaway import STEPS, Part
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.gun.bar import GunBar
from workbench.panels.display.gun.cards import GunCards
from workbench.panels.display.gun.monitor_card import MonitorCard
from workbench.panels.display.gun.paper import answer, drawing
from workbench.panels.display.gun.part_dock import PartDock
from workbench.panels.display.gun.presets import preset, presets
from workbench.panels.display.gun.setting import Setting
from workbench.panels.panel import DockPart, KeysWhileSeen, Said
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.subjects.gun import KIND, is_of_a_gun
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.split import Split
from workbench.widgets.stepping.step_bar import stepping_key
from workbench.widgets.tube.gun_view import GunView
from workbench.widgets.tube.steered_tube import SteeredTube


class GunPage(PlainPage, QWidget):
    """``hover_text``: what is said in passing."""

    hover_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.setting = Setting(session, self)
        self.bar = GunBar()
        self.drawing_view, self.tube = GunView(), SteeredTube()
        self.monitor = MonitorCard(session)
        self.cards = GunCards(self.monitor, self.bar.time)
        self.part = PartDock()
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setProperty("role", "muted")
        self.note.hide()
        self._waiting = False
        self._fault = ""
        self._step = 0
        self.beside = Split(Qt.Orientation.Horizontal)
        for widget, share in ((self.drawing_view, 66), (self.tube, 34)):
            self.beside.addWidget(widget)
            self.beside.setStretchFactor(self.beside.count() - 1, share)
        self.beside.setSizes([660, 340])
        whole = QVBoxLayout(self)
        whole.setContentsMargins(12, 4, 12, 8)
        whole.setSpacing(6)
        whole.addWidget(self.bar)
        whole.addWidget(self.beside, 1)
        whole.addWidget(self.note)
        whole.addWidget(self.cards)
        self.setFocusProxy(self.drawing_view)
        self._actions = self._made_actions()
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        """Every example as a command, and the labels."""
        made = []
        for each in presets():
            action = QAction(_("Gun: {title}").format(title=each.title), self)
            action.setObjectName(f"gun.{each.slug}")
            action.setToolTip(each.told)
            action.triggered.connect(lambda _on=False, slug=each.slug: self.take_preset(slug))
            made.append(action)
        self._labels = QAction(_("Labels in the drawing"), self)
        self._labels.setObjectName("gun.labels")
        self._labels.setCheckable(True)
        self._labels.setChecked(True)
        self._labels.toggled.connect(self.bar.labels.setChecked)
        self.bar.labels.toggled.connect(self._labels.setChecked)
        for view in (self.drawing_view, self.tube):
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            view.addActions([self._labels, *made])
        return [self._labels, *made]

    def _connect(self) -> None:
        session, setting = self.session, self.setting
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        session.state_changed.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved):
            signal.connect(self._take_step)
        setting.refused.connect(self._refuse)
        for part in (self.bar, self.cards, self.monitor):
            part.edited.connect(self._edit)
        self.part.edited.connect(lambda name, value: self._edit({name: value}))
        self.bar.preset_wanted.connect(self.take_preset)
        self.bar.labelled.connect(self.drawing_view.set_labelled)
        self.bar.paused.connect(self._pause)
        self.bar.slowed.connect(lambda factor: self._drive(slow_motion=factor))
        self.bar.moment_wanted.connect(self._go_to)
        self.drawing_view.part_chosen.connect(self._speak_of)
        self.drawing_view.lifted.connect(lambda y: self._steer(None, y))
        self.tube.moved.connect(self._steer)
        for view in (self.drawing_view, self.tube):
            view.held.connect(session.hold_runs)
        self.tube.advanced.connect(self._follow_tube)
        comfort.changed.connect(self.refresh_soon)

    # What Display asks of a page

    def docks(self) -> Sequence[DockPart]:
        """What the chosen part is for."""
        return (("gun_part", _("This part"), self.part, Qt.DockWidgetArea.RightDockWidgetArea),)

    def commands(self) -> Sequence[QAction]:
        """Its examples, and the labels."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The numbers of all parts."""
        return ((_("Parts of the tube"), self.part.table(self.setting.gun)),)

    def copy(self) -> bool:
        """Put drawing and screen on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.beside.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """How the tube works, as an answer in an exam."""
        return answer(self.setting.gun)

    def drawing(self) -> Derivation | None:
        """The tube cut open, with labels where they are on."""
        return drawing(self.setting.gun, self.bar.labels.isChecked())

    def offer_export(self, menu: QMenu) -> None:
        """Let the bar and the menus lead to what can be exported."""
        for view in (self.drawing_view, self.tube):
            view.addAction(menu.menuAction())
        for action in menu.actions():
            if action.objectName() == "export_tube":
                self.bar.save.clicked.connect(action.trigger)

    # The hand

    def _edit(self, changes: dict[str, Any]) -> None:
        self.setting.change(changes)

    def _refuse(self, fault: str) -> None:
        if fault != self._fault:
            self._fault = fault
            self.refresh_soon()

    def _steer(self, x: float | None, y: float | None) -> None:
        said = self.setting.steer(x, y)
        if said:
            self.hover_text.emit(said)

    def _speak_of(self, part: str) -> None:
        self.part.show_part(part, self.setting.gun)
        self.drawing_view.choose(part)
        words = self.part.title.text()
        self.hover_text.emit(_("{part}: the dock This part says what it is for.").format(part=words))

    def take_preset(self, slug: str) -> None:
        """Set the tube as an example has it; the run begins anew."""
        chosen = preset(slug)
        self._fault = ""
        self.session.update_state(subject=replace(self.usual, arguments=chosen.settings), step=0)
        self._drive(slow_motion=chosen.slow_motion, paused=False)
        self.setting.follow()
        self.hover_text.emit(chosen.told)

    def _drive(self, **changes: Any) -> None:
        self.session.update_state(tube=replace(self.session.state.tube, **changes))

    def _pause(self, on: bool) -> None:
        """Hold the tube's time; the steps are then those of the beam where it is."""
        gun = self.setting.gun
        if on and not self.tube.averaged:
            within = self.tube.seconds() % gun.period
            self.setting.change({"moment": round(1e3 * float(within), 6)})
        self._drive(paused=on)

    def _go_to(self, moment_ms: float) -> None:
        """Look at the beam at a time, and hold the tube there."""
        self.setting.change({"moment": moment_ms})
        if not self.session.state.tube.paused:
            self._drive(paused=True)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that drawing and screen left step the run."""
        do = stepping_key(self.session.run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    # Showing

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen."""
        if not self._waiting and (self.isVisible() or self.part.isVisible()):
            self._waiting = True
            self._due.emit()

    @property
    def _live_seconds(self) -> float | None:
        """The tube's time while it runs to be seen; None where the beam is drawn at the moment set."""
        running = not self.session.state.tube.paused and not self.tube.averaged
        return float(self.tube.seconds()) if self.setting.gun.swings and running else None

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        self.setting.follow()
        gun, tube = self.setting.gun, self.session.state.tube
        self._light_step()
        self.part.show_part(self.part.part, gun)
        if not self.isVisible():
            return
        self.bar.show_gun(gun, tube)
        self.monitor.show_gun(gun)
        self.tube.set_slow_motion(tube.slow_motion)
        self.tube.set_paused(tube.paused)
        self.tube.show_gun(gun, None)  # whether it runs to be seen depends on its inputs
        self._show_beam()
        self._say()

    def _show_beam(self) -> None:
        """Drawing, spot and arithmetic at the time that is looked at."""
        gun, seconds = self.setting.gun, self._live_seconds
        way = gun.way(seconds)
        lit: tuple[Part, ...] = STEPS[self._step - 1] if 0 < self._step <= len(STEPS) else ()
        self.drawing_view.show_gun(gun, way, lit, seconds)
        reached = way[-1][0] >= gun.screen
        self.tube.show_gun(gun, way[-1] if reached else None)
        self.cards.show_gun(gun, seconds)

    def _follow_tube(self) -> None:
        if self._live_seconds is not None and not self._waiting and self.isVisible():
            self._show_beam()

    @property
    def _stepped(self) -> int:
        """The number of the step, 0 where no beam is stepped."""
        return self.session.run.number if is_of_a_gun(self.session.state.subject) else 0

    def _take_step(self, *_arguments: object) -> None:
        """A run tells no more than its step: one made anew under a drag shows nothing else."""
        if self._stepped != self._step:
            self.refresh_soon()

    def _light_step(self) -> None:
        """Mark the part that the step is about, and speak of it where the step is another."""
        step = self._stepped
        if step != self._step:
            self._step = step
            if 0 < step <= len(STEPS):
                bent = 2 if self.setting.gun.coils and step == 5 else 0
                part = STEPS[step - 1][-1 if step == 1 else bent]
                self.part.show_part(part, self.setting.gun)
                self.drawing_view.choose("")
            self.cards.light(step)

    def _say(self) -> None:
        gun = self.setting.gun
        words = self._fault
        if not words and gun.swings and self._live_seconds is not None:
            words = _("The steps are those of t = {t:g} ms; pause to step the beam where it is.").format(
                t=gun.moment
            )
        elif not words and gun.swings and self.tube.averaged:
            words = _(
                "Calm holds the figure still; it would be drawn {rate:.3g} times a second. Make it slower to "
                "see the spot run."
            ).format(rate=self.tube.refresh_hz / max(self.session.state.tube.slow_motion, 1.0))
        role = "error" if self._fault else "muted"
        if self.note.property("role") != role:
            self.note.setProperty("role", role)
            self.note.style().polish(self.note)
        self.note.setText(words)
        self.note.setVisible(bool(words))

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()
