"""The page Gun as a person uses it: drag, type, turn, step, choose a part, save the drawing."""

from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QDial, QPushButton, QSlider
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.algorithms.scanning.electron_beam_views import (
    ANODE,
    CATHODE,
    DEFLECTION,
    FOCUS,
    GRID,
    SCREEN,
)
from workbench.display.cutaway import STEPS, parts_of
from workbench.display.gun import OFF, SINE
from workbench.document.errors import DocumentError
from workbench.document.storage.files import read
from workbench.panels.display.gun.page import GunPage
from workbench.panels.display.gun.parts import numbers_of
from workbench.panels.display.gun.presets import presets
from workbench.rendering.subjects.gun import gun_of, settings_of, with_settings
from workbench.session.session import Session
from workbench.widgets.fields.number_field import EntryLine
from workbench.widgets.stepping.sentence_view import SentenceView


@pytest.fixture
def page(gun_page: GunPage) -> GunPage:
    return gun_page


def settle(page: GunPage) -> None:
    page.session.flush()
    page.refresh()


def test_the_run_goes_through_the_parts_from_the_cathode_to_the_screen(
    page: GunPage, session: Session
) -> None:
    assert session.run.steps is not None
    told = []
    for step in range(1, 7):
        session.update_state(step=step)
        settle(page)
        told.append(session.run.steps[step].title)
        assert page.part.part in STEPS[step - 1]
        assert page.drawing_view._lit == STEPS[step - 1]
    assert tuple(told) == (CATHODE, GRID, FOCUS, ANODE, DEFLECTION, SCREEN)


def test_a_voltage_is_typed_slid_and_scrubbed(qtbot: QtBot, page: GunPage) -> None:
    field = page.cards.beam.fields["anode"]
    field.number.field.selectAll()
    qtbot.keyClicks(field.number.field, "4000")
    qtbot.keyClick(field.number.field, Qt.Key.Key_Return)
    settle(page)
    assert page.setting.gun.anode == 4000.0
    assert page.setting.gun.way()[-1][2] == pytest.approx(12.0)
    page.cards.beam.fields["grid"].slider.setValue(0)
    settle(page)
    assert page.setting.gun.grid == -80.0
    assert page.setting.gun.beam_current == 0.0
    assert page.cards.beam.fields["grid"].number.value() == -80.0


def test_each_move_of_the_hand_is_shown_once(
    qtbot: QtBot, page: GunPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The run that follows the hand tells nothing new but its step."""
    shown: list[float] = []
    monkeypatch.setattr(page.monitor, "show_gun", lambda gun: shown.append(gun.way()[-1][1]))
    tube = page.tube
    centre = tube._glass.center().toPoint()
    qtbot.mousePress(tube, Qt.MouseButton.LeftButton, pos=centre)
    turn(page)
    for along in range(1, 6):
        shown.clear()
        qtbot.mouseMove(tube, centre + QPoint(5 * along, 3))
        turn(page)
        assert len(shown) == 1
        assert shown[0] == pytest.approx(page.setting.gun.way()[-1][1])
    qtbot.mouseRelease(tube, Qt.MouseButton.LeftButton, pos=centre + QPoint(25, 3))
    turn(page)
    page.session.update_state(step=3)
    turn(page)
    assert page.drawing_view._lit == STEPS[2]


def turn(page: GunPage) -> None:
    """All that is due now happens."""
    for _turn in range(4):
        QApplication.processEvents()


def test_rubbish_is_refused_in_place_and_nothing_is_lost(qtbot: QtBot, page: GunPage) -> None:
    field = page.cards.beam.fields["anode"].number
    for typed in ("0", "-5", "lots"):
        field.field.selectAll()
        qtbot.keyClicks(field.field, typed)
        qtbot.keyClick(field.field, Qt.Key.Key_Return)
        assert field.complaint.isVisible()
        assert field.complaint.text().endswith(".")
        assert page.setting.gun.anode == 2000.0


def test_plates_that_would_overlap_are_refused_in_one_sentence(page: GunPage) -> None:
    page.part.edited.emit("reach_x", 190.0)
    settle(page)
    assert page.setting.gun.reach_x == 150.0
    assert "overlap" in page.note.text()
    page.part.edited.emit("reach_x", 120.0)
    settle(page)
    assert page.setting.gun.reach_x == 120.0
    assert not page.note.isVisible()


def test_the_spot_is_dragged_in_the_drawing(qtbot: QtBot, page: GunPage) -> None:
    view = page.drawing_view
    spot = view.spot_px
    assert spot is not None
    goal = view.place_px(page.setting.gun.screen, -20.0).toPoint()
    qtbot.mousePress(view, Qt.MouseButton.LeftButton, pos=spot.toPoint())
    qtbot.mouseMove(view, goal)
    qtbot.mouseRelease(view, Qt.MouseButton.LeftButton, pos=goal)
    settle(page)
    _z, x, y, _r = page.setting.gun.way()[-1]
    assert y == pytest.approx(-20.0, abs=1.0)
    assert x == pytest.approx(17.34, abs=0.1)
    assert not page.session.undo_stack.canUndo()


def test_the_spot_is_dragged_on_the_screen_and_moved_by_keys(qtbot: QtBot, page: GunPage) -> None:
    tube = page.tube
    at = tube._at(-40.0, 30.0).toPoint()
    qtbot.mousePress(tube, Qt.MouseButton.LeftButton, pos=at)
    qtbot.mouseRelease(tube, Qt.MouseButton.LeftButton, pos=at)
    settle(page)
    assert page.setting.gun.way()[-1][1:3] == pytest.approx((-40.0, 30.0), abs=1.0)
    page.setting.change({"x_volts": -492.9})
    settle(page)
    assert not page.cards.across.fields["volts"].number.field.overflows
    qtbot.mouseClick(tube, Qt.MouseButton.LeftButton, pos=at)
    settle(page)
    x, y = page.setting.gun.way()[-1][1:3]
    qtbot.keyClick(tube, Qt.Key.Key_Right)
    settle(page)
    qtbot.keyClick(tube, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    settle(page)
    assert page.setting.gun.way()[-1][1:3] == pytest.approx((x + 1.0, y + 10.0), abs=0.1)


@pytest.mark.parametrize("of", ["tube", "drawing_view"])
def test_the_run_waits_for_a_drag(qtbot: QtBot, page: GunPage, session: Session, of: str) -> None:
    view, left, before = getattr(page, of), Qt.MouseButton.LeftButton, session.run.calls
    spot = page.drawing_view.spot_px if of == "drawing_view" else page.tube._at(-40.0, 30.0)
    assert spot is not None
    at = spot.toPoint()
    qtbot.mousePress(view, left, pos=at)
    qtbot.mouseMove(view, at + QPoint(0, 12))
    settle(page)
    assert page.setting.gun.way()[-1][2] != pytest.approx(12.0, abs=0.5)
    assert session.run.calls is before
    qtbot.mouseRelease(view, left, pos=at + QPoint(0, 12))
    settle(page)
    assert session.run.calls is not before


def test_keys_go_from_part_to_part_and_each_says_what_it_is_for(qtbot: QtBot, page: GunPage) -> None:
    view = page.drawing_view
    for part in parts_of(page.setting.gun):
        qtbot.keyClick(view, Qt.Key.Key_Right)
        assert view.chosen == part
        assert page.part.part == part
        assert len(page.part.words.text()) > 60
        assert view.accessibleDescription()
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert view.chosen == parts_of(page.setting.gun)[0]


def test_a_part_is_chosen_by_a_click_on_it_and_on_its_label(qtbot: QtBot, page: GunPage) -> None:
    view = page.drawing_view
    view.grab()
    for placed in view._placed:
        left, low, right, high = placed.box
        qtbot.mouseClick(
            view,
            Qt.MouseButton.LeftButton,
            pos=view.place_px((left + right) / 2, (low + high) / 2).toPoint(),
        )
        assert view.chosen == placed.label.part
    view.set_labelled(False)
    for place, part in (((32.0, 8.2), "focus"), ((7.0, 8.8), "grid"), ((86.0, 8.8), "plates_y")):
        qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view.place_px(*place).toPoint())
        assert view.chosen == part


def test_an_input_draws_a_figure_and_a_drag_takes_it_off(qtbot: QtBot, page: GunPage) -> None:
    page.take_preset("lissajous")
    settle(page)
    gun = page.setting.gun
    assert (gun.x.wave, gun.y.wave) == (SINE, SINE)
    assert page.cards.up.fields["rate"].isVisible()
    assert not page.cards.up.fields["volts"].isVisible()
    assert page.bar.time.isVisible()
    assert page.tube.driver is not None
    lit = page.tube.driver.beam.energy_per_frame()
    assert (lit > 0.1 * lit.max()).sum() > 200
    page.tube.moved.emit(5.0, -5.0)
    settle(page)
    assert (page.setting.gun.x.wave, page.setting.gun.y.wave) == (OFF, OFF)
    assert page.setting.gun.way()[-1][1:3] == pytest.approx((5.0, -5.0), abs=0.1)


def test_a_moment_is_chosen_and_stepped(page: GunPage, session: Session, qtbot: QtBot) -> None:
    page.take_preset("lissajous")
    settle(page)
    page.bar.moment.edited.emit(2.0)
    settle(page)
    assert session.state.tube.paused
    assert page.setting.gun.moment == 2.0
    qtbot.waitUntil(lambda: session.run.done)
    steps = session.run.steps
    assert steps is not None
    assert steps[5].row[1] == pytest.approx(tuple(page.setting.gun.arguments()[4]))


def test_plates_give_way_to_coils(page: GunPage) -> None:
    page.bar.bent_by.setCurrentIndex(1)
    page.bar.bent_by.activated.emit(1)
    settle(page)
    assert page.setting.gun.coils
    assert page.cards.up.fields["field"].isVisible()
    assert "coils" in parts_of(page.setting.gun)
    page.cards.up.edited.emit({"y_field": 10.0})
    settle(page)
    assert "never gets out" in page.cards.up.line.text()


@pytest.mark.parametrize("each", presets(), ids=lambda each: each.slug)
def test_every_example_can_be_drawn(page: GunPage, each) -> None:
    page.take_preset(each.slug)
    settle(page)
    gun = page.setting.gun
    assert gun.fault() == ""
    settings = settings_of(gun)
    assert {name: settings[name] for name in each.settings} == each.settings
    assert page.bar.phosphor.currentData() == gun.phosphor
    assert not page.grab().isNull()


def test_knobs_turn_the_grid_and_the_tubes(page: GunPage, session: Session) -> None:
    knobs = page.monitor
    knobs.brightness.number.edited.emit(-0.2)
    settle(page)
    assert session.state.tube.brightness == -0.2
    assert page.setting.gun.grid == pytest.approx(-18.0 - 0.2 * 0.75 * 60.0)
    knobs.brightness.dial.setValue(100)
    settle(page)
    assert session.state.tube.brightness == 0.0
    assert page.setting.gun.grid == pytest.approx(-18.0)
    knobs.contrast.number.edited.emit(0.5)
    settle(page)
    assert page.setting.gun.grid == pytest.approx(-60.0 + 42.0 / 2)


def test_what_is_set_is_kept_in_the_file(page: GunPage, session: Session, tmp_path: Path) -> None:
    page.setting.change({"anode": 1500.0, "y_wave": SINE, "phosphor": "P7"})
    session.save_as(tmp_path / "gun.gwb")
    kept = read(tmp_path / "gun.gwb").session.positions["gun"].subject
    gun = gun_of(kept)
    assert (gun.anode, gun.y.wave, gun.phosphor) == (1500.0, SINE, "P7")
    assert set(kept.arguments) == {"anode", "y_wave", "phosphor"}


def test_a_setting_out_of_range_is_refused_on_reading(session: Session, page: GunPage) -> None:
    with pytest.raises(DocumentError, match="anode"):
        session.update_state(subject=with_settings(page.usual, {"anode": -1.0}))
    odd = with_settings(page.usual, {"phosphor": "P77", "x_wave": "square"})
    assert (gun_of(odd).phosphor, gun_of(odd).x.wave) == ("P1", OFF)


def test_every_control_has_a_name_and_a_tooltip(page: GunPage) -> None:
    for kind in (QAbstractButton, QComboBox, QSlider, QDial, EntryLine):
        for control in page.findChildren(kind):
            assert control.toolTip(), control.accessibleName()
            if not isinstance(control, QPushButton):
                assert control.accessibleName(), control.toolTip()


def test_a_narrow_page_shows_one_card_at_a_time(page: GunPage, qtbot: QtBot) -> None:
    page.resize(600, 380)
    qtbot.waitUntil(lambda: not page.cards.up.isVisible())
    assert page.cards.beam.isVisible()
    page.cards.buttons.button(1).click()
    assert page.cards.up.isVisible()
    assert not page.cards.beam.isVisible()
    assert page.minimumSizeHint().width() <= 640
    page.resize(900, 460)
    qtbot.waitUntil(lambda: page.cards.beam.isVisible() and page.cards.up.isVisible())


def test_hidden_or_steady_it_rests(page: GunPage, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not page.tube.running, timeout=5000)
    page.take_preset("p7")
    settle(page)
    assert page.tube.running
    page.hide()
    assert not page.tube.running


def test_a_place_outside_the_glass_moves_nothing(page: GunPage, qtbot: QtBot) -> None:
    before = page.setting.gun
    qtbot.mouseClick(page.tube, Qt.MouseButton.LeftButton, pos=QPoint(1, 1))
    settle(page)
    assert page.setting.gun == before


def test_drawing_cards_and_screen_tell_of_one_moment(page: GunPage, session: Session) -> None:
    page.take_preset("p7")
    settle(page)
    session.update_state(tube=replace(session.state.tube, paused=True))
    settle(page)
    page.setting.change({"moment": 130.0})
    settle(page)
    _z, _x, y, _r = page.setting.gun.way()[-1]
    assert page.drawing_view._way[-1][2] == y
    assert f"{y:.1f}\N{NO-BREAK SPACE}mm" in page.cards.up.line.text()
    assert page.tube._spot is not None
    assert page.tube._spot[2] == y


def test_the_words_of_a_part_take_the_room_they_need(page: GunPage, qtbot: QtBot) -> None:
    dock = page.part
    qtbot.addWidget(dock)
    dock.resize(120, 500)
    dock.show()
    dock.resize(460, 500)
    dock.show_part("grid", page.setting.gun)
    wide = dock.viewport().width() - 24
    dock.words.setMinimumHeight(0)
    needed = dock.words.heightForWidth(wide)
    dock._make_room()
    assert dock.words.minimumHeight() == needed < 120


def test_the_flight_to_the_screen_takes_the_time_of_its_length_at_its_speed(page: GunPage) -> None:
    gun = page.setting.gun
    numbers = dict(numbers_of("anode", gun))
    metres_a_second = 1000.0 * float(numbers["Speed"].removesuffix(" km/s").replace(",", ""))
    seconds = gun.screen / 1000.0 / metres_a_second
    told, unit = numbers["Flight to the screen"].split()
    assert unit == "ns"
    assert float(told) * 1e-9 == pytest.approx(seconds, rel=5e-3)
    assert float(told) == pytest.approx(10.8, abs=0.05)


def test_phosphors_are_listed_in_units_that_are_read_at_a_glance(gun_page: GunPage) -> None:
    titles = [gun_page.bar.phosphor.itemText(k) for k in range(gun_page.bar.phosphor.count())]
    assert "P33  orange, 5 s (uncertain)" in titles
    assert "P31  green, 340 µs" in titles
    assert "P3  amber, 19 ms" in titles


def test_the_exponent_of_the_grid_s_formula_is_raised(
    gun_page: GunPage, session: Session, qtbot: QtBot
) -> None:
    sentence = SentenceView(session.run)
    keep_until_the_end(qtbot, sentence)
    session.run.go_to_number(2)
    sentence.refresh()
    assert ")<sup>γ</sup>" in sentence.text()
    assert "^" not in sentence.text()


def test_reset_puts_every_knob_back_and_is_no_step_of_undo(gun_page: GunPage, qtbot: QtBot) -> None:
    page, session = gun_page, gun_page.session
    usual = page.setting.gun
    page.take_preset("lissajous")
    page.setting.change({"coils": True, "focus": 300.0})
    session.flush()
    assert page.setting.gun != usual
    qtbot.mouseClick(page.bar.reset, Qt.MouseButton.LeftButton)
    session.flush()
    assert page.setting.gun == usual
    assert session.state.tube.slow_motion == 1.0
    assert not session.undo_stack.canUndo()
