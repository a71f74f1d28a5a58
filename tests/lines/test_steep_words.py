"""What is said of a steep line names the line's own axes, though the text has swapped them."""

import re

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

NUMBER = r"(−?\d+)"
ends = st.tuples(*[st.integers(-12, 12)] * 4)


def sentences(slug: str, line: tuple[int, int, int, int]) -> list[str]:
    entry = catalogue.get(slug)
    steps = Steps(entry, record(entry.function, *line))
    return ["".join(part.text for part in step.sentence) for step in steps]


def number(text: str) -> int:
    return int(text.replace("−", "-"))


@pytest.mark.parametrize("slug", ["bresenham_line", "bresenham_line_two_ends", "midpoint_line", "wu_line"])
@given(line=ends)
@settings(max_examples=25)
def test_that_the_axes_are_swapped_is_said_of_steep_lines_alone(slug, line):
    x0, y0, x1, y1 = line
    start, *_rest = sentences(slug, line)
    assert ("the text swaps x and y" in start) == (abs(y1 - y0) > abs(x1 - x0))


@pytest.mark.parametrize("slug", ["bresenham_line", "bresenham_line_two_ends"])
@given(line=ends)
@settings(max_examples=40)
def test_each_p_is_what_its_formula_gives_with_the_lines_own_sides(slug, line):
    x0, y0, x1, y1 = line
    assume((x0, y0) != (x1, y1))
    sides = {"Δx": abs(x1 - x0), "Δy": abs(y1 - y0)}
    start, *rest = sentences(slug, line)
    first = re.search(rf"p is 2(Δ.) − (Δ.) = {NUMBER} − {NUMBER} = {NUMBER}", start)
    assert first is not None
    shorter, longer, twice, other, p = first.groups()
    assert (number(twice), number(other)) == (2 * sides[shorter], sides[longer])
    assert number(p) == 2 * sides[shorter] - sides[longer]
    for sentence in rest:
        grown = re.search(rf"Next p = {NUMBER} \+ 2(Δ.)(?: − 2(Δ.))? = {NUMBER}", sentence)
        assert grown is not None
        before, up, down, after = grown.groups()
        assert number(after) == number(before) + 2 * sides[up] - (2 * sides[down] if down else 0)


@given(line=ends)
@settings(max_examples=25)
def test_the_midpoint_lines_function_is_zero_along_the_line(line):
    x0, y0, x1, y1 = line
    start, *_rest = sentences("midpoint_line", line)
    told = re.search(rf"F is a = {NUMBER} times ([xy]) and b = {NUMBER} times ([xy])", start)
    assert told is not None
    a, of_a, b, of_b = told.groups()
    assert {of_a, of_b} == {"x", "y"}
    way = {"x": abs(x1 - x0), "y": abs(y1 - y0)}
    assert number(a) * way[of_a] + number(b) * way[of_b] == 0
