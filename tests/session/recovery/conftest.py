"""A session that keeps its unsaved work in a folder of the test."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.session import Session


@pytest.fixture
def session(qtbot: QtBot, tmp_path: Path) -> Session:
    session = Session(document=example_document())
    session.start_autosave(tmp_path)
    yield session
    session.close()
    session.deleteLater()
