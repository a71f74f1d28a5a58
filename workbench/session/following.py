"""Makes the runs of a session follow its active figure, and keeps their cursor in the session's state."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from workbench.document.model import AnyFigure, Curve, Polygon, SeedFill
from workbench.rendering.clipping import clipper_calls, clippers_of
from workbench.rendering.curve_runs import construction_of, curve_calls
from workbench.rendering.mapping import Call
from workbench.rendering.outline_fill import outline_fill
from workbench.rendering.raster import figure_calls
from workbench.session.recorded_run import DEPTH_LIMIT
from workbench.session.run import Run

if TYPE_CHECKING:
    from workbench.session.session import Session


class Following(QObject):
    """``run`` follows the active figure of ``session``, ``follower`` the compared algorithm step for step.

    Step, detail and asking first are the session's: what is switched on the run is written into its state at
    once, and ``update`` makes the run as the state is, whoever changed it last.
    """

    def __init__(self, session: "Session", run: Run, follower: Run) -> None:
        super().__init__(session)
        self._session, self._run, self._follower = session, run, follower
        self._telling = False
        self._step: int | None = None
        run.moved.connect(self._moved)
        run.grown.connect(self._lock)
        run.asked.connect(lambda: session.update_state(ask_first=run.ask_first))
        QTimer.singleShot(0, self.update)

    def begin_anew(self) -> None:
        """Another document is open: the step in its state is where its run stands."""
        self._step = None

    def switch(self, stays: bool) -> None:
        """Ask first and count as the state says, at once: the run is never otherwise than the state.

        Where the run ``stays`` in its step, the state takes the number that this has as it counts now.
        """
        before, self._telling = self._telling, self._telling or not stays
        try:
            self._run.set_ask_first(self._session.state.ask_first)
            self._run.set_detail(self._session.state.detail)
        finally:
            self._telling = before

    def update(self) -> None:
        """Follow what is active now; the session calls this before it tells what changed."""
        session, state = self._session, self._session.state
        figure = session.active_figure
        clips = state.stepped == "clipper"
        constructs = state.stepped == "curve" and isinstance(figure, Curve)
        calls: list[Call] = []
        if isinstance(figure, Curve) and constructs:
            text = construction_of(figure, state.construction)
            calls = curve_calls(session.sheet, figure, text, state.curve_u)
        elif figure is not None:
            calls = (clipper_calls if clips else figure_calls)(session.sheet, figure)
        before = self._run.figure_id, self._run.entry
        self._telling = True
        try:
            self._follow(self._run, calls, figure)
            self.switch(stays=False)
            if self._run.figure_id == before[0] and state.step == self._step:
                if self._run.entry is not before[1]:  # another text on the same figure begins at its start
                    self._session.update_state(step=0)
            else:
                self._run.go_to_number(state.step)
            self._step = self._session.state.step
        finally:
            self._telling = False
        self._follow(self._follower, [] if constructs else self._compared(figure), figure)
        self._lock()

    def _compared(self, figure: AnyFigure | None) -> list[Call]:
        """What the compared algorithm runs on the active figure; nothing where none can be compared."""
        session, state = self._session, self._session.state
        if figure is None:
            return []
        if state.stepped == "clipper":
            if state.compare in clippers_of(figure):
                return clipper_calls(session.sheet, figure, state.compare)
        elif state.compare in figure.algorithms and state.compare != figure.drawn_with:
            return figure_calls(session.sheet, figure, state.compare)
        elif isinstance(figure, Polygon) and state.compare in SeedFill.algorithms:
            filled = outline_fill(session.sheet, figure, state.compare).call
            return [] if filled is None else [filled]
        return []

    def _follow(self, run: Run, calls: list[Call], figure: AnyFigure | None) -> None:
        if not calls or figure is None:
            run.clear()
            return
        sheet = self._session.sheet
        arguments = [call.arguments for call in calls if call.entry is calls[0].entry]
        run.follow(
            calls[0].entry,
            arguments[0],
            figure.id,
            (sheet.width_px, sheet.height_px),
            arguments[1:],
            figure.recursion_limit if isinstance(figure, SeedFill) else DEPTH_LIMIT,
        )

    def _moved(self) -> None:
        self._lock()
        run = self._run
        if not self._telling and run.entry is not None and run.target is not None:
            self._step = run.target
            self._session.update_state(step=run.target, detail=run.detail)

    def _lock(self) -> None:
        """The follower shows as many steps as the run, all of them when that is at its end."""
        if self._follower.entry is None:
            return
        step = self._run.step
        if step is None:
            return
        if self._follower.detail:
            self._follower.set_detail(False)
        number = self._run.passed + step.number
        self._follower.go(number if not self._run.ended else self._follower.last_position)
