"""The card of a curve: what is missing, how it is counted, its kinds, knots and steps."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    LEFT,
    ZIGZAG,
    click,
    curve_through,
    opened,
    the_curve,
)
from workbench.document.curves.pieces import pieces_of
from workbench.document.subjects import Subject
from workbench.widgets.canvas.drawing import PenStroke
from workbench.widgets.stepping.step_bar import Steps


def test_what_is_missing_is_said_on_the_card(qtbot):
    panel = opened(qtbot, curve_through((30, 10), (40, 20)))
    assert panel.card.fault.isVisible()
    assert "There are 2 points, and 4 are needed; add 2." in panel.card.fault.text()


@pytest.mark.parametrize(
    ("spline", "there"), [("b_spline", "count"), ("kochanek_bartels", "sign"), ("bezier_path", "joint")]
)
def test_nothing_of_the_card_is_hidden_only_to_be_shown(qtbot, monkeypatch, spline, there):
    """At each move of a drag the card would be laid out twice."""
    panel = opened(qtbot, curve_through(*ZIGZAG[:4], spline=spline, beside=("hermite",)))
    panel.focus.choose((the_curve(panel).points_world[0].id,))
    settle()
    card, asked = panel.card, []
    boxes = card.compare, card.sign, card.joint, card.legend, card.count, card.fault, card.steps
    for box in (*boxes, *card.shape.values()):
        monkeypatch.setattr(box, "setVisible", lambda shown, box=box: asked.append((box, shown)))
    panel.refresh()
    assert (getattr(card, there), True) in asked
    assert (card.legend, True) in asked
    assert not {box for box, shown in asked if shown} & {box for box, shown in asked if not shown}
    assert not card.compare.isVisible()


def test_both_countings_stand_on_the_card(zigzag):
    said = zigzag.card.count.text()
    assert "n + 1 = 5" in said
    assert "d = 4" in said
    assert "5 points, degree 3, 2 pieces" in said


def test_a_span_without_length_is_no_piece(qtbot):
    panel = opened(qtbot)
    panel.session.open_example("curve-circle")
    settle()
    assert "9 points, degree 2, 4 pieces" in panel.card.count.text()


def test_other_kinds_are_shown_beside_and_named(zigzag):
    zigzag.card._kinds["catmull_rom"].trigger()
    settle()
    assert the_curve(zigzag).beside == ("catmull_rom",)
    assert "Catmull-Rom" in zigzag.card.legend.text()


def test_the_text_that_is_stepped_is_chosen_on_the_card(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    assert panel.card.steps.currentData() == "de_boor"
    panel.card.steps.setCurrentIndex(panel.card.steps.findData("flatten_bezier"))
    panel.card.steps.activated.emit(panel.card.steps.currentIndex())
    settle()
    qtbot.waitUntil(lambda: panel.session.run.entry.slug == "flatten_bezier", timeout=5000)
    assert panel.card.tolerance.isVisible()
    panel.card.tolerance.edited.emit(0.5)
    assert the_curve(panel).tolerance_px == 0.5
    panel.card.spline.setCurrentIndex(panel.card.spline.findData("nurbs"))
    panel.card.spline.activated.emit(panel.card.spline.currentIndex())
    settle()
    assert the_curve(panel).spline == "nurbs"


def test_the_sign_of_the_continuity_is_the_books_or_the_papers(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline="kochanek_bartels", continuity=0.5))
    book = pieces_of(the_curve(panel)).controls
    panel.card.sign.setCurrentIndex(panel.card.sign.findData("paper"))
    panel.card.sign.activated.emit(panel.card.sign.currentIndex())
    settle()
    paper = the_curve(panel)
    assert paper.continuity_sign == "paper"
    assert not np.allclose(pieces_of(paper).controls, book)
    np.testing.assert_array_equal(pieces_of(replace(paper, continuity=-0.5)).controls, book)
    panel.card.spline.setCurrentIndex(panel.card.spline.findData("cardinal"))
    panel.card.spline.activated.emit(panel.card.spline.currentIndex())
    settle()
    assert not panel.card.sign.isVisible()


def test_the_course_s_own_texts_are_offered_and_stepped(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline="natural_cubic"))
    offered = [panel.card.steps.itemData(k) for k in range(panel.card.steps.count())]
    assert offered[0] == "de_casteljau"
    for slug in ("natural_cubic_system", "hermite_blend", "bernstein_curve"):
        panel.card.steps.setCurrentIndex(offered.index(slug))
        panel.card.steps.activated.emit(panel.card.steps.currentIndex())
        settle()
        qtbot.waitUntil(lambda slug=slug: panel.session.run.entry.slug == slug, timeout=5000)
    panel = opened(qtbot, curve_through(*ZIGZAG))
    offered = [panel.card.steps.itemData(k) for k in range(panel.card.steps.count())]
    assert {"b_spline_sum", "de_boor", "bernstein_curve", "hermite_blend"} <= {*offered}
    assert "natural_cubic_system" not in offered


@pytest.mark.parametrize(
    ("spline", "round_", "choice"),
    [("natural_cubic", False, False), ("clamped_cubic", False, False), ("periodic_cubic", True, False),
     ("catmull_rom", True, True)],
)  # fmt: skip
def test_only_what_may_be_closed_is_offered_to_be(qtbot, spline, round_, choice):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline=spline, closed=spline != "periodic_cubic"))
    said = []
    panel.hover_text.connect(said.append)
    assert (panel.card.closed.isChecked(), panel.card.closed.isEnabled()) == (round_, choice)
    before = the_curve(panel)
    panel.commands.toggle_closed()
    assert (the_curve(panel) == before) == bool(said) == (not choice)


def test_knots_are_freed_of_a_curve_that_is_there(qtbot):
    """What the pen draws next has no knots yet that could be freed."""
    panel = opened(qtbot)
    rule = panel.card.rule
    free = rule.model().index(rule.findData("free"), 0)
    offered = Qt.ItemFlag.ItemIsEnabled
    assert rule.isVisible()
    assert not free.flags() & offered
    for place in ZIGZAG:
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert free.flags() & offered
    rule.setCurrentIndex(free.row())
    rule.activated.emit(free.row())
    settle()
    assert the_curve(panel).knot_rule == "free"


@pytest.mark.parametrize("rule", ["uniform", "free"])
def test_a_closed_b_spline_is_counted_as_it_goes_round(qtbot, rule):
    panel = opened(qtbot, curve_through(*ZIGZAG, closed=True))
    panel.card.rule.setCurrentIndex(panel.card.rule.findData(rule))
    panel.card.rule.activated.emit(panel.card.rule.currentIndex())
    settle()
    assert the_curve(panel).knot_rule == rule
    assert f"{len(ZIGZAG)} pieces" in panel.card.count.text()


@pytest.mark.parametrize(("spline", "pieces"), [("natural_cubic", 4), ("periodic_cubic", 5)])
def test_pieces_are_counted_and_legs_drawn_as_the_curve_goes(qtbot, spline, pieces):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline=spline, closed=spline == "natural_cubic"))
    assert f"{pieces} cubic pieces" in panel.card.count.text()
    (legs,) = [each for each in panel.view.drawn() if isinstance(each, PenStroke) and each.pattern == "dash"]
    assert len(legs.points) == pieces + 1


def test_asked_first_what_becomes_of_a_piece_is_chosen_and_tried_again(qtbot):
    panel = opened(qtbot, curve_through((6, 6), (16, 40), (40, 40), (56, 8), spline="bezier"))
    session, run = panel.session, panel.session.run
    bar = Steps(run)
    qtbot.addWidget(bar)
    bar.show()
    session.update_state(subject=Subject("curve", entry="flatten_bezier"), ask_first=True)
    settle()
    qtbot.waitUntil(lambda: run.entry.slug == "flatten_bezier" and run.done, timeout=5000)
    settle()

    def choose(text):
        button = next(button for button in bar.options.buttons if button.text() == text)
        qtbot.mouseClick(button, LEFT)
        settle()

    again, show = bar.bar.after_wrong
    assert [button.text() for button in bar.options.buttons] == ["Flat", "Divide"]
    choose("Flat")
    assert bar.sentence.plain.startswith("No: “flat” is not what comes next.")
    assert (run.position, run.right, run.wrong) == (0, 0, 1)
    qtbot.mouseClick(again, LEFT)
    choose("Divide")
    assert (run.position, run.right, run.wrong) == (1, 0, 1)
    choose("Flat" if run.steps[2].answer == "divide" else "Divide")
    qtbot.mouseClick(show, LEFT)
    assert (run.position, run.right, run.wrong) == (2, 0, 2)
    before = run.position
    qtbot.mouseClick(panel.canvas, LEFT, pos=panel.canvas.widget_position(30, 30).toPoint())
    settle()
    assert (run.position, run.right, run.wrong) == (before, 0, 2)
