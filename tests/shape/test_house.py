"""What the house asks of every file: small, well named, and each power in its one place."""

import ast
import itertools
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "workbench"
FILES = sorted(PACKAGE.rglob("*.py"))
TESTS = sorted((ROOT / "tests").rglob("*.py"))

LINES_OF_AN_ALGORITHM = 200
LINES_OF_A_FILE = 400
VAGUE = {"utils", "util", "helpers", "helper", "manager", "managers", "misc", "common"}


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def named(path: Path) -> Iterator[str]:
    """Every name that a file reads, as a dotted text, and every module it imports."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        match node:
            case ast.Attribute(value=ast.Name(id=owner), attr=attribute):
                yield f"{owner}.{attribute}"
            case ast.Import(names=names):
                yield from (alias.name for alias in names)
            case ast.ImportFrom(module=str(module), names=names, level=0):
                yield module
                yield from (f"{module}.{alias.name}" for alias in names)


def users(*names: str) -> set[str]:
    return {name_of(path) for path in FILES if set(names) & set(named(path))}


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_file_is_small(path: Path) -> None:
    algorithm = path.is_relative_to(PACKAGE / "algorithms")
    count = len(path.read_text(encoding="utf-8").splitlines())
    assert count <= (LINES_OF_AN_ALGORITHM if algorithm else LINES_OF_A_FILE)


@pytest.mark.parametrize("path", TESTS, ids=name_of)
def test_file_of_tests_is_small(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= LINES_OF_A_FILE


def test_no_name_says_nothing() -> None:
    vague = [name_of(path) for path in PACKAGE.rglob("*") if VAGUE & set(path.stem.lower().split("_"))]
    assert vague == []


def test_every_package_and_module_says_what_it_is_for() -> None:
    silent = [
        name_of(path)
        for path in FILES
        if (text := path.read_text(encoding="utf-8")).strip() and not ast.get_docstring(ast.parse(text))
    ]
    assert silent == []


def test_only_the_recorder_traces() -> None:
    tracing = (
        "sys.settrace",
        "sys.setprofile",
        "threading.settrace",
        "sys.monitoring",
        "threading.setprofile",
    )
    assert users(*tracing) == {"workbench/engine/recorder.py"}


def test_only_the_lowering_rewrites() -> None:
    assert users("ast.NodeTransformer", "ast.unparse", "ast.fix_missing_locations") == {
        "workbench/engine/lowering.py"
    }


def test_algorithms_import_numpy_and_the_standard_library() -> None:
    allowed = {"numpy", "workbench", *sys.stdlib_module_names}
    levels_below = ("workbench.algorithms", "workbench.geometry")
    for path in (PACKAGE / "algorithms").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            modules: list[str] = []
            if isinstance(node, ast.Import):
                modules = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                modules = [node.module or ""]
            for module in modules:
                assert module.partition(".")[0] in allowed, f"{name_of(path)} imports {module}"
                assert not module.startswith("workbench") or module.startswith(levels_below)


def test_nothing_is_unpickled_or_fetched() -> None:
    modules = ("pickle", "shelve", "marshal", "urllib.request", "http.client", "requests")
    assert users(*modules) == set()
    # A pair within the process: Ctrl+C wakes the event loop by it
    assert users("socket") == {"workbench/shell/interrupts.py"}


def test_no_note_of_unfinished_work() -> None:
    words = ["TODO", "FIXME", "XXX"]
    for path, word in itertools.product(FILES, words):
        assert word not in path.read_text(encoding="utf-8"), name_of(path)
