"""The program starts and finds its resources from a checkout, an editable install and a wheel."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.xdist_group("processes")

ROOT = Path(__file__).resolve().parents[2]
RESOURCES = {path.relative_to(ROOT).as_posix() for path in (ROOT / "resources").rglob("*") if path.is_file()}
ENTER = """
import runpy, site, sys
site.addsitedir(sys.argv[1])
sys.argv[:2] = ["workbench"]
runpy.run_module("workbench", run_name="__main__", alter_sys=True)
"""
WHERE = """
import site, sys
site.addsitedir(sys.argv[1])
import workbench
from workbench.paths import resource
print(workbench.__file__, resource("phosphors.toml"), resource("phosphors.toml").is_file(), sep="\\n")
"""


def run(*words: str | Path, folder: Path) -> subprocess.CompletedProcess[str]:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        [sys.executable, *map(str, words)],
        cwd=folder,
        env={**environment, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        timeout=180,
    )


def done(result: subprocess.CompletedProcess[str]) -> str:
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A wheel made from the source distribution, so that both are complete."""
    folder = tmp_path_factory.mktemp("built")
    done(run("-m", "build", "--no-isolation", "--outdir", folder, ROOT, folder=folder))
    return next(folder.glob("*.whl"))


@pytest.fixture(scope="module", params=["checkout", "editable", "wheel"])
def site(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder from which ``workbench`` can be imported once it is a site folder."""
    folder: Path = tmp_path_factory.mktemp(request.param)
    if request.param == "checkout":
        return ROOT
    pip = ["-m", "pip", "install", "--quiet", "--no-deps", "--no-compile", "--no-index", "--target", folder]
    if request.param == "editable":
        done(run(*pip, "--no-build-isolation", "--editable", ROOT, folder=folder))
    else:
        done(run(*pip, request.getfixturevalue("built"), folder=folder))
    return folder


def test_wheel_holds_every_resource(built: Path) -> None:
    with zipfile.ZipFile(built) as wheel:
        names = set(wheel.namelist())
    assert {f"workbench/{name}" for name in RESOURCES} <= names
    assert not [name for name in names if name.startswith("tests/")]


def test_resources_are_found(site: Path, tmp_path: Path) -> None:
    package, _, found = done(run("-P", "-c", WHERE, site, folder=tmp_path)).splitlines()
    assert found == "True"
    copied = (site / "workbench" / "__init__.py").exists()
    assert Path(package).is_relative_to(site if copied else ROOT)


def test_commands_work(site: Path, tmp_path: Path) -> None:
    assert "bresenham_line" in done(run("-P", "-c", ENTER, site, "list", folder=tmp_path))


def test_window_appears(site: Path, tmp_path: Path) -> None:
    result = run("-P", "-W", "error", "-c", ENTER, site, "--quit-after-first-frame", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")


def test_console_script(built: Path, tmp_path: Path) -> None:
    site = tmp_path / "site"
    done(
        run(
            "-m",
            "pip",
            "install",
            "--quiet",
            "--no-deps",
            "--no-index",
            "--target",
            site,
            built,
            folder=tmp_path,
        )
    )
    told = subprocess.run(
        [site / "bin" / "graphics-workbench", "--version"],
        env={**os.environ, "PYTHONPATH": str(site)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (told.returncode, told.stdout) == (0, "Graphics Workbench 0.1.0\n")
