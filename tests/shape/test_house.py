"""What the house asks of every file: small, well named, and each power in its one place."""

import ast
import itertools
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "workbench"
FILES = sorted(PACKAGE.rglob("*.py"))
TESTS = sorted((ROOT / "tests").rglob("*.py"))

LINES_OF_AN_ALGORITHM = 200
LINES_OF_A_FILE = 400
VAGUE = {"utils", "util", "helpers", "helper", "manager", "managers", "misc", "common"}


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def text_of(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def _named(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        match node:
            case ast.Attribute(value=ast.Name(id=owner), attr=attribute):
                yield f"{owner}.{attribute}"
            case ast.Import(names=names):
                yield from (alias.name for alias in names)
            case ast.ImportFrom(module=str(module), names=names, level=0):
                yield module
                yield from (f"{module}.{alias.name}" for alias in names)


class Read(NamedTuple):
    """What a file says of itself, and all that it reads by name, as dotted texts, or imports."""

    purpose: str | None
    names: frozenset[str]


@cache
def read(path: Path) -> Read:
    tree = ast.parse(text_of(path))
    return Read(ast.get_docstring(tree), frozenset(_named(tree)))


def users(*names: str) -> set[str]:
    return {name_of(path) for path in FILES if not read(path).names.isdisjoint(names)}


def test_files_are_small() -> None:
    lines = {path: len(text_of(path).splitlines()) for path in (*FILES, *TESTS)}
    most = {
        path: LINES_OF_AN_ALGORITHM if path.is_relative_to(PACKAGE / "algorithms") else LINES_OF_A_FILE
        for path in lines
    }
    assert [(name_of(path), count) for path, count in lines.items() if count > most[path]] == []


def test_no_name_says_nothing() -> None:
    vague = [name_of(path) for path in PACKAGE.rglob("*") if VAGUE & set(path.stem.lower().split("_"))]
    assert vague == []


def test_every_package_and_module_says_what_it_is_for() -> None:
    assert [name_of(path) for path in FILES if text_of(path).strip() and not read(path).purpose] == []


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


def test_nothing_is_unpickled_or_fetched() -> None:
    modules = ("pickle", "shelve", "marshal", "urllib.request", "http.client", "requests")
    assert users(*modules) == set()
    # A pair within the process: threads and Ctrl+C wake the event loop by it
    assert users("socket") == {"workbench/session/bell.py"}


def test_no_note_of_unfinished_work() -> None:
    words = ("TODO", "FIXME", "XXX")
    texts = {name_of(path): text_of(path) for path in FILES}
    assert [pair for pair in itertools.product(texts, words) if pair[1] in texts[pair[0]]] == []
