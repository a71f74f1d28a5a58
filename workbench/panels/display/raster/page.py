"""The page Raster: from the picture in the frame buffer to the beam, line by line and pixel by pixel."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QKeySequence, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from workbench.display.colour_table import table_fault
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.raster.bar import RasterBar
from workbench.panels.display.raster.buffer_dock import BufferDock
from workbench.panels.display.raster.derivation import derivation
from workbench.panels.display.raster.feed import RasterFeed
from workbench.panels.display.raster.mode_dock import ModeDock
from workbench.panels.display.raster.setting import PAGE, RasterSetting
from workbench.panels.display.raster.sums_dock import SumsDock
from workbench.panels.display.raster.system_view import SystemView
from workbench.panels.panel import DockPart, KeysWhileSeen, Said
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.subjects.raster import KIND
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.flow_layout import FlowArea
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.split import Split
from workbench.widgets.stepping.step_bar import stepping_key
from workbench.widgets.tube.raster_view import RasterView
from workbench.widgets.tube.timing_diagram import TimingDiagram

_LOW_PX, _NARROW_PX, _SIDE_PX = 400, 640, 12
_BEFORE_THE_END = Fraction(1, 4)
_CAUGHT = 0.62, 0.45
"""How far down the picture, and along the line, the beam is caught."""

_CAUGHT_SLOW = 20_000.0


class RasterPage(PlainPage, QWidget):
    """The tube and the system beside it, the timing below; ``hover_text``: what is said in passing."""

    hover_text = Signal(str)
    _due = Signal()
    _moved = Signal()

    usual = RasterSetting.usual
    example = "house"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.setting = RasterSetting(session)
        self._waiting = self._following = self._small = False
        self.tube, self.system, self.diagram = RasterView(), SystemView(), TimingDiagram()
        self.sums, self.mode = SumsDock(self.setting), ModeDock(self.setting)
        self.buffer = BufferDock(self.setting)
        self._actions = self._made_actions()
        self.bar = RasterBar(self.setting, self._actions)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        beside = Split(Qt.Orientation.Horizontal)
        for widget in (self.tube, self.system):
            beside.addWidget(widget)
            beside.setStretchFactor(beside.count() - 1, 1)
        beside.setSizes([1000, 900])
        whole = QVBoxLayout(self)
        whole.setContentsMargins(_SIDE_PX, 8, _SIDE_PX, 8)
        whole.setSpacing(8)
        self.strip = FlowArea(self.bar)
        whole.addWidget(self.strip)
        whole.addWidget(beside, 1)
        whole.addWidget(self.note)
        whole.addWidget(self.diagram)
        self.feed = RasterFeed(self.setting, self.tube, self.refresh_soon, self)
        KeysWhileSeen(self, self._actions)
        self.setFocusProxy(self.tube)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        self.path = self._action("path", _("Beam path"), "path", "Shift+P")
        self.path.setToolTip(_("Draw the lines and the retraces between them over the picture (Shift+P)"))
        self.path.setCheckable(True)
        self.path.toggled.connect(self.tube.show_path)
        self.shows_system = self._action("system", _("System"), "tree-structure", "Shift+S")
        self.shows_system.setToolTip(_("Show the raster-scan system beside the tube (Shift+S)"))
        self.shows_system.setCheckable(True)
        self.shows_system.setChecked(True)
        self.shows_system.toggled.connect(lambda _on: self._show_parts())
        self.caught = self._action("catch", _("Catch the beam"), "crosshair", "Shift+B")
        self.caught.setToolTip(_("Slow the tube down and stop the beam in the middle of a line (Shift+B)"))
        self.caught.triggered.connect(lambda _checked=False: self.catch_beam())
        self.pause = self._action("pause", _("Pause"), "pause", "Shift+Space")
        self.pause.setToolTip(_("Hold the tube's time, or let it run on (Shift+Space)"))
        self.pause.setCheckable(True)
        self.pause.triggered.connect(self._pause)
        actions = [self.pause, self.path, self.shows_system, self.caught]
        for view in (self.tube, self.system):
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            view.addActions(actions)
        return actions

    def _action(self, name: str, text: str, icon: str, key: str) -> QAction:
        action = QAction(text, self)
        action.setObjectName(f"raster.{name}")
        action.setShortcut(QKeySequence(key))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        set_icon(action, icon)
        self.addAction(action)
        return action

    def _connect(self) -> None:
        session = self.session
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, comfort.changed, session.ahead.arrived):
            told.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown):
            signal.connect(self._follow_soon)
        self._moved.connect(self._follow_run, Qt.ConnectionType.QueuedConnection)
        self.tube.advanced.connect(self._follow_beam)
        self.tube.probed.connect(self._probed)
        for dock in (self.sums, self.buffer):
            dock.said.connect(self.hover_text)

    def _show_parts(self) -> None:
        """Tube and system beside each other, or one of them where there is little room."""
        system = self.shows_system.isChecked()
        self.system.setVisible(system)
        self.tube.setVisible(not (system and self._small))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """On a small page names and legends go, and the system takes the place of the tube."""
        super().resizeEvent(event)
        small = event.size().height() < _LOW_PX
        if small != self._small:
            self._small = small
            self.diagram.be_low(small)
            self.shows_system.setChecked(not small)
            self._show_parts()
        self.bar.be_compact(small or event.size().width() < _NARROW_PX)
        self.strip.fit(event.size().width() - 2 * _SIDE_PX, event.size().height())

    # What Display asks of a page

    def docks(self) -> Sequence[DockPart]:
        """Exam sums, frame buffer, numbers of the mode."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (
            ("raster_sums", _("Exam sums"), self.sums, right),
            ("raster_buffer", _("Frame buffer"), self.buffer, right),
            ("raster_mode", _("Mode"), self.mode, right),
        )

    def commands(self) -> Sequence[QAction]:
        """Its switches, and the beam in mid-line."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The sums, the colour table, what is lost at each depth."""
        return [*self.sums.content(), *self.buffer.content()]

    def copy(self) -> bool:
        """Put the tube as it glows now on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.tube.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """The system with its numbers, the timing, and the sums."""
        self.sums.content()
        system = self.system
        return derivation(self.setting.scan, system.now, system.changed, self.sums.sums)

    # What is shown

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened."""
        docks = (self.sums, self.buffer, self.mode)
        if not self._waiting and (self.isVisible() or any(dock.isVisible() for dock in docks)):
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        for dock in (self.sums, self.buffer, self.mode):
            dock.refresh()
        if not self.isVisible():
            return
        self.bar.refresh()
        self.pause.setChecked(self.session.state.tube.paused)
        self.diagram.show_timing(self.setting.timing)
        self._follow_run()

    @property
    def _stepped(self) -> Mapping[str, Any]:
        """The variables of the text where the run stands; none before its first step."""
        run, state = self.session.run, self.session.state
        if state.workspace != PAGE or run.subject is None or run.subject.kind != KIND or not run.number:
            return {}
        call = run.own_call()
        return {} if call is None else call.variables

    def _follow_soon(self, *_arguments: object) -> None:
        """Follow the run when all that happens now has happened."""
        if not self._following and self.isVisible():
            self._following = True
            self._moved.emit()

    def _follow_run(self) -> None:
        """Hold the beam where the run stands, or let it run before the first step."""
        self._following = False
        scan, now = self.setting.scan, self._stepped
        if scan is None or "line" not in now:
            self.tube.hold_at(None)
            self._follow_beam()
            self._say()
            return
        timing = scan.timing
        if self.session.run.detail:
            clock = Fraction(int(now["clock"])) + Fraction(1, 2)
        else:
            line = timing.line_of_row(int(now["line"]))
            clock = line * timing.h_total + timing.h_active - _BEFORE_THE_END
        phase = clock % timing.clocks_per_frame / timing.pixel_clock_hz
        self.tube.hold_at(phase, int(now["y"]))
        self.system.show_numbers(scan, now, self.session.run.changed_names)
        if "y" in now:
            self.sums.address((int(now.get("x", 0)), int(now["y"])))
        self._place_beam(phase)
        self._say()

    def _place_beam(self, seconds: Fraction) -> None:
        """Show in the diagram where the beam is at a time."""
        scan = self.setting.scan
        if scan is not None:
            clocks = seconds * scan.timing.pixel_clock_hz % scan.timing.clocks_per_frame
            line, within = divmod(clocks, scan.timing.h_total)
            self.diagram.show_beam(int(line), float(within))

    def _follow_beam(self) -> None:
        """Show the numbers of the beam where it runs so slowly that it is seen."""
        if self.tube.held:
            return
        scan = self.setting.scan
        if scan is None or not self.tube.beam_is_seen:
            self.diagram.hide_beam()
            self.system.show_numbers(scan, {}, ())
            return
        seconds = self.tube.seconds()
        self._place_beam(seconds)
        moment = scan.at(scan.clock_at(seconds))
        now = {} if moment is None else moment._asdict()
        self.system.show_numbers(scan, now, now)

    def _say(self) -> None:
        words = []
        setting = self.setting
        if fault := table_fault(setting.scan.buffer.depth, setting.scan.buffer.table) if setting.scan else "":
            words.append(fault)
        if setting.mode.uncertain_fields:
            words.append(_("Some numbers of this mode are uncertain; the dock Mode names them."))
        tube = self.session.state.tube
        if self.tube.held:
            words.append(_("The beam is held at the step; go back to step 0 to let it run."))
        elif comfort.calm and tube.slow_motion > 1.0 and self.tube.averaged:
            words.append(_("Calm holds this still: slow the tube down further to see the beam."))
        if (said := " ".join(words)) != self.note.text():
            self.note.setText(said)  # it keeps its place when it is empty, so that the tube keeps its size

    # The hand

    def _pause(self, on: bool) -> None:
        self.session.update_state(tube=replace(self.session.state.tube, paused=on))

    def catch_beam(self) -> None:
        """Slow the tube down and stop it with the beam in the middle of a line, on a lit pixel."""
        scan = self.setting.scan
        if scan is None:
            return
        timing = scan.timing
        column, row = int(_CAUGHT[1] * timing.h_active), int(_CAUGHT[0] * timing.v_active)
        row = timing.v_active - 1 - row
        rows, columns = np.nonzero(scan.buffer.shown)
        if len(rows):  # where it is on
            nearest = int(np.argmin((rows - row) ** 2 + (columns - column) ** 2))
            column, row = int(columns[nearest]), int(rows[nearest])
        frames = int(self.tube.seconds() / timing.frame_s) + 1
        seconds = float(frames * timing.frame_s + timing.hit_s(column, row))
        tube = replace(self.session.state.tube, slow_motion=_CAUGHT_SLOW, paused=True, time_s=seconds)
        self.session.run.first()  # and not where it was going
        self.session.update_state(tube=tube, step=0)

    def _probed(self, x: int, y: int) -> None:
        """Go to the step that scans the row, in detail to the pixel; the sums tell its address."""
        scan, sheet = self.setting.scan, self.setting.sheet
        if scan is None:
            return
        timing, run = scan.timing, self.session.run
        column = (2 * x + 1) * timing.h_active // (2 * sheet.width_px)
        row = (2 * y + 1) * timing.v_active // (2 * sheet.height_px)
        self.sums.address((column, row))
        if run.detail:
            if not run.run_to_pixel(column, row):
                said = _("The beam is dark at ({x}, {y}), so nothing is emitted there.")
                self.hover_text.emit(said.format(x=column, y=row))
            return
        order = [r for field in range(timing.fields) for r in range(field, timing.v_active, timing.fields)]
        run.stay_at(order.index(timing.v_active - 1 - row) + 1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Home, End and Space are for the run."""
        do = stepping_key(self.session.run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()
