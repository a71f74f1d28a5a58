"""The page Flicker as a person uses it: numbers, the map, the light, motion, and real flashing."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox
from pytestqt.qtbot import QtBot
from scipy.optimize import brentq

from tests.panels.display.conftest import put_on_screen
from workbench.display.flicker import in_closed_form, zones
from workbench.display.phosphor import Phosphor, names
from workbench.document import DocumentError
from workbench.document.subjects import Subject
from workbench.exchange.diagram_svg import write_diagram
from workbench.exchange.diagrams import Heading, Sentence
from workbench.panels.display.flicker.figures import column_at, moved_picture
from workbench.panels.display.flicker.measures import doubt, verdict
from workbench.panels.display.flicker.page import FlickerPage
from workbench.panels.display.flicker.phosphor_table import PhosphorTable
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.comfort import comfort


@pytest.fixture
def page(qtbot: QtBot, session: Session) -> FlickerPage:
    one = FlickerPage(session)
    put_on_screen(qtbot, one, 1000, 600)
    session.visit("flicker", one.usual)
    session.flush()
    qtbot.waitUntil(lambda: one.tube.driver is not None)
    return one


def typed(qtbot: QtBot, field, text: str) -> None:
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)


def test_numbers_set_the_tube_and_what_is_stepped(qtbot: QtBot, page: FlickerPage, session: Session) -> None:
    typed(qtbot, page.controls.refresh, "90/2")
    session.flush()
    assert session.state.subject.arguments["refresh_hz"] == 45.0
    qtbot.waitUntil(lambda: page.tube.setup.refresh_hz == 45.0)
    assert "45 Hz flickers" in page.measures.verdict.text()
    assert session.run.entry is not None
    assert session.run.entry.slug == "phosphor_decay"
    _terms, dt, steps = session.run.calls[0]
    assert dt * steps == pytest.approx(1000.0 / 45.0)
    assert not session.undo_stack.canUndo()


def test_as_many_periods_are_plotted_as_are_asked_for(qtbot: QtBot, page: FlickerPage) -> None:
    for count in (1, 3):
        typed(qtbot, page.controls.periods, str(count))
        page.session.flush()
        qtbot.waitUntil(lambda count=count: len(page.light._hits) == count + 1)
        assert page.light._formula.ms[-1] == pytest.approx(count * 1000.0 / 60.0, rel=0.01)


def test_typed_rubbish_is_said_in_place_and_changes_nothing(
    qtbot: QtBot, page: FlickerPage, session: Session
) -> None:
    before = session.state
    for text in ("0", "fast", "1e9"):
        typed(qtbot, page.controls.refresh, text)
        assert page.controls.refresh.complaint.text()
        assert page.controls.refresh.field.text() == text
    assert session.state == before


@pytest.mark.parametrize(
    ("name", "value"), [("refresh_hz", 0.0), ("persistence", -1.0), ("steps", 2.5), ("phosphor", 7)]
)
def test_a_file_cannot_set_what_no_field_takes(session: Session, name: str, value) -> None:
    session.visit("flicker", Subject("flicker"))
    with pytest.raises(DocumentError, match=name):
        session.update_state(subject=Subject("flicker", arguments={name: value}))


def test_an_unknown_phosphor_of_a_file_becomes_the_usual_one(page: FlickerPage) -> None:
    page.change({"phosphor": "P77"})
    page.session.flush()
    assert page.controls.phosphor.currentData() == "P31"


def test_formula_and_measured_light_stand_beside_each_other(qtbot: QtBot, page: FlickerPage) -> None:
    page.change({"phosphor": "P1"})
    page.session.flush()
    formula = in_closed_form(Phosphor.named("P1"), 1 / 60)
    qtbot.waitUntil(lambda: "…" not in page.measures.table.rows[0][2], timeout=10000)
    for row, value in zip(page.measures.table.rows[1:], formula[1:], strict=True):
        assert float(row[1]) == pytest.approx(value, abs=6e-4)
        assert float(row[2]) == pytest.approx(value, rel=0.05)
    assert len(page.light._measured.ms)


def test_an_answer_that_comes_late_is_not_shown(qtbot: QtBot, page: FlickerPage) -> None:
    light = page._probed
    page._take_light((page._asked_for - 1, light))  # type: ignore[arg-type]
    assert page._probed is light


def test_the_point_of_the_map_drives_the_tube(qtbot: QtBot, page: FlickerPage, session: Session) -> None:
    page.map.setFocus()
    qtbot.keyClick(page.map, Qt.Key.Key_Left)
    qtbot.keyClick(page.map, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    session.flush()
    assert session.state.subject.arguments["refresh_hz"] == 49.0
    for _press in range(30):
        qtbot.keyClick(page.map, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    session.flush()
    assert session.state.subject.arguments["persistence"] == 100.0
    assert "smears" in page.measures.verdict.text()
    qtbot.waitUntil(lambda: page.tube.setup.persistence == 100.0)


def test_the_point_is_dragged(qtbot: QtBot, page: FlickerPage, session: Session) -> None:
    qtbot.waitUntil(lambda: page.map._plot is not None, timeout=10000)
    viewport, box = page.map._plot.viewport(), page.map._plot.getPlotItem().vb
    qtbot.waitUntil(lambda: viewport.width() > 50)

    def place(hz: float, power: float) -> QPoint:
        from PySide6.QtCore import QPointF

        return page.map._plot.mapFromScene(box.mapViewToScene(QPointF(hz, power)))

    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=place(60.0, -3.5))
    qtbot.mouseMove(viewport, place(30.0, -3.0))
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=place(30.0, -3.0))
    session.flush()
    now = session.state.subject.arguments
    assert now["refresh_hz"] == pytest.approx(30.0, abs=2.0)
    assert now["persistence"] == pytest.approx(1e-3 / 0.00034, rel=0.2)


def test_a_run_is_ringed_in_the_light(qtbot: QtBot, page: FlickerPage, session: Session) -> None:
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
    session.update_state(step=3)
    session.flush()
    stepped = page.light._stepped
    assert len(stepped.ms) == 5  # the hit, three steps, and the ring around the last of them
    assert stepped.ms[-1] == pytest.approx(3 * 1000 / 60 / 12)


def test_a_figure_moves_when_it_is_asked_to_and_leaves_its_trail(
    qtbot: QtBot, page: FlickerPage, session: Session
) -> None:
    page.change({"phosphor": "P39", "figure": "bar", "speed": 300.0})
    session.flush()
    qtbot.waitUntil(lambda: np.count_nonzero(page.image) == 48 * 3)
    held = page.image.copy()
    qtbot.wait(80)
    assert np.array_equal(page.image, held)
    page.controls.moves.click()
    qtbot.waitUntil(lambda: not np.array_equal(page.image, held), timeout=5000)

    def glows_where_the_bar_was() -> bool:
        driver = page.tube.driver
        assert driver is not None
        return bool(driver.lights[0][driver.beam.energy_per_frame() < 1e-9].max() > 0.05)

    qtbot.waitUntil(glows_where_the_bar_was)
    page.controls.moves.click()
    assert not page._moving.isActive()


def test_figures_come_again_at_the_left() -> None:
    assert [column_at((64, 48), 10.0, t) for t in (0.0, 0.15, 6.39, 6.4)] == [0, 1, 63, 0]
    bar = moved_picture("bar", (64, 48), 63)
    assert set(np.nonzero(bar)[1]) == {63, 0, 1}
    spot = moved_picture("spot", (64, 48), 5)
    assert np.count_nonzero(spot) == 16
    assert set(np.nonzero(spot)[1]) == {5, 6, 7, 8}


def test_a_warning_comes_before_real_flashing(qtbot: QtBot, page: FlickerPage) -> None:
    assert comfort.calm
    try:
        page.controls.calm.click()
        assert comfort.calm
        assert page.controls.calm.isChecked()
        assert page.warning.isVisible()
        assert "60 times a second" in page.warning.words.text()
        page.warning.keep.click()
        assert comfort.calm
        assert not page.warning.isVisible()
        page.controls.calm.click()
        page.warning.show_it.click()
        assert not comfort.calm
        assert not page.controls.calm.isChecked()
        page.controls.calm.click()
        assert comfort.calm
    finally:
        comfort.set_calm(True)


def test_every_phosphor_has_its_persistence_source_and_doubts(page: FlickerPage, session: Session) -> None:
    table = dict(page.tables())["Phosphors"]
    assert [row[0] for row in table.rows] == list(names())
    doubts = {row[0]: row[4] for row in table.rows}
    assert "time to 10 %" in doubts["P39"]
    assert doubts["P31"] == "\N{EN DASH}"
    page.phosphors.chosen.emit("P7")
    session.flush()
    assert session.state.subject.arguments["phosphor"] == "P7"
    assert "Tektronix" in page.phosphors.note.text()


def test_every_control_has_a_name_and_a_tooltip(page: FlickerPage) -> None:
    for kind in (QAbstractButton, QComboBox):
        for control in page.controls.findChildren(kind):
            assert control.toolTip(), control.accessibleName()
            assert control.accessibleName() or control.text()
    for plot in (page.map, page.light):
        assert plot.accessibleName()
        assert plot.accessibleDescription()


def test_a_steady_tube_rests(qtbot: QtBot, page: FlickerPage) -> None:
    qtbot.waitUntil(lambda: not page.tube.running, timeout=5000)
    assert not page._moving.isActive()


def test_the_derivation_works_out_why_it_flickers(qtbot: QtBot, page: FlickerPage) -> None:
    page.change({"phosphor": "P39", "refresh_hz": 30.0, "luminance": 100.0})
    page.session.flush()
    qtbot.waitUntil(lambda: page.measures.table.rows[0][2].endswith("%"))
    text = " ".join(block.text for block in page.derivation().blocks if isinstance(block, Heading | Sentence))
    (term,) = Phosphor.named("P39").terms
    percent = np.tanh(1.0 / (60.0 * term.tau_s))
    depth = 2.0 / np.hypot(1.0, 60.0 * np.pi * term.tau_s)

    def above(f: float) -> float:
        """How far the rate that is asked for lies above the rate f that modulates the light."""
        return 60.0 + 16.6 * np.log10(200.0 / np.hypot(1.0, 2.0 * np.pi * f * term.tau_s) / 137.0) - f

    fusion = brentq(above, 1.0, 99.0)
    assert f"= {100.0 * percent:.1f} %" in text
    assert f"= {depth:.3f}, at most 2" in text
    assert f"$ = {fusion:.1f} Hz." in text
    assert "30 Hz flickers" in text
    assert "measured …" not in text
    assert all(f"{point}." in text for point in range(1, 6))
    assert write_diagram(page.derivation()).startswith("<")


@pytest.mark.parametrize("name", ["P1", "P31", "P39"])
def test_map_and_verdict_give_one_fusion_frequency_at_any_rate(name: str) -> None:
    """The rate that is asked for does not change with the rate that one has."""
    phosphor = Phosphor.named(name)
    zone = zones(phosphor, 100.0)
    (of_map,) = [hz for t10_s, hz in zip(*zone[:2], strict=True) if t10_s == pytest.approx(phosphor.t10_s)]
    for rate in (20.0, 60.0, 120.0):
        said = verdict(phosphor, rate, 100.0)
        assert f"fuses from {of_map:.1f} Hz" in said
        assert ("flickers" in said) == (rate < of_map)
        assert f"from {of_map:.1f} Hz" in FlickerPage._where(phosphor, rate, 100.0)


def test_a_rate_just_below_fusion_is_not_said_to_be_that_rate() -> None:
    """P4 at 100 cd/m² fuses from 60.2 Hz."""
    said = FlickerPage._where(Phosphor.named("P4"), 60.0, 100.0)
    assert said == "flickers: 60 Hz, fuses from 60.2 Hz"


@pytest.mark.parametrize("name", ["P1", "P7", "P31", "P45"])
def test_the_phosphor_on_the_tube_is_in_sight_in_its_table(qtbot: QtBot, name: str) -> None:
    """Also where the note beneath is longer than the one before, and where the dock is made lower."""
    table = PhosphorTable()
    put_on_screen(qtbot, table, 290, 250)
    for height in (250, 190):
        table.resize(290, height)
        table.mark(name)
        QApplication.processEvents()
        view = table.view
        assert view.viewport().rect().contains(view.visualRect(view.currentIndex()).center())


def test_on_a_low_page_the_map_has_more_room_than_the_tube_beside_it_and_no_field_is_cut(
    qtbot: QtBot, page: FlickerPage
) -> None:
    page.resize(600, 330)
    qtbot.waitUntil(lambda: page.map.width() > 300)
    qtbot.waitUntil(lambda: page.map.height() >= 100 and page.map.width() > 1.5 * page.tube.width())
    for field in page.controls.findChildren(NumberField):
        assert field.width() >= field.minimumSizeHint().width()
    assert page.measures.verdict.text() in page.measures.toolTip()
    page.resize(900, 560)
    qtbot.waitUntil(page.measures.verdict.isVisible)
    qtbot.waitUntil(lambda: abs(page.map.width() - page.tube.width()) < 10)


@pytest.mark.parametrize("name", names())
def test_what_is_uncertain_is_named_with_its_extent(name: str) -> None:
    phosphor = Phosphor.named(name)
    said = doubt(phosphor)
    assert said.startswith("The rate above which the eye sees no flicker is uncertain by about 10 Hz.")
    assert (phosphor.name in said) == bool(phosphor.uncertain_fields)
