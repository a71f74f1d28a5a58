"""Object space against image space: the course's table with numbers of this scene, and how time grows."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QSplitter, QVBoxLayout, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.space.feature_table import FeatureTable
from workbench.panels.space.in_sight import InSight
from workbench.rendering.scene.spaces import Measures, SpaceRow, space_rows, title_of
from workbench.widgets.plots.growth_plot import GrowthCurve, GrowthPlot

PIXELS, POLYGONS = 0, 1


class QuestionDock(QSplitter):
    """``seen``: it came in sight, so what it tells is to be measured; ``measure_wanted``: the button."""

    seen = Signal()
    measure_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Vertical, parent)
        self.setChildrenCollapsible(False)
        self.table = FeatureTable(
            _("Object space and image space"), _("Choose a row to read what has to be added to it")
        )
        self.table.currentCellChanged.connect(lambda *_cells: self._tell())
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setContentsMargins(10, 4, 10, 4)
        self.note.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        upper = QWidget()
        column = QVBoxLayout(upper)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.table, 1)
        column.addWidget(self.note)
        self.addWidget(upper)
        self.addWidget(self._lower())
        self.setStretchFactor(0, 3)
        self.setStretchFactor(1, 2)
        self.rows: tuple[SpaceRow, ...] = ()
        self._measures = Measures()
        self._chosen = ""
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)

    def _lower(self) -> QWidget:
        self.plot = GrowthPlot()
        self.what = QComboBox()
        self.what.addItem(_("Time by pixels"), PIXELS)
        self.what.addItem(_("Time by polygons"), POLYGONS)
        self.what.setAccessibleName(_("What grows"))
        self.what.setToolTip(_("The same polygons in more pixels, or the same picture of more polygons"))
        self.what.currentIndexChanged.connect(lambda _index: self._plot_growth())
        self.measure = QPushButton(_("Measure times"))
        self.measure.setToolTip(_("Time every method at ten times the width and height, and how that grows"))
        self.measure.clicked.connect(self.measure_wanted)
        bar = QHBoxLayout()
        bar.setContentsMargins(8, 4, 8, 0)
        bar.addWidget(self.what)
        bar.addStretch(1)
        bar.addWidget(self.measure)
        lower = QWidget()
        column = QVBoxLayout(lower)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(bar)
        column.addWidget(self.plot, 1)
        return lower

    def _come_in_sight(self, seen: bool) -> None:
        if seen:
            self._show()
            self.seen.emit()

    def show_measures(self, measures: Measures, chosen: str) -> None:
        """Show what is measured by now; ``chosen`` is the method that is spoken of."""
        self._measures, self._chosen = measures, chosen
        self.rows = space_rows(measures)
        if self.in_sight.now:
            self._show()

    def show_busy(self, busy: bool) -> None:
        """While it is measured the button rests."""
        self.measure.setEnabled(not busy)

    def _show(self) -> None:
        rows = [(row.feature, row.object_space, row.image_space) for row in self.rows]
        headings = ("", _("Object space"), _("Image space"))
        self.table.show_rows(headings, rows, [row.but for row in self.rows])
        if self.table.currentRow() < 0 and rows:
            self.table.setCurrentCell(0, 0)
        self._tell()
        self._plot_growth()

    def _tell(self) -> None:
        number = self.table.currentRow()
        but = self.rows[number].but if 0 <= number < len(self.rows) else ""
        self.note.setText(f"<b>{_('But:')}</b> {but}" if but else "")
        self.note.setVisible(bool(but))

    def _plot_growth(self) -> None:
        which = self.what.currentData()
        curves = [
            GrowthCurve(
                title_of(method),
                growth.by_polygons if which == POLYGONS else growth.by_pixels,
                growth.exponents[which],
            )
            for method, growth in self._measures.growth.items()
        ]
        unit = _("n polygons") if which == POLYGONS else _("n pixels")
        self.plot.show_curves(curves, unit, title_of(self._chosen) if self._chosen else "")

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of what can be exported."""
        columns = _("feature"), _("object space"), _("image space"), _("but")
        tables = [
            (_("Object space and image space"), Table(columns, [tuple(row) for row in self.rows], False))
        ]
        if (numbers := self.plot.numbers()) is not None:
            tables.append((_("Growth of the time"), numbers))
        return tables
