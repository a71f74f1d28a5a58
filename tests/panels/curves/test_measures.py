"""What is measured of a curve: joints, the comb."""

import pytest
from PySide6.QtWidgets import QLabel

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    curve_through,
    the_curve,
)
from tests.panels.curves.docked import PLACES, with_docks
from workbench.document.curves.pieces import pieces_of
from workbench.panels.curves.compare import MEASURED_DEGREE
from workbench.panels.curves.docks import measures_of
from workbench.panels.curves.scene import point_at
from workbench.widgets.canvas.drawing import PenStroke


def test_a_double_click_on_a_joint_goes_there(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, spline="bezier_path"))
    table = panel.beside.continuity
    assert len(table.model.joints) == 1
    table.joint_activated.emit(0)
    settle()
    assert panel.focus.u == pytest.approx(0.5)
    at = point_at(panel.session.sheet, the_curve(panel), panel.focus.u)
    assert at == pytest.approx(PLACES[3])


def test_the_measures_are_those_of_the_curve(qtbot):
    panel = with_docks(qtbot, curve_through((20.0, 10.0), (50.0, 10.0), spline="bezier"))
    assert "30 px" in panel.beside.insight.words.text()


def test_measures_have_true_minus_signs() -> None:
    """Below the sheet, turning to the right."""
    curve = curve_through((-20.0, -10.0), (0.0, -2.0), (20.0, -10.0), spline="bezier")
    told = dict(measures_of(pieces_of(curve), 0.5))
    assert told["at u = 0.5"] == "(0, −6)"
    assert told["curvature"].startswith("−0.02 1/px, radius 50 px")
    assert told["box"] == "(−20, −10) – (20, −6)"


def test_the_comb_has_teeth_on_every_piece():
    from workbench.panels.curves.marks import COMB_TEETH, comb

    pieces = pieces_of(curve_through(*PLACES, spline="catmull_rom"))
    strokes = [each for each in comb(pieces, 80.0) if isinstance(each, PenStroke)]
    assert len(strokes) == 2 * (len(PLACES) - 1)
    assert len(strokes[0].points) >= 3 * COMB_TEETH


def test_a_curve_of_a_high_degree_is_not_measured(qtbot):
    places = [(float(7 * k % 61), float(5 * k % 43)) for k in range(MEASURED_DEGREE + 2)]
    for count, measured in ((MEASURED_DEGREE + 1, True), (MEASURED_DEGREE + 2, False)):
        panel = with_docks(qtbot, curve_through(*places[:count], spline="bezier", beside=("natural_cubic",)))
        bezier, other = panel.beside.measured.model.kinds
        assert bezier.values[-1] == str(count - 1)
        assert (None not in bezier.values[:3]) == measured
        assert None not in other.values[:3]
        said = [label.text() for label in panel.beside.insight.findChildren(QLabel)]
        assert any("not measured" in text for text in said) != measured
