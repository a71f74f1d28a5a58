"""Several kinds of curve over the same points are compared."""

import pytest
from msgspec.structs import replace

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    curve_through,
    the_curve,
)
from tests.panels.curves.docked import PLACES, with_docks
from workbench.widgets.canvas.drawing import PenStroke


def test_the_same_points_through_several_kinds_are_compared(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    table = panel.beside.measured.model
    names = [kind.name for kind in table.kinds]
    assert names[0] == "B-spline"
    assert {"Natural cubic spline", "Catmull-Rom spline", "Bézier curve"} <= set(names)
    passes = {kind.name: kind.values[0] for kind in table.kinds}
    assert passes["Natural cubic spline"] is True
    assert passes["B-spline"] is False
    panel.beside.measured.kind_activated.emit(names.index("Catmull-Rom spline"))
    settle()
    assert the_curve(panel).beside == ("catmull_rom",)
    qtbot.waitUntil(lambda: not panel.beside.comparing)
    assert [kind.name for kind in table.kinds] == ["B-spline", "Catmull-Rom spline"]


def compared(qtbot, curve):
    """The values of each kind in the table of a curve, by the name of the kind and of the measure."""
    table = with_docks(qtbot, curve).beside.measured.model
    names = [measure.name for measure in table.measures]
    return {kind.name: dict(zip(names, kind.values, strict=True)) for kind in table.kinds}


@pytest.mark.parametrize("spline", ["cardinal", "catmull_rom", "kochanek_bartels"])
def test_ends_that_only_steer_are_not_passed(qtbot, spline):
    curve = curve_through(*PLACES, spline=spline, beside=("hermite",), ends="inner")
    own, other = compared(qtbot, curve).values()
    assert (own["through the points"], other["through the points"]) == (False, True)
    assert own["farthest point"] > 1
    around, _other = compared(qtbot, replace(curve, closed=True)).values()
    assert around["through the points"] is True


def test_kinds_with_two_ends_have_no_joint_between_these(qtbot):
    """A kind that cannot go round is measured as it is drawn, whatever is asked of the others."""
    beside = ("clamped_cubic", "periodic_cubic", "catmull_rom")
    curve = curve_through(*PLACES, spline="natural_cubic", beside=beside, closed=True)
    smooth = {name: values["smoothness"] for name, values in compared(qtbot, curve).items()}
    assert smooth == {
        "Natural cubic spline": "C2, G2",
        "Clamped cubic spline": "C2, G2",
        "Periodic cubic spline": "C2, G2",
        "Catmull-Rom spline": "C1, G1",
    }
    table = with_docks(qtbot, curve).beside.continuity
    assert len(table.model.joints) == len(PLACES) - 2
    periodic = with_docks(qtbot, replace(curve, spline="periodic_cubic", closed=False))
    assert len(periodic.beside.continuity.model.joints) == len(PLACES)


def test_kinds_in_the_table_have_the_lines_of_the_canvas(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, beside=("nurbs", "cardinal")))
    drawn = {(stroke.ink, stroke.pattern) for stroke in panel.view.drawn() if isinstance(stroke, PenStroke)}
    shown = [(kind.ink, kind.pattern) for kind in panel.beside.measured.model.kinds]
    assert len(shown) == 3
    assert set(shown) <= drawn


def test_what_is_not_compared_says_why(qtbot):
    many = [(float(k % 60), float(k % 7)) for k in range(201)]
    for drawn, said in (
        ([], "Select a curve"),
        ([curve_through(*many)], "more than 200 points"),
        ([curve_through((1.0, 1.0))], "4 are needed"),
    ):
        table = with_docks(qtbot, *drawn).beside.measured
        assert table.state.empty
        assert said in table.state.sentence.text()
    assert not with_docks(qtbot, curve_through(*many[:200])).beside.measured.state.empty
