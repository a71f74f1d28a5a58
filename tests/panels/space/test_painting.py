"""What is painted with each picture of a scene, and what is not."""

import pytest
from msgspec.structs import replace
from PySide6.QtGui import QRegion
from PySide6.QtWidgets import QMainWindow
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example
from workbench.document.scene.looking import orbited
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.projection_page import ProjectionPage
from workbench.session.session import Session


@pytest.mark.parametrize("dressed", [False, True])
def test_an_opaque_card_over_the_picture_is_not_painted_with_it(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, dressed: bool
) -> None:
    """Its fields take longer than the picture; through a clear one, or beside its corners, that is seen."""
    window = QMainWindow()
    qtbot.addWidget(window)
    panel = SpacePanel(Session(document=example("space-house").document))
    window.setCentralWidget(panel)
    if dressed:
        window.setStyleSheet("#card { background: #fff; border-radius: 4px; }")
    window.resize(1100, 700)
    window.show()
    page = panel.page_of("space")
    assert isinstance(page, ProjectionPage)
    eye, card = page.eye, page.card
    around = card.geometry()
    painted: list[QRegion] = []

    def shown_anew() -> QRegion:
        with monkeypatch.context() as watch:
            watch.setattr(eye, "update", lambda *region: painted.extend(region))
            eye.show_scene(replace(eye.scene, camera=orbited(eye.scene.camera, 0.3, 0.1)))
        return painted[-1]

    region = shown_anew()
    assert region.contains(around.center()) is not dressed
    for seen in (around.topLeft(), around.bottomRight(), eye.rect().center(), eye.rect().bottomRight()):
        assert region.contains(seen)
    card.hide()
    assert shown_anew().contains(around.center())
