"""Kinds of curves over the same points, beside each other in numbers."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QPersistentModelIndex,
    QPointF,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QAction,
    QFont,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QTableView, QVBoxLayout, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.canvas.drawing import PATTERNS, Pattern, ink_of
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import code_font
from workbench.widgets.plots.parameter_axis import number_text
from workbench.widgets.tables.table_columns import DECORATION_PX, FittedColumns, WholeRows
from workbench.widgets.tables.table_copies import put_on_clipboard, rows_copied

Index = QModelIndex | QPersistentModelIndex
Value = float | bool | str | None
_PADDING_PX = 20
_SAMPLE_PX = 16


@dataclass(frozen=True, slots=True)
class Measure:
    """What is measured: a heading, its unit, what it means, and which of two numbers is the better one."""

    name: str
    unit: str = ""
    meaning: str = ""
    best: Literal["", "least", "greatest"] = ""


@dataclass(frozen=True, slots=True)
class Measured:
    """One kind of curve: its name, the ink and the pattern of its line on the canvas (ink "" when it is not
    there), a value for each measure. A truth is shown as a sign, None as a dash.
    """

    name: str
    ink: str
    values: tuple[Value, ...]
    pattern: Pattern = "solid"


def value_text(value: Value) -> str:
    """A value as it is read."""
    if value is None:
        return "\N{EN DASH}"
    if isinstance(value, bool):
        return f"\N{CHECK MARK} {_('yes')}" if value else f"\N{MULTIPLICATION SIGN} {_('no')}"
    return value if isinstance(value, str) else number_text(value)


def _line_sample(kind: Measured) -> QPixmap:
    """The line that stands for a kind on the canvas."""
    ratio = 2.0
    sample = QPixmap(round(_SAMPLE_PX * ratio), round(_SAMPLE_PX * ratio))
    sample.setDevicePixelRatio(ratio)
    sample.fill(Qt.GlobalColor.transparent)
    painter = QPainter(sample)
    ink = colour(ink_of(tokens(), kind.ink))
    painter.setPen(QPen(ink, 2, PATTERNS[kind.pattern], Qt.PenCapStyle.FlatCap))
    painter.drawLine(QPointF(0, _SAMPLE_PX / 2), QPointF(_SAMPLE_PX, _SAMPLE_PX / 2))
    painter.end()
    return sample


class MeasureModel(QAbstractTableModel):
    """Kinds as rows and measures as columns, or, in a narrow place, the other way round."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.measures: tuple[Measure, ...] = ()
        self.kinds: tuple[Measured, ...] = ()
        self.upright = False

    def take(self, measures: tuple[Measure, ...], kinds: tuple[Measured, ...]) -> None:
        """Show other values."""
        if (measures, kinds) == (self.measures, self.kinds):
            return
        before = self.rowCount(), self.columnCount(), self.measures, [kind.name for kind in self.kinds]
        after = measures, [kind.name for kind in kinds]
        if before[2:] == after:
            self.kinds = kinds
            self.dataChanged.emit(self.index(0, 0), self.index(before[0] - 1, before[1] - 1))
        else:
            self.beginResetModel()
            self.measures, self.kinds = measures, kinds
            self.endResetModel()

    def turn(self, upright: bool) -> None:
        """Kinds as columns (``upright``) or as rows."""
        if upright != self.upright:
            self.beginResetModel()
            self.upright = upright
            self.endResetModel()

    def _where(self, row: int, column: int) -> tuple[int, int]:
        """The number of the kind and of the measure."""
        return (column, row) if self.upright else (row, column)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Kinds, or measures."""
        return 0 if parent.isValid() else len(self.measures if self.upright else self.kinds)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Measures, or kinds."""
        return 0 if parent.isValid() else len(self.kinds if self.upright else self.measures)

    def headings(self) -> list[str]:
        """What is measured, with units."""
        return [self._measure_text(number) for number in range(len(self.measures))]

    def _measure_text(self, number: int) -> str:
        measure = self.measures[number]
        return f"{measure.name} ({measure.unit})" if measure.unit else measure.name

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The names of the kinds and of what is measured; those at the side stay while one scrolls."""
        across = orientation == Qt.Orientation.Horizontal
        if role == Qt.ItemDataRole.TextAlignmentRole:
            side = Qt.AlignmentFlag.AlignRight if across else Qt.AlignmentFlag.AlignLeft
            return side | Qt.AlignmentFlag.AlignVCenter
        if across == self.upright:
            return self._kind(section, role)
        if role == Qt.ItemDataRole.DisplayRole:
            return self._measure_text(section)
        return self.measures[section].meaning if role == Qt.ItemDataRole.ToolTipRole else None

    def _kind(self, number: int, role: int) -> Any:
        kind = self.kinds[number]
        if role == Qt.ItemDataRole.DisplayRole:
            return kind.name
        return _line_sample(kind) if role == Qt.ItemDataRole.DecorationRole and kind.ink else None

    def best(self, measure: int) -> set[int]:
        """The kinds with the best number of a measure; none when all are alike."""
        asked = self.measures[measure].best
        numbers = {
            k: kind.values[measure]
            for k, kind in enumerate(self.kinds)
            if isinstance(kind.values[measure], float) and kind.values[measure] == kind.values[measure]
        }
        if not asked or len(set(numbers.values())) < 2:
            return set()
        wanted = (min if asked == "least" else max)(numbers.values())  # type: ignore[type-var]
        return {k for k, value in numbers.items() if value == wanted}

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """A value; the best number of a measure is bold."""
        kind, measure = self._where(index.row(), index.column())
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.measures[measure].meaning or None
        if role == Qt.ItemDataRole.DisplayRole:
            return value_text(self.kinds[kind].values[measure])
        if role == Qt.ItemDataRole.FontRole:
            font = code_font(12)
            font.setWeight(QFont.Weight.Bold if kind in self.best(measure) else QFont.Weight.Normal)
            return font
        return None


class MeasureTable(QWidget):
    """``kind_activated`` sends the number of a kind double-clicked or entered, ``copied`` a sentence;
    ``example_wanted``: the button of the empty table was pressed.
    """

    kind_activated = Signal(int)
    copied = Signal(str)
    example_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = MeasureModel(self)
        self.view = QTableView()
        self.view.setModel(self.model)
        self.view.setAccessibleName(_("Curves compared"))
        self.view.setToolTip(_("The same points under each kind of curve; the best number of each is bold"))
        self.view.setShowGrid(False)
        self.view.setSelectionMode(QTableView.SelectionMode.SingleSelection)
        self.view.setEditTriggers(QTableView.EditTrigger.NoEditTriggers)
        self.view.setTabKeyNavigation(False)
        side = self.view.verticalHeader()
        side.setDefaultSectionSize(22)
        side.setHighlightSections(False)
        self.view.setCornerButtonEnabled(False)
        self.view.setItemDelegate(WholeRows(self.view))
        self.model.dataChanged.connect(FittedColumns(self.view).widen)
        self.copy_action = QAction(_("Copy table"), self)
        self.copy_action.setToolTip(_("Copy the comparison; it pastes as a table"))
        self.copy_action.triggered.connect(self.copy_all)
        self.view.addAction(self.copy_action)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.state = EmptyView(self.view, _("Select a curve to measure it beside other kinds."))
        self.state.wanted.connect(self.example_wanted)
        self.state.set_empty(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.state)
        self.setFocusProxy(self.view)
        self.view.activated.connect(lambda index: self.kind_activated.emit(self._kind_of(index)))
        for header, across in ((self.view.horizontalHeader(), True), (side, False)):
            header.sectionDoubleClicked.connect(partial(self._enter, across))
        theme.changed.connect(self._restyle)

    def _restyle(self) -> None:
        self.view.viewport().update()
        self.view.horizontalHeader().viewport().update()
        self.view.verticalHeader().viewport().update()
        self.update()

    def set_rows(self, measures: Sequence[Measure], kinds: Sequence[Measured], without: str = "") -> None:
        """Show these kinds, each with a value for every measure; without any the sentence ``without``."""
        if without:
            self.state.sentence.setText(without)
        self.model.take(tuple(measures), tuple(kinds))
        self.state.set_empty(not self.model.kinds)
        self._turn()

    def _kind_of(self, index: Index) -> int:
        return index.column() if self.model.upright else index.row()

    def _enter(self, across: bool, section: int) -> None:
        """A name was double-clicked: a kind, or what is measured."""
        if across == self.model.upright:
            self.kind_activated.emit(section)

    def _turn(self) -> None:
        """The way round that fits the place: kinds as rows, or as columns when they need less room."""
        metrics, model = self.view.horizontalHeader().fontMetrics(), self.model
        names = [
            metrics.horizontalAdvance(kind.name) + DECORATION_PX * bool(kind.ink) for kind in model.kinds
        ]
        headings = [metrics.horizontalAdvance(text) for text in model.headings()]
        across, upright = (
            max(first, default=0) + sum(rest) + _PADDING_PX * (1 + len(rest))
            for first, rest in ((names, headings), (headings, names))
        )
        model.turn(upright < across and across > self.width())
        behavior = QTableView.SelectionBehavior
        self.view.setSelectionBehavior(behavior.SelectColumns if model.upright else behavior.SelectRows)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the place."""
        super().resizeEvent(event)
        self._turn()

    def content(self) -> Table:
        """What it shows, one row for each curve."""
        return self._table(self.model.kinds)

    def copy(self) -> None:
        """Put the selected kind on the clipboard, or with none selected all of them."""
        chosen = {self._kind_of(cell) for cell in self.view.selectedIndexes()}
        self._copy([kind for k, kind in enumerate(self.model.kinds) if not chosen or k in chosen])

    def copy_all(self) -> None:
        """Put the whole table on the clipboard, as text with tabs and as HTML."""
        self._copy(self.model.kinds)

    def _table(self, kinds: Sequence[Measured]) -> Table:
        headings = (_("curve"), *self.model.headings())
        rows = [(kind.name, *map(value_text, kind.values)) for kind in kinds]
        return Table(headings, rows, formulas=False)

    def _copy(self, kinds: Sequence[Measured]) -> None:
        put_on_clipboard(self._table(kinds))
        self.copied.emit(rows_copied(len(kinds)))

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))
