"""The cards below the tube: as much room as they need, at any width, whatever is typed."""

import re

import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as trying
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from tests.panels.display.test_gun import settle
from workbench.display.gun import SINE
from workbench.panels.display.gun.page import GunPage
from workbench.session.session import Session


@pytest.fixture
def page(gun_page: GunPage) -> GunPage:
    return gun_page


def test_what_is_wrong_is_said_over_the_whole_card_and_the_slider_stays(page: GunPage, qtbot: QtBot) -> None:
    slid = page.cards.beam.fields["grid"]
    before = slid.slider.mapTo(page.cards, QPoint(0, 0)) - slid.number.mapTo(page.cards, QPoint(0, 0))
    slid.number.field.selectAll()
    qtbot.keyClicks(slid.number.field, "abc")
    qtbot.keyClick(slid.number.field, Qt.Key.Key_Return)
    said = slid.number.complaint
    qtbot.waitUntil(lambda: said.isVisible() and said.height() >= said.heightForWidth(said.width()))
    after = slid.slider.mapTo(page.cards, QPoint(0, 0)) - slid.number.mapTo(page.cards, QPoint(0, 0))
    assert after == before
    assert said.width() == slid.width()


@pytest.mark.parametrize("width", [760, 800, 840, 1000])
def test_what_is_wrong_is_said_whole_in_cards_of_any_width(page: GunPage, qtbot: QtBot, width: int) -> None:
    page.resize(width, 520)
    qtbot.waitUntil(lambda: page.cards.width() > width - 60)
    beam = page.cards.beam
    high = beam.fields["anode"].number.field.height()
    for name, typed in (("anode", "99999"), ("focus", "-3"), ("grid", "abc")):
        number = beam.fields[name].number
        number.field.selectAll()
        qtbot.keyClicks(number.field, typed)
        qtbot.keyClick(number.field, Qt.Key.Key_Return)
        said = number.complaint
        qtbot.waitUntil(said.isVisible)
        qtbot.waitUntil(lambda said=said: said.height() >= said.heightForWidth(said.width()))
        assert [field.number.field.height() for field in beam.fields.values()] == [high] * 3


def test_cards_ask_from_the_start_for_no_more_room_than_held_inputs_need(session: Session) -> None:
    fresh = GunPage(session)
    asked = fresh.cards.sizeHint().height()
    rows = [field for field in fresh.cards.up.fields.values() if not field.isHidden()]
    fresh.cards.show_gun(fresh.setting.gun)
    assert len(rows) == 1
    assert fresh.cards.sizeHint().height() == asked
    fresh.deleteLater()


def test_a_held_card_tells_the_law_in_letters_and_with_numbers(page: GunPage, qtbot: QtBot) -> None:
    card = page.cards.up
    assert card.law.isVisible()
    assert re.sub("<[^>]*>", "", card.law.text()) == "y = l Dy Vy / (2 d Va)"
    assert card.limit.text() == "caught beyond 640 V"
    page.setting.change({"y_volts": -316.4})
    settle(page)
    assert "40·200·(\u2212316.4) / (2·16·2000)" in card.line.text()
    page.setting.change({"y_wave": SINE})
    settle(page)
    assert not card.law.isVisible()
    assert not card.limit.isVisible()


def test_a_narrow_page_brings_the_card_of_the_step_forward(
    page: GunPage, session: Session, qtbot: QtBot
) -> None:
    page.resize(600, 380)
    qtbot.waitUntil(lambda: not page.cards.up.isVisible())
    assert page.cards.beam.height() < 80
    session.update_state(step=5)
    settle(page)
    assert page.cards.up.isVisible()
    assert not page.cards.beam.isVisible()
    page.cards.buttons.button(3).click()
    assert page.monitor.isVisible()
    assert page.monitor.height() < 110


@pytest.mark.parametrize("width", [600, 785, 1100])
def test_the_card_of_the_beam_tells_current_and_focus_at_any_width(
    page: GunPage, qtbot: QtBot, width: int
) -> None:
    page.resize(width, 460)
    page.setting.change({"focus": 50.0})
    settle(page)
    card = page.cards.beam
    qtbot.waitUntil(lambda: card.focus.isVisible() == (width > 700))
    told = card.focus if width > 700 else card.line
    words = re.sub("<[^>]*>", "", told.text()).replace("\N{NO-BREAK SPACE}", " ")
    assert "\N{GREEK SMALL LETTER SIGMA} 22 mm, sharp at 420 V" in words
    for label in (told, card.line):
        assert label.heightForWidth(label.width()) <= label.height()
        assert label.sizeHint().width() <= label.width() or label.wordWrap()


def test_the_sliders_of_an_input_stand_beside_one_another_on_a_narrow_page(
    page: GunPage, qtbot: QtBot
) -> None:
    page.setting.change({"y_wave": SINE})
    page.resize(660, 380)
    settle(page)
    page.cards.buttons.button(1).click()
    fields = [page.cards.up.fields[name] for name in ("peak", "rate", "phase")]
    qtbot.waitUntil(lambda: all(field.isVisible() for field in fields))
    for field in fields:
        qtbot.waitUntil(lambda f=field: f.number.width() >= f.number.minimumSizeHint().width())
        assert field.number.label.width() >= field.number.label.sizeHint().width()
        assert field.number.unit.x() >= field.number.field.geometry().right()


@pytest.mark.parametrize(
    ("settings", "up", "across"),
    [
        ({"grid": -60.0}, "No beam: the grid is at its cut-off.", "No beam: the grid is at its cut-off."),
        (
            {"grid": -70.0, "coils": True},
            "No beam: the grid is at its cut-off.",
            "No beam: the grid is at its cut-off.",
        ),
        ({"y_volts": 700.0}, "Caught: beyond 640 V a plate is hit.", "The other plates catch the beam."),
        ({"x_volts": -700.0}, "The other plates catch the beam.", "Caught: beyond 640 V a plate is hit."),
        (
            {"coils": True, "y_field": 9.0},
            "The coils turn it round: it never gets out.",
            "The coils turn it round: it never gets out.",
        ),
    ],
)
def test_where_no_beam_arrives_its_cards_say_why(
    page: GunPage, settings: dict[str, float], up: str, across: str
) -> None:
    page.setting.change(settings)
    settle(page)
    for card, why in ((page.cards.up, up), (page.cards.across, across)):
        assert card.line.text() == f"<b>{why}</b>"
        assert card.line.heightForWidth(card.line.width()) <= card.line.height()


@given(
    turns=st.lists(st.tuples(st.sampled_from(["brightness", "contrast"]), st.integers(0, 200)), max_size=12)
)
@trying(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=25)
def test_knobs_that_are_turned_back_bring_the_grid_back(page: GunPage, turns: list[tuple[str, int]]) -> None:
    """However far they went, and however many turns came before the page was shown."""
    knobs = page.monitor
    settle(page)
    places = knobs.brightness.dial.value(), knobs.contrast.dial.value()
    before = page.setting.gun.grid
    for name, at in turns:
        getattr(knobs, name).dial.setValue(at)
    knobs.brightness.dial.setValue(places[0])
    knobs.contrast.dial.setValue(places[1])
    settle(page)
    assert page.setting.gun.grid == pytest.approx(before, abs=0.03)
