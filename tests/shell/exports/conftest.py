"""The whole program with a picture that is saved and a run that is recorded."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.shell.exports.exporting import recorded
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[MainWindow]:
    """The whole program, with a line in Draw whose run is recorded, saved as work.gwb."""
    from workbench.session.session import Session

    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    made = make_window(Settings())
    made.resize(1280, 680)
    made.show()
    made.attach(Session(made))
    qtbot.waitExposed(made)
    made.open_example("line")
    made.session.save_as(tmp_path / "work.gwb")
    recorded(qtbot, made)
    yield made
    made.session.undo_stack.setClean()
    made.close()
    made.deleteLater()
