"""The family tree of projections: what is said of the matrix beside it."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.scene.model import Camera
from workbench.panels.space import family_dock


def test_numbers_have_true_minus_signs_and_words_keep_their_hyphens(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_matrices: object) -> None:
        raise ValueError("No one-point perspective has z = -2.")

    monkeypatch.setattr(family_dock, "classify", refuse)
    dock = family_dock.FamilyDock()
    qtbot.addWidget(dock)
    dock.show_camera(Camera(), "one-point")
    assert dock.words.text() == "No one-point perspective has z = −2."
