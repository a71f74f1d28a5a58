"""What every test stands on: no window, a fresh profile each, and nothing said unasked.

Tests that start, kill or time processes bear ``xdist_group("processes")``: they run one after the other.

Python warnings and Qt warnings fail a test through ``pyproject.toml``; a log record of level WARNING or above
fails it here, unless the test asks for ``caplog`` and so judges the records itself.
"""

import gc
import itertools
import logging
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

ROOT = Path(__file__).resolve().parent.parent

# Set before any test module imports Qt or the engine. The compiled readings are named by what went into them,
# so runs may share them: compiling anew would take minutes.
os.environ["QT_QPA_PLATFORM"] = "offscreen"
os.environ["LANGUAGE"] = "en"
os.environ.setdefault("GRAPHICS_WORKBENCH_CACHE", str(ROOT / ".pytest_cache" / "compiled"))
# The tests are on all cores already: more threads for small products only wait for one another, and busily.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")
# Each process would compile hundreds of modules anew, this one as those that tests start.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

settings.register_profile(
    "workbench", deadline=None, max_examples=60, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("ci", settings.get_profile("workbench"), derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "workbench")

MOST_WIDGETS_MORE = 500

_left = 0  # widgets that the last whole collection could not drop

_numbers = itertools.count()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--approve", action="store_true", help="write the approved texts anew, to be read in the diff"
    )


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object:
    """On several cores a file stays on one, for what its tests share; groups as they are marked."""
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadGroupScheduling

    class ByFile(LoadGroupScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return str(super()._split_scope(nodeid)).partition("::")[0]

    return ByFile(config, log)


@pytest.fixture(autouse=True)
def profile(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The folder that holds all the program keeps during this test; not there until something is written."""
    folder = tmp_path_factory.getbasetemp() / "profiles" / str(next(_numbers))
    os.environ["GRAPHICS_WORKBENCH_PROFILE"] = str(folder)
    yield folder
    os.environ.pop("GRAPHICS_WORKBENCH_PROFILE", None)


@pytest.fixture(autouse=True)
def _threads() -> Iterator[None]:
    """Nothing that a test began runs on behind it: a recorder holds settings of the whole process."""
    yield
    background = sys.modules.get("workbench.engine.background")
    if background is not None:
        assert background.end_all(60.0)  # what is being compiled cannot be stopped


def pytest_collection_finish() -> None:
    """What was imported lives as long as the process: no collection looks through it again."""
    gc.collect()
    gc.freeze()


@pytest.fixture(autouse=True)
def _garbage() -> Iterator[None]:
    """Drop what an application drops from its event loop, which no longer turns after a test.

    What has grown old, such as whole windows, is looked for once there is much more of it than the last time:
    widgets that are left cost memory, and time whenever events are handed out.
    """
    global _left
    yield
    if _widgets() > _left + MOST_WIDGETS_MORE:
        gc.collect()
        _left = _widgets()
    elif not gc.isenabled():
        gc.collect(1)


def _widgets() -> int:
    """How many widgets there are once those are gone that only wait for it."""
    qt = sys.modules.get("PySide6.QtWidgets")
    application = qt.QApplication.instance() if qt is not None else None
    if application is None:
        return 0
    from PySide6.QtCore import QEvent

    application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return len(application.allWidgets())


@pytest.fixture(scope="module", autouse=True)
def _old_garbage() -> Iterator[None]:
    """The same for all that has grown old."""
    global _left
    yield
    if not gc.isenabled():
        gc.collect()
    _left = _widgets()


@pytest.fixture(scope="session", autouse=True)
def _clipboard() -> Iterator[None]:
    """The offscreen clipboard outlives the interpreter; with what Python made in it, the process dies."""
    yield
    gui = sys.modules.get("PySide6.QtGui")
    if gui is not None and gui.QGuiApplication.instance() is not None:
        gui.QGuiApplication.clipboard().clear()


class _Unexpected(logging.Handler):
    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.records: list[logging.LogRecord] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.records.append(record)


@pytest.fixture(autouse=True)
def _quiet_log(request: pytest.FixtureRequest) -> Iterator[None]:
    handler = _Unexpected()
    logging.getLogger().addHandler(handler)
    yield
    logging.getLogger().removeHandler(handler)
    if handler.records and "caplog" not in request.fixturenames:
        said = "\n".join(f"{one.levelname} {one.name}: {one.getMessage()}" for one in handler.records)
        pytest.fail(f"unexpected log records:\n{said}", pytrace=False)
