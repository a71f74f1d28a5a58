"""A row of matrices to read, point at and change: numbers are dragged sideways or typed where they stand."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QAction,
    QActionGroup,
    QFocusEvent,
    QGuiApplication,
    QKeyEvent,
    QMouseEvent,
)
from PySide6.QtWidgets import QWidget

from workbench.algorithms.numerals import with_minus
from workbench.exchange.formulas.copying import cell_text, latex, numpy_text, plain, plain_formula
from workbench.exchange.formulas.terms import Cell, Matrix, Place, Shows
from workbench.language import _
from workbench.widgets.fields.number_field import SCRUB_PX
from workbench.widgets.formulas.cell_editor import CellEditor
from workbench.widgets.formulas.row_surface import MARGIN, RowSurface
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.type_faces import code_font

_SLACK_PX = 3
_FINE, _COARSE = 0.1, 10.0
_ARROWS = {
    Qt.Key.Key_Left: (0, -1),
    Qt.Key.Key_Right: (0, 1),
    Qt.Key.Key_Up: (-1, 0),
    Qt.Key.Key_Down: (1, 0),
}
_BEGINS_A_NUMBER = "0123456789.-−+("


class MatrixRow(RowSurface):
    """``edited`` sends (term, row, column, value) while a number is dragged and when one was typed, and
    ``edit_ended`` when that is over: what came between is one step of undo. The number shown is the one sent
    until the owner shows others. Escape in a drag sends the number that it began with.

    ``cell_clicked`` and ``cell_hovered`` send (term, row, column), ``hover_left`` follows; ``shows_changed``
    that symbols, numbers or both were chosen; ``copied`` one sentence, when something is on the clipboard.
    ``step`` is what one notch of a drag changes; Shift makes it ten times finer, Ctrl ten times coarser.
    """

    edited = Signal(int, int, int, float)
    edit_ended = Signal()
    cell_clicked = Signal(int, int, int)
    cell_hovered = Signal(int, int, int)
    hover_left = Signal()
    shows_changed = Signal(str)
    copied = Signal(str)

    def __init__(self, parent: QWidget | None = None, step: float = 0.1, upright: int = MARGIN) -> None:
        super().__init__(parent, upright)
        self.step = step
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(_("Matrices"))
        self.setToolTip(
            _("Drag a number sideways (Shift: finer, Ctrl: coarser), double-click it to type; arrows move")
        )
        self.editor = CellEditor(self)
        self.editor.typed.connect(self._take_typed)
        self._typing: Place | None = None
        self._owner: object = None
        self._press: tuple[Place, QPointF] | None = None
        self._dragged: float | None = None
        self._last_x = self._rest = 0.0
        self._add_actions()

    # The menu

    def _add_actions(self) -> None:
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        kinds = QActionGroup(self)
        self.shows_actions: dict[Shows, QAction] = {}
        choices: tuple[tuple[Shows, str], ...] = (
            ("symbols", _("Symbols")),
            ("numbers", _("Numbers")),
            ("both", _("Symbols and numbers")),
        )
        for shows, title in choices:
            action = QAction(title, kinds)
            action.setCheckable(True)
            action.setChecked(shows == self.shows)
            action.triggered.connect(partial(self._choose_shows, shows))
            self.shows_actions[shows] = action
        self.addActions(kinds.actions())
        parting = QAction(self)
        parting.setSeparator(True)
        self.addAction(parting)
        formats: tuple[tuple[str, Callable[[], str]], ...] = (
            ("LaTeX", lambda: latex(self.terms, self.shows)),
            ("NumPy", lambda: numpy_text(self.terms)),
            (_("text"), lambda: plain(self.terms, self.shows)),
        )
        for name, write in formats:
            action = QAction(_("Copy as {format}").format(format=name), self)
            action.triggered.connect(partial(self._copy, name, write))
            self.addAction(action)

    def set_shows(self, shows: Shows) -> None:
        """Show symbols, numbers or both."""
        self.shows_actions[shows].setChecked(True)
        super().set_shows(shows)

    def _choose_shows(self, shows: Shows) -> None:
        self.set_shows(shows)
        self.shows_changed.emit(shows)

    def copy(self) -> None:
        """Put the row on the clipboard as text."""
        self._copy(_("text"), lambda: plain(self.terms, self.shows))

    def _copy(self, name: str, write: Callable[[], str]) -> None:
        QGuiApplication.clipboard().setText(write())
        self.copied.emit(_("The matrices are on the clipboard as {format}.").format(format=name))

    # The current cell

    @property
    def current(self) -> Place | None:
        """The cell that the keys are at."""
        return self._current

    def set_current(self, place: Place | None) -> None:
        """Go to a cell; a screen reader says it."""
        self._current = place
        self._tell()
        self.update()

    def _cell(self, place: Place) -> Cell:
        number, row, column = place
        return self._matrix(number).cells[row][column]

    def described(self, place: Place) -> str:
        """What a screen reader says of a cell."""
        number, row, column = place
        name = plain_formula(self._matrix(number).name)
        where = _("row {row}, column {column}: {cell}").format(
            row=row + 1, column=column + 1, cell=cell_text(self._cell(place))
        )
        return f"{name}, {where}" if name else where

    def _tell(self) -> None:
        said = _("Matrices") if self._current is None else self.described(self._current)
        if said != self.accessibleName():
            self.setAccessibleName(said)
            if self.hasFocus():
                QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.NameChanged))

    def _lay_out_anew(self) -> None:
        super()._lay_out_anew()
        self._tell()
        places = self.places
        if self._press is not None and self._press[0] not in places:
            self._press = self._dragged = None
        if self._typing is not None and self._typing not in places:
            self.editor.close_field()

    # Changing a number

    def _send(self, place: Place, value: float) -> None:
        number, row, column = place
        term = self._matrix(number)
        cells = [list(each) for each in term.cells]
        cells[row][column] = replace(cells[row][column], value=value)
        terms = list(self._terms)
        terms[number] = replace(term, cells=tuple(map(tuple, cells)))
        self.set_terms(terms)
        self.edited.emit(number, row, column, value)

    def belong_to(self, owner: object) -> None:
        """Show the matrices of ``owner``; a number that is being typed for another one is left out."""
        if owner != self._owner:
            self._owner = owner
            self.editor.close_field()

    def edit(self, place: Place, text: str | None = None) -> None:
        """Open the field over a cell that can be changed, with ``text`` in it or else its number."""
        value = self._cell(place).value
        if not self.editable(place) or value is None:
            return
        self.set_current(place)
        self._typing = place
        shown = with_minus(f"{value + 0.0:.10g}")
        font = code_font()
        font.setPixelSize(max(self._sizes))
        self.editor.open_at(
            self.cell_box(place), shown if text is None else text, self.described(place), font
        )
        if text is not None:
            self.editor.setCursorPosition(len(text))
            self.editor.setModified(True)

    def _take_typed(self, value: float) -> None:
        place, self._typing = self._typing, None
        if place is not None and place in self.places and value != self._cell(place).value:
            self._send(place, value)
            self.edit_ended.emit()

    # The pointer

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a cell."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        place = self.cell_at(event.position())
        if place is not None:
            self.set_current(place)
            self._press = place, event.position()
            self._last_x, self._rest = event.position().x(), 0.0

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the number held, or tell what is pointed at."""
        if self._press is None:
            self._hover_at(event.position())
            return
        place, start = self._press
        if self._dragged is None:
            if abs(event.position().x() - start.x()) <= _SLACK_PX or not self.editable(place):
                return
            self._dragged = self._cell(place).value
        self._rest += event.position().x() - self._last_x
        self._last_x = event.position().x()
        notches = int(self._rest / SCRUB_PX)
        value = self._cell(place).value
        if notches and value is not None:
            self._rest -= notches * SCRUB_PX
            self._send(place, round(value + notches * self._step(event.modifiers()), 9) + 0.0)

    def _step(self, modifiers: Qt.KeyboardModifier) -> float:
        if modifiers & Qt.KeyboardModifier.ShiftModifier:
            return self.step * _FINE
        return self.step * _COARSE if modifiers & Qt.KeyboardModifier.ControlModifier else self.step

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go of the number, or click."""
        if event.button() != Qt.MouseButton.LeftButton or self._press is None:
            return
        place, start = self._press
        self._press = None
        if self._dragged is not None:
            self._dragged = None
            self.edit_ended.emit()
            self._hover_at(event.position())
        elif (event.position() - start).manhattanLength() <= _SLACK_PX:
            self.cell_clicked.emit(*place)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Type a number."""
        place = self.cell_at(event.position())
        if event.button() == Qt.MouseButton.LeftButton and place is not None:
            self.edit(place)

    def _hover_at(self, position: QPointF) -> None:
        place = self.cell_at(position)
        can = place is not None and self.editable(place)
        self.setCursor(Qt.CursorShape.SizeHorCursor if can else Qt.CursorShape.ArrowCursor)
        if place == self._hovered:
            return
        self._hovered = place
        self.update()
        if place is None:
            self.hover_left.emit()
        else:
            self.cell_hovered.emit(*place)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at any more."""
        if self._hovered is not None:
            self._hovered = None
            self.update()
            self.hover_left.emit()

    # The keys

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move among cells, Enter types or clicks, a digit types, Escape takes a drag back."""
        key, places, here = event.key(), self.places, self._current
        if key == Qt.Key.Key_Escape and self._press is not None:
            self._take_back()
        elif not is_plain(event):
            super().keyPressEvent(event)
        elif key in _ARROWS and places:
            self.set_current(places[0] if here is None else self._beside(here, *_ARROWS[Qt.Key(key)]))
        elif key in (Qt.Key.Key_Home, Qt.Key.Key_End) and places:
            self.set_current(places[0 if key == Qt.Key.Key_Home else -1])
        elif here is not None and key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self.editable(here):
                self.edit(here)
            else:
                self.cell_clicked.emit(*here)
        elif here is not None and self.editable(here) and event.text() and event.text() in _BEGINS_A_NUMBER:
            self.edit(here, event.text())
        else:
            super().keyPressEvent(event)

    def _take_back(self) -> None:
        assert self._press is not None
        place, value = self._press[0], self._dragged
        self._press = self._dragged = None
        if value is not None:
            self._send(place, value)
            self.edit_ended.emit()

    def _beside(self, here: Place, down: int, right: int) -> Place:
        """The next cell in a direction, of the next matrix at the end of a row; else the same."""
        number, row, column = here
        rows, columns = self._matrix(number).shape
        if 0 <= row + down < rows and 0 <= column + right < columns:
            return number, row + down, column + right
        matrices = [k for k, term in enumerate(self._terms) if isinstance(term, Matrix)]
        at = matrices.index(number) + right
        if not right or not 0 <= at < len(matrices):
            return here
        rows, columns = self._matrix(matrices[at]).shape
        return matrices[at], min(row, rows - 1), 0 if right > 0 else columns - 1

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Keys begin at the first cell."""
        super().focusInEvent(event)
        if self._current is None and self.places:
            self.set_current(self.places[0])
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring goes."""
        super().focusOutEvent(event)
        self.update()
