"""Folders that cannot be had: the program starts with what it has, and says what is not kept and why."""

import errno
import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench import paths
from workbench.engine import kernel_files
from workbench.shell.settings import Settings
from workbench.shell.start import Building, make_window
from workbench.shell.warming import readiness

ROOT = Path(__file__).parents[2]
STRANGER = 4321


def said_after_the_start(qtbot: QtBot) -> str:
    """What stands in the message bar of a window that is wholly built."""
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    building.end()
    said = window.messages.text
    window.settings.set("calm", False)
    assert window.settings.get("calm") is False
    window.session.undo_stack.setClean()
    window.close()
    window.deleteLater()
    QApplication.processEvents()
    return said


def test_a_profile_that_is_a_file(qtbot: QtBot, profile: Path) -> None:
    profile.parent.mkdir(exist_ok=True)
    profile.write_text("not a folder")
    said = said_after_the_start(qtbot)
    assert f"{profile / 'settings' / 'settings.ini'} cannot be written (Not a directory)" in said
    assert "Your settings will be forgotten when you quit" in said
    assert f"Unsaved work is not kept, as {profile / 'recovery'} cannot be written (Not a directory)" in said
    assert profile.read_text() == "not a folder"


def test_settings_that_are_a_folder(qtbot: QtBot, profile: Path) -> None:
    (profile / "settings" / "settings.ini").mkdir(parents=True)
    said = said_after_the_start(qtbot)
    assert said.endswith("cannot be written (Is a directory): put that right and start again.")
    assert "Unsaved" not in said
    assert list((profile / "settings").iterdir()) == [profile / "settings" / "settings.ini"]


@pytest.mark.parametrize("linked", [False, True])
def test_settings_that_are_a_pipe_are_left_alone(profile: Path, tmp_path: Path, linked: bool) -> None:
    path = profile / "settings" / "settings.ini"
    path.parent.mkdir(parents=True)
    pipe = tmp_path / "pipe" if linked else path
    os.mkfifo(pipe)
    if linked:
        path.symlink_to(pipe)
    settings = Settings()
    assert settings.problem.endswith("(it is not a regular file): put that right and start again.")
    settings.set("calm", False)
    settings.write()
    assert settings.get("calm") is False
    assert pipe.is_fifo()
    assert path.is_symlink() == linked


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("folder", "settings.ini.lock is in the way"),
        ("pipe", "settings.ini.lock is in the way"),
        ("foreign", "another program holds settings.ini.lock"),
        ("large", "it has over 1,000,000 bytes"),
    ],
)
def test_settings_that_would_be_waited_for_are_only_remembered(
    qtbot: QtBot, profile: Path, kind: str, reason: str
) -> None:
    path = profile / "settings" / "settings.ini"
    path.parent.mkdir(parents=True)
    lock = path.with_name("settings.ini.lock")
    if kind == "folder":
        lock.mkdir()
    elif kind == "pipe":
        os.mkfifo(lock)
    elif kind == "foreign":
        lock.write_text("1\nanother\nelsewhere\n")
    else:
        with path.open("wb") as file:
            file.truncate(3 << 30)
    before = sorted(path.parent.iterdir())
    settings = Settings()
    assert f"({reason})" in settings.problem
    settings.set("calm", False)
    settings.write()
    assert settings.get("calm") is False
    assert sorted(path.parent.iterdir()) == before


def test_nothing_is_said_when_all_is_well(qtbot: QtBot, profile: Path) -> None:
    assert said_after_the_start(qtbot) == ""
    assert Settings().get("calm") is False
    assert (profile / "settings").stat().st_mode & 0o777 == 0o700


def test_a_disk_that_is_full(profile: Path) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
    try:
        settings = Settings()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert "(File too large)" in settings.problem
    assert list((profile / "settings").iterdir()) == []


def test_without_a_home_no_folder_is_made_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileNotFoundError):
        paths.make(Path("~/.config/graphics-workbench"))
    monkeypatch.setattr("workbench.shell.settings.settings_folder", lambda: Path("~/.config/gw"))
    settings = Settings()
    settings.set("calm", False)
    settings.write()
    assert "No such file or directory" in settings.problem
    assert list(tmp_path.iterdir()) == []
    assert paths.home_folder() == Path.home()


# A window as an ordinary user opens it: root may write everywhere, and so becomes somebody else, once what
# only root may be able to read has been imported and a window was built in a profile that works.
PROGRAM = f"""
import os, sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from workbench.shell.start import Building, make_window
application = QApplication(["workbench"])
def window_says():
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    building.built.connect(application.quit)
    window.show()
    application.exec()
    building.end()
    text = window.messages.text
    calm = window.settings.get("calm")
    window.settings.set("theme", "dark")
    window.session.undo_stack.setClean()
    window.close()
    return calm, text
window_says()
if os.geteuid() == 0:
    os.setgroups([])
    os.setgid({STRANGER})
    os.setuid({STRANGER})
for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"):
    os.environ.pop(name, None)
if sys.argv[1]:
    os.environ["GRAPHICS_WORKBENCH_PROFILE"] = sys.argv[1]
else:
    del os.environ["GRAPHICS_WORKBENCH_PROFILE"]
calm, text = window_says()
os.write(1, f"{{calm}}|{{text}}".encode())
"""


@pytest.fixture
def public() -> Iterator[Path]:
    """A folder that every user may enter."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        yield Path(folder)


def started(profile: str, cwd: Path) -> tuple[str, str]:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, profile],
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert not done.stderr
    calm, said = done.stdout.split("|")
    return calm, said


def test_settings_that_may_be_read_but_not_written_are_used(public: Path) -> None:
    settings = public / "settings"
    settings.mkdir(mode=0o755)
    (settings / "settings.ini").write_text("[General]\ncalm=false\n")
    (settings / "settings.ini").chmod(0o444)
    settings.chmod(0o555)
    public.chmod(0o555)
    calm, said = started(str(public), public)
    assert calm == "False"
    assert "settings.ini cannot be written (Permission denied)" in said
    assert "Unsaved work is not kept" in said
    assert (settings / "settings.ini").read_text() == "[General]\ncalm=false\n"
    public.chmod(0o755)
    settings.chmod(0o755)


def test_settings_that_may_not_be_read_are_left_alone(public: Path) -> None:
    settings = public / "settings"
    settings.mkdir()
    (settings / "settings.ini").write_text("[General]\ncalm=false\n")
    (settings / "settings.ini").chmod(0)
    if os.geteuid() == 0:
        os.chown(settings, STRANGER, STRANGER)
        os.chown(public, STRANGER, STRANGER)
    calm, said = started(str(public), public)
    assert calm == "True"
    assert said.endswith("cannot be written (Permission denied): put that right and start again.")
    (settings / "settings.ini").chmod(0o600)
    assert (settings / "settings.ini").read_text() == "[General]\ncalm=false\n"


@pytest.mark.skipif(os.geteuid() != 0, reason="a user with an account has a home, whatever HOME says")
def test_without_any_home_the_window_opens(public: Path) -> None:
    calm, said = started("", public)
    assert calm == "True"
    assert "Your settings will be forgotten" in said
    assert "Unsaved work is not kept" in said
    assert list(public.iterdir()) == []


def test_the_status_bar_says_where_compiled_readings_are_not_kept(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    reason = os.strerror(errno.ENOSPC)
    for room, words in (
        (kernel_files.Room(tmp_path), ""),
        (kernel_files.Room(tmp_path, reason), "Compiled algorithms are kept only until you quit."),
        (kernel_files.Room(None, reason), "Compiled algorithms cannot be kept: large pictures take longer."),
    ):
        monkeypatch.setattr(kernel_files, "_rooms", {paths.cache_folder(): room})
        text, why = readiness()
        assert text == words
        assert (reason in why and str(paths.cache_folder()) in why) == bool(words)
