"""Once something else is done while a knot or weight is pulled in its plot, the hand changes nothing more."""

import pytest
from PySide6.QtCore import QPoint

from tests.panels.by_hand import LEFT, settle
from tests.panels.curves.by_hand import curve_through
from tests.panels.curves.docked import PLACES, with_docks
from workbench.document.edits import remove_figures

INTERRUPTIONS = {
    "undo": lambda session: session.undo_stack.undo(),
    "no curve": lambda session: session.apply(remove_figures([session.sheet.figures[0].id]), ""),
    "another picture": lambda session: session.open_example("curve-circle"),
    "no picture": lambda session: session.new(),
}


def pulled(qtbot, panel, plot, place, way, interrupt):
    """Pull, and go on after what interrupts; the document as that left it, and as it is in the end."""
    session = panel.session
    before = session.document
    qtbot.mousePress(plot, LEFT, pos=place)
    for part in (1, 2):
        qtbot.mouseMove(plot, place + part * way)
        settle()
    assert session.document != before
    interrupt(session)
    settle()
    after = session.document
    for part in (3, 40, -40):
        qtbot.mouseMove(plot, place + part * way)
        settle()
    assert session.document is after
    qtbot.mouseRelease(plot, LEFT, pos=place)
    settle()
    return after, session.document


@pytest.mark.parametrize("name", INTERRUPTIONS)
@pytest.mark.parametrize("what", ["weights", "knots"])
def test_what_is_pulled_in_a_plot_goes_no_farther_after_something_else(qtbot, name, what):
    panel = with_docks(qtbot, curve_through(*PLACES, spline="nurbs"))
    if what == "weights":
        plot, way = panel.beside.basis.weights, QPoint(0, -6)
        place = plot._bar(5).center().toPoint()
    else:
        plot, way = panel.beside.basis.knots, QPoint(6, 0)
        place = plot.places()[5].toPoint()
    after, in_the_end = pulled(qtbot, panel, plot, place, way, INTERRUPTIONS[name])
    assert in_the_end is after
    panel.session.open_example("curve-circle")
    settle()
    before = panel.session.document
    panel.commands.pull_weight(1, 3.0)  # the next pull is one of its own
    assert panel.session.document != before


def test_a_hand_that_holds_one_curve_pulls_no_other_that_is_chosen_meanwhile(qtbot):
    panel = with_docks(qtbot, *(curve_through(*PLACES[:n], spline="nurbs") for n in (4, 7)))
    session, basis = panel.session, panel.beside.basis
    short, long = (figure.id for figure in session.sheet.figures)
    session.update_state(selection=(short,), active=short)
    settle()
    basis.knot_dragged.emit("#4", 0.5)
    session.update_state(selection=(long,), active=long)
    settle()
    before = session.document
    assert panel.focus.curve.id == long
    basis.knot_dragged.emit("#9", 2.5)  # the short curve has no such knot
    basis.weight_dragged.emit(1, 3.0)
    assert session.document is before
    basis.knot_released.emit("")
    basis.knot_dragged.emit("#6", 2.5)
    assert session.sheet.figures[1].knots[6].u == 2.5
    assert session.sheet.figures[0] is before.sheets[0].figures[0]
