"""run.py sets up once, says what it does, and passes everything on."""

import ast
import os
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

from tests.packaging.checkout import ROOT, linux_only

pytestmark = pytest.mark.xdist_group("processes")

PROJECT = """
[project]
dependencies = ["tiny{version}"]
[project.optional-dependencies]
test = []
[tool.graphics-workbench.download-megabytes]
program = 3
test = 4
"""

PROGRAM = """
import os, sys, tiny
print(tiny.__name__, sys.argv[1:], os.getcwd())
sys.exit(7 if "fail" in sys.argv else 0)
"""


def make_wheel(folder: Path, name: str, version: str) -> None:
    folder.mkdir(exist_ok=True)
    information = f"{name}-{version}.dist-info"
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as wheel:
        wheel.writestr(f"{name}.py", "")
        wheel.writestr(
            f"{information}/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n"
        )
        wheel.writestr(
            f"{information}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        )
        wheel.writestr(f"{information}/RECORD", "")


def make_house(folder: Path) -> Path:
    """A checkout with a space in its path, and the wheels beside it."""
    house = folder / "a house"
    (house / "workbench").mkdir(parents=True)
    (house / "workbench" / "__init__.py").touch()
    (house / "workbench" / "__main__.py").write_text(PROGRAM)
    (house / "pyproject.toml").write_text(PROJECT.format(version=""))
    shutil.copy(ROOT / "run.py", house)
    make_wheel(folder / "wheels", "tiny", "1.0")
    return house


def environment(**changes: str) -> dict[str, str]:
    unwanted = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "PYTHONPATH")
    return {**{name: value for name, value in os.environ.items() if name not in unwanted}, **changes}


def run(house: Path, *words: str, **changes: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, house / "run.py", *words],
        cwd=house.parent,
        env=environment(**changes),
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A house that has been set up from its wheels, with what was said meanwhile kept in ``said``."""
    house = make_house(tmp_path_factory.mktemp("set-up"))
    result = run(house, "setup", "--wheels", "wheels")
    assert result.returncode == 0, result.stdout + result.stderr
    (house / "said").write_text(result.stderr)
    return house


def said(result: subprocess.CompletedProcess[str]) -> str:
    """The one line on standard error."""
    assert result.stderr.count("\n") == 1, result.stderr
    return result.stderr


def test_an_older_python_can_read_it_and_is_told() -> None:
    source = (ROOT / "run.py").read_text(encoding="utf-8")
    ast.parse(source, feature_version=(3, 6))
    old = f"import sys; sys.version_info = (3, 10, 2); exec({source!r}, {{'__name__': '__main__'}})"
    told = subprocess.run([sys.executable, "-c", old], capture_output=True, text=True, timeout=30)
    assert told.returncode == 1
    assert "needs Python 3.11 or newer, and this is Python 3.10" in told.stderr


def test_without_ensurepip_it_says_what_to_install(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    code = "import runpy, sys; sys.modules['ensurepip'] = None; sys.argv = ['run.py', 'setup']; "
    code += f"runpy.run_path({str(house / 'run.py')!r}, run_name='__main__')"
    told = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=30, env=environment()
    )
    assert told.returncode == 1
    assert "lacks the modules venv and ensurepip" in said(told)
    assert f"python3.{sys.version_info[1]}-venv" in told.stderr


@linux_only
def test_without_a_display_it_says_so_before_it_installs(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    told = run(house)
    assert told.returncode == 1
    assert "no display" in said(told)
    assert "python3 run.py tour DIR" in told.stderr
    assert not (house / ".venv").exists()


def test_a_folder_without_wheels_is_refused(tmp_path: Path) -> None:
    told = run(make_house(tmp_path), "setup", "--wheels", str(tmp_path))
    assert told.returncode == 1
    assert "--wheels" in said(told)


def test_where_the_set_up_cannot_be_written_one_line_says_so(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    (house / ".venv").write_text("in the way")
    done = run(house, "setup", "--wheels", str(tmp_path / "wheels"))
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1
    assert f"{house / '.venv'} (File exists): copy this folder to where you may write" in done.stderr


def test_what_cannot_be_cleared_away_is_named_in_one_line(tmp_path: Path, house: Path) -> None:
    """A package that was left halfway and is no folder."""
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    packages = next((other / ".venv").glob("lib/python*/site-packages"))
    shutil.rmtree(packages / "tiny-1.0.dist-info")
    (packages / "tiny-1.0.dist-info").symlink_to(tmp_path / "wheels")
    next((other / ".venv").glob(".installed-*")).unlink()
    done = run(other, "setup", "--wheels", str(tmp_path / "wheels"))
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    assert "The set-up stopped at" in done.stderr


def test_help_needs_no_set_up(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    assert "python3 run.py test" in run(house, "--help").stdout
    assert not (house / ".venv").exists()


def test_set_up_says_where_from(house: Path) -> None:
    words = (house / "said").read_text()
    assert str(house.parent / "wheels") in words
    assert "set-up is complete" in words


def test_set_up_once_only(house: Path) -> None:
    again = run(house, "setup")
    assert (again.returncode, again.stdout, again.stderr) == (0, "", "")


def test_arguments_folder_and_status_are_passed_on(house: Path) -> None:
    told = run(house, "list", "two words")
    assert (told.returncode, told.stderr) == (0, "")
    assert told.stdout == f"tiny ['list', 'two words'] {house.parent}\n"
    assert run(house, "list", "fail").returncode == 7


def test_what_is_to_be_downloaded_is_said_first(house: Path, tmp_path: Path) -> None:
    """A dependency that is not to be had: the size is said before pip fails, and the failure after it."""
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    (other / "pyproject.toml").write_text(PROJECT.format(version=">=9"))
    told = run(other, "list", PIP_NO_INDEX="1")
    assert told.returncode == 1
    lines = told.stderr.splitlines()
    assert "at most about 3 MB to download" in lines[0]
    assert "could not be installed" in lines[-1]


def test_the_tests_add_only_their_own_packages(house: Path, tmp_path: Path) -> None:
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    told = run(other, "test", PIP_NO_INDEX="1")
    assert "Installing 0 packages" in told.stderr
    assert "at most about 4 MB to download" in told.stderr
    assert "No module named pytest" in told.stderr
    assert run(other, "setup").stderr == ""


def test_the_tests_run_on_all_cores_unless_something_else_is_asked_for(house: Path, tmp_path: Path) -> None:
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    run(other, "test")
    (other / "pytest.py").write_text("import sys\nprint(*sys.argv[1:])\n")
    words = run(other, "test", "tests/engine", "-n", "0").stdout.split()
    assert words[words.index("--dist") + 1] == "loadgroup"
    assert words[:2] == ["-n", "auto"]
    assert words[-3:] == ["tests/engine", "-n", "0"]


def test_changed_requirements_are_installed(tmp_path: Path, house: Path) -> None:
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    make_wheel(tmp_path / "wheels", "tiny", "2.0")
    (other / "pyproject.toml").write_text(PROJECT.format(version=">=2"))
    told = run(other, "list", "--wheels", str(tmp_path / "wheels"))
    assert told.returncode == 0
    assert "tiny-2.0" in told.stdout
    assert run(other, "list").stderr == ""


def test_two_starts_at_once_set_up_once(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    command = [sys.executable, house / "run.py", "list", "--wheels", tmp_path / "wheels"]
    started = [
        subprocess.Popen(
            command, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        for _ in range(2)
    ]
    told = [process.communicate(timeout=120) for process in started]
    assert [process.returncode for process in started] == [0, 0]
    assert sum("Installing" in error for _, error in told) == 1
    assert sum("waiting for it" in error for _, error in told) == 1
    assert all(output.splitlines()[-1].startswith("tiny") for output, _ in told)


@pytest.mark.skipif(os.name == "nt", reason="sends a signal as a terminal does")
def test_stopped_in_the_middle_it_goes_on(tmp_path: Path) -> None:
    house = make_house(tmp_path)
    command = [sys.executable, str(house / "run.py"), "list", "--wheels", str(tmp_path / "wheels")]
    process = subprocess.Popen(
        command,
        env=environment(),
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        # What is started in the background of a shell would not hear it
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert process.stderr is not None
    assert "Making an environment" in process.stderr.readline()
    while not (house / ".venv" / "pyvenv.cfg").exists():
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)
    rest = process.communicate(timeout=60)[1]
    assert process.returncode == 130
    assert rest.splitlines()[-1] == "Stopped; run the same command again to go on."
    assert run(house, "list", "--wheels", str(tmp_path / "wheels")).returncode == 0


def test_a_package_that_was_left_halfway_is_installed_anew(tmp_path: Path, house: Path) -> None:
    other = make_house(tmp_path)
    shutil.copytree(house / ".venv", other / ".venv", symlinks=True)
    next((other / ".venv").rglob("tiny.py")).unlink()
    for stamp in (other / ".venv").glob(".installed*"):
        stamp.unlink()
    assert run(other, "list", "--wheels", str(tmp_path / "wheels")).returncode == 0
    assert len(list((other / ".venv").rglob("tiny.py"))) == 1
