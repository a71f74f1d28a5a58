"""A panel with the bouncing ball."""

from collections.abc import Iterator

import pytest

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.panels.animate.panel import AnimatePanel
from workbench.session.session import Session


@pytest.fixture
def panel(qtbot) -> Iterator[AnimatePanel]:
    session = Session()
    session.open_example("animate-ball")
    panel = AnimatePanel(session)
    keep_until_the_end(qtbot, panel)
    qtbot.addWidget(panel.between)
    panel.resize(960, 620)
    panel.between.show()
    panel.show()
    panel.activateWindow()
    settle()
    yield panel
    session.frames.stop()
    session.close()
