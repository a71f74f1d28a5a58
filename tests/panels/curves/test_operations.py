"""Commands on curves by hand: bend, insert, split, join, degrees, mirror, align, convert, smooth; undo."""

import re

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent
from PySide6.QtGui import QKeySequence

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    SHIFT,
    ZIGZAG,
    click,
    curve_through,
    drag,
    opened,
    places,
    send,
    the_curve,
)
from workbench.algorithms.curves import distances, joints, piece_points
from workbench.document.curves.pieces import pieces_of
from workbench.document.model import SPLINES, Polyline
from workbench.panels.curves.menu import canvas_menu
from workbench.panels.curves.scene import point_at
from workbench.shell.actions import commands

SEVEN = ((26.0, 10.0), (28.0, 24.0), (36.0, 40.0), (44.0, 20.0), (50.0, 10.0), (56.0, 12.0), (60.0, 30.0))


def on_curve(curve, count=101):
    pieces = pieces_of(curve)
    return piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], count))


def farthest(curve, places):
    """How far the farthest of ``places`` is from the curve."""
    line = on_curve(curve, 4001)
    return max(float(np.hypot(*(line - place).T).min()) for place in places)


def sentences(panel):
    said = []
    panel.hover_text.connect(said.append)
    return said


def double_click(panel, x, y):
    click(panel, x, y)
    send(panel, QEvent.Type.MouseButtonDblClick, x, y)
    send(panel, QEvent.Type.MouseButtonRelease, x, y)


@pytest.mark.parametrize("spline", SPLINES)
def test_the_curve_itself_is_dragged_and_passes_under_the_pointer(qtbot, spline):
    panel = opened(qtbot, curve_through(*SEVEN, spline=spline))
    before = places(panel)
    x, y = point_at(panel.session.sheet, the_curve(panel), 0.43)
    drag(panel, (x, y), (x + 1, y + 2), (x + 2, y + 3))
    ways = np.array(places(panel)) - np.array(before)
    assert np.ptp(ways, axis=0).max() > 0.1
    away = np.hypot(*(on_curve(the_curve(panel), 3001) - (x + 2, y + 3)).T).min()
    assert away < 0.25
    panel.session.undo_stack.undo()
    assert places(panel) == before


@pytest.mark.parametrize("spline", ["bezier_path", "b_spline", "nurbs"])
def test_a_double_click_on_the_curve_inserts_a_point_and_leaves_it(qtbot, spline):
    panel = opened(qtbot, curve_through(*SEVEN, spline=spline))
    before, count = on_curve(the_curve(panel)), len(places(panel))
    steps = panel.session.undo_stack.count()
    double_click(panel, *point_at(panel.session.sheet, the_curve(panel), 0.3))
    assert len(places(panel)) > count
    assert farthest(the_curve(panel), before) < 0.02
    assert panel.session.undo_stack.count() == steps + 1
    assert panel.focus.points


def test_a_double_click_beside_the_curve_inserts_nothing(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    double_click(panel, 30, 2)
    assert len(places(panel)) == 7


def test_split_and_join_give_the_same_curve(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    before = on_curve(the_curve(panel))
    panel.focus.set_u(0.4)
    panel.commands.split()
    assert len(panel.session.sheet.figures) == 2
    assert len(panel.session.state.selection) == 2
    panel.commands.join()
    settle()
    assert farthest(the_curve(panel), before) < 0.05
    panel.session.undo_stack.undo()
    panel.session.undo_stack.undo()
    assert len(places(panel)) == 7


def test_one_curve_alone_cannot_be_joined_and_that_is_said(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    said = sentences(panel)
    panel.commands.join()
    assert any("two curves" in text for text in said)


def test_a_raised_degree_leaves_the_curve_and_a_lowered_one_tells_its_error(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline="bezier"))
    before = on_curve(the_curve(panel))
    panel.commands.raise_degree()
    assert on_curve(the_curve(panel)) == pytest.approx(before)
    assert len(places(panel)) == 6
    said = sentences(panel)
    panel.commands.lower_degree()
    assert any("changed by" in text for text in said)
    assert on_curve(the_curve(panel)) == pytest.approx(before, abs=1e-6)


def test_mirrored_twice_is_as_before(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    panel.boxing.flip("x")
    assert places(panel) != list(SEVEN)
    panel.boxing.flip("x")
    assert places(panel) == pytest.approx(np.array(SEVEN))


def test_chosen_points_are_aligned(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    said = sentences(panel)
    panel.commands.align("left")
    assert said[-1] == "Choose 2 points of the curve first."
    panel.commands.joint("smooth")
    assert said[-1] == "Choose a point of the curve first."
    click(panel, *ZIGZAG[1])
    click(panel, *ZIGZAG[3], SHIFT)
    panel.commands.align("left")
    assert (places(panel)[1][0], places(panel)[3][0]) == (32, 32)


@pytest.mark.parametrize("spline", ["b_spline", "catmull_rom", "natural_cubic"])
def test_a_conversion_looks_the_same_and_says_so(qtbot, spline):
    panel = opened(qtbot, curve_through(*SEVEN, spline=spline))
    before = on_curve(the_curve(panel))
    said = sentences(panel)
    panel.commands.convert("bezier_path")
    assert the_curve(panel).spline == "bezier_path"
    assert farthest(the_curve(panel), before) < 0.05
    assert any("exactly" in text for text in said)


@pytest.mark.parametrize("spline", ["bezier_path", "catmull_rom", "natural_cubic", "nurbs"])
def test_what_a_hermite_spline_cannot_follow_is_said_and_never_less(qtbot, spline):
    """A Hermite spline has one tangent at each point, whatever tolerance is asked for."""
    panel = opened(qtbot, curve_through(*SEVEN, spline=spline))
    before = on_curve(the_curve(panel))
    said = sentences(panel)
    panel.commands.convert("hermite")
    away = distances(pieces_of(the_curve(panel)), before).max()
    if away > 1e-6:
        (told,) = re.findall(r"changed by ([\d.]+) at most", said[-1])
        assert away <= float(told)
    else:
        assert "exactly" in said[-1]
    assert (away > 0.2) == (spline in ("bezier_path", "catmull_rom"))


@pytest.mark.parametrize("spline", ["natural_cubic", "hermite", "bezier", "b_spline"])
def test_curves_that_are_joined_are_no_farther_off_than_is_said(qtbot, spline):
    """By their rule, or, of degree 4, as a path; a B-spline is joined exactly."""
    shape = np.array(((4, 8), (8, 30), (14, 12), (20, 34), (26, 8)), float)
    curves = [curve_through(*(shape + np.array([far, 0])).tolist(), spline=spline) for far in (0.0, 22.0)]
    curves[1] = replace(
        curves[1], points_world=tuple(replace(p, tangent_y=9) for p in curves[1].points_world)
    )
    panel = opened(qtbot, *curves)
    before = np.concatenate([on_curve(curve) for curve in panel.session.sheet.figures])
    panel.session.update_state(selection=tuple(curve.id for curve in panel.session.sheet.figures))
    said = sentences(panel)
    panel.commands.join()
    away = distances(pieces_of(the_curve(panel)), before).max()
    if spline == "b_spline":
        assert said[-1] == "The curves are now one, and look as before."
        assert away < 1e-9
        return
    (told,) = re.findall(r"changed by ([\d.]+) at most", said[-1])
    assert 1e-4 < away <= float(told)


@pytest.mark.parametrize("kind", ["G1", "C1", "C2"])
def test_a_joint_is_made_smooth_and_the_points_moved_are_named(qtbot, kind):
    panel = opened(qtbot, curve_through(*SEVEN, spline="bezier_path"))
    said = panel.commands.smooth([0], kind)
    (found,) = joints(pieces_of(the_curve(panel)))
    best = found.geometric if kind[0] == "G" else found.parametric
    assert best >= kind
    assert "H1" in said
    assert kind in panel.commands.smooth([0], kind)
    panel.session.undo_stack.undo()
    assert places(panel) == list(SEVEN)


def test_the_chosen_joints_are_made_smooth_and_an_end_is_none(qtbot):
    path = ((2, 2), (4, 12), (10, 14), (14, 8), (20, 4), (24, 6), (28, 12), (30, 18), (36, 20), (40, 16))
    panel = opened(qtbot, curve_through(*path, spline="bezier_path"))
    said, ids = sentences(panel), [point.id for point in the_curve(panel).points_world]
    panel.focus.choose([ids[9]])
    panel.commands.smooth_here("G1")
    assert said[-1] == "An end of the curve is not a joint; choose a point between two pieces."
    panel.focus.choose([ids[7]])  # a handle of the second joint
    panel.commands.smooth_here("G1")
    assert places(panel)[:5] == [*path[:5]]
    assert places(panel)[5:] != [*path[5:]]
    panel.session.undo_stack.undo()
    panel.focus.choose([ids[3], ids[6]])
    panel.commands.smooth_here("C1")
    assert [joint.parametric for joint in joints(pieces_of(the_curve(panel)))] == ["C1", "C1"]
    panel.session.undo_stack.undo()
    assert places(panel) == [*path]


def test_what_was_said_of_a_joint_goes_with_undo(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN, spline="bezier_path"))
    panel.beside.smoothing_wanted.emit(0, "C1")
    assert "H1" in panel.beside.continuity.words.text()
    panel.session.undo_stack.undo()
    panel.beside.refresh()
    assert "H1" not in panel.beside.continuity.words.text()


def test_the_button_of_the_table_smooths_and_says_what_moved(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN, spline="bezier_path"))
    panel.beside.smoothing_wanted.emit(0, "C1")
    assert "H1" in panel.beside.continuity.words.text()


def test_a_curve_becomes_a_polyline_within_its_tolerance(qtbot):
    panel = opened(qtbot, replace(curve_through(*SEVEN, spline="nurbs"), tolerance_px=0.25))
    before = on_curve(the_curve(panel), 2001)
    said = sentences(panel)
    panel.commands.flatten()
    (line,) = panel.session.sheet.figures
    assert isinstance(line, Polyline)
    corners = np.array([(p.x, p.y) for p in line.points_world])
    start, along = corners[:-1], np.diff(corners, axis=0)
    share = np.clip(((before[:, None] - start) * along).sum(-1) / (along**2).sum(-1), 0, 1)
    away = np.hypot(*np.moveaxis(before[:, None] - start - share[..., None] * along, -1, 0)).min(axis=1)
    assert away.max() <= 0.25
    assert any("0.25 px" in text for text in said)
    panel.session.undo_stack.undo()
    assert places(panel) == list(SEVEN)


@pytest.mark.parametrize(("spline", "around"), [("natural_cubic", False), ("periodic_cubic", True)])
def test_a_polyline_goes_round_where_the_curve_does(qtbot, spline, around):
    panel = opened(qtbot, curve_through(*SEVEN, spline=spline, closed=not around))
    ends = on_curve(the_curve(panel))[[0, -1]]
    panel.commands.flatten()
    (line,) = panel.session.sheet.figures
    assert line.closed == around
    corners = np.array([(p.x, p.y) for p in line.points_world])
    assert corners[0] == pytest.approx(ends[0])
    assert (np.hypot(*(corners[-1] - ends[1])) > 0.1) == around


def test_reversed_it_runs_the_other_way(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    before = on_curve(the_curve(panel))
    panel.commands.reverse()
    assert on_curve(the_curve(panel)) == pytest.approx(before[::-1])


def test_closed_and_opened_again(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    panel.commands.toggle_closed()
    assert the_curve(panel).closed
    panel.commands.toggle_closed()
    assert not the_curve(panel).closed


def test_the_menu_has_every_command_of_curves_once(qtbot):
    panel = opened(qtbot, curve_through(*SEVEN))
    menu = canvas_menu(panel._actions, panel.canvas)
    listed = []
    for action in menu.actions():
        listed += action.menu().actions() if action.menu() is not None else [action]
    names = [action.objectName() for action in listed if not action.isSeparator()]
    assert len(names) == len(set(names))
    wanted = {f"curves.{row[0]}" for row in (*panel.commands.rows(), *panel.exchange.rows())}
    assert wanted <= set(names)


def test_a_command_without_a_curve_says_what_to_do(qtbot):
    panel = opened(qtbot)
    said = sentences(panel)
    for row in panel.commands.rows():
        said.clear()
        row[4]()
        assert said, row[0]
    assert panel.session.sheet.figures == ()


def test_what_a_path_cannot_be_is_said_and_nothing_is_lost(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG[:2], spline="natural_cubic"))
    before = the_curve(panel)
    click(panel, *ZIGZAG[1])
    said = sentences(panel)
    panel.commands.joint("smooth")
    assert said == ["Only the points of a Bézier path have handles; convert the curve first."]
    assert the_curve(panel) == before


def test_no_key_of_the_panel_is_taken_twice_or_is_the_windows(qtbot):
    panel = opened(qtbot)
    keys = [action.shortcut().toString() for action in panel.actions() if not action.shortcut().isEmpty()]
    assert len(keys) == len(set(keys))
    windows = {QKeySequence(key).toString() for command in commands() for key in command.keys}
    assert not windows.intersection(keys)
