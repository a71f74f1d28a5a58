"""Path data and shapes of SVG become the curves that the standard says."""

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.exchange.svg_texts import SHEET, Array, cubics, path, svg
from workbench.algorithms.curves import bezier_point
from workbench.document.model import Circle, Curve, Ellipse, Line, Polygon, Polyline
from workbench.exchange.svg_paths import read_svg

number = st.integers(-9, 9).map(float) | st.floats(-99, 99).map(lambda v: round(v, 3))

pair = st.tuples(number, number)

COMMANDS = st.one_of(
    st.tuples(st.sampled_from("LlTt"), pair),
    st.tuples(st.sampled_from("HhVv"), st.tuples(number)),
    st.tuples(st.sampled_from("Cc"), st.tuples(*[number] * 6)),
    st.tuples(st.sampled_from("SsQq"), st.tuples(*[number] * 4)),
)


def by_hand(start: tuple[float, float], commands: list[tuple[str, tuple[float, ...]]]) -> list[Array]:
    """The segments, each with its own number of control points, as the standard words them."""
    at = np.array(start)
    reflected: dict[str, Array] = {}
    found: list[Array] = []
    for letter, values in commands:
        base = at if letter.islower() else np.zeros(2)
        kind = letter.upper()
        if kind == "H":
            points = [np.array([base[0] + values[0], at[1]])]
        elif kind == "V":
            points = [np.array([at[0], base[1] + values[0]])]
        else:
            points = list(base + np.array(values).reshape(-1, 2))
        if kind in "ST":
            key = "C" if kind == "S" else "Q"
            points.insert(0, reflected.get(key, at))
            kind = key
        found.append(np.array([at, *points]))
        at = points[-1]
        reflected = {kind: 2 * at - points[-2]} if kind in "CQ" else {}
    return found


def written(letter: str, values: tuple[float, ...], compact: bool) -> str:
    words = [repr(v).removesuffix(".0") for v in values]
    if not compact:
        return f" {letter} , ".replace(" , ", " ") + " , ".join(words)
    text = letter
    for k, word in enumerate(words):
        word = re.sub(r"^(-?)0\.", r"\1.", word)
        text += ("" if k == 0 or word.startswith("-") else " ") + word
    return text


@given(pair, st.lists(COMMANDS, min_size=1, max_size=8), st.booleans())
def test_every_command_draws_what_the_standard_says(
    start: tuple[float, float], commands: list[tuple[str, tuple[float, ...]]], compact: bool
) -> None:
    data = written("M", start, compact) + "".join(written(*command, compact) for command in commands)
    (figure,) = path(data)
    made, truth = cubics(figure), by_hand(start, commands)
    assert len(made) == len(truth)
    us = np.linspace(0, 1, 9)
    for piece, controls in zip(made, truth, strict=True):
        assert np.abs(bezier_point(piece, us) - bezier_point(controls, us)).max() <= 1e-9
    assert not figure.closed


def test_runs_close_and_begin_anew_where_they_began() -> None:
    first, second, third = path("m 1 1 4 0 0 4 z l 2 2 m 1 1 h 3 v 3 H 4 V 4 z")
    assert [f.closed for f in (first, second, third)] == [True, False, True]
    assert cubics(first)[:, 0].tolist() == [[1, 1], [5, 1], [5, 5]]
    assert cubics(second)[0, [0, -1]].tolist() == [[1, 1], [3, 3]]
    assert cubics(third)[:, 0].tolist() == [[4, 4], [7, 4], [7, 7], [4, 7]]
    assert path("M 1 1 L 5 1 5 5 1 1 Z")[0].closed
    assert len(cubics(path("M 1 1 L 5 1 5 5 1 1 Z")[0])) == 3


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("away", [0.0, 3e4])
def test_a_path_that_comes_back_within_rounding_is_closed_there(seed: int, away: float) -> None:
    """Steps from point to point, each cut off after three decimals, add up to nearly nothing."""
    chance = np.random.default_rng(seed)
    count = int(chance.integers(1, 9))
    places = chance.uniform(-30, 30, (3 * count, 2))
    steps = np.round(np.diff(np.vstack([places, places[:1]]), axis=0), 3)
    rows = (f"c {' '.join(f'{x:.3f},{y:.3f}' for x, y in ways)}" for ways in _from_begins(steps, count))
    (figure,) = path(f"m {away},{away} {' '.join(rows)} z")
    assert figure.closed
    assert len(cubics(figure)) == count
    begin, end = cubics(figure)[0, 0], cubics(figure)[-1, -1]
    assert begin.tolist() == end.tolist()


def _from_begins(steps: Array, count: int) -> Array:
    """For each of so many cubics its three points from its begin."""
    return np.cumsum(steps.reshape(count, 3, 2), axis=1)


@pytest.mark.parametrize("gap", [0.1, 0.01])
def test_a_gap_that_is_no_rounding_is_closed_by_a_line(gap: float) -> None:
    (figure,) = path(f"M 0 0 L 30 0 30 30 {gap} 0 Z")
    assert figure.closed
    assert len(cubics(figure)) == 4


@settings(max_examples=100)
@given(
    st.floats(0.1, 50),
    st.floats(0.1, 50),
    st.floats(-180, 180),
    st.booleans(),
    st.booleans(),
    st.tuples(st.floats(-50, 50), st.floats(-50, 50)),
    st.sampled_from([1.0, 0.01, 1e-5]),
)
def test_an_arc_lies_on_its_ellipse(
    rx: float, ry: float, turn: float, large: bool, sweep: bool, end: tuple[float, float], tolerance: float
) -> None:
    begin, finish = np.array([3.0, -4.0]), np.array([3.0 + end[0], -4.0 + end[1]])
    data = (
        f"M 3 -4 A {rx!r} {ry!r} {turn!r} {int(large)}{int(sweep)}{float(finish[0])!r},{float(finish[1])!r}"
    )
    text = svg(f'<path fill="none" stroke="red" d="{data}"/>')
    if np.array_equal(begin, finish):
        assert read_svg(text, SHEET).figures == ()
        return
    found = read_svg(text, SHEET, tolerance)
    assert found.error <= tolerance
    pieces = cubics(found.figures[0])
    assert np.abs(pieces[0, 0] - begin).max() <= 1e-9
    assert np.abs(pieces[-1, -1] - finish).max() <= 1e-9
    phi = math.radians(turn)
    to_circle = np.array([[math.cos(phi), math.sin(phi)], [-math.sin(phi), math.cos(phi)]]) / [[rx], [ry]]
    ends = to_circle @ np.column_stack([begin, finish])
    half = 0.5 * math.dist(*ends.T)
    grown = max(half, 1.0)
    centre = ends.mean(axis=1)
    if half < 1.0:
        across = (ends[:, 1] - ends[:, 0]) / (2 * half)
        side = math.sqrt(1.0 - half * half) * (1 if large == sweep else -1)
        centre = centre + side * np.array([across[1], -across[0]])
    points = np.concatenate([bezier_point(piece, np.linspace(0, 1, 33)) for piece in pieces])
    round_it = (to_circle @ points.T).T - centre
    off = np.abs(np.hypot(*round_it.T) - grown).max()
    shrunk = 1.0 / min(rx, ry)
    # Ends as far apart as the radii allow leave the centre as uncertain as the root of the rounding, and ends
    # that are nearly one place leave the direction between them as uncertain as their rounding beside it.
    assert off <= found.error * shrunk + 1e-6 * grown + 1e-14 / half
    angles = np.unwrap(np.arctan2(round_it[:, 1], round_it[:, 0]))
    whole = angles[-1] - angles[0]
    assert (whole > 0) == sweep
    if half < 0.999:
        assert (abs(whole) > math.pi) == large


def test_arcs_without_radius_are_lines() -> None:
    (figure,) = path("M 0 0 A 0 5 0 0 1 10 0")
    assert np.allclose(cubics(figure)[0], [[0, 0], [10 / 3, 0], [20 / 3, 0], [10, 0]])


def test_basic_shapes_become_figures_of_their_own() -> None:
    body = (
        '<line x1="1" y1="-2" x2="3" y2="-4" stroke="#f00"/>'
        '<polyline points="1,-1 2-2 3-1" fill="none" stroke="red"/>'
        '<polygon points="1,-1 2,-2 3,-1"/>'
        '<rect x="1" y="-9" width="4" height="2" style="fill:none;stroke:red"/>'
        '<circle cx="5" cy="-6" r="2" fill="none" stroke="red"/>'
        '<ellipse cx="5" cy="-6" rx="2" ry="1"/>'
        '<rect x="0" y="-10" width="8" height="6" rx="2" stroke="red" fill="none"/>'
        '<circle cx="50%" cy="10%" r="1" transform="skewX(20)"/>'
    )
    figures = read_svg(svg(body), SHEET).figures
    kinds = [Line, Polyline, Polygon, Polyline, Circle, Ellipse, Curve, Circle]
    assert [type(figure) for figure in figures] == kinds
    assert [(p.x, p.y) for p in figures[0].points_world] == [(1, 2), (3, 4)]
    assert [(p.x, p.y) for p in figures[3].points_world] == [(1, 9), (5, 9), (5, 7), (1, 7)]
    assert [figure.colour for figure in figures] == [2, 2, 1, 2, 2, 1, 2, 1]
    assert figures[4].algorithm == "midpoint_circle"
    assert figures[5].algorithm == "ellipse_fill"
    assert figures[6].closed
    assert len(cubics(figures[6])) == 8


def test_joints_are_what_the_handles_say() -> None:
    (figure,) = path("M 0 0 C 0 1 2 4 4 4 C 6 4 8 4 9 9 C 9.5 11.5 9 9 20 20 L 30 21")
    assert [p.joint for p in figure.points_world[::3]] == [
        "corner",
        "symmetric",
        "smooth",
        "corner",
        "corner",
    ]
