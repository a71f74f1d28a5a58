"""The Display workspace as a person uses it: choose, slow down, pause, step, measure."""

from fractions import Fraction
from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtWidgets import QAbstractButton, QComboBox, QSlider
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from tests.panels.display.conftest import put_on_screen
from tests.panels.display.strips import cut_texts, lies_whole
from workbench.display import RasterBeam
from workbench.display.retrace import RetracingBeam
from workbench.document.edits import remove_figures
from workbench.document.state import SessionState
from workbench.document.storage.files import read
from workbench.panels.display.tubes_page import TubesPage
from workbench.panels.shared.tube_dock import TubeDock
from workbench.session.session import Session
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.spans import span_text


@pytest.fixture
def panel(qtbot: QtBot, session: Session) -> TubesPage:
    made = TubesPage(session)
    put_on_screen(qtbot, made, 1100, 560)
    return made


def test_both_tubes_show_the_sheet(panel: TubesPage) -> None:
    for tube in (panel.raster, panel.vector):
        assert tube.isVisible()
        assert tube.driver is not None
        assert max(float(light.max()) for light in tube.driver.lights) > 0.3


def test_an_edit_reaches_the_tubes(panel: TubesPage, session: Session) -> None:
    figures = [figure.id for figure in session.sheet.figures]
    session.apply(remove_figures(figures), "Delete")
    session.flush()
    assert panel.raster.driver is not None
    assert not panel.raster.driver.beam.energy_per_frame().any()
    assert panel.vector.driver is not None
    assert not panel.vector.driver.beam.energy_per_frame().any()


def test_a_tube_does_not_tell_what_is_asked_for(panel: TubesPage, session: Session, qtbot: QtBot) -> None:
    session.open_example("line")
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)

    def lit() -> bool:
        tubes = (panel.raster, panel.vector)
        return all(tube.driver is not None and tube.driver.beam.energy_per_frame().any() for tube in tubes)

    qtbot.waitUntil(lit)
    session.update_state(ask_first=True)
    qtbot.waitUntil(lambda: not lit())
    steps = session.run.steps
    assert steps is not None
    for number in range(1, len(steps) + 1):
        assert not lit()
        session.run.answer(*steps[number].chosen[0])
        session.flush()
    qtbot.waitUntil(lit)


def test_controls_change_the_session_and_follow_it(panel: TubesPage, session: Session) -> None:
    controls = panel.controls
    controls.phosphor.setCurrentIndex(controls.phosphor.findData("P7"))
    controls.phosphor.activated.emit(controls.phosphor.currentIndex())
    controls.slow.setValue(66)
    controls.views.button(1).click()
    session.flush()
    now = session.state.tube
    assert (now.phosphor, now.shown) == ("P7", "raster")
    assert now.slow_motion == pytest.approx(10**3.3)
    assert not panel.vector.isVisible()
    assert panel.raster.setup.phosphor == "P7"
    session.update_state(tube=replace(now, shown="vector", slow_motion=1.0))
    session.flush()
    assert panel.vector.isVisible()
    assert controls.slow.value() == 0
    assert panel.instruments.tube is panel.vector


def test_steps_go_to_the_next_line_and_pixel(panel: TubesPage, session: Session) -> None:
    assert panel.raster.driver is not None
    beam = panel.raster.driver.beam
    assert isinstance(beam, RasterBeam)
    panel.controls.line.click()
    session.flush()
    assert session.state.tube.paused
    assert not panel.raster.running
    first = panel.raster.seconds()
    assert first % beam.timing.line_s == 0
    panel.controls.line.click()
    assert panel.raster.seconds() - first == beam.timing.line_s
    panel.controls.pixel.click()
    assert panel.raster.seconds() - first == beam.timing.line_s + beam.timing.pixel_s


def test_calm_says_what_it_holds_still(qtbot: QtBot, panel: TubesPage, session: Session) -> None:
    session.update_state(tube=replace(session.state.tube, slow_motion=6.0))
    session.flush()
    assert "10 times a second" in panel.note.text()
    session.update_state(tube=replace(session.state.tube, slow_motion=1000.0))
    session.flush()
    assert not panel.note.isVisible()


def test_the_flicker_meter_says_that_calm_holds_it_still_and_has_the_switch(
    panel: TubesPage, session: Session
) -> None:
    session.update_state(tube=replace(session.state.tube, refresh_hz=20.0))
    session.flush()
    panel._say()
    controls = panel.controls
    assert controls.flicker.text().startswith("flickers: 20 Hz")
    assert controls.flicker.text().endswith("; Calm holds it still")
    assert controls.calm.isChecked()
    controls.calm.click()
    assert comfort.calm
    assert controls.calm.isChecked()
    assert "flash 20 times a second" in panel.warning.words.text()
    panel.warning.show_it.click()
    panel._say()
    try:
        assert not comfort.calm
        assert not panel.warning.isVisible()
        assert "Calm" not in controls.flicker.text()
    finally:
        comfort.set_calm(True)
    assert controls.calm.isChecked()


def test_instruments_measure_the_probed_pixel(qtbot: QtBot, panel: TubesPage, session: Session) -> None:
    session.update_state(tube=replace(session.state.tube, slow_motion=2000.0, paused=True))
    session.flush()
    panel.instruments.refresh()
    assert panel.raster.probe is not None
    for plot in panel.instruments.plots():
        assert plot.accessibleDescription()
    panel.raster.set_probe((0, 0))
    panel.instruments.refresh()
    assert "dark" in panel.instruments.light.accessibleDescription()


def test_an_unknown_phosphor_of_a_file_becomes_the_usual_one(panel: TubesPage, session: Session) -> None:
    session.update_state(tube=replace(session.state.tube, phosphor="P77"))
    session.flush()
    assert panel.raster.setup.phosphor == "P31"


def test_every_control_has_a_name_and_a_tooltip(panel: TubesPage) -> None:
    for kind in (QAbstractButton, QComboBox, QSlider):
        for control in panel.controls.findChildren(kind):
            assert control.toolTip(), control.accessibleName()
            assert control.accessibleName(), control.toolTip()


@pytest.mark.parametrize("width", [480, 776, 1260])
def test_no_control_of_the_strip_is_cut(panel: TubesPage, qtbot: QtBot, width: int) -> None:
    strip = panel.controls
    assert panel.strip.takeWidget() is strip
    keep_until_the_end(qtbot, strip)
    strip.show()
    strip.resize(width, strip.heightForWidth(width))
    for number in range(strip.phosphor.count()):
        strip.phosphor.setCurrentIndex(number)
        assert cut_texts(strip) == []
    assert strip.width() == width
    assert lies_whole(strip)


def test_the_strip_does_not_hold_the_window_wide(panel: TubesPage) -> None:
    assert panel.minimumSizeHint().width() <= 960


def test_the_dock_follows_the_session_and_swaps_its_tube(qtbot: QtBot, session: Session) -> None:
    dock = TubeDock(session)
    qtbot.addWidget(dock)
    dock.resize(300, 280)
    dock.show()
    assert dock.view is dock.raster
    dock._choices.button(1).click()
    assert dock.view is dock.vector
    qtbot.waitUntil(lambda: dock.vector.is_current)
    assert dock.vector.driver is not None
    assert dock.vector.driver.beam.energy_per_frame().any()
    assert not dock.raster.running


def test_the_time_of_the_tube_is_saved_and_restored_and_never_undone(
    qtbot: QtBot, panel: TubesPage, session: Session, tmp_path: Path
) -> None:
    session.update_state(tube=replace(session.state.tube, paused=True, slow_motion=2000.0))
    session.flush()
    panel.raster.step(Fraction(1, 8))
    session.save_as(tmp_path / "house.gwb")
    stored = session.state.tube.time_s
    assert stored >= 0.125
    assert not session.undo_stack.canUndo()
    assert load_state(tmp_path / "house.gwb").tube.time_s == stored
    other = Session()
    shown = TubesPage(other)
    keep_until_the_end(qtbot, shown)
    with qtbot.waitExposed(shown):
        shown.show()
    other.open(tmp_path / "house.gwb")
    other.flush()
    for tube in (shown.raster, shown.vector):
        assert abs(float(tube.seconds()) - stored) < 1e-3
    before = float(shown.raster.seconds())
    other.update_state(tube=replace(other.state.tube, refresh_hz=50.0))
    other.flush()
    assert float(shown.raster.seconds()) >= before
    other.close()


def load_state(path: Path) -> SessionState:
    return read(path).session


def test_a_time_has_the_unit_that_keeps_it_readable() -> None:
    assert [span_text(seconds) for seconds in (9000.0, 2640.0, 2.0, 0.0167)] == [
        "2.5 h",
        "44 min",
        "2 s",
        "16.7 ms",
    ]


def test_brightness_and_contrast_reach_the_tubes_and_the_file(
    panel: TubesPage, session: Session, tmp_path: Path
) -> None:
    assert panel.raster.driver is not None
    dark = panel.raster.driver.beam.energy_per_frame().sum()
    panel.controls.brightness.edited.emit(0.3)
    panel.controls.contrast.edited.emit(1.4)
    session.flush()
    assert (session.state.tube.brightness, session.state.tube.contrast) == (0.3, 1.4)
    for tube in (panel.raster, panel.vector):
        assert tube.setup.knobs == (0.3, 1.4)
    assert isinstance(panel.raster.driver.beam, RetracingBeam)
    assert panel.raster.driver.beam.energy_per_frame().sum() > 1.5 * dark
    session.save_as(tmp_path / "bright.gwb")
    assert load_state(tmp_path / "bright.gwb").tube.brightness == 0.3


def test_on_a_low_page_the_tubes_have_the_most_room(panel: TubesPage, session: Session, qtbot: QtBot) -> None:
    session.open_example("line")
    session.flush()
    panel.resize(655, 290)
    qtbot.waitUntil(panel.note.isHidden)
    qtbot.waitUntil(lambda: panel.width() == 655)
    rows = panel.strip, panel.instruments
    qtbot.waitUntil(lambda: panel.raster.height() > 1.3 * max(row.height() for row in rows))


def test_the_controls_are_all_seen_on_a_page_of_a_small_screen(panel: TubesPage, qtbot: QtBot) -> None:
    panel.resize(655, 290)
    qtbot.waitUntil(panel.strip.verticalScrollBar().isVisible)
    panel.resize(800, 440)
    qtbot.waitUntil(lambda: panel.width() == 800)
    qtbot.waitUntil(lambda: panel.strip.height() >= panel.controls.height())
    assert lies_whole(panel.controls)


@pytest.mark.parametrize(("height", "low"), [(360, True), (560, False)])
def test_on_a_low_page_the_tubes_have_the_room_of_the_instruments(
    session: Session, qtbot: QtBot, height: int, low: bool
) -> None:
    page = TubesPage(session)
    put_on_screen(qtbot, page, 600, height)
    assert page.instruments.isHidden() == low
    assert page.controls.instruments.isHidden() != low
    before = page.raster.height()
    page.controls.instruments.click()
    qtbot.waitUntil(page.instruments.isVisible)
    if low:
        qtbot.waitUntil(lambda: page.raster.height() < before)
