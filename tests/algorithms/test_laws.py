"""Every law of every entry names the test that proves it, and that test runs on this entry."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import pytest

from tests.algorithms.proofs import proof_of, runs_on
from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.lines.dda import dda_line

LAWS = [
    pytest.param(entry, law, id=f"{entry.slug}-{law.proof.rpartition('::test_')[2]}")
    for entry in catalogue.entries()
    for law in entry.laws
]


@pytest.mark.parametrize(("entry", "law"), LAWS)
def test_a_law_is_proved_by_a_test_that_runs_on_its_entry(entry: Entry, law: Law) -> None:
    test = proof_of(law.proof)
    assert test is not None, f"{entry.slug}: there is no test tests/{law.proof}"
    assert runs_on(test, entry), f"{entry.slug}: tests/{law.proof} does not run on it"


@pytest.mark.parametrize("entry", catalogue.entries(), ids=lambda entry: entry.slug)
def test_an_entry_has_laws_and_says_each_once(entry: Entry) -> None:
    sentences = [law.sentence for law in entry.laws]
    assert sentences
    assert len(set(sentences)) == len(sentences)


@pytest.mark.parametrize(
    "proof",
    [
        "",
        "lines/test_lines.py",
        "lines/test_lines.py::test_no_such_test",
        "lines/test_no_such_file.py::test_bresenham_mirrors_exactly",
        "lines/test_lines.py::drawn",
    ],
)
def test_what_is_no_test_is_none(proof: str) -> None:
    assert proof_of(proof) is None


@pytest.mark.parametrize(
    ("proof", "slugs"),
    [
        # Over functions, over pairs with slugs; named in its body, in what it calls, in a list of its module
        ("lines/test_lines.py::test_both_ends_are_included", {"dda_line", "bresenham_line", "midpoint_line"}),
        (
            "seed_fill/test_regions.py::test_flood_fills_colour_the_region_of_the_seed_s_colour",
            {"flood_fill_4", "flood_fill_8"},
        ),
        ("lines/test_lines.py::test_bresenham_mirrors_exactly", {"bresenham_line"}),
        (
            "polygons/test_scan_line_exact.py::test_shifted_by_whole_pixels_it_is_the_same",
            {"scan_line_exact"},
        ),
        (
            "lines/test_lines.py::test_backwards_at_45_degrees",
            {"dda_line", "dda_line_single", "dda_line_fixed", "bresenham_line", "midpoint_line"},
        ),
        (
            "clipping/test_polygons.py::test_a_fork_is_left_in_one_piece_with_an_edge_that_runs_back_over_itself",
            {"sutherland_hodgman"},
        ),
    ],
)
def test_which_algorithms_a_test_runs_on(proof: str, slugs: set[str]) -> None:
    test = proof_of(proof)
    assert test is not None
    assert {entry.slug for entry in catalogue.entries() if runs_on(test, entry)} == slugs


def emit_nothing(count: int) -> Iterator[tuple[int, int]]:
    """A text of no use."""
    yield from ()


@pytest.mark.parametrize(
    "parameter", [Parameter("count", "n", "int", 1, low=0), Parameter("count", "n", "points", 1)]
)
def test_without_ranges_and_without_a_generator_it_is_said(parameter: Parameter) -> None:
    function: Callable[..., Any] = emit_nothing
    bare = replace(
        next(entry for entry in catalogue.entries() if entry.function is dda_line),
        function=function,
        parameters=(parameter,),
    )
    with pytest.raises(TypeError, match="emit_nothing has no range for count and no generator"):
        arguments(bare)
