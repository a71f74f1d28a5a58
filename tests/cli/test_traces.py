"""The three tables of every entry's own example, in every format."""

import copy
import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.cli import traces
from workbench.cli.arguments import read_arguments
from workbench.cli.failure import BadInputError, WorkError
from workbench.exchange.tables import to_csv, to_json, to_text

ENTRIES = catalogue.entries()
MOST_WRITTEN = 300


@pytest.mark.parametrize("table", list(traces.TABLES))
@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)
def test_every_row_fits_its_headings(entry: Entry, table: str) -> None:
    made = traces.TABLES[table](entry, traces.run(entry, copy.deepcopy(entry.example)))
    assert made.rows
    assert {len(row) for row in made.rows} == {len(made.columns)}
    made = replace(made, rows=made.rows[:: 1 + len(made.rows) // MOST_WRITTEN])
    assert len(to_text(made).splitlines()) == len(made.rows) + 1
    assert len(list(csv.reader(io.StringIO(to_csv(made))))) == len(made.rows) + 1
    assert len(json.loads(to_json(made))["rows"]) == len(made.rows)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)
def test_pixels_are_all_that_is_emitted(entry: Entry) -> None:
    made = traces.TABLES["pixels"](entry, traces.run(entry, copy.deepcopy(entry.example)))
    assert made.rows == [tuple(emitted) for emitted in entry.function(*copy.deepcopy(entry.example))]


def test_a_line_of_a_function_in_another_file_is_read_from_that_file() -> None:
    entry = catalogue.get("cohen_sutherland")
    made = traces.TABLES["lines"](entry, traces.run(entry, entry.example))
    assert [row[2] for row in made.rows[2:5]] == ["code = 0", "if y > ymax:", "code = TOP"]


def test_a_run_that_is_too_long_is_said() -> None:
    with pytest.raises(WorkError, match="not done after"):
        traces.run(catalogue.get("bresenham_line"), (0, 0, 10**9, 1))


def test_a_run_that_fails_is_said() -> None:
    with pytest.raises(WorkError, match="midpoint_circle stopped with an error, TypeError in line"):
        traces.run(catalogue.get("midpoint_circle"), (0, 0, "r"))


def test_what_a_text_says_itself_ends_with_one_full_stop() -> None:
    entry = catalogue.get("electron_beam")
    arguments = (*entry.example[:5], np.array([]), *entry.example[6:])
    with pytest.raises(BadInputError, match=r"was given: A tube has seven numbers: [^.]*[^.]\.$"):
        traces.run(entry, arguments)


def test_a_face_of_a_corner_that_is_not_there_is_told_by_its_number() -> None:
    entry = catalogue.get("depth_buffer")
    arguments = list(copy.deepcopy(entry.example))
    arguments[entry.parameter_names.index("faces")][0, 1] = 99
    with pytest.raises(BadInputError, match=r"asks for an item that is not there .index 99 is out of bounds"):
        traces.run(entry, tuple(arguments))


@pytest.mark.parametrize(
    ("slug", "name", "shape"),
    [
        ("scan_line_fill", "vertices", (3, 1)),
        ("depth_buffer", "vertices", (6, 2)),
        ("depth_sort", "vertices", (1, 3)),
        ("octree", "colours", (0,)),
        ("de_casteljau", "points", (4, 3)),
        ("de_casteljau", "points", (4, 1)),
    ],
)
def test_arrays_of_a_wrong_shape_are_told_beside_those_of_the_example(
    slug: str, name: str, shape: tuple[int, ...]
) -> None:
    entry = catalogue.get(slug)
    arguments = list(copy.deepcopy(entry.example))
    index = entry.parameter_names.index(name)
    arguments[index] = np.resize(arguments[index], shape)
    right = entry.example[index].shape
    with pytest.raises(BadInputError) as said:
        traces.run(entry, tuple(arguments))
    given, example = str(said.value).split("; in its example they are ")
    assert f"{name} {' × '.join(map(str, shape))}" in given
    assert f"{name} {' × '.join(map(str, right))}" in example


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["1"], "takes 4 arguments (x0 y0 x1 y1), but 1 was given."),
        (["1", "2"], "takes 4 arguments (x0 y0 x1 y1), but 2 were given."),
        (
            ["0", "0", "7" * 5_000, "5"],
            "x1: this has a number of more than 4,300 digits; give a shorter one.",
        ),
        (["0", "0", "7" * 4_000, "5"], "x1: it does not fit in 64 bits."),
        (["0", "0", "x", "5"], "x1 = x: this is not a number or a list as Python writes it."),
    ],
)
def test_arguments_are_refused_for_what_is_wrong_with_them(words: list[str], said: str) -> None:
    with pytest.raises(BadInputError) as refused:
        read_arguments(catalogue.get("bresenham_line"), words)
    assert str(refused.value).endswith(said)
