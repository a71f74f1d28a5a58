"""What the page Random scan shows of a session: the list, its times, and where its run stands."""

from dataclasses import dataclass
from functools import partial

from workbench.display.list_time import list_time
from workbench.display.refresh_limit import LineTime, longest_steady_s
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.display.vector.architecture import Working
from workbench.panels.display.vector.numbers import Budget
from workbench.panels.shared.tube_feed import setup_of
from workbench.rendering import unshown
from workbench.rendering.display_program import (
    MOST_ORDERED,
    DisplayProgram,
    Strokes,
    program_of,
)
from workbench.rendering.subjects.random_scan import (
    KIND,
    is_ordered,
    length_of,
    lines_of,
    own_strokes,
    program_for,
    runs_a_list,
    shortest_ps_of,
    timing_of,
    units_of,
)
from workbench.session.session import Session
from workbench.widgets.plots.refresh_plot import RefreshCurve
from workbench.widgets.tube.stroke_view import Trace


@dataclass(frozen=True, slots=True, eq=False)
class VectorRun:
    """The list and its ``budget``; the ``address`` that was run last, -1 where none was. ``steps`` tells
    whether a frame is stepped, of which ``drawn`` strokes are there. ``locked`` says why the list cannot be
    changed, ``note`` what else is to be told; ``stores`` that it is on a storage tube.
    """

    program: DisplayProgram
    budget: Budget
    address: int
    drawn: int
    size: tuple[int, int]
    locked: str
    note: str
    stores: bool

    @property
    def steps(self) -> bool:
        """Whether a frame is stepped."""
        return self.address >= 0

    @property
    def strokes_now(self) -> Strokes:
        """What the tube shows: all of it, or what a frame that is stepped has drawn so far."""
        return self.program.strokes.cut(self.drawn) if self.steps else self.program.strokes

    @property
    def trace(self) -> Trace | None:
        """Where the beam is."""
        return Trace.at(self.program, self.address) if self.steps else None

    @property
    def working(self) -> Working:
        """What the parts of the system do."""
        rows, ends = self.program.rows, self.program.strokes.ends
        operation = int(rows[self.address, 0]) if self.steps else -1
        beam = tuple(rows[self.address, 1:3].tolist()) if len(rows) else (0.0, 0.0)
        drawn = ends[: self.drawn] if self.steps else ends[:0]
        return Working(operation, self.address, beam, drawn, ends, self.size, rows)

    @property
    def curve(self) -> RefreshCurve:
        """The rate against the number of lines."""
        budget = self.budget
        return RefreshCurve(
            budget.line.total_ps * 1e-12, budget.shortest_ps * 1e-12, budget.fusion_hz, budget.most
        )


def vector_run(session: Session) -> VectorRun | None:
    """The list of a session's sheet under its subject; a list stepped otherwise is not stepped here.

    None while a large sheet is worked on.
    """
    sheet, subject = session.sheet, session.state.subject
    if not runs_a_list(subject):
        raise ValueError("The page Random scan shows the run of a display list.")
    test, make = bool(lines_of(subject)), partial(_programs, sheet, subject)
    programs = make() if test else session.ahead.of(sheet, "programs", make, is_ordered(subject))
    if programs is None:
        return None
    program, plain = programs
    timing, units, shortest = timing_of(subject), units_of(sheet, subject), shortest_ps_of(subject)
    time = list_time(program.rows, units, timing, shortest)
    unordered = 0 if plain is program else list_time(plain.rows, units, timing, shortest).list_ps
    length = length_of(sheet, subject) * units
    line = LineTime.of(timing, length) if test else LineTime.mean(time, len(program.strokes))
    longest = longest_steady_s(setup_of(session.state.tube).guns())
    budget = Budget(
        timing, units, shortest, time, len(program.strokes), line, length, test,
        1.0 / longest, line.most_lines(longest, shortest), unordered,
    )  # fmt: skip
    address, drawn = _position(session, program)
    size = sheet.width_px, sheet.height_px
    stores = bool(subject.arguments.get("storage", False))
    return VectorRun(
        program, budget, address, drawn, size, _locked(test, is_ordered(subject)),
        _note(session, is_ordered(subject), program), stores,
    )  # fmt: skip


def _programs(sheet: Sheet, subject: Subject) -> tuple[DisplayProgram, DisplayProgram]:
    """The list as it is run, and in the order of the sheet: the same one, unless its strokes are ordered."""
    program = program_for(sheet, subject)
    ordered = is_ordered(subject) and not lines_of(subject)
    return program, program_of(own_strokes(sheet, subject)) if ordered else program


def _position(session: Session, program: DisplayProgram) -> tuple[int, int]:
    """The address that was run last, and how many strokes are drawn by then."""
    run = session.run
    if run.entry is None or run.entry.slug != KIND or not run.position or not len(program):
        return -1, 0
    address = min(run.step_number - 1, len(program) - 1)
    if address < 0:
        return -1, 0
    return address, program.drawn_by(address)


def _locked(test: bool, ordered: bool) -> str:
    if test:
        return _("Test lines belong to no sheet; draw the picture of the sheet to change its list.")
    if ordered:
        return _("This order was made by the display; keep it, or switch it off, to change the list.")
    return ""


def _note(session: Session, ordered: bool, program: DisplayProgram) -> str:
    missing = session.ahead.of(session.sheet, "unshown", partial(unshown, session.sheet)) or ()
    said = list(dict.fromkeys(sentence for _id, sentence in missing))
    if ordered and len(program.strokes) > MOST_ORDERED:
        sentence = _("Of more than {most:,} strokes the order is left as it is.")
        said.append(sentence.format(most=MOST_ORDERED))
    return " ".join(said)
