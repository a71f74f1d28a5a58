"""The plot of the stack on a run too long to be recorded whole: steps and depths are those of the run."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.algorithms import catalogue
from workbench.document.samples.examples import blank_sheet
from workbench.engine.observation import Steps
from workbench.engine.pending import Depths
from workbench.engine.recorder import record
from workbench.panels.fill.panel import FillPanel
from workbench.session.session import Session

SIDE, SEED = 24, 12


def depths_of(slug):
    """Those of the whole run, recorded at once."""
    entry = catalogue.get(slug)
    picture = np.zeros((SIDE, SIDE), np.int64)
    steps = Steps(entry, record(entry.function, picture, SEED, SEED, 1, 2))
    depths = Depths(steps)
    while depths.advance(1000):
        pass
    return depths.values


@pytest.fixture
def panel(qtbot):
    session = Session(document=blank_sheet(SIDE, SIDE))
    session.run.limit = 2500
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(700, 500)
    panel.show()
    panel.choose_tool("seed")
    panel.tool.algorithm = "boundary_fill_4"
    panel.tool.press(float(SEED), float(SEED), Qt.KeyboardModifier.NoModifier, 1.0)
    panel.tool.release(float(SEED), float(SEED))
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=30000)
    panel.plot.setParent(None)
    qtbot.addWidget(panel.plot)
    panel.plot.resize(500, 240)
    return panel


def count_to_the_end(qtbot, panel):
    panel.plot.show()
    run = panel.session.run
    qtbot.waitUntil(lambda: run.done and len(panel.plot.depths) == len(run.steps) + 1, timeout=30000)
    qtbot.waitUntil(lambda: panel.plot._plot is not None, timeout=30000)
    settle()


def test_steps_and_depths_are_those_of_the_whole_run(qtbot, panel):
    run, plot, true = panel.session.run, panel.plot, depths_of("boundary_fill_4")
    assert run.in_stretches
    count_to_the_end(qtbot, panel)
    assert "so far, from step 0 to" in plot.caption.text()
    assert panel.card.heat.text() == "Tests of each pixel"
    run.go_to_number(1600)
    count_to_the_end(qtbot, panel)
    assert 0 < run.passed < 1600 == run.number
    assert plot.begin_at == run.passed
    assert panel.card.heat.text() == f"Tests after step {run.passed:,}"
    end = run.passed + len(run.steps)
    assert plot.depths.tolist() == true[run.passed : end + 1].tolist()
    first = run.passed + int(np.argmax(true[run.passed : end + 1]))
    assert plot.caption.text() == (
        f"{true[1600]:,} on the stack. Counted so far, from step {run.passed:,} to {end:,}: at most "
        f"{true[first]:,}, first after step {first:,}."
    )
    assert plot.reach == (run.passed, end)
    assert plot.numbers().rows[0] == (str(run.passed), str(true[run.passed]))
    assert plot._curve.getData()[0][0] == run.passed
    assert plot._cursor_x == 1600
    plot.step_wanted.emit(end - 5)
    assert run.number == end - 5


def test_what_is_not_counted_yet_is_not_told_of_the_step(qtbot, panel, monkeypatch):
    run, plot, true = panel.session.run, panel.plot, depths_of("boundary_fill_4")
    monkeypatch.setattr(panel.view._slices, "start", lambda: None)  # the counting goes no further by itself
    plot.show()
    settle()
    panel.view._look_on()
    known = len(plot.depths)
    run.go(run.last_position - 1)  # the very last is cut
    panel.refresh()
    assert known < run.position
    assert plot.caption.text().startswith(
        f"{true[run.position]:,} on the stack. Counted so far, from step 0 to "
    )
