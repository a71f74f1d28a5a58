"""How the time of every method grows with the pixels, or with the polygons, and the powers fitted to it."""

from collections.abc import Mapping

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.rendering.scene.growth import Growth
from workbench.rendering.scene.spaces import title_of
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.plots.growth_plot import GrowthCurve, GrowthPlot

PIXELS, POLYGONS = 0, 1


class GrowthDock(QWidget):
    """``seen``: it came in sight, so what it shows is to be measured."""

    seen = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.plot = GrowthPlot()
        self.what = QComboBox()
        self.what.addItem(_("Time by pixels"), PIXELS)
        self.what.addItem(_("Time by polygons"), POLYGONS)
        self.what.setAccessibleName(_("What grows"))
        self.what.setToolTip(_("The same polygons in more pixels, or the same picture of more polygons"))
        self.what.currentIndexChanged.connect(lambda _index: self._plot_growth())
        bar = QHBoxLayout()
        bar.setContentsMargins(8, 4, 8, 0)
        bar.addWidget(self.what)
        bar.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(bar)
        column.addWidget(self.plot, 1)
        self._growth: Mapping[str, Growth] = {}
        self._chosen = ""
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)

    def _come_in_sight(self, seen: bool) -> None:
        if seen:
            self._plot_growth()
            self.seen.emit()

    def show_growth(self, growth: Mapping[str, Growth], chosen: str) -> None:
        """Show what is measured by now; ``chosen`` is the method that is spoken of."""
        self._growth, self._chosen = growth, chosen
        if self.in_sight.now:
            self._plot_growth()

    def _plot_growth(self) -> None:
        which = self.what.currentData()
        unit = _("n polygons") if which == POLYGONS else _("n pixels")
        self.plot.show_curves(self._curves(which), unit, title_of(self._chosen) if self._chosen else "")

    def _curves(self, which: int) -> list[GrowthCurve]:
        return [
            GrowthCurve(
                title_of(method),
                growth.by_polygons if which == POLYGONS else growth.by_pixels,
                growth.exponents[which],
            )
            for method, growth in self._growth.items()
        ]

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of the tables of times, for export."""
        tables = []
        for which, title in ((PIXELS, _("Time by pixels")), (POLYGONS, _("Time by polygons"))):
            rows = [
                (curve.name, n, seconds * 1e3, curve.power)
                for curve in self._curves(which)
                for n, seconds in curve.points
            ]
            if rows:
                columns = _("method"), "n", _("ms"), _("power of n")
                tables.append((title, Table(columns, rows, formulas=False)))
        return tables
