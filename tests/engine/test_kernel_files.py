"""Whose folder kernels are read from, and what is done where none can be written."""

import os
import pickle
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numba
import pytest

from tests.engine import written_texts as texts
from workbench import paths
from workbench.engine import compiled, kernel_files
from workbench.engine.ownership import owned, sealed
from workbench.engine.warm import Progress, Warming

STRANGER = 4321
CORNERS = [[0, 0], [4, 5], [2, 7]]
as_root = pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a file to somebody else")


@pytest.fixture
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("GRAPHICS_WORKBENCH_CACHE", str(tmp_path / "above" / "cache"))
    monkeypatch.setattr(kernel_files, "_rooms", {})
    compiled._kernel.cache_clear()
    yield tmp_path / "above" / "cache"
    compiled._kernel.cache_clear()


@pytest.fixture
def temporary(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The temporary folder of the system, a fresh one that every user may enter."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o1777)
        monkeypatch.setenv("TMPDIR", folder)
        monkeypatch.setattr(tempfile, "tempdir", None)
        yield Path(folder)


class Planted:
    """What, when it is unpickled, leaves a trace."""

    def __init__(self, trace: Path) -> None:
        self.trace = trace

    def __reduce__(self) -> tuple[Callable[[Path], int], tuple[str]]:
        return os.mkdir, (str(self.trace),)  # type: ignore[return-value]


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache that holds one kernel, to be copied."""
    folder = tmp_path_factory.mktemp("kept")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GRAPHICS_WORKBENCH_CACHE", str(folder))
        compiled._kernel.cache_clear()
        assert compiled.collect(texts.corners).tolist() == CORNERS
        compiled._kernel.cache_clear()
    return folder


def plant(kept: Path, cache: Path, trace: Path) -> None:
    """Put a trap into every index of what was kept."""
    paths.make(cache.parent)
    shutil.copytree(kept, cache)
    indexes = list(cache.rglob("*.nbi"))
    assert indexes
    for index in indexes:
        index.write_bytes(pickle.dumps(numba.__version__) + pickle.dumps(Planted(trace)))


def opened(cache: Path) -> None:
    cache.chmod(0o777)


def open_to_the_group(cache: Path) -> None:
    cache.chmod(0o770)


def shared_as_the_temporary_folder(cache: Path) -> None:
    cache.chmod(0o1777)


def open_above(cache: Path) -> None:
    cache.parent.chmod(0o777)


def a_kernel_open(cache: Path) -> None:
    next(cache.glob("*/kernel.py")).parent.chmod(0o777)


def linked_from_an_open_folder(cache: Path) -> None:
    cache.rename(cache.parent / "real")
    (cache.parent / "open").mkdir()
    (cache.parent / "open").chmod(0o777)
    (cache.parent / "open" / "link").symlink_to(cache.parent / "real")
    cache.symlink_to("open/link")


def of_a_stranger(cache: Path) -> None:
    os.chown(cache, STRANGER, -1)


def above_of_a_stranger(cache: Path) -> None:
    os.chown(cache.parent, STRANGER, -1)


def a_kernel_of_a_stranger(cache: Path) -> None:
    os.chown(next(cache.glob("*/kernel.py")).parent, STRANGER, -1)


def an_index_of_a_stranger(cache: Path) -> None:
    for index in cache.rglob("*.nbi"):
        os.chown(index, STRANGER, -1)


def test_what_lies_in_a_folder_of_ones_own_is_read(kept: Path, own_cache: Path, tmp_path: Path) -> None:
    """So that the trap of the next test is known to work."""
    plant(kept, own_cache, tmp_path / "trace")
    assert compiled.collect(texts.corners).tolist() == CORNERS
    assert (tmp_path / "trace").is_dir()


@pytest.mark.parametrize(
    "change",
    [
        opened,
        open_to_the_group,
        shared_as_the_temporary_folder,
        open_above,
        a_kernel_open,
        linked_from_an_open_folder,
        pytest.param(of_a_stranger, marks=as_root),
        pytest.param(above_of_a_stranger, marks=as_root),
        pytest.param(a_kernel_of_a_stranger, marks=as_root),
        pytest.param(an_index_of_a_stranger, marks=as_root),
    ],
)
def test_what_others_may_have_put_there_is_never_read(
    change: Callable[[Path], None], kept: Path, own_cache: Path, tmp_path: Path, temporary: Path
) -> None:
    plant(kept, own_cache, tmp_path / "trace")
    change(own_cache)
    assert compiled.collect(texts.corners).tolist() == CORNERS
    assert not (tmp_path / "trace").exists()
    folder = kernel_files.room().folder
    assert folder is not None
    assert owned(folder)
    assert all(sealed(kernel) for kernel in folder.iterdir() if kernel.stem in sys.modules)


def test_the_compilers_own_folders_are_never_read(
    own_cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "numba"))
    assert compiled.collect(texts.corners).tolist() == CORNERS
    assert not (tmp_path / "numba").exists()
    assert list(own_cache.rglob("*.nbi"))


def test_a_folder_below_a_sticky_one_is_ones_own(temporary: Path) -> None:
    (temporary / "mine").mkdir()
    assert owned(temporary / "mine")
    assert not owned(temporary / "mine" / "..")
    (temporary / "mine").chmod(0o755)
    assert owned(temporary / "mine")
    assert not sealed(temporary / "mine")
    temporary.chmod(0o777)
    assert not owned(temporary / "mine")


def test_links_that_lead_round_and_files_are_no_folder(tmp_path: Path) -> None:
    (tmp_path / "round").symlink_to(tmp_path / "round")
    (tmp_path / "file").touch()
    assert not any(owned(tmp_path / name) for name in ("round", "file", "nothing"))


# A start of the program, and where it kept what it compiled. Root may write everywhere, and so becomes
# somebody else first; by then it has compiled once, as only root may be able to read the compiler's modules.
PROGRAM = f"""
import os, resource, sys
from tests.engine import written_texts as texts
from workbench.engine import compiled, kernel_files
def compile_corners(cache):
    os.environ["GRAPHICS_WORKBENCH_CACHE"] = cache
    compiled._kernel.cache_clear()
    assert compiled.collect(texts.corners).tolist() == {CORNERS}
    assert compiled.kernel(texts.corners).used
before, cache, end = sys.argv[1:]
compile_corners(before)
if os.geteuid() == 0:
    os.setgroups([])
    os.setgid({STRANGER})
    os.setuid({STRANGER})
resource.setrlimit(resource.RLIMIT_FSIZE, (int(end), int(end)))
compile_corners(cache)
room = kernel_files.room()
os.write(1, f"{{room.folder}}|{{room.reason}}".encode())
"""


def run(temporary: Path, cache: Path, files_end_at: int = resource.RLIM_INFINITY) -> tuple[str, str]:
    """Run the program as an ordinary user with this temporary folder; where it kept what, and why there."""
    with tempfile.TemporaryDirectory(dir=temporary.parent) as before:
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM, before, str(cache), str(files_end_at)],
            cwd=Path(__file__).parents[2],
            env={**os.environ, "TMPDIR": str(temporary)},
            capture_output=True,
            text=True,
            check=False,
        )
    assert not done.stderr
    folder, reason = done.stdout.split("|")
    return folder, reason


@pytest.fixture
def closed(temporary: Path) -> Iterator[Path]:
    """A folder that may be read but not written."""
    folder = temporary / "closed"
    folder.mkdir()
    (folder / "cache").mkdir()
    (folder / "cache").chmod(0o555)
    folder.chmod(0o555)
    yield folder
    folder.chmod(0o755)


@pytest.mark.parametrize("name", ["cache", "missing"])
def test_a_cache_that_cannot_be_written_leaves_nothing_behind(
    temporary: Path, closed: Path, name: str
) -> None:
    folder, reason = run(temporary, closed / name)
    assert Path(folder).parent == temporary
    assert reason == "Permission denied"
    assert list(temporary.iterdir()) == [closed]


def test_without_a_temporary_folder_it_is_compiled_all_the_same(temporary: Path, closed: Path) -> None:
    """Nor with one that others may write without its being sticky."""
    temporary.chmod(0o777)
    folder, reason = run(temporary, closed / "cache")
    assert folder == "None"
    assert reason == "Permission denied"
    assert list(temporary.iterdir()) == [closed]


@pytest.mark.parametrize("size", [0, 12000])
def test_a_disk_that_is_full_while_compiling_leaves_nothing_behind(temporary: Path, size: int) -> None:
    """What is too long: any file, or only what was compiled."""
    (temporary / "home").mkdir(mode=0o700)
    if os.geteuid() == 0:
        os.chown(temporary / "home", STRANGER, STRANGER)
    assert run(temporary, temporary / "home" / "cache", size) == ("None", "File too large")
    assert list(temporary.iterdir()) == [temporary / "home"]
    assert not list((temporary / "home").rglob("*.tmp*"))


def test_a_child_warms_the_private_folder_of_its_parent(own_cache: Path, temporary: Path) -> None:
    own_cache.mkdir(parents=True)
    own_cache.chmod(0o777)
    warming = Warming(["bresenham_line"], ("collect",))
    reports: list[Progress] = []
    warming.follow(reports.append)
    warming.stop()
    assert reports == [Progress(1, 1, "bresenham_line", "collect")]
    assert not list(own_cache.iterdir())
    assert len(list(temporary.glob("*/*/kernel.py"))) == 1


def test_a_child_whose_disk_is_full_says_so_and_nothing_is_prepared(own_cache: Path, temporary: Path) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (12000, hard))
    try:
        warming = Warming(["bresenham_line"], ("collect",))
        reports: list[Progress] = []
        warming.follow(reports.append)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert warming.finished
    assert not reports
    assert kernel_files.room() == kernel_files.Room(None, "File too large")
