"""What a session keeps in the file beside the picture: it is saved, but never a step of undo."""

from typing import Annotated, Literal

import msgspec

from workbench.algorithms import catalogue
from workbench.document.check import number_problem, refuse, shown
from workbench.document.fields import Number, numbers_of
from workbench.document.model import MAX_SIDE_PX, Document
from workbench.language import _

LONGEST_TIME_S = 1e9


def _drive(label: str, low: float, high: float, unit: str = "") -> Number:
    return Number(label=label, low=low, high=high, unit=unit, keyed=False)


class TubeSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the tubes are driven; ``slow_motion`` times slower than life, ``time_s`` on the tube's clock.

    ``persistence`` stretches the phosphor's decay, ``vector_display`` names the speeds of the vector tube.
    """

    shown: Literal["both", "raster", "vector"] = "both"
    phosphor: str = "P31"
    refresh_hz: Annotated[float, _drive(_("refresh rate"), 0.1, 1000.0, "Hz")] = 60.0
    slow_motion: Annotated[float, _drive(_("slow motion"), 0.001, 1e9)] = 1.0
    persistence: Annotated[float, _drive(_("persistence"), 0.01, 100.0)] = 1.0
    vector_display: str = "teaching"
    paused: bool = False
    time_s: Annotated[float, _drive(_("time"), 0.0, LONGEST_TIME_S, "s")] = 0.0


class SessionState(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Current sheet, selected and active figures (ids), the compared algorithm, the cursor, the tube.

    An empty ``sheet`` means the first one, an empty ``compare`` no comparison. ``step`` counts rows of the
    hand table, or lines in ``detail``; ``ask_first`` hides the next pixel until it was guessed. ``stepped``
    tells which run of the active figure is stepped: its algorithm's, that of the sheet's clipper, or of a
    curve its ``construction`` (empty: that of its kind) at ``curve_u``, a share of the range of u.
    ``pixel`` (x, y) is the one that is asked about: why is it as it is.
    """

    sheet: str = ""
    selection: tuple[str, ...] = ()
    active: str = ""
    compare: str = ""
    step: int = 0
    detail: bool = False
    ask_first: bool = False
    stepped: Literal["figure", "clipper", "curve"] = "figure"
    pixel: tuple[int, int] | None = None
    tube: TubeSettings = TubeSettings()
    curve_u: float = 0.5
    construction: str = ""


def check_state(state: SessionState, document: Document) -> SessionState:
    """``state`` itself when all it refers to is in ``document``; raises DocumentError with the field."""
    figures = {figure.id for sheet in document.sheets for figure in sheet.figures}
    if state.sheet and all(sheet.id != state.sheet for sheet in document.sheets):
        raise refuse("session.sheet", _missing(state.sheet))
    for index, figure in enumerate(state.selection):
        if figure not in figures:
            raise refuse(f"session.selection[{index}]", _missing(figure))
    if state.active and state.active not in figures:
        raise refuse("session.active", _missing(state.active))
    if catalogue.known(state.compare):  # one that is not known stays: a newer program may have written it
        entry = catalogue.get(state.compare)
        if not (entry.draws or entry.clips):
            raise refuse("session.compare", _missing(state.compare))
    if catalogue.known(state.construction) and not catalogue.get(state.construction).constructs:
        raise refuse("session.construction", _missing(state.construction))
    if not 0.0 <= state.curve_u <= 1.0:
        problem = _("is {value}; give a number between {low:g} and {high:g}")
        raise refuse("session.curve_u", problem.format(value=shown(state.curve_u), low=0, high=1))
    if state.pixel is not None and not all(0 <= side < MAX_SIDE_PX for side in state.pixel):
        problem = _("is {value}; give a column and a row from 0")
        raise refuse("session.pixel", problem.format(value=shown(state.pixel)))
    if not 0 <= state.step < 2**53:
        raise refuse("session.step", _("is {value}; give a whole number from 0").format(value=state.step))
    if not state.tube.phosphor.isalnum() or len(state.tube.phosphor) > 32:
        raise refuse("session.tube.phosphor", _("is not a name; give one such as P31"))
    if len(state.tube.vector_display) > 32:
        raise refuse("session.tube.vector_display", _("is not a name; give one such as teaching"))
    for name, number in numbers_of(TubeSettings).items():
        if problem := number_problem(number, getattr(state.tube, name)):
            raise refuse(f"session.tube.{name}", problem)
    return state


def cleaned(state: SessionState, document: Document) -> SessionState:
    """``state`` without what is no longer in ``document``; the same object when nothing is missing."""
    figures = {figure.id for sheet in document.sheets for figure in sheet.figures}
    sheet = (
        state.sheet if any(known.id == state.sheet for known in document.sheets) else document.sheets[0].id
    )
    selection = tuple(figure for figure in state.selection if figure in figures)
    active = state.active if state.active in figures else ""
    if (sheet, selection, active) == (state.sheet, state.selection, state.active):
        return state
    step = state.step if active == state.active else 0
    return msgspec.structs.replace(state, sheet=sheet, selection=selection, active=active, step=step)


def _missing(identity: str) -> str:
    return _("is {value}, which there is not; remove it or name one that there is").format(
        value=shown(identity)
    )
