"""What the catalogue and every entry in it must hold to."""

import ast
import inspect
import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import workbench.algorithms
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry

ENTRIES = catalogue.entries()
each = pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)


def test_a_ladder_is_climbed_in_teaching_order() -> None:
    for entry, following in pairwise(ENTRIES):
        assert entry.next_rung in ("", following.slug)
    lines = catalogue.topic("lines")
    assert [entry.next_rung for entry in lines] == [*(entry.slug for entry in lines[1:]), ""]


def test_an_unknown_slug_is_answered_with_the_nearest() -> None:
    with pytest.raises(LookupError, match=r"'bresenham'.*bresenham_line"):
        catalogue.get("bresenham")


def test_what_makes_a_kind_of_curve_is_looked_up_once() -> None:
    """It is asked for many times at each move of a drag."""
    assert catalogue.constructing("b_spline", "bezier") is catalogue.constructing("b_spline", "bezier")


def test_slugs_are_unique() -> None:
    assert len({entry.slug for entry in ENTRIES}) == len(ENTRIES)


@each
def test_microseconds_are_written_with_mu(entry: Entry) -> None:
    said = [view.sentence for view in entry.views] + [each.unit for each in entry.parameters]
    assert [text for text in said if re.search(r"\bus\b", text)] == []


@each
def test_parameters_are_those_of_the_function(entry: Entry) -> None:
    assert [parameter.name for parameter in entry.parameters] == list(
        inspect.signature(entry.function).parameters
    )
    for parameter in entry.parameters:
        assert parameter.label
        if parameter.low is not None and parameter.high is not None:
            assert parameter.low <= parameter.example <= parameter.high


@each
def test_what_it_says_of_itself_is_complete(entry: Entry) -> None:
    assert entry.title
    assert entry.summary.endswith(".")
    assert "\n" not in entry.summary
    assert entry.source
    assert all(law.endswith(".") for law in (*(law.sentence for law in entry.laws), *entry.not_laws))
    assert entry.next_rung in ("", *(other.slug for other in ENTRIES))
    assert entry.writes in ("", *(parameter.name for parameter in entry.parameters))


@each
def test_the_example_is_a_fresh_copy(entry: Entry) -> None:
    list(entry.function(*entry.example))
    for argument, parameter in zip(entry.example, entry.parameters, strict=True):
        assert argument is not parameter.example or not isinstance(argument, np.ndarray)
        assert np.array_equal(argument, parameter.example)


@each
def test_the_text_fits_on_one_screen(entry: Entry) -> None:
    assert len(inspect.getsourcelines(entry.function)[0]) <= 60


def test_algorithms_import_numpy_and_the_standard_library_only() -> None:
    folder = Path(workbench.algorithms.__path__[0])
    allowed = {*sys.stdlib_module_names, "numpy"}
    for path in folder.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                names = [node.module or "."]
            else:
                continue
            for name in names:
                ours = name.startswith(("workbench.algorithms", "workbench.geometry"))
                assert ours or name.partition(".")[0] in allowed, f"{path.name} imports {name}"


@pytest.mark.parametrize("name", ["workbench.algorithms", "workbench.algorithms.catalogue"])
def test_importing_them_loads_neither_qt_nor_numba(name: str) -> None:
    code = (
        f"import sys, {name}\n"
        "heavy = ('PySide6', 'shiboken6', 'numba', 'llvmlite')\n"
        "print([n for n in sys.modules if n.partition('.')[0] in heavy])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
