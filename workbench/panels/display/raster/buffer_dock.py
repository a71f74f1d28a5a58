"""The dock of the frame buffer: bits per pixel, colour table, and what the picture loses at each depth."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QIcon, QImage, QPixmap
from PySide6.QtWidgets import (
    QColorDialog,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QScrollArea,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.scanning.raster_marks import hexadecimal
from workbench.display.colour_table import (
    DEPTHS,
    DIRECT,
    FrameBuffer,
    Table,
    most_frequent,
    ramp,
    stored,
    table_fault,
    usual_table,
)
from workbench.display.raster_sums import frame_buffer_bytes
from workbench.display.scan import resampled
from workbench.exchange import tables
from workbench.language import _, ngettext
from workbench.panels.display.raster.colour_grid import ColourGrid
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.shared.tube_feed import picture_of
from workbench.rendering.scene.backdrop import can_be_lit, whole_picture
from workbench.rendering.subjects.raster import depth_of, paper_of, table_of
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.in_sight import InSight

_REST_MS = 120
_ICON = QSize(48, 36)


def depth_title(depth: int) -> str:
    """A depth with how many colours it tells apart."""
    if depth >= DIRECT:
        return _("{depth} bits, direct").format(depth=depth)
    said = ngettext("{depth} bit, {count} colours", "{depth} bits, {count} colours", depth)
    return said.format(depth=depth, count=1 << depth)


def loss_text(buffer: FrameBuffer) -> str:
    """What a picture loses in a frame buffer."""
    loss = buffer.loss
    if not loss.changed:
        return _("Nothing is lost: all colours of the picture ({count}) are kept.").format(count=loss.colours)
    return _(
        "{colours} colours become {kept}, so {lost} are lost. {changed:,} of {pixels:,} pixels change; the "
        "largest error of a channel is {largest} of 255, the mean {mean:.3g}."
    ).format(
        colours=loss.colours,
        kept=loss.kept,
        lost=loss.lost,
        changed=loss.changed,
        pixels=buffer.bits.size,
        largest=loss.largest,
        mean=loss.mean,
    )


class BufferDock(QScrollArea):
    """``said``: what cannot be done, and why."""

    said = Signal(str)

    def __init__(self, setting: RasterSetting, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self._buffers: list[FrameBuffer] = []
        self._shown: object = None
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.depth_box = QComboBox()
        for each in DEPTHS:
            self.depth_box.addItem(depth_title(each), each)
        self.depth_box.setAccessibleName(_("Bits per pixel"))
        self.depth_box.setToolTip(_("How many bits the frame buffer has for a pixel"))
        self.depth_box.activated.connect(lambda k: self.choose_depth(self.depth_box.itemData(k)))
        self.grid = ColourGrid()
        self.grid.chosen.connect(lambda _index: self._show_entry())
        self.grid.wanted.connect(self.ask_colour)
        self.entry = QLabel()
        self.colour = QLineEdit()
        self.colour.setMaximumWidth(90)
        self.colour.setAccessibleName(_("Colour of the entry"))
        self.colour.setToolTip(_("Type a colour such as #FF8800"))
        self.colour.editingFinished.connect(self._typed)
        self.fault, self.loss = QLabel(), QLabel()
        self.fault.setProperty("role", "error")
        for label in (self.fault, self.loss):
            label.setWordWrap(True)
        self.depths = self._made_table()
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(10, 8, 10, 8)
        column.setSpacing(8)
        column.addWidget(self.depth_box)
        column.addWidget(self.grid)
        row = QHBoxLayout()
        row.addWidget(self.entry, 1)
        row.addWidget(self.colour)
        column.addLayout(row)
        column.addWidget(self._buttons())
        for widget in (self.fault, self.loss, self.depths):
            column.addWidget(widget)
        column.addStretch(1)
        self.setWidget(body)
        self._resting = QTimer(self)
        self._resting.setSingleShot(True)
        self._resting.setInterval(_REST_MS)
        self._resting.timeout.connect(self._compare)
        self.in_sight = InSight(self)
        self.in_sight.follow(self.refresh)

    def _made_table(self) -> QTableWidget:
        table = QTableWidget(len(DEPTHS), 4)
        table.setAccessibleName(_("What is lost at each depth"))
        table.setToolTip(_("The picture at each depth with its usual table; double-click one to choose it."))
        table.setHorizontalHeaderLabels((_("bits"), _("bytes"), _("lost"), _("error")))
        table.verticalHeader().hide()
        table.setShowGrid(False)
        table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        table.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
        table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        table.setTabKeyNavigation(False)
        table.setIconSize(_ICON)
        table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(table.columnCount() - 1, QHeaderView.ResizeMode.Stretch)
        for column, meaning in ((2, _("colours lost")), (3, _("largest error"))):
            table.model().setHeaderData(
                column, Qt.Orientation.Horizontal, meaning, Qt.ItemDataRole.ToolTipRole
            )
        for number in range(len(DEPTHS)):
            table.setRowHeight(number, _ICON.height() + 4)
        table.setFixedHeight(len(DEPTHS) * (_ICON.height() + 4) + header.sizeHint().height() + 4)
        table.cellActivated.connect(lambda row, _column: self.choose_depth(DEPTHS[row]))
        return table

    def _buttons(self) -> QWidget:
        buttons = QWidget()
        row = flowing(buttons, 6)
        self.change = QPushButton(_("Change"))
        self.add = QPushButton(_("Add"))
        self.remove = QPushButton(_("Remove"))
        self.load = QPushButton(_("Load"))
        for button, tip in (
            (self.change, _("Choose another colour for the entry")),
            (self.add, _("Add an entry at the end of the table")),
            (self.remove, _("Take the entry out of the table")),
            (self.load, _("Fill the table with a ramp, the usual colours, or those of the picture")),
        ):
            button.setToolTip(tip)
            button.setAccessibleName(tip)
            row.addWidget(button)
        self.change.clicked.connect(lambda: self.ask_colour(self.grid.index))
        self.add.clicked.connect(lambda: self._take((*self.table, 0xFFFFFF)))
        self.remove.clicked.connect(self._remove)
        menu = QMenu(self.load)
        for title, make in self._loads():
            menu.addAction(title, partial(self._load, make))
        self.load.setMenu(menu)
        return buttons

    @staticmethod
    def _loads() -> Sequence[tuple[str, object]]:
        return (
            (_("Usual table"), None),
            (_("Ramp of greys"), 0xFFFFFF),
            (_("Ramp of red"), 0xFF0000),
            (_("Ramp of green"), 0x00FF00),
            (_("Ramp of blue"), 0x0000FF),
            (_("Ramp of amber"), 0xFFB000),
            (_("Colours of the picture"), "picture"),
            (_("Nothing"), ()),
        )

    def _load(self, what: object) -> None:
        count = 1 << depth_of(self._setting.subject)
        if what is None:
            self._setting.give(own_table=False)
        elif isinstance(what, int):
            self._take(ramp(count, what))
        else:
            picture = whole_picture(self._setting.sheet)
            self._take(most_frequent(picture, count) if what else ())

    @property
    def table(self) -> Table:
        """The table that is set now."""
        return table_of(self._setting.sheet, self._setting.subject)

    def choose_depth(self, depth: int) -> None:
        """Another depth, with its usual table."""
        self._setting.give(depth=depth, own_table=False)

    def _take(self, table: Table) -> None:
        depth = depth_of(self._setting.subject)
        if len(table) > 1 << depth:
            self.said.emit(table_fault(depth, table))
            return
        self._setting.give(own_table=True, table=tuple(map(float, table)))

    def _remove(self) -> None:
        index = self.grid.index
        self._take((*self.table[:index], *self.table[index + 1 :]))

    def set_colour(self, index: int, colour: int) -> None:
        """Give an entry a colour, 0xRRGGBB."""
        self._take((*self.table[:index], colour, *self.table[index + 1 :]))

    def ask_colour(self, index: int) -> None:
        """Let a person choose a colour for an entry."""
        if not 0 <= index < len(self.table):
            return
        dialog = QColorDialog(QColor.fromRgb(self.table[index]), self)
        dialog.setWindowTitle(_("Colour of entry {index}").format(index=index))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.colorSelected.connect(partial(self._take_chosen, index))
        dialog.open()

    def _take_chosen(self, index: int, chosen: QColor) -> None:
        if index < len(self.table):
            self.set_colour(index, chosen.rgb() & 0xFFFFFF)

    def _typed(self) -> None:
        """What was typed for the entry, if it is a colour."""
        if not self.colour.isModified() or not self.grid.index < len(self.table):
            return
        self.colour.setModified(False)
        colour = QColor.fromString(self.colour.text().strip())
        if colour.isValid():
            self.set_colour(self.grid.index, colour.rgb() & 0xFFFFFF)
        else:
            said = _("\u201c{text}\u201d is no colour; type one such as #FF8800.")
            self._complain(said.format(text=self.colour.text()))

    def _complain(self, sentence: str) -> None:
        self.fault.setText(sentence)
        self.fault.setVisible(bool(sentence))

    def refresh(self) -> None:
        """Show the depth and the table that are set now; unseen, when it is seen."""
        if not self.in_sight.now:
            return
        subject = self._setting.subject
        state = self._setting.sheet, self._setting.timing, depth_of(subject), self.table
        if self._shown is not None and state == self._shown:
            return
        self._shown = state
        depth, table = state[2:]
        direct = depth >= DIRECT
        self.depth_box.setCurrentIndex(self.depth_box.findData(depth))
        self.grid.show_colours(table, direct)
        for widget in (self.change, self.remove, self.colour):
            widget.setEnabled(bool(table) and not direct)
        self.load.setEnabled(not direct)
        self.add.setEnabled(not direct and len(table) < 1 << depth)
        scan = self._setting.scan
        kept = bool(table) and scan is not None and not scan.buffer.loss.changed
        self._complain("" if kept and len(table) <= 1 << depth else table_fault(depth, table))
        self._show_entry()
        self.loss.setText("" if scan is None else loss_text(scan.buffer))
        self._resting.start()

    def _show_entry(self) -> None:
        depth, table, index = depth_of(self._setting.subject), self.table, self.grid.index
        if depth >= DIRECT:
            self.entry.setText(_("No table: 8 bits each for red, green and blue, on three ramps."))
        elif not table:
            self.entry.setText(_("The table has no entries."))
        else:
            said = _("Entry {index} of {count}: bits {bits}")
            if depth == 1:
                whose = _("the background") if index == 0 else _("all that is drawn")
                said = _("{entry}, {whose}").format(entry=said, whose=whose)
            self.entry.setText(said.format(index=index, count=len(table), bits=f"{index:0{depth}b}"))
        self.entry.setWordWrap(True)
        self.colour.setText(hexadecimal(table[index]) if index < len(table) else "")

    def _compare(self) -> None:
        """The picture at every depth, the one that is set with its own table."""
        if not self.in_sight.now:
            return
        sheet, chosen = self._setting.sheet, depth_of(self._setting.subject)
        picture = picture_of(self._setting.session, sheet, can_be_lit(sheet))
        if picture is None:
            self._shown = None  # it is shown when it has come
            return
        timing, paper = self._setting.timing, paper_of(sheet)
        if timing is not None:
            picture = resampled(picture, timing)
        of_depths = {depth: usual_table(depth, paper) for depth in DEPTHS} | {chosen: self.table}
        self._buffers = [stored(picture, depth, table, paper) for depth, table in of_depths.items()]
        height, width = picture.shape
        for row, buffer in enumerate(self._buffers):
            size = frame_buffer_bytes(width, height, buffer.depth)
            cells = (
                str(buffer.depth),
                f"{float(size):,.10g}",
                f"{buffer.loss.lost} / {buffer.loss.colours}",
                str(buffer.loss.largest),
            )
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setToolTip(loss_text(buffer))
                if column:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                else:
                    item.setIcon(_thumbnail(buffer))
                self.depths.setItem(row, column, item)
        self.depths.selectRow(DEPTHS.index(chosen))

    def content(self) -> list[tuple[str, tables.Table]]:
        """Titles and contents of its tables, for export."""
        found = []
        table = self.table
        if table and depth_of(self._setting.subject) < DIRECT:
            rows = [(k, hexadecimal(colour)) for k, colour in enumerate(table)]
            found.append((_("Colour table"), tables.Table((_("entry"), _("colour")), rows, formulas=False)))
        if self._buffers:
            columns = (
                _("bits"),
                _("colours kept"),
                _("colours lost"),
                _("pixels changed"),
                _("largest error"),
                _("mean error"),
            )
            measured = [
                (b.depth, b.loss.kept, b.loss.lost, b.loss.changed, b.loss.largest, b.loss.mean)
                for b in self._buffers
            ]
            found.append((_("What is lost at each depth"), tables.Table(columns, measured, formulas=False)))
        return found


def _thumbnail(buffer: FrameBuffer) -> QIcon:
    """The picture as it is shown at a depth."""
    packed = np.ascontiguousarray(buffer.shown[::-1] | np.uint32(0xFF000000))
    height, width = packed.shape
    image = QImage(packed.tobytes(), width, height, 4 * width, QImage.Format.Format_RGB32).copy()
    return QIcon(
        QPixmap.fromImage(
            image.scaled(_ICON, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.FastTransformation)
        )
    )
