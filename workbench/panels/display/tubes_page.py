"""The page Tubes: the picture on both tubes, with instruments, in real time or far slower."""

from fractions import Fraction
from functools import partial

from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from workbench.display.raster_beam import RasterBeam
from workbench.display.refresh_limit import longest_steady_s
from workbench.language import _
from workbench.panels.display.controls import DisplayControls
from workbench.panels.display.instruments import TubeInstruments
from workbench.panels.shared.tube_feed import TubeFeed
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering import unshown
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.flash_warning import FlashWarning
from workbench.widgets.look.flow_layout import FlowArea
from workbench.widgets.tube.view import TubeView

_SIDE_PX = 12
_MOST_STRIP, _MOST_INSTRUMENTS = 0.27, 0.26
_LOW_PX = 420


class TubesPage(PlainPage, QWidget):
    """Two tubes in the middle, controls above, instruments below; on a low page where they are asked for."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.controls = DisplayControls(session)
        self.raster, self.vector = TubeView("raster"), TubeView("vector")
        self.instruments = TubeInstruments()
        self.warning = FlashWarning()
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setWordWrap(True)
        self.note.hide()
        self.tubes = QHBoxLayout()
        self.tubes.setSpacing(12)
        self.tubes.addWidget(self.raster)
        self.tubes.addWidget(self.vector)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(_SIDE_PX, 8, _SIDE_PX, 8)
        whole.setSpacing(8)
        self.strip = FlowArea(self.controls, _MOST_STRIP)
        whole.addWidget(self.strip)
        whole.addWidget(self.warning)
        whole.addLayout(self.tubes, 1)
        whole.addWidget(self.note)
        whole.addWidget(self.instruments)
        self.feed = TubeFeed(session, [self.raster, self.vector], self)
        self.controls.stepped.connect(self._step)
        self.controls.instruments.toggled.connect(lambda _on: self._share_height())
        self.controls.calm.flash_wanted.connect(lambda: self.warning.ask(self._flash_hz()))
        for tube in (self.raster, self.vector):
            tube.probed.connect(lambda _x, _y, t=tube: self._watch(t))
            tube.advanced.connect(self._say)
        session.state_changed.connect(self._show_state)
        comfort.changed.connect(self._say)
        self.setFocusProxy(self.raster)
        self._said = ""
        self.raster.shown.connect(self._probe_something)
        self._show_state()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The strip has the rows that it needs; on a low page the instruments leave the tubes room."""
        super().resizeEvent(event)
        self._share_height()
        self.strip.fit(event.size().width() - 2 * _SIDE_PX, event.size().height())

    def _share_height(self) -> None:
        low = self.height() < _LOW_PX
        self.controls.instruments.setVisible(low)
        self.instruments.setMaximumHeight(int(_MOST_INSTRUMENTS * self.height()))
        self.instruments.setVisible(not low or self.controls.instruments.isChecked())

    def copy(self) -> bool:
        """Put the tube that is measured, as it glows now, on the clipboard."""
        QGuiApplication.clipboard().setPixmap((self.instruments.tube or self.raster).grab())
        return True

    def _show_state(self) -> None:
        shown = self.session.state.tube.shown
        self.raster.setVisible(shown != "vector")
        self.vector.setVisible(shown != "raster")
        watched = self.instruments.tube
        if watched is None or watched.isHidden():
            self.instruments.watch(self.vector if shown == "vector" else self.raster)
        self._say()

    def _probe_something(self) -> None:
        """Until somebody chooses, measure a lit pixel near the middle."""
        if self.raster.probe is None and self.vector.probe is None:
            lit = self.raster.lit_pixel()
            if lit is not None:
                self.raster.set_probe(lit)
                self.instruments.soon()

    def _watch(self, tube: TubeView) -> None:
        other = self.vector if tube is self.raster else self.raster
        other.set_probe(None)
        self.instruments.watch(tube)

    def _step(self, what: str) -> None:
        driver = self.raster.driver
        if driver is None or not isinstance(driver.beam, RasterBeam):
            return
        timing, now = driver.beam.timing, driver.tube.seconds
        unit = timing.line_s if what == "line" else timing.pixel_s
        step = (now // unit + 1) * unit - now
        for tube in (self.raster, self.vector):
            if not tube.isHidden():
                tube.step(Fraction(step))

    def _say(self) -> None:
        words = self._words()
        if words != self._said:
            self._said = words
            self.note.setText(words)
            self.note.setVisible(bool(words))
        self.controls.show_flicker(self._flicker())

    def _glowing(self) -> list[TubeView]:
        return [tube for tube in (self.raster, self.vector) if not tube.isHidden()]

    def _flash_hz(self) -> float:
        """How often a second the faster tube really flashes."""
        return max(tube.refresh_hz for tube in self._glowing()) / self.session.state.tube.slow_motion

    def _words(self) -> str:
        state = self.session.state.tube
        said = []
        if comfort.calm and state.slow_motion > 1.0 and any(tube.averaged for tube in self._glowing()):
            said.append(
                _(
                    "Calm holds this still: it would flash {rate:.3g} times a second. Slow the tube "
                    "down further to see the beam, or switch Calm off beside the flicker meter."
                ).format(rate=self._flash_hz())
            )
        if not self.vector.isHidden():
            sheet = self.session.sheet
            missing = self.session.ahead.of(sheet, "unshown", partial(unshown, sheet)) or ()
            said.extend(dict.fromkeys(sentence for _id, sentence in missing))
            if self.vector.refresh_hz < 0.999 * state.refresh_hz:
                said.append(
                    _(
                        "The display list takes {ms:.3g} ms, so the vector tube refreshes at {rate:.3g} Hz."
                    ).format(ms=1000.0 / self.vector.refresh_hz, rate=self.vector.refresh_hz)
                )
        return " ".join(said)

    def _flicker(self) -> str:
        tube = self.instruments.tube
        if tube is None or tube.driver is None:
            return ""
        fusion = 1.0 / longest_steady_s(tuple(tube.driver.tube.guns))
        words = _("flickers") if tube.refresh_hz < fusion else _("steady")
        said = _("{words}: {rate:.3g} Hz, fuses from {fusion:.1f} Hz").format(
            words=words, rate=tube.refresh_hz, fusion=fusion
        )
        held = comfort.calm and tube.refresh_hz < fusion
        return _("{said}; Calm holds it still").format(said=said) if held else said
