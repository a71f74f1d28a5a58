"""A text is lowered once and kept, and lowered anew as soon as anything changes that it comes from."""

import ast
import importlib
import itertools
import os
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from workbench.algorithms import catalogue
from workbench.engine import arguments, compiled, kernel_files, lowered_files, lowering, warm
from workbench.engine.lowering import Variant, lower

ENGINE = Path(lowered_files.__file__).parent
DATES = itertools.count(10**18, 10**9)

STEPS = """from typing import NamedTuple

LEAP = 2

class Place(NamedTuple):
    x: int
    y: int = 0

def step(x, by=1):
    return x + LEAP * by
"""
WALK = """from steps_of_walk import Place, step

END = 9

def walk(first: int):
    kept: list[Place] = []
    # Go on
    x = first
    while x < END:
        kept.append(Place(x))
        yield x, kept[-1].y
        x = step(x)
"""


def write(file: Path, text: str) -> None:
    """Write a file, dated before this process began: a later one has been imported as something else."""
    file.write_text(text)
    os.utime(file, ns=(0, next(DATES)))


@pytest.fixture
def lowerings(own_cache: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of what is lowered, each time."""
    names: list[str] = []

    def counted(function: Callable[..., Any], *rest: Any) -> lowering.Lowered:
        names.append(function.__name__)
        return lower(function, *rest)

    monkeypatch.setattr(lowered_files, "lower", counted)
    return names


@pytest.fixture
def walk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Any]]:
    """Imports the texts above as a new process would, with something replaced in both files."""
    folder = tmp_path / "texts"
    folder.mkdir()
    monkeypatch.syspath_prepend(str(folder))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    names = {"steps_of_walk": STEPS, "walk_in_steps": WALK}

    def imported(old: str = "", new: str = "") -> Callable[..., Any]:
        for name, text in names.items():
            write(folder / f"{name}.py", text.replace(old, new) if old else text)
            sys.modules.pop(name, None)
        importlib.invalidate_caches()
        return importlib.import_module("walk_in_steps").walk  # type: ignore[no-any-return]

    yield imported
    for name in names:
        sys.modules.pop(name, None)


def test_a_text_is_lowered_once_for_all_processes(walk: Callable[..., Any], lowerings: list[str]) -> None:
    first = lowered_files.lowered(walk())
    assert lowered_files.lowered(walk()) == first == lower(walk())
    assert lowerings == ["walk"]


@pytest.mark.parametrize("variant", ["plain", "counting", "probing"])
@pytest.mark.parametrize("slug", ["bresenham_line", "gouraud"])
def test_what_is_kept_is_what_was_lowered(slug: str, variant: Variant, lowerings: list[str]) -> None:
    entry = catalogue.get(slug)
    considers = arguments.considered(entry)
    kept, again = (lowered_files.lowered(entry.function, variant, considers) for _time in range(2))
    assert lowerings == [slug]
    assert again == kept == lower(entry.function, variant, considers)


CHANGES = [
    ("return x + LEAP", "return x - LEAP"),
    ("LEAP = 2", "LEAP = 3"),
    ("by=1", "by=2"),
    ("END = 9", "END = 8"),
    ("y: int = 0", "y: int = 5"),
    ("x: int\n    y: int", "y: int\n    x: int"),
    ("list[Place]", "list[tuple[int, int]]"),
]


@pytest.mark.parametrize(("old", "new"), CHANGES)
def test_a_change_anywhere_makes_another_text_and_another_kernel(
    old: str, new: str, walk: Callable[..., Any], lowerings: list[str]
) -> None:
    key = compiled.kernel(walk()).key
    changed = compiled.kernel(walk(old, new))
    assert lowerings == ["walk", "walk"]
    assert changed.key != key
    assert changed.lowered == lower(walk(old, new))
    assert compiled.kernel(walk()).key == key
    assert lowerings == ["walk", "walk"]


def test_the_type_of_a_field_in_another_file_counts(walk: Callable[..., Any], lowerings: list[str]) -> None:
    lowered_files.lowered(walk())
    changed = lowered_files.lowered(walk("y: int = 0", "y: float = 0"))
    assert changed.text == lower(walk("y: int = 0", "y: float = 0")).text
    assert len(lowerings) == 2


def test_a_value_that_was_set_in_memory_counts(
    walk: Callable[..., Any], lowerings: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    lowered_files.lowered(walk())
    function = walk()
    monkeypatch.setattr(sys.modules["walk_in_steps"], "END", 4)
    assert "END = 4" in lowered_files.lowered(function).text
    monkeypatch.setattr(sys.modules["walk_in_steps"], "step", len)
    with pytest.raises(ValueError, match="step is not a number"):
        lowered_files.lowered(function)


def test_a_file_that_changes_while_it_is_lowered_is_not_kept(
    walk: Callable[..., Any], own_cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    function = walk()

    def slow(*rest: Any) -> lowering.Lowered:
        Path(function.__code__.co_filename).write_text(WALK + "# another\n")
        return lower(*rest)

    monkeypatch.setattr(lowered_files, "lower", slow)
    lowered_files.lowered(function)
    assert not list(own_cache.rglob("lowered.json"))


@pytest.mark.parametrize("written", ["", "[1]", '["walk", "", [], [], 2, false, [[1]], []]'])
def test_rubbish_only_costs_time(
    written: str, walk: Callable[..., Any], own_cache: Path, lowerings: list[str]
) -> None:
    first = lowered_files.lowered(walk())
    for file in own_cache.rglob("lowered.json"):
        file.write_text(written)
    assert lowered_files.lowered(walk()) == lowered_files.lowered(walk()) == first
    assert lowerings == ["walk", "walk"]


def test_what_others_may_have_written_is_not_read(
    walk: Callable[..., Any], own_cache: Path, lowerings: list[str]
) -> None:
    first = lowered_files.lowered(walk())
    (file,) = own_cache.rglob("lowered.json")
    file.write_text(file.read_text().replace("END = 9", "END = 1"))
    file.parent.chmod(0o777)
    assert lowered_files.lowered(walk()) == first


def _engine_modules(text: str) -> set[str]:
    """The modules of the engine that a text imports, wherever it does."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("workbench.engine"):
            last = (node.module or "").removeprefix("workbench.engine").removeprefix(".")
            names |= {last} if last else {alias.name for alias in node.names}
    return names


@pytest.fixture
def copied_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    folder = tmp_path / "engine"
    shutil.copytree(ENGINE, folder, ignore=shutil.ignore_patterns("__pycache__"))
    for module, known in ((kernel_files, kernel_files._surroundings), (lowered_files, lowered_files._engine)):
        monkeypatch.setattr(module, "__file__", str(folder / Path(module.__file__).name))
        known.cache_clear()
    yield folder
    kernel_files._surroundings.cache_clear()
    lowered_files._engine.cache_clear()


def test_a_change_in_what_is_compiled_with_a_text_makes_another_kernel(copied_engine: Path) -> None:
    """With whatever the overloads and the lowered texts import of the engine, and these in turn."""
    waiting = ["overloads", *_engine_modules(lower(catalogue.get("bresenham_line").function).text)]
    for name in waiting:
        waiting += _engine_modules((ENGINE / f"{name}.py").read_text()) - set(waiting)
    assert {"overloads", "sinks", "places", "choices"} <= set(waiting)
    for name in {*waiting, "arguments", "compiled", "processor"}:
        key = kernel_files.key("text", "")
        with (copied_engine / f"{name}.py").open("a") as file:
            file.write("# changed\n")
        kernel_files._surroundings.cache_clear()
        assert kernel_files.key("text", "") != key, name


def test_a_change_anywhere_in_the_engine_lowers_anew(
    copied_engine: Path, walk: Callable[..., Any], lowerings: list[str]
) -> None:
    function = walk()
    lowered_files.lowered(function)
    files = sorted(copied_engine.glob("*.py"))
    for file in files:
        write(file, file.read_text() + "# changed\n")
        lowered_files._engine.cache_clear()
        lowered_files.lowered(function)
    assert len(lowerings) == len(files) + 1


def test_asking_what_is_warm_lowers_nothing_that_was_lowered_before(lowerings: list[str]) -> None:
    uses = warm.work(["bresenham_line", "midpoint_circle"])
    for _time in range(2):
        compiled._kernel.cache_clear()
        assert not any(warm.warm(slug, use) for slug, use in uses)
    assert sorted(lowerings) == sorted(["bresenham_line", "midpoint_circle"] * 3)


def test_a_text_beside_an_entry_is_warm_for_its_own_arguments_only(own_cache: Path) -> None:
    """Gouraud's tiles write a light of int64, those of the depth buffer colours of uint32."""
    gouraud = catalogue.get("gouraud")
    tiles, coded = (beside.function for beside in gouraud.beside)

    def mark(function: Callable[..., Any], arrays: tuple[Any, ...]) -> None:
        key = compiled.kernel(function).key
        place = kernel_files.place(key)
        assert place is not None
        place.mkdir(parents=True, exist_ok=True)
        kinds = [value.dtype.str[1:] for value in arrays if hasattr(value, "dtype")]
        kernel_files.mark(key, "-".join(["run", *kinds]))

    mark(gouraud.function, gouraud.example)
    mark(coded, gouraud.beside[1].example)
    mark(tiles, catalogue.get("depth_buffer").beside[0].example)
    assert compiled.ready(tiles, "run")
    assert not warm.warm("gouraud", "paint")
    mark(tiles, gouraud.beside[0].example)
    assert warm.warm("gouraud", "paint")
