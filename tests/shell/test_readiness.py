"""What the status bar says when the warming has ended."""

from pathlib import Path
from types import SimpleNamespace

from pytestqt.qtbot import QtBot

from workbench.shell.warming import Warming
from workbench.shell.window import MainWindow


def test_a_cache_that_others_may_write_is_said_in_the_status_bar(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch
) -> None:
    (tmp_path / "cache").mkdir()
    (tmp_path / "cache").chmod(0o777)
    monkeypatch.setenv("GRAPHICS_WORKBENCH_CACHE", str(tmp_path / "cache"))
    window.complete()
    monkeypatch.setattr(window, "workspace", lambda _slug: SimpleNamespace(topics=["none of them"]))
    warming = Warming(window)
    warming.prepare("draw")
    qtbot.waitUntil(lambda: "kept only until you quit" in window.status.ready.text(), timeout=30_000)
    assert window.status.ready.text() == "Compiled algorithms are kept only until you quit."
    why = window.status.ready.toolTip()
    assert f"{tmp_path / 'cache'} is not used (others may write there)" in why
    warming.stop()
