"""SVG in: path data against an evaluation of its own, arcs against the ellipse; what is refused, where."""

import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from workbench.algorithms.curves import bezier_point
from workbench.document.curves.pieces import pieces_of
from workbench.document.model import (
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    Sheet,
    View,
    whole_sheet,
)
from workbench.document.transforms.links import Affine, Rotate, Scale, Translate
from workbench.exchange.svg_paths import SvgError, read_svg

Array = NDArray[np.float64]
HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -100 100 100">'
SHEET = Sheet(
    "s1",
    "sheet",
    100,
    100,
    (View("v1", Rectangle(0, 0, 100, 100), whole_sheet(100, 100)),),
    (0xFFFFFF, 0, 0xFF0000),
)


def svg(body: str) -> str:
    return f"{HEAD}{body}</svg>"


def path(data: str, tolerance: float | None = None) -> list[Any]:
    return list(read_svg(svg(f'<path fill="none" stroke="red" d="{data}"/>'), SHEET, tolerance).figures)


def seen(figure: Any) -> Array:
    """The control points under the figure's chain in the coordinates of the SVG, y downwards."""
    points = np.array([(p.x, p.y, 1.0) for p in figure.points_world])
    return (points @ figure.matrix.T)[:, :2] * [1.0, -1.0]


def cubics(figure: Any) -> Array:
    """The cubic pieces in the coordinates of the SVG, y downwards."""
    assert isinstance(figure, Curve)
    assert figure.spline == "bezier_path"
    return pieces_of(figure).controls * [1.0, -1.0]


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
    # Ends as far apart as the radii allow leave the centre as uncertain as the root of the rounding.
    assert off <= found.error * shrunk + 1e-6 * grown
    angles = np.unwrap(np.arctan2(round_it[:, 1], round_it[:, 0]))
    whole = angles[-1] - angles[0]
    assert (whole > 0) == sweep
    if half < 0.999:
        assert (abs(whole) > math.pi) == large


def test_arcs_without_radius_are_lines() -> None:
    (figure,) = path("M 0 0 A 0 5 0 0 1 10 0")
    assert np.allclose(cubics(figure)[0], [[0, 0], [10 / 3, 0], [20 / 3, 0], [10, 0]])


def test_transforms_follow_one_another() -> None:
    inner = '<g transform="translate(10,0)"><path transform="rotate(90) scale(2)" d="M 1 0 L 3 1"/></g>'
    (figure,) = read_svg(svg(inner), SHEET).figures
    assert [type(link) for link in figure.transforms] == [Scale, Rotate, Translate]
    assert np.allclose(seen(figure)[[0, -1]], [[10, 2], [8, 6]])
    (skewed,) = read_svg(svg('<path transform="matrix(1 0 1 1 0 5)" d="M 1 2 L 3 4"/>'), SHEET).figures
    assert [type(link) for link in skewed.transforms] == [Affine]
    assert np.allclose(seen(skewed)[[0, -1]], [[3, 7], [7, 9]])


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


def test_a_drawing_is_put_into_the_middle_of_the_window() -> None:
    text = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="10 20 4 2"><path d="M 10 20 L 14 22"/></svg>'
    (figure,) = read_svg(text, SHEET).figures
    ends = [(p.x, p.y) for p in (figure.points_world[0], figure.points_world[-1])]
    assert ends == [(0, 75), (100, 25)]
    bare = read_svg(text.replace(' viewBox="10 20 4 2"', ""), SHEET).figures
    assert [(p.x, p.y) for p in bare[0].points_world] == [(p.x, p.y) for p in figure.points_world]


def test_used_shapes_come_as_often_as_they_are_used_and_hidden_ones_stay_hidden() -> None:
    body = (
        '<defs><circle id="c" cx="1" cy="-1" r="1"/></defs><use href="#c" x="5"/><use href="#c" y="-5"/>'
        '<g display="none"><line x2="1" stroke="red"/></g><text>word</text><image/><image/>'
    )
    found = read_svg(svg(body), SHEET)
    places = [(f.points_world[0].x, f.points_world[0].y, f.visible) for f in found.figures]
    assert places == [(6, 1, True), (1, 6, True), (0, 0, False)]
    assert found.notes == ("Left out: 1 <text>.", "Left out: 2 × <image>.")


def nested(depth: int) -> str:
    return "<g>" * depth + "</g>" * depth


BOMB = (
    '<!DOCTYPE svg [<!ENTITY a "aaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'
    '<svg xmlns="http://www.w3.org/2000/svg"><path d="&b;"/></svg>'
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "The SVG is empty"),
        ("  \n", "The SVG is empty"),
        (svg("<g>"), "Line 1, column 71: the XML is broken (mismatched tag)"),
        ('<svg>\n<path d="M 0 0/></svg>', "Line 2, column"),
        ("<html/>", "no SVG"),
        (b"\xff\xfe\x00", "the XML is broken"),
        (b'<?xml version="1.0" encoding="utf-7"?><svg/>', "character set"),
        (BOMB, "Line 1, column 49: entity 'b' would expand"),
        ('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg/>', "entity 'x' would expand"),
        (svg(nested(300)), "nested more than 200 deep"),
        (
            svg('\n  <path id="p" d="M 0 0 L 1"/>'),
            "Line 2, column 3, <path> 'p': command 2 of the path is wrong: L needs 2",
        ),
        (svg('<path d="M 0 0 C 1 2 3 4 5"/>'), "command 2 of the path is wrong: C needs 6 numbers, and 5"),
        (svg('<path d="L 1 1"/>'), "begins with M, not with L"),
        (svg('<path d="M 0 0 L 1 nan"/>'), "command 2 of the path is wrong: 'nan' is not a number"),
        (svg('<path d="M 0 0 X"/>'), "command 2 of the path is wrong: 'X' is not a command"),
        (svg('<path d="M 0 0 L 1 1e999"/>'), "1e999 is too large"),
        (svg('<path d="M 0 0 L 1 1e300"/>'), "1e300 is too large"),
        (svg('<path d="M 0 0 L 1 1e11"/>'), "give a number between -1,000,000 and 1,000,000"),
        (svg('<path d="M 0 0 A 1 1 0 2 0 3 3"/>'), "'2 0 3 3' is not a flag"),
        (svg('<path d="M 0 0 L 1 1 2"/>'), "L needs 2 numbers, and 1 are there"),
        (svg('<circle r="inf"/>'), "r is 'inf', which is not a length"),
        (svg('<line x1="abc"/>'), "x1 is 'abc'"),
        (svg('<polygon points="1,2 3"/>'), "no pairs of numbers"),
        (svg('<g transform="spin(3)"/>'), "transform 'spin(3)' cannot be read"),
        (svg('<g transform="scale(nan)"/>'), "transform 'scale(nan)' cannot be read"),
        (svg('<use href="#nowhere"/>'), "uses '#nowhere', which is not there"),
        (svg('<g id="g"><use href="#g"/></g>'), "uses itself"),
        ('<svg viewBox="0 0 0 5"/>', "viewBox '0 0 0 5'"),
        ('<svg viewBox="0 0 nan 5"/>', "viewBox '0 0 nan 5'"),
    ],
)
def test_what_is_wrong_is_said_with_its_place(text: str | bytes, said: str) -> None:
    with pytest.raises(SvgError) as refused:
        read_svg(text, SHEET)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)
    assert str(refused.value).endswith(".")


def test_what_a_figure_cannot_refer_to_is_said() -> None:
    defined = (
        '<defs><clipPath id="c"><rect width="9" height="9"/></clipPath><mask id="m"/><filter id="f"/>'
        '<marker id="a"/><linearGradient id="g"/><style>.cut { clip-path: url("#c") }</style></defs>'
    )
    drawn = (
        '<g mask="url(#m)"><path d="M 0 0 L 5 5" clip-path="url( #c )" marker-end="url(#a)"/></g>'
        "<rect class='cut' width='1' height='2' style=\"fill:url('#g');filter:url(#f)\"/>"
        '<line x2="1" mask="none" filter="url(#missing)" stroke="red"/>'
    )
    notes = set(read_svg(svg(defined + drawn), SHEET).notes)
    said = {note for note in notes if note.startswith("Left out")}
    counts = {"mask": "1", "clipPath": "2 ×", "marker": "1", "linearGradient": "1", "filter": "1"}
    assert said == {f"Left out: {count} <{tag}>." for tag, count in counts.items()}
    assert not [note for note in read_svg(svg(defined), SHEET).notes if note.startswith("Left out")]


def test_a_use_that_doubles_itself_again_and_again_is_refused() -> None:
    groups = "".join(f'<g id="g{k}"><use href="#g{k + 1}"/><use href="#g{k + 1}"/></g>' for k in range(40))
    with pytest.raises(SvgError, match="more than 100,000 elements"):
        read_svg(svg(f'{groups}<g id="g40"><line x2="1"/></g>'), SHEET)


@settings(max_examples=200)
@given(st.text(alphabet="MmLlHhVvCcSsQqTtAaZz0123456789.,-+eE nif\n", max_size=40))
def test_whatever_stands_in_a_path_is_drawn_or_refused(data: str) -> None:
    figures, said = [], "Line 1, column"
    try:
        figures = path(data)
    except SvgError as error:
        said = str(error)
    assert "Line 1, column" in said
    for figure in figures:
        assert np.isfinite(cubics(figure)).all()


def test_elements_copied_without_their_svg_are_read() -> None:
    first, second = read_svg('<path d="M 0 0 L 4 2"/>\n<circle r="1" inkscape:label="c"/>', SHEET).figures
    assert isinstance(first, Curve)
    assert isinstance(second, Circle)
    with pytest.raises(SvgError, match="Line 2, column 3, <path>: command 1"):
        read_svg('<g>\n  <path d="5"/></g>', SHEET)
    with pytest.raises(SvgError, match=r"Line 1, column 16: the XML is broken"):
        read_svg('<path d="M 0 0"', SHEET)


def test_style_sheets_say_what_is_painted() -> None:
    sheet = (
        "<style>/* from a drawing program */ .a, .b { fill: none; stroke: #f00 }\n"
        "@media print { } line { stroke: black } #x.a { stroke: #000 } g > line { stroke: red }</style>"
    )
    body = (
        '<line class="a" x2="1"/><line id="x" class="c a" x2="1"/><line x2="1"/>'
        '<polygon class="b" points="0,0 1,0 1,1"/><polygon class="c" points="0,0 1,0 1,1"/>'
        '<line class="a" style="stroke:black" x2="1"/>'
    )
    figures = read_svg(svg(f"<defs>{sheet}</defs>{body}"), SHEET).figures
    assert [figure.colour for figure in figures] == [2, 1, 1, 2, 1, 1]
    assert [type(figure) for figure in figures[3:5]] == [Polyline, Polygon]


def test_of_rules_said_twice_each_keeps_its_own_turn() -> None:
    sheet = (
        "<style>.a { stroke: #f00; fill: none } .b { stroke: #000 } .a { fill: #000 }"
        " .c.d { stroke: #f00 } .d.c { opacity: 1 } .e { stroke: #000 } line { stroke: #f00 }</style>"
    )
    body = (
        '<line class="a b" x2="1"/><line class="b" x2="1"/><line class="d c e" x2="1"/><line x2="1"/>'
        '<polygon class="a b" points="0,0 1,0 1,1"/>'
    )
    figures = read_svg(svg(f"{sheet}{body}"), SHEET).figures
    assert [figure.colour for figure in figures] == [1, 1, 2, 2, 1]
    assert isinstance(figures[-1], Polygon)


def test_of_too_many_remarks_the_first_are_said() -> None:
    notes = read_svg(svg("".join(f"<t{k}/>" for k in range(50))), SHEET).notes
    assert len(notes) == 21
    assert notes[0] == "Left out: 1 <t0>."
    assert notes[-1] == "And 30 more remarks like these."


def test_a_drawing_inside_a_drawing_has_a_frame_of_its_own() -> None:
    inner = '<svg x="10" y="-20" width="40" height="20" viewBox="0 0 2 2"{}><path d="M 0 0 L 2 2"/></svg>'
    (fitted,) = read_svg(svg(inner.format("")), SHEET).figures
    (stretched,) = read_svg(svg(inner.format(' preserveAspectRatio="none"')), SHEET).figures
    assert np.allclose(cubics(fitted)[0, [0, -1]], [[20, -20], [40, 0]])
    assert np.allclose(cubics(stretched)[0, [0, -1]], [[10, -20], [50, 0]])


def test_uses_that_nest_without_end_are_refused() -> None:
    groups = "".join(f'<g id="g{k}">{"<g>" * 90}<use href="#g{k + 1}"/>{"</g>" * 90}</g>' for k in range(20))
    with pytest.raises(SvgError, match="nested more than 200 deep"):
        read_svg(svg(f'{groups}<g id="g20"><line x2="1"/></g>'), SHEET)


def test_entities_that_only_abbreviate_are_read() -> None:
    text = '<!DOCTYPE svg [<!ENTITY ns "http://www.w3.org/2000/svg">]><svg xmlns="&ns;"><line x2="1"/></svg>'
    assert len(read_svg(text, SHEET).figures) == 1


WHOLE = svg(
    '<style>.a{fill:none}</style><g transform="rotate(10) translate(3,4) matrix(1 0 0 1 2 3)" class="a">'
    '<path id="p" d="M 1,1 a 2 3 4 0 1 5 5 q 1 2 3 4 t 1 1 z" style="stroke:#123;stroke-width:2"/>'
    '<rect x="1mm" y="10%" width="5" height="4" rx="1"/><use href="#p" x="3"/><svg viewBox="0 0 1 1" '
    'width="3" height="4"><circle r="1"/></svg><polyline points="1,2 3,4"/><text>a &amp; b</text></g>'
)


@settings(max_examples=150)
@given(
    st.lists(
        st.tuples(
            st.integers(0, len(WHOLE)),
            st.integers(0, 5),
            st.text("<>\"'/&;#%(){},.-0 9eazM\x00é", max_size=4),
        ),
        max_size=3,
    )
)
def test_a_damaged_file_is_read_or_refused_in_one_sentence(damages: list[tuple[int, int, str]]) -> None:
    text, said = WHOLE, "."
    for at, length, other in damages:
        text = text[:at] + other + text[at + length :]
    for data in (text, text.encode()):
        try:
            read_svg(data, SHEET)
        except SvgError as error:
            said = str(error)
        assert said.endswith(".")
        assert "\n" not in said
