"""A sheet of many figures is made ready a few figures a turn, and shown as far as it is."""

from msgspec.structs import replace
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.document import edits
from workbench.document.model import AnyFigure, Document, Line, Rectangle, Sheet, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.rendering import frame_buffer
from workbench.session.session import Session
from workbench.session.unfolding import FEW


def line(number: int) -> Line:
    x, y = number % 60, number % 47
    points = WorldPoint(f"p{2 * number}", x, y), WorldPoint(f"p{2 * number + 1}", x + 3, y + 2)
    return Line(f"f{number}", points, "bresenham_line", colour=1)


def lines(count: int) -> Document:
    document = blank_sheet()
    figures = tuple(line(number) for number in range(count))
    return replace(document, sheets=(replace(document.sheets[0], figures=figures),))


class Prepared:
    """What was made ready, by turns of the event loop."""

    def __init__(self, session: Session) -> None:
        self.turns = [0]
        self.ids: list[str] = []
        self.grown: list[int] = []
        session.unfolding.prepare_by(self.prepare)
        session.unfolding.progressed.connect(lambda _ready, _total: self.turns.append(0))
        session.unfolding.grown.connect(lambda: self.grown.append(len(session.shown.figures)))

    def prepare(self, _sheet: Sheet, figure: AnyFigure) -> None:
        self.turns[-1] += 1
        self.ids.append(figure.id)


def test_few_figures_are_shown_at_once(qtbot: QtBot) -> None:
    session = Session(document=lines(FEW))
    prepared = Prepared(session)
    assert session.shown is session.sheet
    assert prepared.ids == []


def test_many_come_a_few_a_turn_and_are_shown_ever_more_seldom(qtbot: QtBot) -> None:
    session = Session(document=lines(20 * FEW))
    prepared = Prepared(session)
    first = session.shown
    assert len(first.figures) <= FEW
    assert session.shown is first  # so that what it is drawn by is remembered
    qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)
    assert max(prepared.turns) <= FEW
    assert sorted(prepared.ids) == sorted(figure.id for figure in session.sheet.figures)
    assert prepared.grown == sorted(set(prepared.grown))
    assert prepared.grown[-1] == 20 * FEW
    assert len(prepared.grown) < 10
    session.apply(edits.move_figures(["f7"], 1.0, 0.0), "Move")
    assert session.shown is session.sheet  # an edit is shown at once


def test_what_is_shown_keeps_its_order_and_holds_what_is_worked_on(qtbot: QtBot) -> None:
    session = Session(document=lines(10 * FEW))
    Prepared(session)
    last = session.sheet.figures[-1].id
    session.update_state(selection=(last,), active=last)
    assert last in {figure.id for figure in session.shown.figures}
    session.apply(edits.move_figures([last], 1.0, 0.0), "Move")
    assert session.sheet.figures[-1] in session.shown.figures
    session.unfolding._turn()
    order = [figure.id for figure in session.sheet.figures]
    places = [order.index(figure.id) for figure in session.shown.figures]
    assert places == sorted(places)
    qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)


def test_another_document_another_window_and_another_panel_begin_anew(qtbot: QtBot) -> None:
    session = Session(document=lines(3 * FEW))
    Prepared(session)
    assert session.shown is not session.sheet
    session.new(lines(2))
    assert session.shown is session.sheet
    QApplication.processEvents()
    session.new(lines(3 * FEW))
    qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)
    session.apply(edits.set_window(session.sheet.first_view.id, Rectangle(0, 0, 32, 24)), "Window")
    assert session.shown is not session.sheet
    qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)
    session.unfolding.prepare_by(lambda _sheet, _figure: None)
    assert session.shown is not session.sheet
    qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)


def test_the_canvas_shows_what_there_is_so_far_and_in_the_end_all(qtbot: QtBot) -> None:
    for kind in (DrawPanel, CurvesPanel):
        session = Session(document=lines(2))
        panel = kind(session)
        qtbot.addWidget(panel.center)
        panel.center.show()
        panel.choose_tool("select")
        session.new(lines(8 * FEW))
        prepared = Prepared(session)
        session.flush()
        panel.refresh()
        assert (panel.canvas._picture.pixels != frame_buffer(session.sheet)).any()
        qtbot.waitUntil(lambda: session.shown is session.sheet, timeout=20_000)  # noqa: B023
        assert max(prepared.turns) <= FEW
        panel.refresh()
        painted = panel.canvas._picture.pixels != panel.canvas._picture.background
        assert (painted == (frame_buffer(session.sheet) != session.sheet.palette[0])).all()
        session.close()
