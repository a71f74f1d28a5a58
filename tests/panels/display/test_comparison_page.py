"""The page Raster or random as a person uses it: one glass over both tubes, areas, numbers, the answer."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QFontMetrics, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen, run_whole
from workbench.algorithms.marks import Word
from workbench.algorithms.scanning.operations import NAMES
from workbench.display.setup import mm_of
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Drawing
from workbench.panels.display.comparison.derivation import _buffer, _random
from workbench.panels.display.comparison.facts import Facts, features
from workbench.panels.display.comparison.page import PAGE, ComparisonPage
from workbench.panels.shared import lighting
from workbench.rendering.display_program import DisplayProgram
from workbench.rendering.hatching import filled_pixels, hatched
from workbench.rendering.scene import backdrop
from workbench.rendering.subjects import raster
from workbench.rendering.subjects.comparison import lens_of
from workbench.session.session import Session
from workbench.shell.style_sheet import style_sheet
from workbench.widgets.formulas.paper import write_pdf
from workbench.widgets.look.tokens import LIGHT

EXAMPLE = "raster-or-random"


@pytest.fixture
def page(qtbot: QtBot, session: Session) -> ComparisonPage:
    made = ComparisonPage(session)
    put_on_screen(qtbot, made, 900, 560)
    run_whole(qtbot, session, PAGE, ComparisonPage.usual)
    settle(made)
    return made


def settle(page: ComparisonPage) -> None:
    """Everything that was asked for is shown."""
    page.session.flush()
    page.refresh()
    page._show_raster()
    page._show_vector()
    page._show_lenses()


def place(page: ComparisonPage) -> tuple[float, float]:
    """Where the glass is."""
    return lens_of(page.session.sheet, page.session.state.subject)


def test_both_tubes_show_the_picture_and_the_glass_is_over_both(page: ComparisonPage) -> None:
    for view in (page.raster, page.vector):
        assert view.driver is not None
        assert max(float(light.max()) for light in view.driver.lights) > 0.3
    assert all(lens.isVisible() for lens in page.lenses)
    page.commands()[0].setChecked(False)
    assert not any(lens.isVisible() for lens in page.lenses)


@pytest.mark.parametrize("of", ["raster", "vector"])
def test_the_pointer_and_the_arrows_move_the_glass_on_both(page: ComparisonPage, of: str) -> None:
    view = getattr(page, of)
    at = view.position(12.0, 30.0)
    event = QMouseEvent(
        QEvent.Type.MouseMove, at, QPointF(view.mapToGlobal(at)), Qt.MouseButton.NoButton,
        Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier,
    )  # fmt: skip
    QApplication.sendEvent(view, event)
    settle(page)
    assert place(page) == (12.0, 30.0)
    view.setFocus()
    for held in (Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.AltModifier):
        QTest.keyClick(view, Qt.Key.Key_Right, held)  # is not this page's
    QTest.keyClick(view, Qt.Key.Key_Right)
    QTest.keyClick(view, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    settle(page)
    assert place(page) == (13.0, 25.0)
    assert page.bar.fields["x"].value() == 13.0
    QTest.keyClick(view, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    for _press in range(20):
        QTest.keyClick(view, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert place(page)[0] == 0.0


def test_areas_are_hatched_on_the_vector_tube_and_that_costs_lines(page: ComparisonPage) -> None:
    assert page.facts is not None
    hatched_lines, ms = len(page.facts.program.strokes), page.facts.time.list_ps
    assert page.facts.hatches > 0
    assert "hatched" in page.note.text()
    page.bar.give(hatch=0)
    settle(page)
    assert page.facts.hatches == 0
    assert len(page.facts.program.strokes) < hatched_lines
    assert page.facts.time.list_ps < ms
    assert "outlines" in page.note.text()


def test_a_hatch_of_every_row_is_the_fill(session: Session) -> None:
    """One stroke for each span, as long as it is wide."""
    strokes = hatched(session.sheet, 1)
    lengths = (strokes.ends[:, 1, 0] - strokes.ends[:, 0, 0] + 1).sum()
    assert 0 <= filled_pixels(session.sheet) - lengths <= len(strokes) + 40  # spans of a single pixel
    assert len(hatched(session.sheet, 3)) < len(strokes)


def test_the_numbers_of_the_table_are_those_of_the_picture(page: ComparisonPage) -> None:
    (title, table), *_more = page.tables()
    assert title == "Raster and random scan"
    rows = {row[0]: row for row in table.rows}
    assert "64 · 48 · 24 bits = 9,216 bytes" in rows["Memory"][1]
    assert page.facts is not None
    assert f"{4 * len(page.facts.program):,} bytes" in rows["Memory"][2]
    assert "16.7 ms, 60 Hz" in rows["Refresh"][1]
    assert f"{page.facts.stairs:,} stairs" in rows["Smoothness"][1]
    assert page.table.rowCount() == len(table.rows)
    page.table.setCurrentCell(1, 0)
    assert page.note.text() == rows["Memory"][3]


def test_one_of_a_kind_and_none_are_said_as_such(page: ComparisonPage, session: Session) -> None:
    facts = page.facts
    assert facts is not None
    one = facts._replace(filled=1, hatches=1, stairs=1, program=_first_line(facts))
    words = {row.name: (row.raster, row.random) for row in features(one)}
    assert words["Beam"][1] == "from end to end of 1 stroke, and nowhere else"
    assert words["Smoothness"][0].startswith("staircase: 1 stair in")
    assert words["Areas, realism"][0].startswith("1 pixel filled;")
    assert words["Areas, realism"][1].endswith("1 stroke of hatching")
    words = {row.name: (row.raster, row.random) for row in features(facts._replace(filled=0, stairs=0))}
    assert words["Areas, realism"][0].startswith("nothing is filled here;")
    assert words["Smoothness"][0] == "no stairs: no line here is slanted"


def _first_line(facts: Facts) -> DisplayProgram:
    """The list of the first line alone."""
    program = facts.program
    return replace(program, strokes=program.strokes.cut(1))


def test_the_mark_on_the_plot_asks_how_often_so_many_lines_are_drawn(page: ComparisonPage) -> None:
    facts = page.facts
    assert facts is not None
    lines = 3 * facts.as_long_as_raster
    page.plot.lines_wanted.emit(lines)
    said = page.plot.accessibleDescription()
    assert said.startswith(f"{lines:,} lines: 2")  # a third of 60 Hz, and a little
    page.bar.give(hatch=0)
    settle(page)
    assert page.plot._lines == len(page.facts.program.strokes)


def test_stepped_the_glass_shows_no_more_than_the_tubes(page: ComparisonPage, session: Session) -> None:
    page.bar.give(x=31.0, y=20.0)
    settle(page)
    whole = [lens.grab().toImage() for lens in page.lenses]
    session.run.go_to_step(1)
    settle(page)
    assert not page.raster._image.any()
    for lens, before in zip(page.lenses, whole, strict=True):
        now = lens.grab().toImage()
        assert now != before
        middle = now.pixelColor(now.width() // 2, now.height() // 2)
        assert middle.lightness() < 40


@pytest.mark.parametrize("all_rows", [False, True])
def test_the_comparison_is_copied_as_a_table(page: ComparisonPage, all_rows: bool) -> None:
    assert page.facts is not None
    page.table.setCurrentCell(2, 1)
    page.table.actions()[0].trigger() if all_rows else page.table.copy()
    lines = QApplication.clipboard().text().rstrip().splitlines()
    assert len(lines) == 1 + (8 if all_rows else 1)
    assert lines[0].split("\t")[1:] == ["Raster scan", "Random scan"]
    assert any("16.7 ms, 60 Hz" in line for line in lines)


@pytest.mark.parametrize("width", [290, 460])
def test_a_narrow_table_leaves_its_words_room(qtbot: QtBot, page: ComparisonPage, width: int) -> None:
    """No word is cut, and the two columns have the most of the width."""
    table = page.table
    put_on_screen(qtbot, table, width, 300)
    QApplication.processEvents()
    first, *columns = (table.columnWidth(column) for column in range(3))
    assert first <= max(0.36 * width, 92)
    for row in range(table.rowCount()):
        for column, room in enumerate((first, *columns)):
            item = table.item(row, column)
            assert item is not None
            longest = max(item.text().split(), key=len)
            assert QFontMetrics(item.font()).horizontalAdvance(longest) <= room


def test_stairs_are_counted_as_the_raster_has_them(page: ComparisonPage, session: Session) -> None:
    session.open_example("line")
    session.visit(PAGE, ComparisonPage.usual)
    settle(page)
    assert page.facts is not None
    assert page.facts.stairs == 8  # from (20, 10) to (30, 18)


def test_stepped_the_raster_has_come_as_far_in_the_same_time(page: ComparisonPage, session: Session) -> None:
    session.run.go_to_step(20)
    settle(page)
    assert page.facts is not None
    trace = page.vector._trace
    assert trace is not None
    assert trace.address == 19
    _address, seconds = page._position(page.facts)
    lines = int(seconds / float(page.facts.raster.line_s))
    assert not page.raster._image[: 48 - lines].any()


def test_the_page_answers_question_10(page: ComparisonPage) -> None:
    derivation = page.derivation()
    assert derivation is not None
    assert sum(isinstance(block, Drawing) for block in derivation.blocks) == 2
    assert write_pdf(derivation).startswith(b"%PDF")
    assert page.copy()


def test_a_moved_glass_measures_nothing_anew_and_feeds_no_tube(page: ComparisonPage) -> None:
    facts, beams = page.facts, [view.driver.beam for view in (page.raster, page.vector) if view.driver]
    page.bar.give(x=7.0, y=9.0, power=12.0)
    settle(page)
    assert place(page) == (7.0, 9.0)
    assert page.facts is facts
    assert [view.driver.beam for view in (page.raster, page.vector) if view.driver] == beams
    page.bar.give(refresh=75.0)
    settle(page)
    assert page.facts is not facts


def test_a_listed_program_ends_with_its_one_jump(page: ComparisonPage, session: Session) -> None:
    session.open_example("line")
    session.visit(PAGE, ComparisonPage.usual)
    settle(page)
    assert page.facts is not None
    words = [item.text for item in _random(page.facts).items if isinstance(item, Word)]
    assert [word.split()[0] for word in words if word.split()[0] in NAMES] == ["MOVE", "DRAW", "JUMP"]


@pytest.mark.parametrize("size", [(640, 480), (480, 640), (64, 48), (300, 900)])
def test_the_pitch_is_that_of_the_face(page: ComparisonPage, size: tuple[int, int]) -> None:
    assert page.facts is not None
    beside = mm_of(1.0, 0.0, size)[0] - mm_of(0.0, 0.0, size)[0]
    assert page.facts._replace(size=size).pitch_mm == pytest.approx(beside)


@given(st.integers(1, 40), st.integers(1, 40), st.randoms(use_true_random=False))
@settings(max_examples=30, deadline=None)
def test_the_part_of_the_buffer_that_is_drawn_is_lit_by_half_if_any_is(width, height, random) -> None:
    """Of all parts as large none is nearer to half."""
    image = np.array([[random.random() < 0.3 for _x in range(width)] for _y in range(height)], np.uint32)
    cells = [item.text for item in _buffer(image) if isinstance(item, Word)][1:]
    rows, columns = min(6, height), min(8, width)
    assert len(cells) == rows * columns
    half = rows * columns // 2
    away = min(
        abs(int(image[y : y + rows, x : x + columns].sum()) - half)
        for y in range(height - rows + 1)
        for x in range(width - columns + 1)
    )
    assert abs(cells.count("1") - half) == away


@pytest.mark.parametrize("kind", ["comparison", "raster"])
def test_a_scene_is_scanned_as_soon_as_it_can_be_lit(
    page: ComparisonPage, session: Session, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    session.open_example("space-house")
    session.visit(PAGE, ComparisonPage.usual)
    for lit in (False, True):
        for module in (backdrop, lighting, raster):
            monkeypatch.setattr(module, "can_be_lit", lambda _sheet, lit=lit: lit)
        settle(page)
        scan = raster.scan_of(session.sheet, Subject("raster"))
        assert scan is not None
        image = page.raster._image if kind == "comparison" else scan.buffer.shown
        assert bool(image.any()) == lit
        assert page._lighting._due.isActive() != lit
        page._lighting._due.stop()


def test_the_names_of_the_features_are_whole(page: ComparisonPage, qtbot: QtBot) -> None:
    table = page.table
    put_on_screen(qtbot, table, 600, 300)
    qtbot.waitUntil(lambda: table.rowCount() > 0 and table.columnWidth(0) >= table.sizeHintForColumn(0))
    rows = range(table.rowCount())
    qtbot.waitUntil(lambda: all(table.rowHeight(row) >= table.sizeHintForRow(row) for row in rows))


def test_the_display_that_is_chosen_is_named_whole(page: ComparisonPage) -> None:
    page.setStyleSheet(style_sheet(LIGHT))
    QApplication.processEvents()
    assert page.bar.display.words_seen() == page.bar.display.currentText() == "Free vector display"
