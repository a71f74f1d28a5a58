"""The page Colour as a person uses it: solids, sliders, the mask, convergence, and colour by voltage."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QAbstractButton, QComboBox, QSlider, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from tests.panels.display.conftest import put_on_screen
from workbench.display.penetration import coded_layers
from workbench.document import DocumentError
from workbench.document.subjects import Subject
from workbench.exchange.diagram_svg import write_diagram
from workbench.exchange.diagrams import Drawing, Heading, Sentence
from workbench.panels.display.colour.page import ColourPage
from workbench.panels.display.colour.sliders import Coordinate, NumberSlider
from workbench.panels.display.panel import DisplayPanel
from workbench.rendering.subjects.colour_model import hsv_of, rgb_of
from workbench.session.session import Session
from workbench.widgets.fields.number_field import complaint_label

EXAMPLE = "colour-bars"


@pytest.fixture
def page(qtbot: QtBot, session: Session) -> ColourPage:
    one = ColourPage(session)
    put_on_screen(qtbot, one, 1000, 600)
    session.visit("colour", one.usual)
    settle(qtbot, session)
    return one


def settle(qtbot: QtBot, session: Session) -> None:
    session.flush()
    qtbot.wait(5)


def typed(qtbot: QtBot, field, text: str) -> None:
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)


def part(page: ColourPage, qtbot: QtBot, number: int) -> None:
    page.switch.button(number).click()
    settle(qtbot, page.session)
    assert page.stack.currentIndex() == number


def test_a_colour_is_typed_in_any_model_and_is_the_same_in_all(
    qtbot: QtBot, page: ColourPage, session: Session
) -> None:
    rgb, cmy, hsv = (page.models.sliders[model] for model in ("rgb", "cmy", "hsv"))
    for field, text in zip((one.field for one in rgb.parts), ("0.2", "0.4", "3/5"), strict=True):
        field.field.selectAll()
        qtbot.keyClicks(field.field, text)
        qtbot.keyClick(field.field, Qt.Key.Key_Return)
        settle(qtbot, session)
    assert rgb_of(page.subject) == (0.2, 0.4, 0.6)
    assert [one.field.value() for one in cmy.parts] == [0.8, 0.6, 0.4]
    assert [one.field.value() for one in hsv.parts] == pytest.approx([210.0, 0.6667, 0.6])
    typed(qtbot, hsv.parts[0].field, "120")
    settle(qtbot, session)
    assert rgb_of(page.subject) == pytest.approx((0.2, 0.6, 0.2), abs=1e-4)
    typed(qtbot, cmy.parts[1].field, "1")
    settle(qtbot, session)
    assert rgb_of(page.subject)[1] == 0.0
    assert page.models.swatch.packed == 0x330033
    assert not session.undo_stack.canUndo()


@pytest.mark.parametrize("width", [580, 1000])
def test_what_is_wrong_with_a_number_is_read_whole_and_four_decimals_too(
    qtbot: QtBot, page: ColourPage, session: Session, width: int
) -> None:
    page.resize(width, 480)
    hue, saturation, _value = page.models.sliders["hsv"].parts
    for channel, text in zip(page.models.sliders["rgb"].parts, ("0.1", "0.2", "0.3"), strict=True):
        typed(qtbot, channel.field, text)
        settle(qtbot, session)
    typed(qtbot, hue.field, "216.67")
    settle(qtbot, session)
    assert (hue.field.field.text(), saturation.field.field.text()) == ("216.67", "0.6667")
    assert not hue.field.field.overflows
    assert not saturation.field.field.overflows
    beam = page.masked.errors["red_x"]
    for number, wrong in enumerate((page.models.sliders["rgb"].parts[1], beam, page.penetration.volts)):
        part(page, qtbot, number)
        typed(qtbot, wrong.field, "0,5")
        settle(qtbot, session)
        said = wrong.field.complaint
        assert "0,5" in said.text()
        assert said.isVisible()
        assert said.height() >= said.heightForWidth(said.width())
        assert said.visibleRegion().boundingRect() == said.rect()
        qtbot.keyClick(wrong.field.field, Qt.Key.Key_Escape)
        assert not said.isVisible()


def test_a_grey_keeps_the_hue_that_was_asked_for(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    hue, saturation, value = page.models.sliders["hsv"].parts
    for field, text in ((hue, "200"), (saturation, "0"), (value, "0"), (value, "1"), (saturation, "0.5")):
        typed(qtbot, field.field, text)
        settle(qtbot, session)
    assert hsv_of(page.subject) == pytest.approx((200.0, 0.5, 1.0))


def test_sliders_are_dragged_and_moved_by_keys(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    red = page.models.sliders["rgb"].parts[0].slider
    red.setFocus()
    before = rgb_of(page.subject)[0]
    qtbot.keyClick(red, Qt.Key.Key_Left)
    settle(qtbot, session)
    assert rgb_of(page.subject)[0] == pytest.approx(before - 0.001)
    red.setValue(0)
    settle(qtbot, session)
    assert rgb_of(page.subject)[0] == 0.0


def test_a_solid_is_turned_by_hand_and_by_keys(qtbot: QtBot, page: ColourPage) -> None:
    for solid in page.models.solids.values():
        turn, tilt, place = solid.turn, solid.tilt, solid.place_of((1.0, 0.0, 0.0))
        qtbot.mousePress(solid, Qt.MouseButton.LeftButton, pos=QPoint(50, 50))
        qtbot.mouseMove(solid, QPoint(70, 60))
        qtbot.mouseRelease(solid, Qt.MouseButton.LeftButton, pos=QPoint(70, 60))
        assert (solid.turn, solid.tilt) == pytest.approx((turn + 12.0, tilt + 6.0))
        assert (solid.place_of((1.0, 0.0, 0.0)) - place).manhattanLength() > 1.0
        qtbot.keyClick(solid, Qt.Key.Key_Right)
        qtbot.keyClick(solid, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
        assert (solid.turn, solid.tilt) == pytest.approx((turn + 17.0, tilt - 24.0))
        solid.look_from(0.0, 1000.0)
        assert solid.tilt <= 90.0


@pytest.mark.parametrize("slug", ["rgb_to_cmy", "rgb_to_hsv", "hsv_to_rgb"])
def test_each_text_is_stepped_on_the_colour(
    qtbot: QtBot, page: ColourPage, session: Session, slug: str
) -> None:
    number = ["rgb_to_cmy", "rgb_to_hsv", "hsv_to_rgb"].index(slug)
    page.models.texts.button(number).click()
    settle(qtbot, session)
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
    assert session.run.entry is not None
    assert session.run.entry.slug == slug
    given = hsv_of(page.subject) if slug == "hsv_to_rgb" else rgb_of(page.subject)
    assert tuple(session.run.calls[0]) == pytest.approx(given)
    drawn = len(page.models.plane.plane.drawn)
    session.run.last()
    settle(qtbot, session)
    assert len(page.models.plane.plane.drawn) > drawn


def test_the_colour_under_the_probe_is_taken(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    part(page, qtbot, 1)
    whole = page.masked.whole
    qtbot.waitUntil(lambda: whole.tube is not None, timeout=5000)
    whole.set_probe((60, 24))
    qtbot.mouseClick(whole, Qt.MouseButton.LeftButton, pos=whole._to_widget(*whole._probe_mm()).toPoint())
    settle(qtbot, session)
    assert rgb_of(page.subject) == pytest.approx((1.0, 128 / 255, 0.0))
    assert "(60, 24)" in page.picked.text()
    assert page.masked.magnified.probe == (60, 24)
    qtbot.keyClick(whole, Qt.Key.Key_Left)
    assert whole.probe == (59, 24)


def test_the_mask_is_chosen_and_magnified(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    part(page, qtbot, 1)
    close = page.masked.magnified
    qtbot.waitUntil(lambda: close.tube is not None, timeout=5000)
    page.masked.kinds.setCurrentIndex(3)
    page.masked.kinds.activated.emit(3)
    typed(qtbot, page.masked.pitch, "1.2")
    settle(qtbot, session)
    qtbot.waitUntil(lambda: close.tube is not None and close.tube.setup.pitch_mm == 1.2, timeout=5000)
    assert close.tube is not None
    assert close.tube.setup.mask == "grille"
    stripes = close.tube.maps[0]
    assert np.array_equal(stripes[0], stripes[-1])
    assert "triads of 1.2 mm" in page.masked.facts.text()
    for text in ("0", "wide"):
        typed(qtbot, page.masked.pitch, text)
        assert page.masked.pitch.complaint.text()
    assert close.tube.setup.pitch_mm == 1.2


def test_beams_are_moved_and_brought_together_again(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    part(page, qtbot, 1)
    whole = page.masked.whole
    qtbot.waitUntil(lambda: whole.tube is not None, timeout=5000)
    page.masked.errors["red_x"].slider.setValue(700)
    settle(qtbot, session)
    qtbot.waitUntil(lambda: whole.tube is not None and whole.tube.setup.errors_mm[0][0] == 2.0, timeout=5000)
    assert "pixels of the picture" in page.masked.facts.text()
    page.masked.converge.click()
    settle(qtbot, session)
    qtbot.waitUntil(
        lambda: whole.tube is not None and whole.tube.setup.errors_mm == ((0.0, 0.0),) * 3, timeout=5000
    )


def test_a_steady_colour_tube_rests_and_slow_motion_shows_the_beams(
    qtbot: QtBot, page: ColourPage, session: Session
) -> None:
    part(page, qtbot, 1)
    close = page.masked.magnified
    qtbot.waitUntil(lambda: close.tube is not None, timeout=5000)
    assert not close.running
    page.change({"slow_motion": 1000.0})
    settle(qtbot, session)
    qtbot.waitUntil(lambda: close.running)
    assert not close.averaged
    page.change({"slow_motion": 1.0})
    settle(qtbot, session)
    qtbot.waitUntil(lambda: not close.running, timeout=5000)


def test_the_voltage_chooses_the_colour(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    part(page, qtbot, 2)
    view = page.penetration
    qtbot.waitUntil(lambda: view.tube.driver is not None, timeout=5000)
    view.buttons["red"].click()
    settle(qtbot, session)
    assert page.subject.arguments["kilovolts"] == 6.0
    assert {colour for *_ends, colour in view.tube._strokes} == {coded_layers(6.0, view.tube.setup.gamma)}
    assert view.tube.driver is not None
    assert view.tube.driver.beam.energy_per_frame(0).any()
    assert not view.tube.driver.beam.energy_per_frame(1).any()
    typed(qtbot, view.volts.field, "12")
    settle(qtbot, session)
    assert view.tube.driver.beam.energy_per_frame(1).sum() > view.tube.driver.beam.energy_per_frame(0).sum()
    assert "13 % " in view.words.text()
    typed(qtbot, view.volts.field, "0")
    assert view.volts.field.complaint.text()
    assert page.subject.arguments["kilovolts"] == 12.0
    view.own.click()
    settle(qtbot, session)
    assert len({colour for *_ends, colour in view.tube._strokes}) == 4


@pytest.mark.parametrize(
    ("name", "value"), [("kilovolts", 0.0), ("pitch_mm", 0.0), ("red", 1.5), ("mask", 3), ("hue", 400.0)]
)
def test_a_file_cannot_set_what_no_field_takes(session: Session, name: str, value) -> None:
    session.visit("colour", Subject("colour_model"))
    with pytest.raises(DocumentError, match=name):
        session.update_state(subject=Subject("colour_model", arguments={name: value}))


def test_keys_switch_the_parts(qtbot: QtBot, page: ColourPage, session: Session) -> None:
    for number, action in enumerate(page.commands()[:3]):
        action.trigger()
        settle(qtbot, session)
        assert page.stack.currentIndex() == number


def test_every_control_has_a_name_and_a_tooltip(page: ColourPage) -> None:
    for kind in (QAbstractButton, QComboBox, QSlider):
        for control in page.findChildren(kind):
            if control.objectName() == "qt_tableview_cornerbutton":
                continue
            assert control.toolTip(), (control.accessibleName(), control)
            assert control.accessibleName() or control.text(), control


def test_tables_and_picture_are_given_out(page: ColourPage) -> None:
    tables = dict(page.tables())
    assert [row[0] for row in tables["Colour in three models"].rows] == list("RGBCMYHSV")
    assert [row[0] for row in tables["Beam penetration"].rows][:4] == ["Red", "Orange", "Yellow", "Green"]
    assert page.copy()


def test_places_in_the_solids(page: ColourPage) -> None:
    """Black and white are opposite corners of both cubes, and the tip and the middle of the hexcone."""
    for model, solid in page.models.solids.items():
        black, white = (solid._solid.place_of(3 * (level,)) for level in (0.0, 1.0))
        if model == "hsv":
            assert black[:2] == white[:2] == (0.0, 0.0)
            assert black[2] < white[2]
        else:
            assert black == tuple(-each for each in white)
    assert page.models.solids["rgb"]._solid.place_of((1.0, 0.0, 0.0)) == (0.5, -0.5, -0.5)
    assert page.models.solids["cmy"]._solid.place_of((1.0, 0.0, 0.0)) == (-0.5, 0.5, 0.5)
    assert isinstance(page.models.solids["hsv"].place_of((1.0, 0.0, 0.0)), QPointF)


def test_display_has_the_pages(qtbot: QtBot, session: Session) -> None:
    panel = DisplayPanel(session)
    keep_until_the_end(qtbot, panel)
    with qtbot.waitExposed(panel):
        panel.show()
    for slug, kind in (("flicker", "flicker"), ("colour", "colour_model")):
        panel.show_page(slug)
        session.flush()
        assert session.state.workspace == slug
        assert session.state.subject.kind == kind


def test_the_derivation_works_out_the_colour_and_the_layers(page: ColourPage, session: Session) -> None:
    page.change({"red": 0.2, "green": 0.4, "blue": 0.6, "kilovolts": 10.0})
    text = " ".join(block.text for block in page.derivation().blocks if isinstance(block, Heading | Sentence))
    for worked_out in ("$C = 1 - R = 0.8$", "(0.6 - 0.2) / 0.6 = 0.6667$", "$H = 210$°"):
        assert worked_out in text
    assert "(6 / 10)^2)$ = 80.0 %; in the red layer 20.0 %" in text
    assert all(f"{point}." in text for point in range(1, 6))
    assert sum(isinstance(block, Drawing) for block in page.derivation().blocks) == 2
    assert write_diagram(page.derivation()).startswith("<")
    page.change({"red": 0.5, "green": 0.5, "blue": 0.5, "kilovolts": 5.0})
    text = " ".join(block.text for block in page.derivation().blocks if isinstance(block, Sentence))
    assert "A grey has no hue." in text
    assert "all of the energy stays in the red layer" in text


@pytest.mark.parametrize(("room", "slides"), [(-1, False), (0, True), (90, True)])
def test_a_slider_never_covers_the_unit_of_its_number(qtbot: QtBot, room: int, slides: bool) -> None:
    place = QWidget()
    part = NumberSlider(Coordinate("x", "Red beam, to the right", 5.0, "mm"), complaint_label(), place)
    put_on_screen(qtbot, place, 300, 30)
    part.resize(part.field.sizeHint().width() + 36 + room, 30)
    assert part.slider.isVisible() == slides
    if slides:
        assert part.slider.geometry().left() > part.field.geometry().right()
