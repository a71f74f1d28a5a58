"""The instruments beside the tubes: beam current, deflection, and the light of the probed pixel over time."""

import numpy as np
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QHBoxLayout, QWidget

from workbench.display.flicker import light_over_refresh
from workbench.display.raster_beam import RasterBeam
from workbench.display.vector_beam import VectorBeam
from workbench.display.waveforms import Waveforms, nearest_pass, waveforms
from workbench.language import _
from workbench.widgets.look.spans import span_text
from workbench.widgets.plots.trace_plot import TracePlot
from workbench.widgets.tube.view import TubeView

_REFRESH_MS = 90
_LINES_SHOWN = 2
_LIGHT_STEPS = 240


class TubeInstruments(QWidget):
    """Four small plots over one tube; ``watch`` says which."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.current = TracePlot(_("Beam current"), _("of full"), 1)
        self.across = TracePlot(_("Deflection x"), "mm", 0)
        self.up = TracePlot(_("Deflection y"), "mm", 0)
        self.light = TracePlot(_("Light at the probe"), _("× mean"), 2)
        self.current.setToolTip(_("The current that the gun sends now; zero while the beam is blanked."))
        self.across.setToolTip(
            _("Where the deflection points the beam sideways, from the middle of the face.")
        )
        self.up.setToolTip(_("Where the deflection points the beam upwards, from the middle of the face."))
        self.light.setToolTip(
            _("How the phosphor at the probed pixel flashes and decays from one refresh to the next.")
        )
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        for plot in self.plots():
            row.addWidget(plot)
        self._tube: TubeView | None = None
        self._due = QTimer(self)
        self._due.setSingleShot(True)
        self._due.setInterval(_REFRESH_MS)
        self._due.timeout.connect(self.refresh)

    def plots(self) -> tuple[TracePlot, ...]:
        """The plots from left to right."""
        return self.current, self.across, self.up, self.light

    def watch(self, tube: TubeView) -> None:
        """Show this tube from now on."""
        if self._tube is tube:
            return
        if self._tube is not None:
            self._tube.advanced.disconnect(self.soon)
            self._tube.probed.disconnect(self.soon)
        self._tube = tube
        tube.advanced.connect(self.soon)
        tube.probed.connect(self.soon)
        self.soon()

    @property
    def tube(self) -> TubeView | None:
        """The tube that is watched."""
        return self._tube

    def soon(self) -> None:
        """Refresh shortly; many calls make one."""
        if not self._due.isActive() and self.isVisible():
            self._due.start()

    def refresh(self) -> None:
        """Draw all four anew."""
        tube = self._tube
        if tube is None or tube.driver is None:
            return
        beam, size = tube.driver.beam, tube.driver.tube.size_mm
        now = tube.seconds()
        moving = not tube.averaged
        frame_start = now // beam.frame_s * beam.frame_s
        if isinstance(beam, RasterBeam):
            line = beam.timing.line_s
            start = now // line * line if moving else frame_start + beam.timing.v_active // 2 * line
            near = waveforms(beam, size, start, line * _LINES_SHOWN, 400)
            whole = waveforms(beam, size, frame_start, beam.frame_s)
            spans = _("{n} lines, {time}").format(n=_LINES_SHOWN, time=span_text(float(line) * _LINES_SHOWN))
        else:
            start = frame_start
            near = whole = waveforms(beam, size, frame_start, beam.frame_s, 320)
            spans = _("1 picture, {time}").format(time=span_text(float(beam.frame_s)))
        picture = _("1 picture, {time}").format(time=span_text(float(beam.frame_s)))
        at = float(now - start) if moving else None
        at_frame = float(now - frame_start) if moving else None
        half_x, half_y = size[0] / 2, size[1] / 2
        self._draw(self.current, near, near.current, (0.0, 1.0), spans, at)
        self._draw(self.across, near, near.x_mm, (-half_x, half_x), spans, at)
        self._draw(self.up, whole, whole.y_mm, (-half_y, half_y), picture, at_frame)
        self._draw_light(tube, beam, at_frame)

    @staticmethod
    def _draw(
        plot: TracePlot,
        over: Waveforms,
        values: np.ndarray,
        bounds: tuple[float, float],
        span: str,
        cursor: float | None,
    ) -> None:
        plot.show_curve(over.seconds.tolist(), values.tolist(), bounds, span, cursor)

    def _draw_light(self, tube: TubeView, beam: object, cursor: float | None) -> None:
        place, pixel = tube.probe_mm(), tube.probe
        if place is None or pixel is None or tube.driver is None:
            self.light.show_words(_("Click the glass to choose a pixel."))
            return
        period = tube.driver.beam.frame_s
        hit = self._hit_time(tube, beam, place, pixel)
        if hit is None:
            self.light.show_words(_("The beam is dark at ({x}, {y}).").format(x=pixel[0], y=pixel[1]))
            return
        # From hit to hit, cut where the picture begins
        after, light = light_over_refresh(tube.driver.tube.guns[0], float(period), _LIGHT_STEPS)[:-1].T
        seconds = np.mod(after + hit, float(period))
        order = np.argsort(seconds)
        seconds, light = seconds[order], light[order]
        span = _("({x}, {y}), 1 picture, {time}").format(
            x=pixel[0], y=pixel[1], time=span_text(float(period))
        )
        self.light.show_curve(seconds.tolist(), light.tolist(), (0.01, 100.0), span, cursor, logarithmic=True)

    @staticmethod
    def _hit_time(
        tube: TubeView, beam: object, place: tuple[float, float], pixel: tuple[int, int]
    ) -> float | None:
        if isinstance(beam, RasterBeam):
            if not beam.drive[:, pixel[1], pixel[0]].any():
                return None
            return float(beam.timing.hit_s(*pixel))
        if isinstance(beam, VectorBeam) and tube.driver is not None:
            pieces = [(p.begin, p.end, p.start_ps * 1e-12, p.duration_ps * 1e-12) for p in beam.pieces]
            when, distance = nearest_pass(place, pieces)
            return when if distance < 3.0 * tube.driver.tube.spot_mm else None
        return None
