"""The program in a real window: a screen of its own under Xvfb, with a window manager, keys by xdotool."""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbench.shell.workspaces import workspaces

ROOT = Path(__file__).resolve().parents[2]
MISSING = [program for program in ("Xvfb", "openbox", "xdotool") if not shutil.which(program)]
FEWEST_COLOURS = 8  # of a window with text in it; an empty one has one or two

pytestmark = pytest.mark.skipif(
    bool(MISSING) and not os.environ.get("CI"),
    reason=f"no real window here: {', '.join(MISSING)} not installed",
)


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    """The name of a fresh screen with a window manager on it."""
    assert not MISSING, f"a real window needs {', '.join(MISSING)}"
    told, tell = os.pipe()
    command = ["Xvfb", "-displayfd", str(tell), "-screen", "0", "1440x900x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=(tell,), stderr=subprocess.DEVNULL)
    os.close(tell)
    with open(told) as number:
        name = f":{number.readline().strip()}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    manager = subprocess.Popen(["openbox", "--sm-disable"], env={**os.environ, "DISPLAY": name}, **quiet)
    yield name
    for process in (manager, server):
        process.terminate()
        process.wait(timeout=10)


@pytest.fixture
def environment(screen: str, profile: Path, tmp_path: Path) -> dict[str, str]:
    """A person's environment on that screen, with a fresh profile."""
    kept = {name: value for name, value in os.environ.items() if name != "QT_QPA_PLATFORM"}
    tmp_path.chmod(0o700)
    ours = {"DISPLAY": screen, "XDG_RUNTIME_DIR": str(tmp_path), "PYTHONPATH": str(ROOT)}
    return {**kept, **ours, "GRAPHICS_WORKBENCH_PROFILE": str(profile)}


def test_every_workspace_appears(environment: dict[str, str]) -> None:
    script = Path(__file__).with_name("visit_workspaces.py")
    done = subprocess.run(
        [sys.executable, "-W", "error", script], env=environment, capture_output=True, text=True, timeout=120
    )
    assert done.stderr == ""
    assert done.returncode == 0
    visits = [line.split() for line in done.stdout.splitlines()]
    assert [place for place, *_ in visits] == ["home", *(workspace.slug for workspace in workspaces())]
    for place, shown, exposed, colours in visits:
        assert (shown, exposed) == (place, "True")
        assert int(colours) >= FEWEST_COLOURS, place


def test_first_frame_and_out(environment: dict[str, str]) -> None:
    command = [sys.executable, "-W", "error", "-m", "workbench", "--quit-after-first-frame"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_opened_and_left_by_keyboard(environment: dict[str, str]) -> None:
    command = [sys.executable, "-W", "error", "-m", "workbench"]
    program = subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True)
    try:
        for words in (
            "search --sync --onlyvisible --name Graphics windowactivate --sync",
            "sleep 1 key ctrl+comma sleep 1 key ctrl+q",
        ):
            subprocess.run(["xdotool", *words.split()], env=environment, check=True, timeout=60)
        said = program.communicate(timeout=60)[1]
    finally:
        program.kill()
    assert (program.returncode, said) == (0, "")


def test_a_letter_takes_up_a_tool(environment: dict[str, str]) -> None:
    script = Path(__file__).with_name("watch_tools.py")
    command = [sys.executable, "-W", "error", script]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    program = subprocess.Popen(command, env=environment, **pipes)
    try:
        tools = [program.stdout.readline().strip()]
        for letter in "lovep":
            words = ["xdotool", "search", "--sync", "--onlyvisible", "--name", "Graphics"]
            words += ["windowactivate", "--sync", "key", letter]
            subprocess.run(words, env=environment, check=True, timeout=60)
            tools.append(program.stdout.readline().strip())
        said = program.communicate(timeout=60)[1]
    finally:
        program.kill()
    assert (program.returncode, said) == (0, "")
    assert tools == ["select", "line", "circle", "select", "ellipse", "polyline"]
