"""The dock This part: what the chosen part is for, its settings, and its numbers."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFormLayout, QLabel, QScrollArea, QSizePolicy, QVBoxLayout, QWidget

from workbench.display.cutaway import Part, parts_of
from workbench.display.gun import Gun
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.gun.parts import numbers_of, part_texts
from workbench.rendering.subjects.gun import NUMBERS, settings_of
from workbench.widgets.fields.number_field import NumberField, lowered


class PartDock(QScrollArea):
    """``edited`` sends the name of an argument and its value."""

    edited = Signal(str, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.part: Part = "grid"
        self._texts = part_texts()
        self._fields: dict[str, NumberField] = {}
        self._rows: list[tuple[str, str]] = []
        self.title, self.words = QLabel(), QLabel()
        self.title.setProperty("role", "title")
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.fields = QVBoxLayout()
        self.fields.setSpacing(6)
        self.numbers = QFormLayout()
        self.numbers.setHorizontalSpacing(8)
        self.numbers.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        inner = QWidget()
        self.column = column = QVBoxLayout(inner)
        column.setContentsMargins(12, 10, 12, 10)
        column.setSpacing(10)
        column.addWidget(self.title)
        column.addWidget(self.words)
        column.addLayout(self.fields)
        column.addLayout(self.numbers)
        column.addStretch(1)
        self.setWidget(inner)
        self.show_part(self.part, Gun())

    def show_part(self, part: str, gun: Gun) -> None:
        """Speak of another part, or of this one with other settings."""
        chosen = next((each for each in parts_of(gun) if each == part), self.part)
        if chosen not in parts_of(gun):
            chosen = parts_of(gun)[5]
        text = self._texts[chosen]
        if chosen != self.part or (not self._fields and text.settings):
            self.part = chosen
            self._offer(text.settings)
        self.title.setText(text.title)
        self.words.setText(lowered(text.words))
        self._make_room()
        settings = settings_of(gun)
        for name, field in self._fields.items():
            value = settings[name]
            assert isinstance(value, float)
            field.set_value(value)
        rows = numbers_of(chosen, gun)
        if [name for name, _value in rows] != [name for name, _value in self._rows]:
            while self.numbers.rowCount():
                self.numbers.removeRow(0)
            for name, value in rows:
                said = QLabel(value)
                said.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
                self.numbers.addRow(lowered(name), said)
        for row, (_name, value) in enumerate(rows):
            item = self.numbers.itemAt(row, QFormLayout.ItemRole.FieldRole)
            shown = None if item is None else item.widget()
            if isinstance(shown, QLabel):
                shown.setText(value)
        self._rows = rows

    def _make_room(self) -> None:
        """A layout knows no least height of words that wrap."""
        margins = self.column.contentsMargins()
        wide = self.viewport().width() - margins.left() - margins.right()
        self.words.setMinimumHeight(0)  # else it is at least as high as it was
        self.words.setMinimumHeight(max(self.words.heightForWidth(max(wide, 1)), 0))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The words wrap anew."""
        super().resizeEvent(event)
        self._make_room()

    def table(self, gun: Gun) -> Table:
        """The numbers of every part, for an answer or a report."""
        rows = [
            (self._texts[part].title, name, value)
            for part in parts_of(gun)
            for name, value in numbers_of(part, gun)
        ]
        return Table((_("part"), _("what"), _("value")), rows)

    def _offer(self, names: tuple[str, ...]) -> None:
        for field in self._fields.values():
            self.fields.removeWidget(field)
            field.hide()
            field.deleteLater()
        self._fields = {}
        for name in names:
            number = NUMBERS[name]
            symbol = f"{number.symbol}_{name[0]}" if name[:2] in ("x_", "y_") else number.symbol
            meaning = number.label[:1].upper() + number.label[1:]
            field = NumberField(symbol, number.unit, low=number.low, high=number.high, meaning=meaning)
            field.edited.connect(lambda value, n=name: self.edited.emit(n, value))
            field.scrubbed.connect(lambda value, n=name: self.edited.emit(n, value))
            field.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
            self._fields[name] = field
            self.fields.addWidget(field)
