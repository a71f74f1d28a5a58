"""Tools of one stroke: a curve fitted to what is drawn freehand, and the point of a curve nearest to one."""

import numpy as np
from PySide6.QtCore import Qt

from workbench.algorithms.curves import closest_point, in_rows
from workbench.algorithms.marks import Word
from workbench.document.curves.pieces import share_at
from workbench.document.edits import add_figure
from workbench.document.model import Curve
from workbench.exchange.fitted_curve import fitted
from workbench.language import _, at_most, ngettext
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.shape import device_pieces
from workbench.panels.stage.gesture import Modifiers, Tool
from workbench.panels.stage.tools import FigureTool
from workbench.widgets.canvas.drawing import Drawn, Marker, PenStroke

FIT_PX = 0.6
_CLOSE_PX = 12


class FreehandTool(FigureTool):
    """Draws freehand; when the button comes up a Bézier path is fitted, within ``tolerance`` pixels."""

    name, icon, key, kind = "freehand", "scribble-loop", "F", Curve

    def __init__(self, focus: CurveFocus) -> None:
        super().__init__(focus.session)
        self.focus = focus
        self.tolerance = FIT_PX
        self._drawn: list[tuple[float, float]] = []

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Freehand")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Drag on the canvas to draw a curve freehand.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Begin a stroke."""
        self._drawn = [(x, y)]
        self.begin()

    def move(self, x: float, y: float) -> None:
        """Go on with it."""
        if self.busy and (x, y) != self._drawn[-1]:
            self._drawn.append((x, y))
            self.band = np.array(self._drawn)

    def release(self, x: float, y: float) -> None:
        """Fit a path; one that ends beside its begin is closed."""
        if not self.busy:
            return
        points, self.band = np.array([*self._drawn, (x, y)]), None
        if float(np.ptp(points, axis=0).max()) < 1.0:
            self.cancel()
            self.failed.emit(_("Drag farther: the line has no length yet."))
            return
        closes = float(np.hypot(*(points[-1] - points[0]))) <= _CLOSE_PX / self.focus.cell_px
        if closes and len(points) > 8:
            points[-1] = points[0]
        made, error = fitted(self.session.sheet, points, self.tolerance, self.next_colour())
        if self.show(add_figure(self.session.sheet.id, made), _("Draw freehand")):
            last = self.session.sheet.figures[-1].id
            self.session.update_state(selection=(last,), active=last, step=0)
            self.failed.emit(fit_words(made, len(points), error))
        self._drawn = []
        self.commit()


def fit_words(curve: Curve, count: int, error: float) -> str:
    """What became of drawn or pasted points."""
    pieces = len(curve.points_world) // 3
    text = ngettext(
        "{pieces} piece passes the {count} points, none of which is more than {error} px away.",
        "{pieces} pieces pass the {count} points, none of which is more than {error} px away.",
        pieces,
    )
    return text.format(pieces=pieces, count=count, error=at_most(error))


class ProbeTool(Tool):
    """Shows the point of the active curve that is nearest to the pointer."""

    name, icon, key, shape = "probe", "crosshair-simple", "M", Qt.CursorShape.CrossCursor

    def __init__(self, focus: CurveFocus) -> None:
        super().__init__(focus.session)
        self.focus = focus

    @property
    def title(self) -> str:
        """What it is called."""
        return _("Nearest point of the curve")

    @property
    def invitation(self) -> str:
        """How to begin."""
        return _("Draw a curve first; then its point nearest to the pointer is found.")

    def press(self, x: float, y: float, modifiers: Modifiers, reach: float) -> None:
        """Go to the u of the nearest point."""
        found, curve = self._found((x, y)), self.focus.curve
        if found is not None and curve is not None:
            self.focus.set_u(share_at(curve, found[0]))

    def move(self, x: float, y: float) -> None:
        """The point follows the pointer."""
        self.focus.probed = (x, y)
        self.focus.changed.emit()

    def cancel(self) -> None:
        """Show it no longer."""
        super().cancel()
        self.focus.probed = None

    def _found(self, at: tuple[float, float]) -> tuple[float, float, float, float] | None:
        """u, x, y of the point that the text of the closest point finds, and how far it is."""
        curve = self.focus.curve
        pieces = None if curve is None else device_pieces(self.session.sheet, curve)
        return None if pieces is None else list(closest_point(*in_rows(pieces), *at))[-1]

    def drawn(self) -> list[Drawn]:
        """The way from the pointer to the curve, its length and the u there."""
        at = self.focus.probed
        found = None if at is None else self._found(at)
        if at is None or found is None:
            return []
        u, x, y, away = found
        words = _("{away:.3g} px, u = {u:.4g}").format(away=away, u=u)
        return [
            PenStroke(np.array([at, (x, y)]), "data2", 1.75, "dash", haloed=True),
            Marker(x, y, "data2", "dot", 9),
            Word(words, x, y, "text", 1, -1, carded=True),
        ]
