"""What stands above the tiles: ready scenes, the size of the pictures, the marks, and the measuring."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QPushButton, QSizePolicy, QWidget

from workbench.document.model import Sheet
from workbench.document.samples.arena import READY
from workbench.document.samples.examples import example
from workbench.language import _
from workbench.panels.space.visibility.card import COLUMNS
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.subjects.visibility import size_of
from workbench.widgets.fields.choice_box import ChoiceBox

_LEAST_LETTERS = 8


class ArenaBar(QWidget):
    """``scene_wanted`` sends the slug of an example, ``columns_wanted`` how wide the pictures are to be."""

    scene_wanted = Signal(str)
    columns_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.ready, self.size_box = ChoiceBox(_LEAST_LETTERS), QComboBox()
        self.ready.setAccessibleName(_("Ready scenes"))
        self.ready.setToolTip(_("Open a scene in which some methods are known to fail, and see why"))
        self.ready.setPlaceholderText(_("Ready scenes"))
        for number, slug in enumerate(READY):
            self.ready.addItem(example(slug).title, slug)
            self.ready.setItemData(number, example(slug).description, Qt.ItemDataRole.ToolTipRole)
        self.ready.setCurrentIndex(-1)
        self.ready.activated.connect(lambda k: self.scene_wanted.emit(self.ready.itemData(k)))
        self.size_box.setAccessibleName(_("Size of the pictures"))
        self.size_box.setToolTip(
            _("How many pixels a picture has; times are measured at ten times the width and height")
        )
        self.size_box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.size_box.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.size_box.activated.connect(lambda k: self.columns_wanted.emit(self.size_box.itemData(k)))
        self.marks = QCheckBox(_("Mark differences"))
        self.marks.setToolTip(_("Mark the pixels that show a different surface from ray casting"))
        self.marks.setChecked(True)
        self.measure = QPushButton()
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(8)
        for widget in (self.ready, self.size_box, self.marks):
            row.addWidget(widget)
        row.addStretch(1)
        row.addWidget(self.measure)
        self.show_busy(False)

    def show_sizes(self, sheet: Sheet, columns: int) -> None:
        """Offer the sizes that fit the sheet; ``columns`` is the present width."""
        sizes = {width: size_of(sheet, width) for width in sorted({*COLUMNS, columns})}
        choices = [(width, f"{width} × {height} px") for width, height in sizes.values()]
        fill_choices(self.size_box, choices, columns)

    def show_busy(self, busy: bool) -> None:
        """What the button does now."""
        self.measure.setText(_("Stop") if busy else _("Measure times"))
        self.measure.setToolTip(
            _("Stop measuring (Escape)")
            if busy
            else _("Time every method at ten times the width and height (Ctrl+M)")
        )
