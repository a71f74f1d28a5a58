"""A sheet of many figures comes into view by and by: what each is drawn by is made a few figures a turn."""

import time
from collections.abc import Callable
from itertools import islice
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from workbench.document.model import AnyFigure, Curve, Sheet
from workbench.rendering.curves import polyline_of

if TYPE_CHECKING:
    from workbench.session.session import Session

Prepare = Callable[[Sheet, AnyFigure], object]

FEW = 60
"""So many new figures are drawn at once; of more, so many are made ready in one turn."""
_TURN_S = 0.02
_GROWTH = 1.5


class Unfolding(QObject):
    """Tells which figures of the current sheet can be drawn without a wait.

    ``grown``: more can be than before; it comes ever more seldom, since each time all is painted anew.
    ``progressed`` sends how many figures are ready, and of how many.
    """

    grown = Signal()
    progressed = Signal(int, int)

    def __init__(self, session: "Session") -> None:
        super().__init__(session)
        self._session = session
        self._prepares: list[Prepare] = [_corners]
        self._ready: dict[int, AnyFigure] = {}
        self._whole: Sheet | None = None
        self._part: Sheet | None = None
        self._frame: object = None
        self._next = 0
        self._timer = QTimer(self)
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._turn)

    def prepare_by(self, prepare: Prepare) -> None:
        """Have ``prepare(sheet, figure)``, which remembers what it makes, called before a figure is shown."""
        if prepare not in self._prepares:
            self._prepares.append(prepare)
            self._ready, self._whole = {}, None

    @property
    def shown(self) -> Sheet:
        """The current sheet in its frame, or, while it unfolds, with those of its figures that are ready."""
        sheet = self._session.frames.sheet
        if sheet is not self._whole or self._part is None:
            self._look(sheet)
        return self._part or sheet

    def _look(self, sheet: Sheet) -> None:
        """What of a sheet is ready; where little is missing that is drawn with the rest."""
        frame = sheet.views
        if frame != self._frame:
            self._ready, self._frame = {}, frame
        self._whole = sheet
        waiting = self._waiting(sheet)
        if len(waiting) > FEW and self._session.sheet is sheet:
            state = self._session.state
            chosen = {*state.selection, state.active}
            for figure in islice((each for each in waiting if each.id in chosen), FEW):
                self._prepare(sheet, figure)
            self._show_part(sheet)
            self._timer.start()
        else:
            self._show_whole(sheet)

    def _waiting(self, sheet: Sheet) -> list[AnyFigure]:
        ready = self._ready
        return [figure for figure in sheet.figures if figure.visible and id(figure) not in ready]

    def _show_part(self, sheet: Sheet) -> None:
        ready = self._ready
        self._part = replace(sheet, figures=tuple(f for f in sheet.figures if id(f) in ready))
        self._next = max(len(self._part.figures) + FEW, round(len(self._part.figures) * _GROWTH))

    def _show_whole(self, sheet: Sheet) -> None:
        self._timer.stop()
        self._part = sheet
        self._ready = {id(figure): figure for figure in sheet.figures if figure.visible}

    def _prepare(self, sheet: Sheet, figure: AnyFigure) -> None:
        self._ready[id(figure)] = figure  # first: what fails, fails where it is drawn
        for prepare in self._prepares:
            prepare(sheet, figure)

    def _turn(self) -> None:
        sheet = self._session.frames.sheet
        if sheet is not self._whole:
            self._timer.stop()  # who shows the other sheet begins anew
            self.grown.emit()
            return
        waiting = self._waiting(sheet)
        end = time.thread_time() + _TURN_S
        count = 0
        for figure in waiting[:FEW]:
            self._prepare(sheet, figure)
            count += 1
            if time.thread_time() > end:
                break
        total = len(sheet.figures)
        self.progressed.emit(total - len(waiting) + count, total)
        if count == len(waiting):
            self._show_whole(sheet)
            self.grown.emit()
        elif total - len(waiting) + count >= self._next:
            self._show_part(sheet)
            self.grown.emit()


def _corners(sheet: Sheet, figure: AnyFigure) -> None:
    """What the pixels of a curve are drawn by."""
    if isinstance(figure, Curve):
        polyline_of(sheet, figure)
