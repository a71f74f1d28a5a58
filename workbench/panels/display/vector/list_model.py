"""The display list as rows of a table: one for each instruction, most of which can be typed into."""

from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.algorithms.numerals import decimal
from workbench.algorithms.scanning.operations import DRAW, JUMP, NAMES
from workbench.display.list_time import ListTime
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.rendering.display_program import DisplayProgram
from workbench.widgets.fields.arithmetic import evaluate
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.look.type_faces import cell_font
from workbench.widgets.tables.table_columns import ROOM_FOR

Index = QModelIndex | QPersistentModelIndex
COUNTER, OPERATION, X, Y, INTENSITY, COLOUR, TIME = range(7)
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class ListModel(QAbstractTableModel):
    """``edited`` sends the address, the column and the number typed; ``refused`` why it is none."""

    edited = Signal(int, int, float)
    refused = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.program: DisplayProgram | None = None
        self._time: ListTime | None = None
        self._palette: tuple[int, ...] = ()
        self._current = -1
        self.locked = ""
        self.columns = (
            _("PC"), _("instruction"), "x", "y", _("I %"), _("colour"), "t \N{MICRO SIGN}s",
        )  # fmt: skip

    def take(self, program: DisplayProgram, time: ListTime, palette: tuple[int, ...], locked: str) -> None:
        """Show a list with the times of its instructions; ``locked`` says why it cannot be changed."""
        self.locked = locked
        if program is self.program:
            self._time, self._palette = time, palette
            if len(program):
                self.dataChanged.emit(self.index(0, 0), self.index(len(program) - 1, TIME))
            return
        self.beginResetModel()
        self.program, self._time, self._palette = program, time, palette
        self.endResetModel()

    @property
    def current(self) -> int:
        """The address of the instruction that is run; -1 for none."""
        return self._current

    def mark(self, address: int) -> None:
        """Mark the instruction that is run."""
        before, self._current = self._current, address
        for row in {before, address}:
            if 0 <= row < self.rowCount():
                self.dataChanged.emit(self.index(row, 0), self.index(row, TIME))

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Instructions."""
        return 0 if parent.isValid() or self.program is None else len(self.program)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """What an instruction has."""
        return 0 if parent.isValid() else len(self.columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The headings."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return self.columns[section]
        if role == ROOM_FOR and section == COUNTER:
            return _marked(self.rowCount() - 1)
        return _RIGHT if role == Qt.ItemDataRole.TextAlignmentRole else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Places of all but the jump back, intensity and colour of strokes."""
        usual = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if self.locked or self.program is None:
            return usual
        operation = int(self.program.rows[index.row(), 0])
        typed = index.column() in (X, Y) and operation != JUMP
        typed |= index.column() in (INTENSITY, COLOUR) and operation == DRAW
        return usual | Qt.ItemFlag.ItemIsEditable if typed else usual

    def value(self, row: int, column: int) -> Any:
        """A number or a word; None where an instruction has none."""
        assert self.program is not None
        assert self._time is not None
        operation, x, y, intensity = self.program.rows[row].tolist()
        match column:
            case 0:
                return row
            case 1:
                return NAMES[int(operation)]
            case 2:
                return x if operation != JUMP else 0
            case 3:
                return y if operation != JUMP else None
            case 4:
                return round(100 * intensity, 1) if operation == DRAW else None
            case 5:
                return self._colour_number(row) if operation == DRAW else None
            case _:
                return int(self._time.each_ps[row]) * 1e-6

    def _packed(self, row: int) -> int:
        assert self.program is not None
        return int(self.program.strokes.colours[self.program.stroke_of[row]])

    def _colour_number(self, row: int) -> int | None:
        packed = self._packed(row)
        return self._palette.index(packed) if packed in self._palette else None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """One cell."""
        row, column = index.row(), index.column()
        if self.program is None:
            return None
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            value = self.value(row, column)
            if column == COUNTER and row == self._current:
                return _marked(row)
            return "" if value is None else value if isinstance(value, str) else decimal(value)
        now = tokens()
        match role:
            case Qt.ItemDataRole.TextAlignmentRole:
                return _LEFT if column == OPERATION else _RIGHT
            case Qt.ItemDataRole.DecorationRole if column == COLOUR and self.value(row, COLOUR) is not None:
                return QColor(f"#{self._packed(row):06X}")
            case Qt.ItemDataRole.BackgroundRole if row == self._current:
                return colour(now.selected)
            case Qt.ItemDataRole.ForegroundRole:
                return colour(now.text if int(self.program.rows[row, 0]) == DRAW else now.muted)
            case Qt.ItemDataRole.FontRole:
                return cell_font(row == self._current)
            case Qt.ItemDataRole.ToolTipRole if self.locked:
                return self.locked
        return None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Send what was typed; it is shown once the list has it."""
        if role != Qt.ItemDataRole.EditRole:
            return False
        text = str(value).strip().removesuffix("%")
        before = self.value(index.row(), index.column())
        if text == ("" if before is None else decimal(before)):
            return False
        try:
            number = evaluate(text)
        except ValueError as problem:
            self.refused.emit(str(problem))
            return False
        self.edited.emit(index.row(), index.column(), number)
        return True

    def content(self) -> Table:
        """The list as a table, every row of it."""
        rows = [
            tuple(self.value(row, column) for column in range(len(self.columns)))
            for row in range(self.rowCount())
        ]
        return Table(self.columns, rows, formulas=False)


def _marked(address: int) -> str:
    return f"\N{BLACK RIGHT-POINTING TRIANGLE} {address}"
