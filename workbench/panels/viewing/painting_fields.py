"""What all views of a sheet share: the clippers, and the size of the device."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QBoxLayout,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms import catalogue
from workbench.document.building import Edit
from workbench.document.model import LINE_CLIPPERS, MAX_SIDE_PX, POLYGON_CLIPPERS
from workbench.document.sheet_edits import set_clipper, set_sheet_size
from workbench.document.view_edits import resize_device
from workbench.language import _
from workbench.session.session import Session
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField

Apply = Callable[[Edit, str, str], bool]


class PaintingFields(QWidget):
    """Edits go through ``apply``, which is given the edit, its name and how it is merged."""

    def __init__(self, session: Session, apply: Apply, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session, self._apply = session, apply
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(6)
        row = QHBoxLayout()
        row.setSpacing(6)
        self.clippers: list[QComboBox] = []
        for slugs, tip in (
            (LINE_CLIPPERS, _("The algorithm that clips lines")),
            (POLYGON_CLIPPERS, _("The algorithm that clips polygons")),
        ):
            chooser = ChoiceBox(6)
            chooser.setAccessibleName(tip)
            chooser.setToolTip(tip)
            for slug in slugs:
                chooser.addItem(_(catalogue.get(slug).title), slug)
            chooser.activated.connect(partial(self._set_clipper, chooser))
            self.clippers.append(chooser)
            row.addWidget(chooser, 1)
        column.addLayout(row)
        self.device_row = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        title = QLabel(_("Device"))
        bold = title.font()
        bold.setBold(True)
        title.setFont(bold)
        self.device_row.addWidget(title)
        self.device_row.addStretch(1)
        sizes = QHBoxLayout()
        self.sizes: list[NumberField] = []
        for name, meaning in (
            (_("width"), _("width of the device")),
            (_("height"), _("height of the device")),
        ):
            field = NumberField(name, "px", low=1, high=MAX_SIDE_PX, integer=True, meaning=meaning)
            field.edited.connect(self._set_size)
            field.scrubbed.connect(partial(self._set_size, merge="scrub device"))
            field.scrub_ended.connect(session.end_merge)
            self.sizes.append(field)
            sizes.addWidget(field)
        self.same = QToolButton()
        self.same.setText(_("Same picture on"))
        self.same.setToolTip(
            _("A device of another size: viewports keep their places in normalised device coordinates")
        )
        self.same.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.same)
        for words, factor in (
            (_("a device half as large"), 0.5),
            (_("a device twice as large"), 2.0),
            (_("a device four times as large"), 4.0),
        ):
            menu.addAction(words, partial(self._scale, factor))
        self.same.setMenu(menu)
        self.device_row.addLayout(sizes)
        column.addLayout(self.device_row)
        column.addWidget(self.same, 0, Qt.AlignmentFlag.AlignLeft)

    def refresh(self) -> None:
        """Show the sheet as it is."""
        sheet = self._session.sheet
        slugs = sheet.lines_clipped_with, sheet.polygons_clipped_with
        for chooser, slug in zip(self.clippers, slugs, strict=True):
            chooser.setCurrentIndex(chooser.findData(slug))
        for field, size in zip(self.sizes, (sheet.width_px, sheet.height_px), strict=True):
            field.belong_to(sheet.id)
            field.set_value(size)

    def _scale(self, factor: float) -> None:
        """Show the same picture on a larger or a smaller device."""
        sheet = self._session.sheet
        width, height = (max(1, round(factor * side)) for side in (sheet.width_px, sheet.height_px))
        self._apply(resize_device(sheet.id, width, height), _("Change the device"), "")

    def _set_clipper(self, chooser: QComboBox, index: int) -> None:
        edit = set_clipper(self._session.sheet.id, chooser.itemData(index))
        self._apply(edit, _("Choose the clipper"), "")

    def _set_size(self, _value: float, merge: str = "") -> None:
        width, height = (round(field.value()) for field in self.sizes)
        self._apply(set_sheet_size(self._session.sheet.id, width, height), _("Change the device"), merge)
