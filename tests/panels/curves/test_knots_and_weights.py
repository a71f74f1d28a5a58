"""Knots and weights are dragged, removed and refused in words."""

import numpy as np

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    curve_through,
    opened,
    places,
    the_curve,
)
from tests.panels.curves.docked import PLACES, with_docks
from workbench.document.curves.settings import set_spline
from workbench.panels.curves.basis import knot_names


def test_a_knot_is_dragged_and_the_knots_become_free(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    before = panel.session.undo_stack.count()
    panel.beside.basis.knot_dragged.emit("#5", 2.5)
    freed = the_curve(panel).knots[5].id
    panel.beside.basis.knot_dragged.emit(freed, 2.75)  # the plot has the free knots by now
    panel.beside.basis.knot_dragged.emit(freed, 2.75)
    panel.beside.basis.knot_released.emit(freed)
    settle()
    curve = the_curve(panel)
    assert curve.knot_rule == "free"
    assert curve.knots[5].u == 2.75
    assert panel.session.undo_stack.count() == before + 1
    panel.session.undo_stack.undo()
    assert the_curve(panel).knot_rule == "open_uniform"


def test_a_knot_that_went_while_it_was_held_is_pulled_no_further(qtbot):
    """By an undo or a redo, before the first move or after it."""
    panel = with_docks(qtbot, curve_through(*PLACES))
    basis, steps = panel.beside.basis, panel.session.undo_stack
    before = the_curve(panel)
    basis.knot_dragged.emit(f"#{len(knot_names(before))}", 2.5)
    assert the_curve(panel) == before
    basis.knot_dragged.emit("#5", 2.5)
    freed = the_curve(panel).knots[5].id
    steps.undo()
    basis.knot_dragged.emit(freed, 2.75)
    basis.knot_dragged.emit("#5", 2.75)
    basis.knot_released.emit(freed)
    assert the_curve(panel) == before
    basis.knot_dragged.emit(freed, 2.75)
    assert the_curve(panel) == before


def test_a_knot_is_removed_where_the_curve_stays(qtbot):
    panel = opened(qtbot, curve_through(*PLACES[:5], spline="b_spline"))
    before = the_curve(panel)
    said = []
    panel.hover_text.connect(said.append)
    panel.beside.basis.knot_unwanted.emit("#4")
    assert the_curve(panel) == before
    assert "the curve would change by up to" in said[-1]
    panel.beside.basis.knot_wanted.emit(0.5)
    (new,) = [knot.id for knot in the_curve(panel).knots if knot.u == 0.5]
    panel.beside.basis.knot_unwanted.emit(new)
    assert len(the_curve(panel).points_world) == 5
    np.testing.assert_allclose(places(panel), [(p.x, p.y) for p in before.points_world], atol=1e-9)
    assert said[-1].startswith("The knot is gone")
    panel.session.undo_stack.undo()
    assert len(the_curve(panel).points_world) == 6


def test_the_knot_nearest_to_u_is_removed_by_a_command(qtbot):
    panel = opened(qtbot, curve_through(*PLACES[:5], spline="b_spline"))
    panel.beside.basis.knot_wanted.emit(0.5)
    panel.focus.set_u(0.26)
    panel.commands.remove_knot_at_u()
    assert 0.5 not in [knot.u for knot in the_curve(panel).knots]
    said = []
    panel.hover_text.connect(said.append)
    panel.session.apply(set_spline(the_curve(panel).id, "bezier"), "Change kind")
    panel.commands.remove_knot_at_u()
    assert said == ["Only a B-spline or NURBS curve has knots; convert the curve first."]


def test_a_knot_that_would_pass_its_neighbour_is_refused_in_words(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    said = []
    panel.hover_text.connect(said.append)
    panel.beside.basis.knot_dragged.emit("#5", 99.0)
    panel.beside.basis.knot_released.emit("#5")
    assert "knots" in said[-1]
    assert the_curve(panel).knot_rule == "open_uniform"
    assert not panel.session.undo_stack.canUndo()


def test_a_weight_is_dragged_as_one_step_of_undo(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, spline="nurbs"))
    for weight in (2.0, 3.0, 4.0):
        panel.beside.basis.weight_dragged.emit(1, weight)
    panel.beside.basis.weight_released.emit(1)
    settle()
    assert the_curve(panel).points_world[1].weight == 4.0
    panel.beside.basis.weight_dragged.emit(2, 5.0)
    panel.beside.basis.weight_released.emit(2)
    panel.session.undo_stack.undo()
    assert the_curve(panel).points_world[1].weight == 4.0
    panel.session.undo_stack.undo()
    assert the_curve(panel).points_world[1].weight == 1.0
