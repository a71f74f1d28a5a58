"""Changes to the display list as steps of undo: they change the figures of the sheet."""

from collections.abc import Callable, Sequence

from workbench.document.errors import DocumentError
from workbench.language import _
from workbench.panels.display.vector.list_model import COLOUR, INTENSITY, X
from workbench.panels.display.vector.run import VectorRun
from workbench.rendering.list_edits import (
    Drawn,
    dimmed,
    drawn_by,
    inserted,
    rows_of,
    set_strokes,
    swapped,
    with_colour,
    with_place,
    without,
)
from workbench.rendering.subjects.random_scan import own_strokes
from workbench.session.session import Session


class ListChanges:
    """``say`` is told what cannot be done, and why."""

    def __init__(self, session: Session, say: Callable[[str], object]) -> None:
        self._session, self._say = session, say

    def change(self, run: VectorRun, address: int, name: str) -> None:
        """Insert, delete or move what is at an address; see ``ListTable.wanted``."""
        rows = rows_of(run.program)
        sheet = self._session.sheet
        if run.locked:
            self._say(run.locked)
            return
        if not rows or not 0 <= address < len(rows):
            address = len(rows) - 1
        try:
            match name:
                case "stroke" | "jump":
                    ink = next((each for each in sheet.palette[1:] if each), 0xFFFFFF)
                    new = inserted(rows, address, run.size, name == "jump", ink)
                    self._apply(drawn_by(new), _("Insert a stroke"), run)
                case "delete" if rows:
                    self._apply(drawn_by(without(rows, address)), _("Delete an instruction"), run)
                case "earlier" | "later" if rows:
                    strokes = swapped(rows, address, name == "later")
                    if strokes is None:
                        self._say(_("The stroke is at the end of the list already."))
                    else:
                        self._apply(strokes, _("Reorder the display list"), run)
        except DocumentError as error:
            self._say(error.short)

    def type(self, run: VectorRun, address: int, column: int, number: float) -> None:
        """Put a number that was typed into the list."""
        rows = rows_of(run.program)
        palette = self._session.sheet.palette
        row = rows[address]
        try:
            if column == INTENSITY:
                if not 0.0 <= number <= 100.0:
                    self._say(_("{value:g} % is no intensity; give 0 to 100.").format(value=number))
                    return
                rows = with_colour(rows, address, dimmed(row.colour, number / 100.0))
            elif column == COLOUR:
                if not (number.is_integer() and 0 <= number < len(palette)):
                    said = _("{value:g} is no colour of the palette; give 0 to {most}.")
                    self._say(said.format(value=number, most=len(palette) - 1))
                    return
                rows = with_colour(rows, address, palette[int(number)])
            else:
                most = run.size[0 if column == X else 1] - 0.5  # the edge of the last pixel
                if not -0.5 <= number <= most:
                    said = _("{value:g} lies beyond the screen; give −0.5 to {most:g}.")
                    self._say(said.format(value=number, most=most))
                    return
                x, y = (number, row.y) if column == X else (row.x, number)
                rows = with_place(rows, address, x, y)
            self._apply(drawn_by(rows), _("Change the display list"), run)
        except DocumentError as error:
            self._say(error.short)

    def keep_order(self, run: VectorRun) -> bool:
        """Let the sheet draw its strokes in the order of the run; whether it does."""
        old = own_strokes(self._session.sheet, self._session.state.subject)
        if run.budget.test:
            self._say(run.locked)
            return False
        strokes = [
            Drawn(x0, y0, x1, y1, int(colour))
            for x0, y0, x1, y1, colour in run.program.strokes.for_tube().tolist()
        ]
        try:
            self._session.apply(
                set_strokes(self._session.sheet, old, strokes), _("Keep the order of the display list")
            )
        except DocumentError as error:
            self._say(error.short)
            return False
        return True

    def _apply(self, strokes: Sequence[Drawn], name: str, run: VectorRun) -> None:
        self._session.apply(set_strokes(self._session.sheet, run.program.strokes, strokes), name)
