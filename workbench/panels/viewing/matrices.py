"""The matrix of a view and its three factors, in symbols above and in numbers below, which can be changed."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from workbench.document.model import View
from workbench.language import _
from workbench.panels.viewing.card import ViewCard
from workbench.panels.viewing.formulas import changed_cells, rewritten, terms_of
from workbench.panels.viewing.rectangles import rectangles
from workbench.session.session import Session
from workbench.widgets.formulas.matrix_row import MatrixRow
from workbench.widgets.formulas.row_surface import Highlight
from workbench.widgets.look.type_faces import scaled, type_scale

SIZE_PX, UPRIGHT_PX = 12, 3
_MERGE = "matrix in View"


class Matrices(QWidget):
    """A number that is changed edits window or viewport through ``card``, where it is said if it cannot be.

    ``before`` is the view as it was before a number was taken hold of; None while none is. ``changed``: what
    is shown is to be brought up to date. ``copied`` sends one sentence.
    """

    changed = Signal()
    copied = Signal(str)

    def __init__(self, session: Session, card: ViewCard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session, self._card = session, card
        self.before: View | None = None
        self.symbols, self.numbers = MatrixRow(upright=UPRIGHT_PX), MatrixRow(upright=UPRIGHT_PX)
        self.symbols.set_shows("symbols")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for row in (self.symbols, self.numbers):
            row.copied.connect(self.copied)
            row.edited.connect(self._rewrite)
            row.edit_ended.connect(self._end)
            column.addWidget(row)
        type_scale.changed.connect(self._take_type)
        self._take_type()

    def _take_type(self) -> None:
        for row in (self.symbols, self.numbers):
            font = row.font()
            font.setPixelSize(scaled(SIZE_PX))
            row.setFont(font)

    def refresh(self, view: View, before: View | None) -> None:
        """Show the matrices of a view; the cells are lit that differ from those ``before`` a drag."""
        cells = () if before is None else changed_cells(before, view)
        for row in (self.symbols, self.numbers):
            row.belong_to(view.id)
            row.set_terms(terms_of(view))
            row.set_highlights(Highlight(*place) for place in cells)

    def _rewrite(self, term: int, row: int, column: int, value: float) -> None:
        view = self._card.view
        if self.before is None:
            self.before = view
        try:
            slug, rectangle = rewritten(view, (term, row, column), value)
        except ValueError as problem:
            self._card.refuse(str(problem))
        else:
            edit = rectangles()[slug].edit(view.id, rectangle)
            self._card.apply(edit, _("Change a number of the matrix"), _MERGE)
        self.changed.emit()

    def _end(self) -> None:
        self.before = None
        self._session.end_merge(_MERGE)
        self.changed.emit()
