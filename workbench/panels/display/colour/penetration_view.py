"""The beam-penetration tube: a display list whose colour is chosen by the accelerating voltage."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.colour.rgb_to_hsv import rgb_to_hsv
from workbench.display.colour_tube import as_levels
from workbench.display.penetration import (
    COLOURS,
    GREEN_LAYER,
    LEAST_KV,
    MOST_KV,
    RED_LAYER,
    STOPPED_KV,
    coded_layers,
    energy_left_kv,
    nearest_named,
    shares,
)
from workbench.display.setup import COLOUR_TUBE, DeviceStroke, TubeSetup
from workbench.document.subjects import Subject
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.display.colour.sliders import Coordinate, NumberSlider
from workbench.rendering.subjects.colour_model import given, number
from workbench.widgets.fields.number_field import complaint_label
from workbench.widgets.look.split import Split
from workbench.widgets.tables.structure_table import StructureModel
from workbench.widgets.tables.table_columns import FittedColumns
from workbench.widgets.tables.table_copies import CopiedTable
from workbench.widgets.tube.view import TubeView


def colour_title(name: str) -> str:
    """A colour of the tube."""
    return {"red": _("Red"), "orange": _("Orange"), "yellow": _("Yellow"), "green": _("Green")}[name]


def penetration_table(kilovolts: float) -> Table:
    """The four colours and the present voltage: what passes the red layer, and where the energy stays."""
    rows = [(colour_title(one.name), one.kilovolts) for one in COLOURS] + [(_("now"), kilovolts)]
    return Table(
        (_("colour"), "V, kV", _("left, keV"), _("red, %"), _("green, %")),
        [
            (
                name,
                volts,
                round(energy_left_kv(volts), 2),
                *(round(100.0 * part, 1) for part in shares(volts)),
            )
            for name, volts in rows
        ],
        formulas=False,
    )


class PenetrationView(QWidget):
    """``changed`` sends the arguments that a hand asks for."""

    changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tube = TubeView("vector")
        self.tube.set_setup(TubeSetup(COLOUR_TUBE))
        self.complaint = complaint_label()
        volts = Coordinate("V", _("Accelerating voltage"), MOST_KV, "kV", 0.1, LEAST_KV)
        self.volts = NumberSlider(volts, self.complaint)
        self.buttons = {one.name: QPushButton(colour_title(one.name)) for one in COLOURS}
        self.own = QCheckBox(_("Colours of the sheet"))
        self.own.setAccessibleName(self.own.text())
        self.own.setToolTip(
            _("Switch the voltage from stroke to stroke, to the colour of the tube nearest to its own")
        )
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.table = penetration_table(COLOURS[-1].kilovolts)
        self.rows = CopiedTable()
        self._model = StructureModel(self.rows)
        self._lay_out()
        self.volts.changed.connect(lambda value: self.changed.emit({"kilovolts": float(value)}))
        self.own.toggled.connect(lambda on: self.changed.emit({"by_stroke": bool(on)}))

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(8)
        head.addWidget(self.volts, 1)
        for one in COLOURS:
            button = self.buttons[one.name]
            button.setProperty("low", True)
            button.setToolTip(_("{kv:g} kV").format(kv=one.kilovolts))
            button.clicked.connect(
                lambda _on=False, kv=one.kilovolts: self.changed.emit({"kilovolts": kv, "by_stroke": False})
            )
            head.addWidget(button)
        head.addWidget(self.own)
        self.rows.setModel(self._model)
        self.rows.setAccessibleName(_("Where the energy of the beam stays"))
        self.rows.setToolTip(_("Where the energy of the beam stays, by accelerating voltage"))
        self.rows.setShowGrid(False)
        self.rows.setTabKeyNavigation(False)
        self.rows.verticalHeader().hide()
        self.rows.verticalHeader().setDefaultSectionSize(22)
        self.rows.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        FittedColumns(self.rows)
        beside = QWidget()
        column = QVBoxLayout(beside)
        column.setContentsMargins(8, 0, 0, 0)
        column.addWidget(self.words)
        column.addWidget(self.rows, 1)
        both = Split(Qt.Orientation.Horizontal)
        both.addWidget(self.tube)
        both.addWidget(beside)
        both.setSizes([1000, 1000])
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(6)
        whole.addLayout(head)
        whole.addWidget(self.complaint)
        whole.addWidget(both, 1)

    def show_subject(
        self, subject: Subject, strokes: Sequence[DeviceStroke], picture_px: tuple[int, int]
    ) -> None:
        """Draw the strokes at the voltage of the subject, or each at that of its own colour."""
        kilovolts, by_stroke = number(subject, "kilovolts"), bool(given(subject, "by_stroke"))
        self.volts.set_value(kilovolts)
        self.own.setChecked(by_stroke)
        self.table = penetration_table(kilovolts)
        self._model.take((self.table.columns, tuple(self.table.rows)))
        self.words.setText(words(kilovolts))
        gamma = self.tube.setup.gamma
        drawn = [
            (x0, y0, x1, y1, coded_layers(_kilovolts_of(colour) if by_stroke else kilovolts, gamma))
            for x0, y0, x1, y1, colour in strokes
        ]
        self.tube.set_strokes(drawn, picture_px)


def _kilovolts_of(packed: int) -> float:
    hue, saturation, _value = next(rgb_to_hsv(*as_levels(packed)))
    return nearest_named(hue, saturation).kilovolts


def words(kilovolts: float) -> str:
    """What happens to the electrons, in numbers."""
    red, green = (100.0 * share for share in shares(kilovolts))
    left = energy_left_kv(kilovolts)
    if left == 0.0:
        said = _("Electrons of {kv:.3g} keV stop in the red layer, which takes all up to {stop:g} keV: red.")
    else:
        said = _(
            "Electrons of {kv:.3g} keV pass the red layer with √({kv:.3g}² − {stop:g}²) = {left:.3g} keV "
            "left: {red:.0f} % of the energy glows red and {green:.0f} % green."
        )
    doubt = _(
        "The voltages are of the usual order, and {one} and {other} stand for the two layers: both "
        "uncertain. There is no blue and no white; a change of voltage takes time, so a "
        "list is sorted by colour."
    )
    told = said.format(kv=kilovolts, stop=STOPPED_KV, left=left, red=red, green=green)
    return f"{told} {doubt.format(one=RED_LAYER, other=GREEN_LAYER)}"
