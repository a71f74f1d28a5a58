"""The page Random scan as a person uses it: step, type, insert, drag the number of lines, store, erase."""

import re

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from tests.panels.display.conftest import put_on_screen
from workbench.display.flicker import critical_frequency_hz
from workbench.display.vector_timing import VectorTiming, vector_displays
from workbench.document import DocumentError
from workbench.document.edits import remove_figures
from workbench.document.subjects import Subject
from workbench.panels.display.vector.architecture import lit_parts
from workbench.panels.display.vector.list_model import COLOUR, INTENSITY, X, Y
from workbench.panels.display.vector.page import VectorPage
from workbench.rendering.subjects.random_scan import program_for
from workbench.rendering.subjects.registry import checked
from workbench.session.session import Session
from workbench.widgets.tube.stroke_view import beside


@pytest.fixture
def page(vector_page: VectorPage) -> VectorPage:
    return vector_page


def settle(page: VectorPage) -> None:
    """Everything that was asked for is shown."""
    page.session.flush()
    page.refresh()


def typed(page: VectorPage, row: int, column: int, text: str) -> bool:
    """Type into a cell of the list."""
    done = page.table.model.setData(page.table.model.index(row, column), text)
    settle(page)
    return done


def give(page: VectorPage, **arguments: object) -> None:
    """Set some of the page's numbers."""
    page._give(**arguments)
    settle(page)


def test_the_list_is_that_of_the_sheet_and_ends_with_a_jump(page: VectorPage, session: Session) -> None:
    model = page.table.model
    program = program_for(session.sheet, session.state.subject)
    assert model.rowCount() == len(program)
    assert model.data(model.index(0, 1)) == "MOVE"
    assert model.data(model.index(len(program) - 1, 1)) == "JUMP"
    assert [model.value(1, X), model.value(1, Y)] == [61.0, 6.0]


def test_the_counter_is_linked_with_the_picture_both_ways(
    page: VectorPage, session: Session, qtbot: QtBot
) -> None:
    """A click on a row lets the beam go there; a click on a stroke goes to its row."""
    page.table.address_chosen.emit(3)
    settle(page)
    assert session.run.step_number == 4
    assert page.table.model.current == 3
    trace = page.tube._trace
    assert trace is not None
    assert (trace.address, trace.end, trace.lit) == (3, (14.0, 24.0), True)
    roof = page.tube.position(19.0, 30.0).toPoint()
    QTest.mouseClick(page.tube, Qt.MouseButton.LeftButton, pos=roof)
    settle(page)
    address = page.table.model.current
    assert page._run is not None
    stroke = page._run.program.stroke_of[address]
    assert page._run.program.strokes.ends[stroke].tolist() == [[10.0, 23.0], [28.0, 37.0]]
    QTest.mouseClick(page.tube, Qt.MouseButton.LeftButton, pos=QPoint(2, 2))
    settle(page)
    assert page.table.model.current == address


def test_a_frame_that_is_stepped_shows_what_it_has_drawn(page: VectorPage, session: Session) -> None:
    page.go_to(1)
    settle(page)
    assert page.tube.driver is not None
    assert len(page.tube.driver.beam.segments) < 6
    assert page._run is not None
    assert page._run.working.drawn.shape == (1, 2, 2)
    session.run.first()
    settle(page)
    assert page.tube._trace is None
    assert page._run.strokes_now is page._run.program.strokes


def test_the_instruction_that_is_run_is_in_sight_with_its_mark_whatever_list_comes(
    page: VectorPage, session: Session, qtbot: QtBot
) -> None:
    view, model = page.table.view, page.table.model

    def is_seen(address: int) -> bool:
        place = view.visualRect(model.index(address, 0))
        metrics = QFontMetrics(model.data(model.index(address, 0), Qt.ItemDataRole.FontRole))
        room = metrics.horizontalAdvance(model.data(model.index(address, 0)))
        return view.viewport().rect().contains(place) and room <= place.width()

    last = model.rowCount() - 1
    page.go_to(last)
    settle(page)
    assert is_seen(last)
    model.beginResetModel()  # another list of the same length
    model.endResetModel()
    view.scrollToTop()
    page.table.show_address(last)
    assert is_seen(last)
    page.resize(900, 440)
    qtbot.waitUntil(lambda: is_seen(last))
    session.run.first()
    settle(page)
    assert view.verticalScrollBar().value() == 0


def test_the_system_says_where_its_list_runs_until_it_was_run(qtbot: QtBot, session: Session) -> None:
    page = VectorPage(session)
    ((_name, _title, dock, _side),) = page.docks()
    keep_until_the_end(qtbot, page)
    with qtbot.waitExposed(dock):
        dock.show()
    assert not page.architecture.isVisible()
    QTest.mouseClick(page.system.button, Qt.MouseButton.LeftButton)
    assert session.state.workspace == "vector"
    put_on_screen(qtbot, page, 900, 560)
    session.flush()
    page.refresh()
    assert page.architecture.isVisible()
    assert page.table.view.hasFocus()  # no longer in the dock, where keys would step nothing
    assert "nothing runs" in page.architecture.accessibleDescription()


@pytest.mark.parametrize(("operation", "parts"), [(0, "deflection"), (1, "intensity"), (2, "processor")])
def test_the_parts_that_work_light_up(page: VectorPage, qtbot: QtBot, operation: int, parts: str) -> None:
    assert parts in lit_parts(operation)
    assert not lit_parts(-1)
    page.go_to({0: 0, 1: 1, 2: len(page.table.model.program or ()) - 1}[operation])
    settle(page)
    qtbot.waitUntil(lambda: "at work" in page.architecture.accessibleDescription())
    page.architecture.resize(420, 220)
    assert not page.architecture.grab().isNull()


def test_a_typed_number_changes_the_figure_and_is_undone(page: VectorPage, session: Session) -> None:
    before = session.document
    assert typed(page, 1, X, "50/2")
    assert page.table.model.value(1, X) == 25.0
    assert session.sheet.figures[0].points_world[1].x == 25.0
    session.undo_stack.undo()
    settle(page)
    assert session.document == before
    assert page.table.model.value(1, X) == 61.0


def test_intensity_and_colour_are_typed(page: VectorPage, session: Session) -> None:
    assert typed(page, 1, INTENSITY, "100 %")
    assert page.table.model.value(1, INTENSITY) == 100.0
    assert typed(page, 1, COLOUR, "2")
    assert session.sheet.figures[0].colour == 2


@pytest.mark.parametrize(
    ("column", "text", "words"),
    [
        (X, "far", "far"),
        (INTENSITY, "120", "no intensity"),
        (COLOUR, "99", "no colour of the palette"),
        (X, "64", "beyond the screen"),
        (Y, "-1", "beyond the screen"),
        (X, "1e12", "beyond the screen"),
    ],
)
def test_rubbish_is_said_and_nothing_is_lost(
    page: VectorPage, session: Session, column: int, text: str, words: str
) -> None:
    before, said = session.document, []
    page.hover_text.connect(said.append)
    typed(page, 1, column, text)
    assert session.document == before
    assert any(words in sentence for sentence in said)


def test_strokes_are_inserted_deleted_and_moved_by_keys(page: VectorPage, session: Session) -> None:
    model = page.table.model
    count = model.rowCount()
    page.table.view.setCurrentIndex(model.index(1, 0))
    actions = {action.objectName().removeprefix("vector."): action for action in page.table.changes}
    actions["stroke"].trigger()
    settle(page)
    assert model.rowCount() == count + 1
    actions["delete"].trigger()
    settle(page)
    assert model.rowCount() == count
    ground = session.sheet.figures[0].id
    page.table.view.setCurrentIndex(model.index(1, 0))
    actions["later"].trigger()
    settle(page)
    assert session.sheet.figures[0].id != ground
    while session.undo_stack.canUndo():
        session.undo_stack.undo()
    settle(page)
    assert session.sheet.figures[0].id == ground


def test_an_order_saves_time_and_can_be_kept(page: VectorPage, session: Session) -> None:
    assert page._run is not None
    plain = page._run.budget.time.list_ps
    give(page, ordered=True)
    assert page._run.budget.time.list_ps < plain
    assert page._run.budget.unordered_ps == plain
    assert "saves" in page.note.text()
    said: list[str] = []
    page.hover_text.connect(said.append)
    page.table.wanted.emit("delete")
    assert "keep it, or switch it off" in said[-1]
    short = page._run.budget.time.list_ps
    page.keep_order()
    settle(page)
    assert not page.bar.ordered.isChecked()
    assert page._run.budget.time.list_ps == pytest.approx(short, rel=1e-6)


def test_dragged_and_by_formula_the_flicker_begins_at_the_same_line(page: VectorPage, qtbot: QtBot) -> None:
    """Lines are asked for on the plot; the meter says of each whether it flickers."""
    give(page, lines=10, length=30.0)
    assert page._run is not None
    most = page._run.budget.most
    assert most is not None
    assert most > 50
    page.plot.lines_wanted.emit(most)
    settle(page)
    assert page._run.budget.lines == most
    assert not page._run.budget.flickers
    assert "enough for the eye" in page.note.text()
    page.plot.lines_wanted.emit(most + 1)
    settle(page)
    assert page._run.budget.flickers
    assert "It flickers." in page.note.text()
    assert page._run.budget.most == most
    assert f"{most:,}" in page.sums.text()


def test_the_limit_is_worked_out_from_numbers_that_the_page_says(page: VectorPage) -> None:
    for arguments in ({"lines": 600, "length": 24.0}, {"lines": 0}, {"lines": 90, "settle": 40.0}):
        give(page, **arguments)
        assert page._run is not None
        eye, line, most = re.findall(r"⌊([\d.,]+) / ([\d.]+)⌋ = ([\d,]+)", page.sums.text())[0]
        eye_us, most_lines = (float(number.replace(",", "")) for number in (eye, most))
        assert eye_us // float(line) == most_lines == page._run.budget.most
        asks = re.search(r"asks for ([\d.]+) Hz", page.note.text())
        assert asks is not None
        assert float(asks[1]) == pytest.approx(1e6 / eye_us, rel=5e-3)


def test_the_counter_beside_the_beam_is_on_the_glass() -> None:
    glass, size = QRectF(0.0, 0.0, 200.0, 150.0), QSize(30, 12)
    for x in range(0, 201, 5):
        for y in range(0, 151, 5):
            base = beside(QPointF(x, y), size, glass)
            word = QRectF(base.x(), base.y() - 12.0, 30.0, 12.0)
            assert glass.adjusted(0.0, 0.0, 0.0, 8.0).contains(word)
            assert not word.contains(QPointF(x, y))


@pytest.mark.parametrize("width", [560, 660, 1000])
def test_its_bar_flows_and_cuts_nothing(page: VectorPage, width: int) -> None:
    give(page, lines=600)
    page.resize(width, 460)
    settle(page)
    bar = page.bar
    typed_into = bar.fields["pace"].field
    typed_into.setText("x")
    QTest.keyClick(typed_into, Qt.Key.Key_Return)
    settle(page)
    parts = [bar.display, bar.phosphor, bar.ordered, bar.storage, *bar.fields.values(), bar.complaint]
    rooms = [part.geometry() for part in parts]
    for part, room in zip(parts, rooms, strict=True):
        assert part.isVisible()
        assert bar.rect().contains(room)
        assert room.width() >= part.sizeHint().width()
        assert sum(room.intersects(other) for other in rooms) == 1


def test_the_keys_of_the_plot_ask_for_lines(page: VectorPage, qtbot: QtBot) -> None:
    give(page, lines=10)
    asked: list[int] = []
    page.plot.lines_wanted.connect(asked.append)
    page.plot.setFocus()
    QTest.keyClick(page.plot, Qt.Key.Key_Right)
    settle(page)
    QTest.keyClick(page.plot, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert asked == [11, 21]


@pytest.mark.parametrize("display", vector_displays())
def test_every_display_can_be_chosen(page: VectorPage, display: str) -> None:
    give(page, display=display)
    assert page._run is not None
    assert page.tube.refresh_hz == pytest.approx(page._run.budget.time.refresh_hz, rel=1e-6)
    assert page.bar.uncertain.isVisible() == bool(VectorTiming.named(display).uncertain)
    assert "_" not in page.bar.uncertain.toolTip()


def test_an_overloaded_list_flickers_and_says_so(page: VectorPage) -> None:
    page.overload()
    settle(page)
    assert page._run is not None
    assert page._run.budget.flickers
    fusion = critical_frequency_hz(100.0, 2.0)
    assert page._run.budget.time.refresh_hz < fusion
    page.draw_sheet()
    settle(page)
    assert page._run.budget.lines == 64


def test_numbers_of_another_display_are_typed_and_checked(page: VectorPage, session: Session) -> None:
    field = page.bar.fields["pace"]
    field.field.setText("0.5")
    field.field.setModified(True)
    field._commit()
    settle(page)
    assert page._run is not None
    assert page._run.budget.timing.ps_per_unit == pytest.approx(500_000)
    field.field.setText("0")
    field._commit()
    assert field.field.property("wrong")
    for bad in ({"refresh": 0.0}, {"pace": 0.0}, {"lines": 1.5}, {"lines": 10**9}, {"settle": -1.0}):
        with pytest.raises(DocumentError):
            checked(Subject("random_scan", arguments=bad))


def test_an_empty_sheet_says_that_its_list_is_empty(page: VectorPage, session: Session) -> None:
    session.apply(remove_figures([figure.id for figure in session.sheet.figures]), "Delete")
    settle(page)
    assert page.nothing.isVisible()
    assert page.table.model.rowCount() == 0
    assert page.derivation() is not None
    page.table.wanted.emit("stroke")
    settle(page)
    assert page.table.model.rowCount() == 3
    assert not page.nothing.isVisible()


def test_its_tables_and_its_page_can_be_exported(page: VectorPage) -> None:
    titles = [title for title, _table in page.tables()]
    assert titles == ["Display list", "Refresh rate"]
    lists = page.tables()[0][1]
    assert len(lists.rows) == page.table.model.rowCount()
    derivation = page.derivation()
    assert derivation is not None
    from workbench.exchange.diagrams import Drawing
    from workbench.widgets.formulas.paper import write_pdf

    assert sum(isinstance(block, Drawing) for block in derivation.blocks) == 1
    assert write_pdf(derivation).startswith(b"%PDF")
    assert page.copy()


def test_what_is_drawn_can_be_seen_stroke_by_stroke_without_a_jump_of_the_numbers(page: VectorPage) -> None:
    """The times of the table are those of the run's hand table."""
    run = page.session.run
    assert run.steps is not None
    for number in (1, 2, 5, len(run.steps)):
        row = run.steps.row(number)
        assert page.table.model.value(number - 1, 6) == pytest.approx(row[5], abs=1e-5)
    assert np.isfinite([page.table.model.value(k, 6) for k in range(5)]).all()


def test_the_paper_of_a_storage_tube_has_no_refresh(page: VectorPage) -> None:
    derivation = page.derivation()
    assert derivation is not None
    assert "1 / max" in str(derivation.blocks)
    give(page, storage=True, ordered=True)
    derivation = page.derivation()
    assert derivation is not None
    said = str(derivation.blocks)
    assert f"{len(page._run.program.strokes):,} · 40 / 9600" in said  # type: ignore[union-attr]
    assert not any(words in said for words in ("1 / max", "the eye asks", "Nearest end first"))


def test_where_it_is_low_the_tube_has_the_height_of_the_plot(page: VectorPage, qtbot: QtBot) -> None:
    assert page.plot.isVisible()
    page.resize(650, 330)
    qtbot.waitUntil(lambda: not page.plot.isVisible())
    page.refresh()
    assert not page.plot.isVisible()
    page.resize(900, 560)
    qtbot.waitUntil(page.plot.isVisible)
