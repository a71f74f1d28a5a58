"""Saving behind the session's back: whatever happens there, its end is told and the next save works."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document import Stored, read
from workbench.document.samples.examples import example_document
from workbench.session import saver
from workbench.session.saver import Saved, Saver


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_failure_of_the_program_is_told_too(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saves: list[Saved] = []
    one = Saver()
    one.saved.connect(saves.append)
    stored = Stored(example_document())
    with monkeypatch.context() as patch:

        def fail(*_args: object) -> None:
            raise KeyError("no such thing")

        patch.setattr(saver, "write", fail)
        one.start(stored, tmp_path / "a.gwb")
        qtbot.waitUntil(lambda: not one.busy)
    one.start(stored, tmp_path / "a.gwb")
    one.wait()
    assert [bool(save.problem) for save in saves] == [True, False]
    assert read(tmp_path / "a.gwb") == stored
