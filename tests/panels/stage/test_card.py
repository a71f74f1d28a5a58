"""What is typed in the card, and what it says of what cannot be: too far away to be drawn, no number."""

import math
from collections.abc import Iterator

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.edits import add_figure, set_attribute, set_window
from workbench.document.fields import Number, numbers_of, structs_in
from workbench.document.model import (
    AnyFigure,
    Circle,
    Ellipse,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    WorldPoint,
)
from workbench.document.samples.examples import blank_sheet
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.stage.card import number_field
from workbench.rendering import REACH_PX, figure_calls
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField, with_subscript

HEXAGON = ((4, 8), (8, 2), (14, 2), (18, 8), (14, 14), (8, 14))
PLACE = (WorldPoint("p1", 10, 10),)
FIGURES = (
    Circle("f1", PLACE, "midpoint_circle", 1, radius_world=5.0),
    Ellipse("f1", PLACE, "midpoint_ellipse", 1, radius_x_world=5.0, radius_y_world=4.0),
    SeedFill("f1", PLACE, "boundary_fill_4", 1),
)


@pytest.fixture
def panel(qtbot: QtBot) -> Iterator[DrawPanel]:
    session = Session(document=blank_sheet(64, 48))
    panel = DrawPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(850, 600)
    panel.show()
    yield panel
    session.close()


def test_an_algorithm_that_this_version_does_not_have_is_said(qtbot: QtBot) -> None:
    figure = replace(FIGURES[0], algorithm="circle_of_tomorrow")
    blank = blank_sheet(64, 48)
    session = Session(document=replace(blank, sheets=(replace(blank.sheets[0], figures=(figure,)),)))
    panel = DrawPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(850, 600)
    panel.show()
    session.update_state(selection=("f1",), active="f1")
    settle()
    card = panel.card
    assert "“circle_of_tomorrow”" in card.trouble.text()
    assert "“Midpoint circle” draws it" in card.trouble.text()
    assert card.algorithm.currentData() == "midpoint_circle"
    assert session.run.entry is not None
    assert session.run.entry.slug == "midpoint_circle"
    card.algorithm.setCurrentIndex(card.algorithm.findData("circle_fill"))
    card.algorithm.activated.emit(card.algorithm.currentIndex())
    settle()
    assert card.trouble.isHidden()
    assert session.sheet.figures[0].algorithm == "circle_fill"
    session.close()


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: type(figure).__name__)
def test_what_is_beyond_reach_is_said(panel: DrawPanel, figure: AnyFigure) -> None:
    session = panel.session
    sheet = session.sheet
    session.apply(add_figure(sheet.id, figure), "Draw")
    session.update_state(selection=("f1",), active="f1")
    settle()
    assert panel.card.trouble.isHidden()
    field = "radius_world" if isinstance(figure, Circle) else "p1/x"
    session.apply(set_attribute(f"{sheet.id}/f1/{field}", REACH_PX + 3_616.0), "Change value")
    settle()
    assert not panel.card.trouble.isHidden()
    assert "20,000" in panel.card.trouble.text()
    assert "16,384" in panel.card.trouble.text()
    if not isinstance(figure, SeedFill):
        assert figure_calls(session.sheet, session.sheet.figures[0]) == []


def test_what_is_just_within_reach_is_drawn(panel: DrawPanel) -> None:
    session = panel.session
    circle = replace(FIGURES[0], radius_world=float(REACH_PX))
    session.apply(add_figure(session.sheet.id, circle), "Draw")
    assert len(figure_calls(session.sheet, session.sheet.figures[0])) == 1


def test_each_of_six_corners_can_be_typed(panel: DrawPanel, qtbot: QtBot) -> None:
    session = panel.session
    corners = tuple(WorldPoint("", float(x), float(y)) for x, y in HEXAGON)
    session.apply(add_figure("s1", Polyline("", corners, "bresenham_line", closed=True)), "Draw")
    figure = session.sheet.figures[-1]
    session.update_state(selection=(figure.id,))
    settle()
    for number, point in enumerate(figure.points_world):
        field = panel.card._fields[f"s1/{figure.id}/{point.id}/y"].field
        field.selectAll()
        qtbot.keyClicks(field, str(20 + number))
        qtbot.keyClick(field, Qt.Key.Key_Return)
        settle()
    (typed,) = (each for each in session.sheet.figures if each.id == figure.id)
    assert [point.y for point in typed.points_world] == [20, 21, 22, 23, 24, 25]
    assert [point.x for point in typed.points_world] == [x for x, _y in HEXAGON]


def test_a_field_stays_where_it_is_beside_one_that_complains(panel: DrawPanel, qtbot: QtBot) -> None:
    session = panel.session
    session.apply(add_figure("s1", FIGURES[0]), "Draw")
    session.update_state(selection=("f1",), active="f1")
    settle()
    bad, beside = (panel.card._fields[f"s1/f1/p1/{axis}"] for axis in "xy")
    bad.field.setFocus()
    bad.field.selectAll()
    qtbot.keyClicks(bad.field, "abc")
    qtbot.keyClick(bad.field, Qt.Key.Key_Return)
    settle()
    assert bad.complaint.isVisible()
    assert beside.field.mapTo(panel, QPoint()).y() == bad.field.mapTo(panel, QPoint()).y()


NUMBERS = {
    f"{kind.__name__}.{name}": number
    for kind in structs_in(Sheet)
    for name, number in numbers_of(kind).items()
    if math.isfinite(number.low)
}


@pytest.mark.parametrize("number", NUMBERS.values(), ids=NUMBERS)
def test_a_field_says_and_takes_what_is_declared(qtbot: QtBot, number: Number) -> None:
    field = number_field(number, "Meaning")
    qtbot.addWidget(field)
    assert (field.label.text(), field.unit.text()) == (with_subscript(number.label), number.unit)
    sent: list[float] = []
    field.edited.connect(sent.append)

    def type_(value: float) -> str:
        field.field.setText(f"{value:.10f}")
        field.field.returnPressed.emit()
        return field.complaint.text()

    field.set_value((number.low + number.high) / 2)
    assert (type_(number.low), type_(number.high)) == ("", "")
    assert sent == [number.low, number.high]
    assert "the least is" in type_(number.low - 1)
    assert "the most is" in type_(number.high + 1)
    assert ("is not whole" in type_(number.low + 0.5)) == number.whole


def test_a_coordinate_is_in_pixels_where_the_world_is_and_a_radius_too(panel: DrawPanel) -> None:
    session = panel.session
    session.apply(add_figure(session.sheet.id, FIGURES[1]), "Draw")
    session.update_state(selection=("f1",), active="f1")

    def fields() -> dict[str, tuple[str, str]]:
        settle()
        kept = [field for field in panel.card.findChildren(NumberField) if field.isVisibleTo(panel.card)]
        return {field.label.text(): (field.unit.text(), field.field.accessibleName()) for field in kept}

    names = {"x": "x of the centre", "y": "y of the centre"}
    radii = {"x": "Horizontal radius", "y": "Vertical radius"}
    expected = {f"{k}<sub>c</sub>": ("px", name) for k, name in names.items()}
    expected |= {f"r<sub>{k}</sub>": ("px", name) for k, name in radii.items()}
    assert fields() == expected
    session.apply(set_window(session.sheet.first_view.id, Rectangle(0.0, 0.0, 100.0, 75.0)), "Window")
    session.update_state(selection=(), active="")
    settle()
    session.update_state(selection=("f1",), active="f1")
    assert {unit for unit, _name in fields().values()} == {""}
