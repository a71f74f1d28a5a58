"""The page Raster as a person uses it: step, click, choose a mode and a depth, type, copy, save."""

from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QAbstractButton, QComboBox, QSlider
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from tests.panels.display.raster.conftest import show_dock
from tests.panels.display.strips import cut_texts, lies_whole
from workbench.document.storage.files import read
from workbench.exchange.diagrams import Drawing
from workbench.panels.display.raster.page import RasterPage
from workbench.panels.display.raster.sums import text_of
from workbench.panels.display.raster.sums_dock import with_levels
from workbench.panels.shared import lighting
from workbench.rendering.scene import backdrop
from workbench.rendering.subjects import raster
from workbench.session.session import Session


def test_the_page_steps_the_frame_buffer_line_by_line(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    assert session.run.entry is not None
    assert session.run.entry.slug == "raster_scan"
    assert not page.tube.held
    for number in (1, 2, 48):
        session.run.go_to_number(number)
        qtbot.waitUntil(lambda n=number: page.tube._row == 48 - n)
        state = page.tube.driver.state()  # type: ignore[union-attr]
        assert state.part == number - 1
        assert state.lit
        assert page.system.now["y"] == 48 - number
        assert page.system.now["address"] == (48 - number) * 64 + 63
        assert "held" in page.note.text()
    session.run.first()
    qtbot.waitUntil(lambda: not page.tube.held)


def test_the_run_scans_a_scene_as_soon_as_it_can_be_lit(
    page: RasterPage, session: Session, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    light = False
    for module in (backdrop, lighting, raster):
        monkeypatch.setattr(module, "can_be_lit", lambda _sheet: light)
    session.open_example("space-house")
    session.visit("raster", page.usual)
    qtbot.waitUntil(lambda: session.run.done and page.feed._lighting._due.isActive(), timeout=20000)
    qtbot.wait(300)  # nothing that was asked for before is still to come
    assert not session.run.calls[0][0].any()
    light = True
    qtbot.waitUntil(lambda: bool(session.run.calls[0][0].any()), timeout=20000)
    assert page.tube._image.any()


def test_in_detail_the_beam_stands_at_the_pixel(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    session.run.set_detail(True)
    session.run.go(400)
    qtbot.waitUntil(lambda: page.tube.held)
    now = session.run.own_call().variables  # type: ignore[union-attr]
    qtbot.waitUntil(lambda: page.system.now.get("x") == now["x"])
    state = page.tube.driver.state()  # type: ignore[union-attr]
    clock = int(now["clock"])
    timing = page.setting.scan.timing  # type: ignore[union-attr]
    assert (state.part, state.place) == divmod(clock, timing.h_total)
    lit = {part for part in ("x", "bits", "red") if part in page.system.changed}
    assert len(lit) <= 1  # one line of the text changes one of them


def test_a_click_on_the_glass_goes_to_the_line(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    place = page.tube._place(30.5, 20.5)
    qtbot.mouseClick(page.tube, Qt.MouseButton.LeftButton, pos=place.toPoint())
    qtbot.waitUntil(lambda: session.run.number == 21)
    qtbot.waitUntil(lambda: page.tube._row == 27)


def test_modes_and_depths_are_chosen_in_the_strip(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    bar = page.bar
    for box, value in ((bar.mode, "ntsc-525i"), (bar.depth_box, 2)):
        box.setCurrentIndex(box.findData(value))
        box.activated.emit(box.currentIndex())
    session.flush()
    scan = page.setting.scan
    assert scan is not None
    assert (scan.timing.fields, scan.buffer.depth) == (2, 2)
    qtbot.waitUntil(lambda: page.tube.timing == scan.timing)
    assert page.tube.refresh_hz == pytest.approx(29.97, abs=0.01)
    qtbot.waitUntil(lambda: len(page.diagram.strips) == 2 and len(page.diagram.strips[1].segments) == 8)
    qtbot.waitUntil(lambda: bar.pixels.count() == 2)
    bar.pixels.setCurrentIndex(1)
    bar.pixels.activated.emit(1)
    session.flush()
    assert page.tube._image.shape == (480, 720)
    assert not session.undo_stack.canUndo()


def test_what_is_set_is_saved_with_the_file(page: RasterPage, session: Session, tmp_path: Path) -> None:
    page.setting.give(mode="pal-625i", depth=4, own_table=True, table=(0.0, 255.0))
    session.run.go_to_number(7)
    session.flush()
    session.save_as(tmp_path / "raster.gwb")
    position = read(tmp_path / "raster.gwb").session.positions["raster"]
    assert position.subject.arguments["mode"] == "pal-625i"
    assert position.subject.arguments["table"] == (0, 255)
    other = Session()
    other.open(tmp_path / "raster.gwb")
    assert other.state.positions["raster"] == position
    other.close()


def test_a_mode_that_cannot_be_says_so_in_place_and_nothing_is_lost(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    show_dock(qtbot, page.mode)
    page.mode.refresh()
    field = page.mode.fields["h_sync"]
    field.edited.emit(0.0)
    session.flush()
    qtbot.waitUntil(lambda: page.mode.fault.isVisible())
    assert "sync" in page.mode.fault.text()
    assert page.feed._refusals[page.tube].isVisible()
    assert session.sheet.figures
    field.edited.emit(10.0)
    session.flush()
    qtbot.waitUntil(lambda: not page.mode.fault.isVisible())
    assert not page.feed._refusals[page.tube].isVisible()
    assert page.setting.value("mode") == "typed"


def take_sums_of(page: RasterPage, source: str) -> None:
    """Choose in the dock what the sums are of."""
    row = page.sums.source.findData(source)
    assert row >= 0
    page.sums.source.setCurrentIndex(row)
    page.sums.source.activated.emit(row)
    page.session.flush()
    page.sums.refresh()


def test_the_sums_of_any_mode_are_worked_out_beside_what_the_tube_scans(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    show_dock(qtbot, page.sums)
    page.sums.refresh()
    scanned = page.setting.scan
    take_sums_of(page, "vesa-1024x768-60")
    results = {each.title: each.result for each in page.sums.sums}
    assert results["Frame buffer"] == "2,359,296 B = 2,304 KiB"
    assert results["Pixel time, the mode's clock"] == "15.38 ns"  # 1 / 65 MHz
    assert results["Line time, the mode's totals"] == "20.68 \N{MICRO SIGN}s"  # 1344 / 65 MHz
    assert results["Share of retrace, the mode's totals"] == "27.4 %"  # 1 - 1024 * 768 / (1344 * 806)
    assert page.setting.scan == scanned
    colours = next(each for each in page.sums.sums if each.title == "Colours")
    assert with_levels(colours.numbers) == "2<sup>24</sup>"
    assert "Colours: 2^b = 2^24 = 16,777,216\n" in text_of(page.sums.sums)
    page.sums.fields["sum_bits"].edited.emit(8.0)
    session.flush()
    page.sums.refresh()
    assert page.sums.sums[0].result == "786,432 B = 768 KiB"
    take_sums_of(page, "typed")
    assert [page.sums.fields[name].value() for name in ("sum_width", "sum_height", "sum_bits")] == [
        1024,
        768,
        8,
    ]
    for name in ("sum_hz", "sum_h_us", "sum_v_us"):
        assert not page.sums.fields[name].field.overflows
    take_sums_of(page, "")
    assert page.sums.sums[0].numbers.startswith(f"{scanned.timing.h_active} ")


def test_the_sums_follow_the_mode_or_the_numbers_that_are_typed(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    page.setting.give(mode="vga-640x480-60", at_mode=True)
    session.flush()
    show_dock(qtbot, page.sums)
    page.sums.refresh()
    results = {each.title: each.result for each in page.sums.sums}
    assert results["Frame buffer"] == "921,600 B = 900 KiB"
    assert results["Pixel time, the mode's clock"] == "39.72 ns"
    assert results["Line time, the mode's totals"] == "31.78 \N{MICRO SIGN}s"
    assert results["Share of retrace, the mode's totals"] == "26.9 %"
    assert results["Bandwidth of the video amplifier, at least"] == "12.59 MHz"
    assert results["Loading over the line"] == "73.73 s"
    assert results["Pixel time, given retraces"] == "39.72 ns"
    take_sums_of(page, "typed")
    session.flush()
    for name, value in (("sum_hz", 60.0), ("sum_width", 3.0), ("sum_height", 2.0), ("sum_v_us", 1e6)):
        page.sums.fields[name].edited.emit(value)
    session.flush()
    qtbot.waitUntil(lambda: page.sums.sums[0].result == "18 B \N{ALMOST EQUAL TO} 0.01758 KiB")
    faults = [each.title for each in page.sums.sums if each.fault]
    assert faults == [f"{what}, given retraces" for what in ("Line time", "Pixel time", "Share of retrace")]
    assert not any("mode" in each.title for each in page.sums.sums)
    page.sums.fields["sum_width"].edited.emit(0.0)
    session.flush()
    qtbot.waitUntil(lambda: page.sums.fault.isVisible())
    assert page.sums.sums == []


def test_the_sums_are_copied_as_text_and_as_a_table(page: RasterPage, qtbot: QtBot) -> None:
    show_dock(qtbot, page.sums)
    page.sums.copy_text()
    lines = QGuiApplication.clipboard().text().splitlines()
    assert len(lines) == len(page.sums.sums) > 12
    assert lines[0].startswith("Frame buffer: W")
    page.sums.copy_table()
    data = QGuiApplication.clipboard().mimeData()
    assert data is not None
    assert data.html().count("<tr>") == len(lines) + 1
    titles = [title for title, _table in page.tables()]
    assert titles[0] == "Exam sums"


def test_what_is_lost_is_shown_side_by_side(page: RasterPage, qtbot: QtBot) -> None:
    show_dock(qtbot, page.buffer)
    page.buffer.refresh()
    qtbot.waitUntil(lambda: page.buffer.depths.item(4, 2) is not None)
    lost = [page.buffer.depths.item(row, 2).text() for row in range(5)]
    assert lost[-1] == "0 / 7"
    assert int(lost[0].split("/")[0]) >= int(lost[2].split("/")[0])
    assert not page.buffer.depths.item(0, 0).icon().isNull()
    page.setting.give(mode="ntsc-525i", at_mode=True, depth=4)
    page.session.flush()
    page.buffer.refresh()
    qtbot.waitUntil(lambda: page.buffer.depths.item(2, 1).text() == "172,800")
    assert "of 345,600 pixels" in page.buffer.loss.text()


def test_the_beam_is_caught_in_the_middle_of_a_line(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    page.caught.trigger()
    session.flush()
    qtbot.waitUntil(lambda: page.tube.beam_is_seen and page.tube.driver.state().lit)
    state = page.tube.driver.state()  # type: ignore[union-attr]
    assert any(state.currents)
    assert session.state.tube.paused
    qtbot.waitUntil(lambda: page.system.now.get("colour", 0) != 0)
    assert page.diagram._now is not None
    light = page.tube.driver.lights[0]  # type: ignore[union-attr]
    assert light.max() > 20.0  # it has just been hit


def test_the_derivation_shows_system_timing_and_sums(
    page: RasterPage, session: Session, qtbot: QtBot
) -> None:
    session.run.go_to_number(3)
    qtbot.waitUntil(lambda: page.system.now.get("y") == 45)
    page_of_it = page.derivation()
    assert page_of_it is not None
    drawings = [block for block in page_of_it.blocks if isinstance(block, Drawing)]
    assert len(drawings) == 3
    words = "".join(getattr(item, "text", "") for item in drawings[0].items)
    for part in ("CPU", "System memory", "Display controller", "Frame buffer", "Monitor", "45", "64"):
        assert part in words


def test_the_path_of_the_beam_is_drawn_on_request(page: RasterPage) -> None:
    before = page.tube.grab().toImage()
    page.path.trigger()
    with_path = page.tube.grab().toImage()
    page.path.trigger()
    assert with_path != before
    assert page.tube.grab().toImage() == before


def test_every_control_has_a_name_and_a_tooltip(page: RasterPage) -> None:
    for part in (page.bar, page.sums, page.buffer, page.mode):
        for kind in (QAbstractButton, QComboBox, QSlider):
            for control in part.findChildren(kind):
                if not control.objectName().startswith("qt_"):
                    assert control.toolTip(), (control, control.accessibleName())
                    assert control.accessibleName() or getattr(control, "text", str)(), control


@pytest.mark.parametrize("width", [560, 776, 1260])
def test_no_text_of_the_strip_is_cut(page: RasterPage, qtbot: QtBot, width: int) -> None:
    bar = page.strip.takeWidget()
    keep_until_the_end(qtbot, bar)
    bar.show()
    bar.resize(width, bar.heightForWidth(width))
    assert cut_texts(bar) == []
    assert bar.width() == width
    assert lies_whole(bar)


def test_the_timing_diagram_tells_its_parts(page: RasterPage, qtbot: QtBot) -> None:
    page.setting.give(mode="vga-640x480-60", at_mode=True)
    page.session.flush()
    qtbot.waitUntil(lambda: page.diagram._timing is not None and page.diagram._timing.h_active == 640)
    bar = page.diagram._bar(0)
    said = page.diagram.told_at(QPointF(bar.left() + 0.85 * bar.width(), bar.center().y()))
    assert said == "sync: 96 clocks, 3.813 \N{MICRO SIGN}s"
    assert "front porch: 10 lines" in page.diagram.accessibleDescription()


def test_a_hidden_or_held_tube_rests(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    session.run.go_to_number(5)
    qtbot.waitUntil(lambda: page.tube.held)
    assert not page.tube.running
    session.run.first()
    session.update_state(tube=replace(session.state.tube, slow_motion=1000.0))
    session.flush()
    qtbot.waitUntil(lambda: page.tube.running)
    page.window().hide()
    assert not page.tube.running


def test_only_a_bare_key_steps_the_run(page: RasterPage, session: Session, qtbot: QtBot) -> None:
    qtbot.keyClick(page, Qt.Key.Key_End, Qt.KeyboardModifier.ControlModifier)
    assert session.run.number == 0
    qtbot.keyClick(page, Qt.Key.Key_End)
    assert session.run.ended
