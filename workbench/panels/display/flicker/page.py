"""The page Flicker: refresh rate against phosphor, in numbers, over time, on a map, and on the tube."""

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from workbench.algorithms.marks import Spot
from workbench.display.flicker import (
    fusion_hz,
    in_closed_form,
    light_over_refresh,
    measured,
    zones,
)
from workbench.display.light_probe import ProbedLight, probed_light
from workbench.display.phosphor import Phosphor
from workbench.display.setup import too_many_pixels
from workbench.document.state import as_seen
from workbench.document.subjects import Argument, Position, Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.flicker.controls import FlickerControls
from workbench.panels.display.flicker.derivation import derivation
from workbench.panels.display.flicker.figures import column_at, moved_picture, moving
from workbench.panels.display.flicker.measures import MeasuresView
from workbench.panels.display.flicker.phosphor_table import PhosphorTable
from workbench.panels.panel import DockPart, KeysWhileSeen, Said
from workbench.panels.shared.lighting import Lighting
from workbench.panels.shared.tube_feed import picture_of
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.subjects.flicker import KIND, given, is_of_a_phosphor, number, phosphor_of, setup_of
from workbench.session.answers import Answers
from workbench.session.session import Session
from workbench.widgets.look.flash_warning import FlashWarning
from workbench.widgets.look.flow_layout import FlowArea
from workbench.widgets.look.split import Split
from workbench.widgets.plots.flicker_map import FlickerMap
from workbench.widgets.plots.light_plot import LightPlot, Trace
from workbench.widgets.tables.table_copies import put_on_clipboard
from workbench.widgets.tube.refusal import Refusal
from workbench.widgets.tube.view import TubeView

PAGE = "flicker"
_SAMPLES = 400
_REST_MS, _MOVE_MS = 150, 33
_LOW_PX, _SIDE_PX = 420, 12
_SHARES, _LOW_SHARES, _BESIDE_LOW = [560, 440], [640, 360], [360, 640]
_NOTHING = Trace(np.zeros(0), np.zeros(0))


class FlickerPage(PlainPage, QWidget):
    """Controls, the tube and the map, light over time and the numbers. ``image`` is what the tube shows."""

    hover_text = Signal(str)

    usual = Subject(KIND)
    example = "house"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.warning = FlashWarning()
        self.controls = FlickerControls()
        self.tube = TubeView("raster")
        self.refusal = Refusal(self.tube)
        self.map = FlickerMap()
        self.light = LightPlot()
        self.measures = MeasuresView((self.controls.steps, self.controls.periods))
        self.phosphors = PhosphorTable()
        self._probed: ProbedLight | None = None
        self._asked_for = 0
        self._measuring = Answers(self)
        self._measuring.arrived.connect(self._take_light)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._settle)
        self._moving = QTimer(self, interval=_MOVE_MS)
        self._moving.timeout.connect(self._move)
        self._lighting = Lighting(self._settle, self)
        self._column, self._held = -1, False
        self.image = np.zeros((1, 1), np.uint32)
        self._lay_out()
        self._copy_table = QAction(_("Copy the flicker measures"), self)
        self._copy_table.setObjectName("flicker.copy_measures")
        self._copy_table.triggered.connect(self._copy_measures)
        self.addAction(self._copy_table)
        KeysWhileSeen(self, [self._copy_table])
        self.tube.addAction(self._copy_table)
        self.tube.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._connect()
        self.setFocusProxy(self.tube)

    def _lay_out(self) -> None:
        above, below = Split(Qt.Orientation.Horizontal), Split(Qt.Orientation.Horizontal)
        for split, parts in ((above, (self.tube, self.map)), (below, (self.light, self.measures))):
            for part in parts:
                split.addWidget(part)
            split.setSizes([1000, 1000])
        both = Split(Qt.Orientation.Vertical)
        both.addWidget(above)
        both.addWidget(below)
        both.setSizes(_SHARES)
        self._above, self._both, self._low = above, both, False
        self.strip = FlowArea(self.controls)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(_SIDE_PX, 8, _SIDE_PX, 8)
        whole.setSpacing(6)
        whole.addWidget(self.strip)
        whole.addWidget(self.warning)
        whole.addWidget(both, 1)

    def _connect(self) -> None:
        session, run = self.session, self.session.run
        for told in (session.changed, session.state_changed):
            told.connect(self.refresh)
        for told in (run.changed, run.moved, run.grown):
            told.connect(self._show_steps)
        for grown in (session.unfolding.grown, session.ahead.arrived):
            grown.connect(self._rest.start)
        self.controls.changed.connect(self.change)
        self.controls.calm.flash_wanted.connect(lambda: self.warning.ask(number(self.subject, "refresh_hz")))
        self.controls.moves.toggled.connect(self._let_move)
        self.map.moved.connect(self._point_moved)
        self.map.held.connect(self._hold)
        self.tube.shown.connect(self.refresh)
        self.tube.probed.connect(lambda _x, _y: self._rest.start())
        self.phosphors.chosen.connect(lambda name: self.change({"phosphor": name}))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """On a low page the map needs the room that the tube cannot fill, and some of that below."""
        super().resizeEvent(event)
        self.strip.fit(event.size().width() - 2 * _SIDE_PX, event.size().height())
        low = event.size().height() < _LOW_PX
        if low != self._low:
            self._low = low
            self._both.setSizes(_LOW_SHARES if low else _SHARES)
            self._above.setSizes(_BESIDE_LOW if low else [1000, 1000])
            self.measures.be_low(low)

    # What the panel asks of a page

    def docks(self) -> Sequence[DockPart]:
        """The persistence of every phosphor."""
        return (("phosphors", _("Phosphors"), self.phosphors, Qt.DockWidgetArea.RightDockWidgetArea),)

    def commands(self) -> Sequence[QAction]:
        """Copies of its numbers."""
        return (self._copy_table,)

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The measures, and the persistence of every phosphor."""
        return (_("Flicker measures"), self.measures.table), (_("Phosphors"), self.phosphors.table)

    def derivation(self) -> Derivation:
        """Why it flickers or does not, as an answer in an exam."""
        subject = self.subject
        refresh_hz, luminance = setup_of(subject).refresh_hz, number(subject, "luminance")
        return derivation(phosphor_of(subject), refresh_hz, luminance, self.measures.table)

    def copy(self) -> bool:
        """Put the tube as it glows now on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.tube.grab())
        return True

    def _copy_measures(self) -> None:
        put_on_clipboard(self.measures.table)
        self.hover_text.emit(_("The flicker measures are on the clipboard."))

    # What is set

    @property
    def subject(self) -> Subject:
        """What this page steps, whether it is seen or not."""
        return self.session.state.positions.get(PAGE, Position(self.usual)).subject

    def change(self, changes: Mapping[str, Argument]) -> None:
        """Set some of its numbers."""
        subject = self.subject
        if self.session.state.workspace == PAGE:
            arguments = {**subject.arguments, **changes}
            self.session.update_state(subject=replace(subject, arguments=arguments))

    def _point_moved(self, refresh_hz: float, seconds: float) -> None:
        own = phosphor_of(replace(self.subject, arguments={**self.subject.arguments, "persistence": 1.0}))
        factor = min(max(seconds / own.t10_s, 0.01), 100.0)
        self.change({"refresh_hz": float(refresh_hz), "persistence": float(f"{factor:.4g}")})

    # What is shown

    def refresh(self, *_arguments: object) -> None:
        """Show the session as it is now: numbers at once, tube and light when a drag has come to rest."""
        if not self.isVisible():
            return
        subject = self.subject
        self.controls.show_subject(subject)
        setup, phosphor = setup_of(subject), phosphor_of(subject)
        luminance = number(subject, "luminance")
        own = phosphor.named(phosphor.name)
        formula = in_closed_form(phosphor, 1.0 / setup.refresh_hz)
        self._probed, self._asked_for = None, self._asked_for + 1
        self.measures.show_measures(formula, None, phosphor, setup.refresh_hz, luminance)
        self.map.show_map(
            zones(own, luminance),
            setup.refresh_hz,
            phosphor.t10_s,
            self._where(phosphor, setup.refresh_hz, luminance),
        )
        self.phosphors.mark(phosphor.name)
        if self.tube.driver is None:
            self._settle()
        elif not self._rest.isActive():
            self._rest.start()

    def _hold(self, on: bool) -> None:
        """While the point is dragged only the tube follows; run and light come when it is let go."""
        self._held = on
        self.session.hold_runs(on)
        self._rest.start()

    @staticmethod
    def _where(phosphor: Phosphor, refresh_hz: float, luminance: float) -> str:
        fusion = fusion_hz(phosphor, luminance)
        words = _("flickers") if refresh_hz < fusion else _("steady")
        return _("{words}: {rate:.4g} Hz, fuses from {fusion:.1f} Hz").format(
            words=words, rate=refresh_hz, fusion=fusion
        )

    def _settle(self) -> None:
        """Bring the tube up to date, and unless the point is held the light over time, and measure it."""
        self._rest.stop()
        if not self._held:
            self._show_light()
        subject, sheet = self.subject, self.session.shown
        size = sheet.width_px, sheet.height_px
        refused = too_many_pixels(size)
        self.refusal.say(refused)
        if refused or not self.isVisible():
            return
        self.tube.set_setup(setup_of(subject))
        if moving(str(given(subject, "figure"))):
            self._column = -1
            self._move()
        else:
            seen = as_seen(self.session.state, sheet)
            image = picture_of(self.session, seen, self._lighting.lit(sheet))
            if image is None:
                return
            self._put(image)
        self._probe_something()
        self._let_move()
        if not self._held:
            self._measure()

    def _put(self, image: NDArray[np.uint32]) -> None:
        """Put a frame buffer on the tube."""
        self.image = image
        self.tube.set_image(image)

    def _probe_something(self) -> None:
        """Measure a lit pixel near the middle until somebody chooses, or where a figure has left it dark."""
        probe, image = self.tube.probe, self.image
        if probe is None or (moving(str(given(self.subject, "figure"))) and not image[probe[1], probe[0]]):
            lit = self.tube.lit_pixel()
            if lit is not None:
                self.tube.set_probe(lit)

    def _let_move(self, *_on: object) -> None:
        """Run the figure while that is asked for and it is seen."""
        there = moving(str(given(self.subject, "figure"))) and self.tube.sight.now
        if there and self.controls.moves.isChecked():
            self._moving.start()
        else:
            self._moving.stop()

    def _move(self) -> None:
        subject, sheet = self.subject, self.session.shown
        if not self.isVisible():
            self._moving.stop()
            return
        size = sheet.width_px, sheet.height_px
        column = column_at(size, number(subject, "speed"), float(self.tube.seconds()))
        if column != self._column:
            self._column = column
            self._put(moved_picture(str(given(subject, "figure")), size, column))

    def _measure(self) -> None:
        """Ask for the light of the probed pixel, as the beam makes it."""
        pixel = self.tube.probe
        if pixel is None or (self.controls.moves.isChecked() and self._moving.isActive()):
            return
        self._asked_for += 1
        work = partial(probed_light, self.image, setup_of(self.subject), pixel)
        self._measuring.ask(partial(_numbered, self._asked_for, work), "flicker")

    def _take_light(self, answer: tuple[int, ProbedLight]) -> None:
        asked_for, light = answer
        if asked_for != self._asked_for or not self.isVisible():
            return
        self._probed = light
        subject = self.subject
        phosphor, setup = phosphor_of(subject), setup_of(subject)
        formula = in_closed_form(phosphor, 1.0 / setup.refresh_hz)
        seen = measured(*light)
        self.measures.show_measures(formula, seen, phosphor, setup.refresh_hz, number(subject, "luminance"))
        self._show_light()

    def _show_light(self) -> None:
        subject = self.subject
        phosphor, period = phosphor_of(subject), 1.0 / setup_of(subject).refresh_hz
        periods = int(number(subject, "periods"))
        once = light_over_refresh(phosphor, period, _SAMPLES)[:-1]
        formula = Trace(
            1e3 * np.concatenate([once[:, 0] + k * period for k in range(periods)]),
            np.tile(once[:, 1], periods),
        )
        dots, words = _NOTHING, _("{name}, {n} refreshes of {ms:.4g} ms")
        if self._probed is not None:
            mean = self._probed.energies.sum() / period
            if mean > 0.0:
                seconds, light = self._probed.seconds[:-1], self._probed.light[:-1] / mean
                dots = Trace(
                    1e3 * np.concatenate([seconds + k * period for k in range(periods)]),
                    np.tile(light, periods),
                )
            else:
                words = _("{name}, {n} refreshes of {ms:.4g} ms; the probed pixel is dark")
        said = words.format(name=phosphor.name, n=periods, ms=1e3 * period)
        self.light.show_light(formula, dots, [1e3 * k * period for k in range(periods + 1)], said)
        self._show_steps()

    def _show_steps(self) -> None:
        """Ring what the run has stepped."""
        run = self.session.run
        if not self.isVisible() or not is_of_a_phosphor(run.subject):
            self.light.show_steps(_NOTHING)
            return
        spots = [(mark.x, mark.y) for mark in run.marks() if isinstance(mark, Spot)]
        ms, light = np.array(spots, float).reshape(-1, 2).T
        self.light.show_steps(Trace(ms, light))


def _numbered(asked_for: int, work: partial[ProbedLight]) -> tuple[int, ProbedLight]:
    return asked_for, work()
