"""The matrices under the canvas: one row for each product, in which numbers are pointed at and changed."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QFont, QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget

from workbench.language import _
from workbench.panels.transform.ground import Ground
from workbench.panels.transform.rows import Row
from workbench.widgets.formulas.matrix_row import MatrixRow
from workbench.widgets.formulas.row_surface import Highlight
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import scaled

_UPRIGHT_PX, _NARROW_PX = 1, 660


class Matrices(QScrollArea):
    """``entry_changed`` sends link, attribute and value while a number is dragged or when it was typed, then
    ``entry_ended``. ``stage_pointed`` sends the number of the stage whose matrix is pointed at, or None;
    ``cell_clicked`` product, row and column of an element of a product; ``said`` a sentence.
    """

    entry_changed = Signal(str, str, float)
    entry_ended = Signal()
    stage_pointed = Signal(object)
    cell_clicked = Signal(int, int, int)
    said = Signal(str)
    fit_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.setAccessibleName(_("Matrices of the chain"))
        ground = Ground()
        self._column = QVBoxLayout(ground)
        self._column.setContentsMargins(8, 2, 8, 2)
        self._column.setSpacing(0)
        self._column.addStretch(1)
        self.setWidget(ground)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.views: list[MatrixRow] = []
        self._rows: list[Row] = []
        self._current = -1
        self._with_symbols = True

    @property
    def rows(self) -> list[Row]:
        """What is shown."""
        return self._rows

    def show_rows(self, rows: Sequence[Row], lit: int | None = None) -> None:
        """Show other rows; ``lit`` marks the matrices of a stage."""
        self._rows = list(rows)
        while len(self.views) < len(rows):
            self._add()
        for view in self.views[len(rows) :]:
            view.hide()
            view.set_terms(())
        self._choose_type()
        high = [view.heightForWidth(view.width()) for view in self.views]
        for k, (view, row) in enumerate(zip(self.views, rows, strict=False)):
            view.set_shows(row.shows)
            view.belong_to(tuple(stage.link.id for stage in row.of.values()))
            view.set_terms(row.terms)
            view.set_highlights((*_lights(row, lit), *row.highlights))
            view.setVisible(k > 0 or self._with_symbols)
        current = next((k for k, row in enumerate(rows) if row.highlights), -1)
        if current >= 0 and current != self._current:
            self.ensureWidgetVisible(self.views[current], 0, 0)
        self._current = current
        if high != [view.heightForWidth(view.width()) for view in self.views]:
            self.fit_wanted.emit()

    @property
    def narrow(self) -> bool:
        """Whether notes are left out and the type is that of captions."""
        return self.viewport().width() < _NARROW_PX

    def changeEvent(self, event: QEvent) -> None:
        """Its rows follow the type of the program."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._choose_type()

    def _choose_type(self) -> None:
        font = QFont(self.font())
        if self.narrow:
            font.setPixelSize(scaled(CAPTION_PX))
        for view in self.views:
            if view.font() != font:
                view.setFont(font)

    def _add(self) -> None:
        number, view = len(self.views), MatrixRow(upright=_UPRIGHT_PX)
        view.edited.connect(partial(self._take, number))
        view.edit_ended.connect(self.entry_ended)
        view.cell_hovered.connect(partial(self._point, number))
        view.hover_left.connect(lambda: self.stage_pointed.emit(None))
        view.cell_clicked.connect(partial(self._click, number))
        view.copied.connect(self.said)
        self.views.append(view)
        self._column.insertWidget(number, view)

    def _take(self, number: int, term: int, row: int, column: int, value: float) -> None:
        stage = self._rows[number].of.get(term) if number < len(self._rows) else None
        if stage is not None and (row, column) in stage.entries:
            attribute, sign = stage.entries[row, column]
            self.entry_changed.emit(stage.link.id, attribute, sign * value + 0.0)

    def _point(self, number: int, term: int, _row: int, _column: int) -> None:
        shown = self._rows[number] if number < len(self._rows) else None
        if shown is not None:
            stage = shown.of.get(term)
            self.stage_pointed.emit(stage.number if stage is not None else shown.upto.get(term))

    def _click(self, number: int, term: int, row: int, column: int) -> None:
        product = self._rows[number].product if number < len(self._rows) else None
        if product is not None and term == 1:
            self.cell_clicked.emit(product, row, column)

    def height_within(self, room: int) -> int:
        """How high it is to be where ``room`` pixels are left: the row of symbols goes before any scrolls."""
        margins = self._column.contentsMargins()
        edges = margins.top() + margins.bottom() + 1
        # Without a scroll bar, which would come and go with the height, and the height with it
        width = max(self.maximumViewportSize().width() - margins.left() - margins.right(), 1)
        heights = [view.heightForWidth(width) for view in self.views[: len(self._rows)]]
        whole = sum(heights) + edges
        self._with_symbols = whole <= room or len(heights) < 2
        if self._rows:
            self.views[0].setVisible(self._with_symbols)
        return min(whole if self._with_symbols else whole - heights[0], max(room, 0))

    def event(self, event: QEvent) -> bool:
        """Rows that were laid out anew may need another height."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self.fit_wanted.emit()
        return done

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width rows may break."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.fit_wanted.emit()

    def terms_for_paper(self) -> list[Row]:
        """The rows without marks."""
        return [replace(row, highlights=()) for row in self._rows]


def _lights(row: Row, lit: int | None) -> list[Highlight]:
    if lit is None:
        return []
    terms = [term for term, stage in row.of.items() if stage.number == lit]
    terms += [term for term, number in row.upto.items() if number == lit]
    return [Highlight(term, None, None, "accent", "solid") for term in terms]
