"""run.py finds the libraries of the system that are missing, and says how to get them."""

import os
import runpy
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.packaging.checkout import ROOT, linux_only

pytestmark = pytest.mark.xdist_group("processes")


@pytest.fixture
def script() -> dict[str, Any]:
    return runpy.run_path(str(ROOT / "run.py"))


def offscreen_plugin() -> Path:
    import PySide6

    return Path(PySide6.__file__).parent / "Qt" / "plugins" / "platforms" / "libqoffscreen.so"


@linux_only
def test_missing_libraries_are_found_by_loading(tmp_path: Path) -> None:
    # Away from its folder the plugin no longer finds Qt's own libraries; here they may be loaded already.
    alone = shutil.copy(offscreen_plugin(), tmp_path)
    look = f"import runpy, sys; print(*runpy.run_path({str(ROOT / 'run.py')!r})['lacking'](sys.argv[1]))"
    found = [
        subprocess.run(
            [sys.executable, "-c", look, plugin], capture_output=True, text=True, check=True
        ).stdout
        for plugin in (offscreen_plugin(), alone)
    ]
    assert found[0] == "\n"
    assert {"libQt6Core.so.6", "libQt6Gui.so.6"} <= set(found[1].split())


APT_CACHE = """#!/bin/sh
for known in libxcb-icccm4 libxkbcommon-x11-0 libegl1 libdbus-1-3 libglib2.0-0t64 libgssapi-krb5-2; do
  [ "$2" = "$known" ] && printf '%s:\\n  Installed: (none)\\n  Candidate: 1.0\\n' "$2"
done
[ "$2" = libgthread2.0-0 ] && printf '%s:\\n  Installed: (none)\\n  Candidate: (none)\\n' "$2"
exit 0
"""

APT_GET = """#!/bin/sh
echo "$@" >> "$APT_LOG"
"""


@pytest.fixture
def apt(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An apt that knows a few packages and writes down what it is asked to install."""
    for name, text in (("apt-cache", APT_CACHE), ("apt-get", APT_GET)):
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    monkeypatch.setenv("APT_LOG", str(tmp_path / "log"))
    return tmp_path / "log"


@linux_only
@pytest.mark.usefixtures("apt")
@pytest.mark.parametrize(
    ("library", "package"),
    [
        ("libxcb-icccm.so.4", "libxcb-icccm4"),
        ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
        ("libEGL.so.1", "libegl1"),
        ("libdbus-1.so.3", "libdbus-1-3"),
        ("libglib-2.0.so.0", "libglib2.0-0t64"),
        ("libgssapi_krb5.so.2", "libgssapi-krb5-2"),
        ("libgthread-2.0.so.0", ""),
    ],
)
def test_package_of_a_library(script: dict[str, Any], library: str, package: str) -> None:
    assert script["debian_package"](library) == package


def provide(script: dict[str, Any], root: bool, *missing: list[str]) -> None:
    """Let run.py provide libraries when each look at the plugin finds the next of ``missing``."""
    looks = iter([*missing, []])
    names = script["provide_libraries"].__globals__
    names["lacking"] = lambda plugin: next(looks)
    names["os"] = type("System", (), {"geteuid": lambda: 0 if root else 1000, "environ": os.environ})
    names["provide_libraries"](Path("plugin.so"))


@linux_only
def test_root_installs_until_nothing_is_missing(script: dict[str, Any], apt: Path) -> None:
    provide(script, True, ["libxcb-icccm.so.4", "libglib-2.0.so.0", "libgthread-2.0.so.0"], ["libEGL.so.1"])
    update, first, second = apt.read_text().splitlines()
    assert update == "update -qq"
    assert first.endswith("--no-install-recommends libglib2.0-0t64 libxcb-icccm4")
    assert second.endswith("--no-install-recommends libegl1")


@linux_only
def test_others_are_told_the_one_command(script: dict[str, Any], apt: Path) -> None:
    with pytest.raises(script["SetUpError"]) as told:
        provide(script, False, ["libxcb-icccm.so.4", "libEGL.so.1"])
    command = "sudo apt-get install -y --no-install-recommends libegl1 libxcb-icccm4"
    assert str(told.value).endswith(command)
    assert not apt.exists()


@linux_only
@pytest.mark.usefixtures("apt")
def test_a_library_that_stays_missing_ends_it(script: dict[str, Any]) -> None:
    with pytest.raises(script["SetUpError"], match=r"libgthread-2\.0\.so\.0"):
        provide(script, True, ["libgthread-2.0.so.0"], ["libgthread-2.0.so.0"])


@linux_only
@pytest.mark.parametrize(
    ("command", "display", "platform"),
    [
        ("list", {}, ""),
        ("trace", {}, ""),
        ("draw", {}, ""),
        ("tour", {}, "offscreen"),
        ("test", {"DISPLAY": ":0"}, "offscreen"),
        ("setup", {}, "offscreen"),
        ("", {"DISPLAY": ":0"}, "xcb"),
        ("", {"WAYLAND_DISPLAY": "wayland-0"}, "wayland"),
        ("picture.gwb", {"DISPLAY": ":0", "QT_QPA_PLATFORM": "wayland;xcb"}, "wayland"),
        ("", {"QT_QPA_PLATFORM": "offscreen:size=10x10"}, "offscreen"),
    ],
)
def test_platform_of_a_command(
    script: dict[str, Any],
    monkeypatch: pytest.MonkeyPatch,
    command: str,
    display: dict[str, str],
    platform: str,
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in display.items():
        monkeypatch.setenv(name, value)
    assert script["platform_of"](command) == platform
