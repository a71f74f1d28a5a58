"""Basis functions, knots and weights as a person uses them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QGraphicsItem
from pytestqt.qtbot import QtBot

from tests.widgets.plots.by_hand import click, drag, hover
from workbench.algorithms.curves import basis_table
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.plots.basis_plot import BasisPlot

LEFT, RIGHT_KEY, LEFT_KEY = Qt.MouseButton.LeftButton, Qt.Key.Key_Right, Qt.Key.Key_Left
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
KNOTS = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 4.0, 5.0, 5.0, 5.0, 5.0]
US = np.linspace(0, 5, 201)
VALUES = basis_table(np.array(KNOTS), 3, US)
NAMES = [f"N_{{{k}}}" for k in range(8)]
IDS = [f"k{k}" for k in range(12)]


@pytest.fixture
def plot(qtbot: QtBot) -> BasisPlot:
    made = BasisPlot()
    qtbot.addWidget(made)
    made.set_functions(US, VALUES, NAMES)
    made.set_knots(list(zip(IDS, KNOTS, strict=True)))
    made.set_weights([1, 1, 2, 0.5, 1, 4, 1, 1])
    made.set_u(1.5)
    made.resize(420, 340)
    made.show()
    qtbot.waitUntil(lambda: made.curves._plot is not None, timeout=30_000)
    QApplication.processEvents()
    return made


class Told:
    """What a signal has sent."""

    def __init__(self, signal):
        self.all = []
        signal.connect(lambda *sent: self.all.append(sent if len(sent) > 1 else sent[0]))


# Functions and u


def test_u_is_asked_for_by_press_drag_and_keys_and_shown_only_when_set(qtbot: QtBot, plot: BasisPlot):
    told = Told(plot.u_dragged)
    curves = plot.curves
    middle = round(curves.area.center().y())
    drag(qtbot, curves, QPoint(round(curves.x_of(2)), middle), QPoint(round(curves.x_of(3)), middle))
    assert told.all == pytest.approx([2, 3], abs=0.02)
    drag(qtbot, curves, QPoint(round(curves.x_of(3)), middle), QPoint(3000, middle))
    assert told.all[-1] == 5
    assert curves.u == 1.5
    told.all.clear()
    for key, modifier in ((RIGHT_KEY, Qt.KeyboardModifier.NoModifier), (LEFT_KEY, SHIFT)):
        qtbot.keyClick(curves, key, modifier)
    for key in (Qt.Key.Key_Home, Qt.Key.Key_End):
        qtbot.keyClick(curves, key)
    assert told.all == pytest.approx([1.55, 1.0, 0, 5])


def test_u_stays_where_the_curve_is(qtbot: QtBot, plot: BasisPlot):
    plot.set_domain((1.0, 4.0))
    told = Told(plot.u_dragged)
    for part in (plot.curves, plot.knots):
        for x in (part.x_of(0.4), part.x_of(4.6)):
            click(qtbot, part, QPoint(round(x), 30))
    assert told.all == [1, 4, 1, 4]


@given(st.floats(0, 5), st.integers(0, 7))
def test_the_function_pointed_at_is_the_one_there(qapp, u, number):
    plot = BasisPlot()
    plot.resize(420, 340)
    plot.set_functions(US, VALUES, NAMES)
    values = plot.curves.values_at(u)
    assert values == pytest.approx(basis_table(np.array(KNOTS), 3, np.array([u]))[0], abs=2e-3)
    found = plot.curves.function_at(QPointF(plot.curves.x_of(u), plot.curves.y_of(float(values[number]))))
    if values[number] > 0:
        assert values[found] == pytest.approx(values[number], abs=1e-9)
    plot.deleteLater()


def test_pointing_lights_up_function_and_weight_and_tells(qtbot: QtBot, plot: BasisPlot):
    told = Told(plot.hovered)
    curves = plot.curves
    at_peak = QPointF(curves.x_of(1.0), curves.y_of(float(curves.values_at(1.0)[2]))).toPoint()
    dark = curves.grab().toImage()
    hover(curves, at_peak)
    assert told.all == [2]
    assert plot.weights.lit == 2
    assert curves.grab().toImage() != dark
    hover(curves, QPoint(at_peak.x(), round(curves.area.top()) + 2))
    assert told.all == [2, -1]
    qtbot.keyClick(curves, Qt.Key.Key_Up)
    qtbot.keyClick(curves, Qt.Key.Key_Down)
    qtbot.keyClick(curves, Qt.Key.Key_Escape)
    assert told.all == [2, -1, 0, 7, -1]
    hover(plot.weights, plot.weights._bar(5).center().toPoint())
    assert told.all[-1] == 5
    assert curves.lit == 5
    assert "N₅" in curves.accessibleDescription()


def test_lighting_up_from_outside_is_not_told_back(plot: BasisPlot):
    told = Told(plot.hovered)
    plot.highlight(3)
    assert (plot.curves.lit, plot.weights.lit) == (3, 3)
    plot.highlight(99)
    assert (plot.curves.lit, plot.weights.lit) == (-1, -1)
    assert told.all == []


# Knots


def place(plot: BasisPlot, number: int) -> QPoint:
    return plot.knots.places()[number].toPoint()


def test_a_knot_is_dragged_between_its_neighbours(qtbot: QtBot, plot: BasisPlot):
    dragged, released, asked = (
        Told(signal) for signal in (plot.knot_dragged, plot.knot_released, plot.u_dragged)
    )
    y = place(plot, 4).y()
    x = round(plot.knots.x_of(1.4))
    drag(qtbot, plot.knots, place(plot, 4), QPoint(x, y), QPoint(3000, y), QPoint(-50, y))
    assert [name for name, _u in dragged.all] == ["k4"] * 3
    assert [u for _name, u in dragged.all] == pytest.approx([1.4, 2.0, 0.0], abs=0.02)
    assert dragged.all[1][1] == 2.0
    assert released.all == ["k4"]
    assert plot.knots.selected == "k4"
    assert asked.all == []


def test_control_takes_a_knot_to_round_places(qtbot: QtBot, plot: BasisPlot):
    dragged = Told(plot.knot_dragged)
    qtbot.mousePress(plot.knots, LEFT, pos=place(plot, 7))
    end = QPoint(round(plot.knots.x_of(3.07)), place(plot, 7).y())
    spot = QPointF(end)

    QApplication.sendEvent(
        plot.knots,
        QMouseEvent(
            QEvent.Type.MouseMove, spot, plot.knots.mapToGlobal(spot),
            Qt.MouseButton.NoButton, LEFT, CONTROL,
        ),
    )  # fmt: skip
    qtbot.mouseRelease(plot.knots, LEFT, pos=end)
    assert dragged.all == [("k7", 3.0)]


@pytest.mark.parametrize(("towards", "moved"), [(1.6, "k5"), (2.4, "k6")])
@pytest.mark.parametrize("grabbed", [5, 6])
def test_of_equal_knots_the_one_moves_that_has_room(qtbot: QtBot, plot: BasisPlot, towards, moved, grabbed):
    dragged = Told(plot.knot_dragged)
    end = QPoint(round(plot.knots.x_of(towards)), place(plot, grabbed).y())
    drag(qtbot, plot.knots, place(plot, grabbed), end)
    assert dragged.all[0][0] == moved
    assert dragged.all[0][1] == pytest.approx(towards, abs=0.02)


def test_equal_knots_stand_above_one_another(plot: BasisPlot):
    places = plot.knots.places()
    assert places[5].x() == places[6].x()
    assert places[5].y() > places[6].y()
    assert len({p.y() for p in places[:4]}) == 4
    assert all(plot.knots.rect().contains(p.toPoint()) for p in places)


def test_a_click_on_a_knot_moves_nothing(qtbot: QtBot, plot: BasisPlot):
    told = [Told(signal) for signal in (plot.knot_dragged, plot.knot_released)]
    qtbot.mouseClick(plot.knots, LEFT, pos=place(plot, 4))
    assert [each.all for each in told] == [[], []]
    assert plot.knots.selected == "k4"
    assert "Knot 5 of 12: u = 1, multiplicity 1" in plot.knots.accessibleDescription()


def test_keys_choose_and_nudge_a_knot(qtbot: QtBot, plot: BasisPlot):
    dragged, released, asked = (
        Told(signal) for signal in (plot.knot_dragged, plot.knot_released, plot.u_dragged)
    )
    qtbot.keyClick(plot.knots, RIGHT_KEY)
    assert asked.all == pytest.approx([1.55])
    qtbot.mouseClick(plot.knots, LEFT, pos=place(plot, 4))
    qtbot.keyClick(plot.knots, RIGHT_KEY)
    qtbot.keyClick(plot.knots, LEFT_KEY, SHIFT)
    assert dragged.all == [("k4", pytest.approx(1.05)), ("k4", pytest.approx(0.5))]
    assert released.all == ["k4", "k4"]
    qtbot.keyClick(plot.knots, Qt.Key.Key_Up)
    assert plot.knots.selected == "k5"
    qtbot.keyClick(plot.knots, Qt.Key.Key_Escape)
    assert plot.knots.selected == ""
    assert len(asked.all) == 1


def test_a_double_click_or_insert_asks_for_a_knot(qtbot: QtBot, plot: BasisPlot):
    plot.set_domain((0.0, 4.5))
    wanted = Told(plot.knot_wanted)
    qtbot.mouseDClick(plot.knots, LEFT, pos=QPoint(round(plot.knots.x_of(3.0)), 30))
    qtbot.mouseDClick(plot.knots, LEFT, pos=QPoint(round(plot.knots.x_of(4.9)), 30))
    qtbot.keyClick(plot.knots, Qt.Key.Key_Insert)
    assert wanted.all == pytest.approx([3.0, 1.5], abs=0.02)


def test_delete_asks_for_the_chosen_knot_to_go(qtbot: QtBot, plot: BasisPlot):
    unwanted = Told(plot.knot_unwanted)
    qtbot.keyClick(plot.knots, Qt.Key.Key_Delete)
    qtbot.mouseClick(plot.knots, LEFT, pos=place(plot, 4))
    qtbot.keyClick(plot.knots, Qt.Key.Key_Delete)
    assert unwanted.all == ["k4"]


def test_knots_that_follow_a_rule_stay(qtbot: QtBot, plot: BasisPlot):
    plot.set_knots(list(zip(IDS, KNOTS, strict=True)), movable=False)
    told = [Told(signal) for signal in (plot.knot_dragged, plot.knot_released)]
    drag(qtbot, plot.knots, place(plot, 4), place(plot, 4) + QPoint(40, 0))
    qtbot.keyClick(plot.knots, RIGHT_KEY)
    assert [each.all for each in told] == [[], []]


def test_the_axis_holds_still_while_a_knot_is_held(qtbot: QtBot, plot: BasisPlot):
    def follow(name, u):
        now = [(one, u if one == name else value) for one, value in plot.knots.knots]
        plot.set_knots(now)

    plot.knot_dragged.connect(follow)
    start = place(plot, 11)
    qtbot.mousePress(plot.knots, LEFT, pos=start)
    qtbot.mouseMove(plot.knots, start + QPoint(12, 0))
    assert plot.knots.knots[-1][1] > 5
    assert plot.curves.range == (0, 5)
    qtbot.mouseRelease(plot.knots, LEFT, pos=start + QPoint(12, 0))
    assert plot.curves.range == (0, plot.knots.knots[-1][1])


def test_a_knot_that_gets_its_id_while_dragged_stays_in_hand(qtbot: QtBot, plot: BasisPlot):
    plot.set_knots([(f"#{k}", u) for k, u in enumerate(KNOTS)])
    released = Told(plot.knot_released)

    def free(_name, u):
        plot.set_knots([(IDS[k], u if k == 4 else value) for k, value in enumerate(KNOTS)])

    plot.knot_dragged.connect(free)
    drag(qtbot, plot.knots, place(plot, 4), place(plot, 4) + QPoint(9, 0), place(plot, 4) + QPoint(16, 0))
    assert released.all == ["k4"]
    assert plot.knots.selected == "k4"


# Weights


def weight_place(plot: BasisPlot, number: int, weight: float) -> QPoint:
    return QPointF(plot.weights._bar(number).center().x(), plot.weights._y(weight)).toPoint()


def test_weights_are_dragged_on_a_logarithmic_scale(qtbot: QtBot, plot: BasisPlot):
    dragged, released = Told(plot.weight_dragged), Told(plot.weight_released)
    drag(qtbot, plot.weights, weight_place(plot, 2, 2.0), *(weight_place(plot, 2, w) for w in (4.0, 0.25)))
    assert [number for number, _w in dragged.all] == [2] * len(dragged.all)
    assert [w for _n, w in dragged.all][-2:] == pytest.approx([4.0, 0.25], rel=0.08)
    drag(qtbot, plot.weights, weight_place(plot, 2, 2.0), weight_place(plot, 2, 2.0) + QPoint(0, 900))
    assert dragged.all[-1][1] > 0
    assert released.all == [2, 2]
    qtbot.mouseDClick(plot.weights, LEFT, pos=weight_place(plot, 5, 4.0))
    assert dragged.all[-1] == (5, 1.0)


def test_keys_choose_and_change_a_weight(qtbot: QtBot, plot: BasisPlot):
    dragged, hovered = Told(plot.weight_dragged), Told(plot.hovered)
    for _time in range(3):
        qtbot.keyClick(plot.weights, RIGHT_KEY)
    assert hovered.all == [0, 1, 2]
    qtbot.keyClick(plot.weights, Qt.Key.Key_Up, SHIFT)
    qtbot.keyClick(plot.weights, Qt.Key.Key_Down)
    assert dragged.all == [(2, pytest.approx(4.0)), (2, pytest.approx(2 / 2**0.125))]
    assert plot.weights.accessibleDescription() == "weight of P₂: 2"


@given(st.floats(1e-9, 1e9), st.floats(0.01, 100))
def test_every_weight_is_in_sight_and_the_place_tells_it(qapp, weight, other):
    plot = BasisPlot()
    plot.resize(420, 340)
    plot.set_weights([weight, other])
    bars = plot.weights
    for value in (weight, other):
        assert bars.area.top() <= bars._y(value) <= bars.area.bottom()
        assert math.log10(bars._weight_at(bars._y(value)) / value) == pytest.approx(0, abs=1e-6)
    plot.deleteLater()


# The whole


def test_nothing_is_plotted_anew_for_nothing(plot: BasisPlot, monkeypatch: pytest.MonkeyPatch):
    anew = []
    monkeypatch.setattr(plot.curves._lines[0], "setData", lambda *_data: anew.append(1))
    plot.set_functions(US.copy(), VALUES.copy(), NAMES)
    plot.set_knots(list(zip(IDS, KNOTS, strict=True)))
    plot.set_u(2.5)
    plot.highlight(1)
    assert anew == []
    plot.set_functions(US, VALUES[:, :7], NAMES[:7])
    assert anew == [1]


def test_functions_and_knots_stand_on_one_axis_zoomed_or_not(qtbot: QtBot, plot: BasisPlot):
    box = plot.curves._plot.getPlotItem().vb
    for _zoom in range(3):
        for u in (2.0, 3.0, 2.37):
            painted = box.mapViewToScene(QPointF(u, 0)).x() + plot.curves._plot.x()
            assert painted == pytest.approx(plot.curves.x_of(u), abs=0.6)
            assert plot.knots.x_of(u) == pytest.approx(plot.curves.x_of(u), abs=1e-6)
        qtbot.keyClick(plot.curves, Qt.Key.Key_Plus)
    assert plot.knots.range != (0, 5)
    qtbot.keyClick(plot.curves, Qt.Key.Key_0)
    assert plot.knots.range == plot.curves.range == (0, 5)


def test_without_a_curve_it_says_so_and_asks_for_nothing(qtbot: QtBot, plot: BasisPlot):
    plot.set_functions(np.zeros(0), np.zeros((0, 0)), ())
    plot.set_knots([])
    plot.set_weights([])
    assert plot.knots.isHidden()
    assert plot.weights.isHidden()
    told = Told(plot.u_dragged)
    click(qtbot, plot.curves, QPoint(100, 40))
    for key in (RIGHT_KEY, Qt.Key.Key_Up):
        qtbot.keyClick(plot.curves, key)
    assert told.all == []
    assert plot.curves.accessibleDescription() == plot.curves.words != ""
    plot.grab()


def test_parts_have_names_tooltips_and_a_place_in_the_key_order(plot: BasisPlot):
    for part in (plot.curves, plot.knots, plot.weights):
        assert part.accessibleName()
        assert part.toolTip()
        assert part.focusPolicy() & Qt.FocusPolicy.TabFocus


def test_the_theme_shows_everywhere(plot: BasisPlot):
    parts = (plot.curves, plot.knots, plot.weights)
    light = [part.grab().toImage() for part in parts]
    theme.use(DARK)
    try:
        assert all(part.grab().toImage() != seen for part, seen in zip(parts, light, strict=True))
    finally:
        theme.use(LIGHT)


def test_a_thousand_functions_and_knots_paint_and_answer(qtbot: QtBot, plot: BasisPlot):
    knots = np.concatenate([[0, 0, 0], np.linspace(0, 1, 998), [1, 1, 1]])
    us = np.linspace(0, 1, 1000)
    plot.set_functions(us, basis_table(knots, 3, us), [f"N_{{{k}}}" for k in range(1000)])
    plot.set_knots([(str(k), u) for k, u in enumerate(knots.tolist())])
    plot.set_weights([1.0] * 1000)
    plot.set_u(0.5)
    assert not plot.grab().isNull()
    plot.highlight(500)
    assert not plot.grab().isNull()
    qtbot.keyClick(plot.curves, Qt.Key.Key_Up)
    assert plot.curves.lit == plot.weights.lit == 501
    assert "N₅₀₁ is" in plot.curves.accessibleDescription()
    qtbot.mouseClick(plot.knots, LEFT, pos=place(plot, 500))
    assert plot.knots.selected in {str(k) for k in range(498, 503)}


def test_numbers_beside_the_functions_are_those_of_the_size_once_it_has_grown(plot: BasisPlot):
    plot.set_functions(US, VALUES - 0.15, NAMES)
    for height in (140, 170, 200, 240, 300):
        plot.resize(420, height)
        plot.grab()
        QApplication.processEvents()
    grown = plot.grab().toImage()
    for side in ("left", "bottom"):
        plot.curves._plot.getAxis(side).setCacheMode(QGraphicsItem.CacheMode.NoCache)
    assert plot.grab().toImage() == grown
