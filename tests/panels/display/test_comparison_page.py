"""The page Raster or random as a person uses it: one glass over both tubes, areas, numbers, the answer."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen
from workbench.exchange.diagrams import Drawing
from workbench.panels.display.comparison.page import PAGE, ComparisonPage
from workbench.rendering.hatching import filled_pixels, hatched
from workbench.rendering.subjects.comparison import lens_of
from workbench.session.session import Session
from workbench.widgets.formulas.paper import write_pdf

EXAMPLE = "raster-or-random"


@pytest.fixture
def page(qtbot: QtBot, session: Session) -> ComparisonPage:
    made = ComparisonPage(session)
    put_on_screen(qtbot, made, 900, 560)
    session.visit(PAGE, ComparisonPage.usual)
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
    settle(made)
    return made


def settle(page: ComparisonPage) -> None:
    """Everything that was asked for is shown."""
    page.session.flush()
    page.refresh()
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
