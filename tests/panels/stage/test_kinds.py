"""A workspace whose kind of figure the sheet lacks offers its example, until there is one."""

import pytest

from tests.panels.by_hand import LEFT, settle
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.transform.panel import TransformPanel
from workbench.session.session import Session

PANELS = {
    "draw": DrawPanel,
    "fill": FillPanel,
    "clip": ClipPanel,
    "transform": TransformPanel,
    "curves": CurvesPanel,
    "animate": AnimatePanel,
}


@pytest.mark.parametrize(
    ("slug", "of_a_line"),
    [
        ("draw", False),
        ("fill", True),
        ("clip", False),
        ("transform", False),
        ("curves", True),
        ("animate", True),
    ],
)
def test_what_is_missing_is_offered(qtbot, slug, of_a_line):
    session = Session(document=blank_sheet(64, 48))
    panel = PANELS[slug](session)
    qtbot.addWidget(panel.center)
    panel.center.resize(900, 600)
    panel.center.show()
    settle()
    assert panel.empty.isVisible()
    session.new(example_document())  # one line
    settle()
    assert panel.empty.isVisible() is of_a_line
    session.new(blank_sheet(64, 48))
    settle()
    qtbot.mouseClick(panel.empty.button, LEFT)
    settle()
    assert not panel.empty.isVisible()
    assert session.sheet.figures
    session.close()
