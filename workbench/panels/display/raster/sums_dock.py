"""The dock of the exam sums: formula, numbers and result of each, for the mode or for numbers typed in."""

import re
from fractions import Fraction
from functools import partial
from html import escape

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFont, QGuiApplication
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from workbench.display import RasterTiming, raster_modes
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.raster.bar import mode_title
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.display.raster.sums import (
    Numbers,
    Pixel,
    Sum,
    fault_of,
    numbers_of,
    table_of,
    text_of,
    worked_out,
)
from workbench.panels.stage.card import number_field
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.subjects.raster import NUMBERS, SHEET, TYPED, depth_of
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.type_faces import keep_code_font
from workbench.widgets.tables.table_copies import put_on_clipboard

_FIELDS = ("sum_width", "sum_height", "sum_bits", "sum_hz", "sum_h_us", "sum_v_us")
_BITS, _LINE = "sum_bits", "sum_kbits"
_DIGITS = 4
_SMALL_PX = 11


_LEVEL = re.compile(r"([_^])(?:\{([^}]*)\}|(\w))")


def with_levels(formula: str) -> str:
    """A formula as rich text, with real sub- and superscripts."""

    def placed(match: re.Match[str]) -> str:
        tag = "sub" if match[1] == "_" else "sup"
        return f"<{tag}>{match[2] or match[3]}</{tag}>"

    return _LEVEL.sub(placed, escape(formula))


def _rounded(value: Fraction) -> float:
    """In as many digits as the results have."""
    return float(f"{float(value):.{_DIGITS}g}")


class SumsDock(QWidget):
    """``said``: what was copied."""

    said = Signal(str)

    def __init__(self, setting: RasterSetting, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self._pixel: Pixel = (0, 0)
        self.sums: list[Sum] = []
        self.source = ChoiceBox()
        self.source.setAccessibleName(_("Sums of"))
        self.source.setToolTip(
            _("Work the sums out for what the tube scans, for a mode, or for your own numbers")
        )
        tell_choice(self.source)
        self.source.activated.connect(lambda row: self._choose(self.source.itemData(row)))
        self.fields: dict[str, NumberField] = {}
        numbers = QWidget()
        flow = flowing(numbers, across=12, down=4)
        for name in (*_FIELDS, _LINE):
            number = NUMBERS[name]
            field = self.fields[name] = number_field(number, number.label.capitalize())
            give = partial(self._give, name)
            field.edited.connect(give)
            field.scrubbed.connect(give)
            flow.addWidget(field)
        self.fault = QLabel()
        self.fault.setProperty("role", "error")
        self.fault.setWordWrap(True)
        self.rows = QGridLayout()
        self.rows.setHorizontalSpacing(8)
        self.rows.setVerticalSpacing(0)
        self.rows.setColumnStretch(0, 1)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(10, 8, 10, 8)
        column.setSpacing(8)
        column.addWidget(self.source)
        column.addWidget(numbers)
        column.addWidget(self.fault)
        column.addLayout(self.rows)
        column.addStretch(1)
        area = QScrollArea()
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(body)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(area, 1)
        whole.addLayout(self._buttons())
        self._labels: list[tuple[QLabel, QLabel, QLabel]] = []
        self.in_sight = InSight(self)
        self.in_sight.follow(self.refresh)
        self._work_out()
        self._show_rows()  # to make them takes longer than to fill them anew when they are seen

    def _buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setContentsMargins(10, 4, 10, 8)
        for title, tip, do in (
            (_("Copy as text"), _("Put the sums on the clipboard as lines of text"), self.copy_text),
            (_("Copy as table"), _("Put the sums on the clipboard; they paste as a table"), self.copy_table),
        ):
            button = QPushButton(title)
            button.setToolTip(tip)
            button.setAccessibleName(title)
            button.clicked.connect(do)
            row.addWidget(button)
        row.addStretch(1)
        return row

    def copy_text(self) -> None:
        """Put the sums on the clipboard as text."""
        QGuiApplication.clipboard().setText(text_of(self.sums))
        self.said.emit(_("The sums are on the clipboard."))

    def copy_table(self) -> None:
        """Put the sums on the clipboard as a table."""
        put_on_clipboard(table_of(self.sums))
        self.said.emit(_("The sums are on the clipboard."))

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of the table, for export."""
        self._work_out()
        return [(_("Exam sums"), table_of(self.sums))] if self.sums else []

    def address(self, pixel: Pixel) -> None:
        """Tell the address of this pixel of the frame buffer."""
        if pixel != self._pixel:
            self._pixel = pixel
            self.refresh()

    def _choose(self, source: str) -> None:
        """Numbers of one's own begin with those that were worked out, in as many digits as are read."""
        if source != TYPED:
            self._setting.give(sums_typed=False, sum_mode=source)
            return
        numbers = self._of_the_mode()
        self._setting.give(
            sums_typed=True,
            sum_width=numbers.width,
            sum_height=numbers.height,
            sum_bits=numbers.bits,
            sum_hz=_rounded(numbers.refresh_hz),
            sum_h_us=_rounded(numbers.h_retrace_s * 10**6),
            sum_v_us=_rounded(numbers.v_retrace_s * 10**6),
        )

    def _give(self, name: str, value: float) -> None:
        self._setting.give(**{name: int(value) if NUMBERS[name].whole else float(value)})

    @property
    def _mode(self) -> str:
        """The mode that is chosen here; SHEET stands for what the tube scans."""
        mode = str(self._setting.value("sum_mode"))
        return mode if mode in raster_modes() else SHEET

    @property
    def _timing(self) -> RasterTiming:
        return self._scanned if self._mode == SHEET else RasterTiming.named(self._mode)

    @property
    def _scanned(self) -> RasterTiming:
        return self._setting.timing or self._setting.mode

    def _of_the_mode(self) -> Numbers:
        asked = self._mode != SHEET
        bits = int(self._setting.value(_BITS)) if asked else depth_of(self._setting.subject)
        return numbers_of(self._timing, bits, self._line, self._pixel)

    @property
    def _line(self) -> Fraction:
        return Fraction(str(self._setting.value(_LINE))) * 1000

    def _own(self) -> Numbers:
        value = self._setting.value
        h, v, hz = (Fraction(str(value(name))) for name in ("sum_h_us", "sum_v_us", "sum_hz"))
        counts = [int(value(name)) for name in ("sum_width", "sum_height", "sum_bits")]
        million = Fraction(1, 10**6)
        return Numbers(counts[0], counts[1], counts[2], hz, h * million, v * million, self._line, self._pixel)

    def _work_out(self) -> str:
        """Work the sums out; returns what is wrong with the numbers, "" where nothing is."""
        self.sums = []
        if self._setting.value("sums_typed"):
            numbers = self._own()
            self.sums = worked_out(numbers, None)
            return fault_of(numbers)
        fault = self._timing.fault or fault_of(self._of_the_mode())
        if not fault:
            self.sums = worked_out(self._of_the_mode(), self._timing)
        return fault

    def refresh(self) -> None:
        """Show the sums of the numbers that are set now; unseen, when it is seen."""
        if not self.in_sight.now:
            return
        own = bool(self._setting.value("sums_typed"))
        scanned = self._scanned
        tube = _("What the tube scans: {w} \u00d7 {h}").format(w=scanned.h_active, h=scanned.v_active)
        modes = [(name, mode_title(name)) for name in raster_modes()]
        choices = [(SHEET, tube), *modes, (TYPED, _("Numbers of my own"))]
        fill_choices(self.source, choices, TYPED if own else self._mode)
        for name, field in self.fields.items():
            field.setVisible(own or name == _LINE or (name == _BITS and self._mode != SHEET))
            field.set_value(float(self._setting.value(name)))
        fault = self._work_out()
        self.fault.setText(fault)
        self.fault.setVisible(bool(fault))
        self._show_rows()

    def _show_rows(self) -> None:
        while len(self._labels) < len(self.sums):
            self._add_row()
        for number, labels in enumerate(self._labels):
            there = number < len(self.sums)
            for label in labels:
                label.setVisible(there)
            if there:
                each = self.sums[number]
                title, result, numbers = labels
                title.setText(each.title)
                result.setText(each.result or "\N{EN DASH}")
                worked = with_levels(f"{each.formula} = {each.numbers}")
                numbers.setText(worked + escape(f": {each.fault}" if each.fault else ""))
                role = "error" if each.fault else "muted"
                if numbers.property("role") != role:
                    numbers.setProperty("role", role)
                    numbers.style().polish(numbers)

    def _add_row(self) -> None:
        title, result, numbers = QLabel(), QLabel(), QLabel()
        keep_code_font(result, 12, QFont.Weight.Bold)
        result.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom)
        keep_code_font(numbers, _SMALL_PX)
        numbers.setWordWrap(True)
        numbers.setTextFormat(Qt.TextFormat.RichText)
        numbers.setContentsMargins(0, 0, 0, 6)
        title.setWordWrap(True)
        row = 2 * len(self._labels)
        self.rows.addWidget(title, row, 0)
        self.rows.addWidget(result, row, 1)
        self.rows.addWidget(numbers, row + 1, 0, 1, 2)
        for label in (title, result, numbers):
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._labels.append((title, result, numbers))
