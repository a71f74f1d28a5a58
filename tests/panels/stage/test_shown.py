"""Canvases and tubes paint the sheet that is shown, which need not be the one that is edited."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.samples.examples import example
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.shared.tube_dock import TubeDock
from workbench.session.session import Session


@pytest.fixture
def session(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> Session:
    """Shows its sheet without the figure in front."""
    session = Session(document=example("slopes").document)
    sheet = session.sheet
    monkeypatch.setattr(Session, "shown", replace(sheet, figures=sheet.figures[:-1]))
    session.update_state(active=sheet.figures[-1].id)
    yield session
    session.close()
    session.deleteLater()


def inked(pixels: np.ndarray, background: int) -> int:
    return int((pixels != background).sum())


@pytest.mark.parametrize("kind", [DrawPanel, FillPanel, ClipPanel, CurvesPanel])
def test_a_canvas_paints_what_is_shown(session: Session, qtbot: QtBot, kind: type[QWidget]) -> None:
    panel = kind(session)  # type: ignore[call-arg]
    keep_until_the_end(qtbot, panel)
    panel.show()
    qtbot.waitUntil(lambda: session.run.done, timeout=10_000)
    session.run.go(5)
    QApplication.processEvents()
    short = inked(panel.canvas.picture.pixels, panel.canvas.picture.background)
    paper = panel.view.on_paper()
    whole = inked(paper.pixels, paper.background)
    assert session.shown_figure is None
    assert session.active_figure is session.sheet.figures[-1]
    type(session).shown = session.sheet
    session.update_state(step=0)
    session.flush()
    panel.refresh()
    assert 0 < short < inked(panel.canvas.picture.pixels, panel.canvas.picture.background)
    assert short < whole


def test_a_tube_glows_with_what_is_shown(
    session: Session, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    tube = TubeDock(session)
    qtbot.addWidget(tube)
    images = []
    monkeypatch.setattr(tube.raster, "set_image", images.append)
    tube.show()
    QApplication.processEvents()
    type(session).shown = session.sheet
    tube.feed.feed()
    short, whole = images[0], images[-1]
    paper = int(short[0, 0])
    assert 0 < inked(short, paper) < inked(whole, paper)
