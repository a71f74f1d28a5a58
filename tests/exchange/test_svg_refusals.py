"""What is wrong in an SVG is said with its place; damage and bombs are refused."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.exchange.svg_texts import SHEET, cubics, path, svg
from workbench.exchange.svg_paths import SvgError, read_svg


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
        ("<html/>", "XML but not SVG"),
        (b"\xff\xfe\x00", "the XML is broken"),
        (b'<?xml version="1.0" encoding="utf-7"?><svg/>', "character set"),
        (BOMB, "Line 1, column 49: entity 'b' would expand"),
        ('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg/>', "entity 'x' would expand"),
        (svg(nested(300)), "nested more than 200 deep"),
        (
            svg('\n  <path id="p" d="M 0 0 L 1"/>'),
            "Line 2, column 3, <path> 'p': command 2 of the path is wrong: L needs 2",
        ),
        (svg('<path d="M 0 0 C 1 2 3 4 5"/>'), "C needs 6 numbers, but has only 5"),
        (svg('<path d="L 1 1"/>'), "begins with M, not with L"),
        (svg('<path d="M 0 0 L 1 nan"/>'), "command 2 of the path is wrong: 'nan' is not a number"),
        (svg('<path d="M 0 0 X"/>'), "command 2 of the path is wrong: 'X' is not a command"),
        (svg('<path d="M 0 0 L 1 1e999"/>'), "1e999 is too large"),
        (svg('<path d="M 0 0 L 1 1e300"/>'), "1e300 is too large"),
        (svg('<path d="M 0 0 L 1 1e11"/>'), "give a number between -1,000,000 and 1,000,000"),
        (svg('<path d="M 0 0 A 1 1 0 2 0 3 3"/>'), "'2 0 3 3' is not a flag"),
        (svg('<path d="M 0 0 L 1 1 2"/>'), "L needs 2 numbers, but has only 1"),
        (svg('<circle r="inf"/>'), "r is 'inf', which is not a length"),
        (svg('<line x1="abc"/>'), "x1 is 'abc'"),
        (svg('<polygon points="1,2 3"/>'), "not pairs of numbers"),
        (svg('<g transform="spin(3)"/>'), "transform 'spin(3)' cannot be read"),
        (svg('<g transform="scale(nan)"/>'), "transform 'scale(nan)' cannot be read"),
        (svg('<use href="#nowhere"/>'), "uses '#nowhere', which does not exist"),
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
    counts = {"mask": "1", "clipPath": "1", "marker": "1", "linearGradient": "1", "filter": "1"}
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


def test_of_too_many_remarks_the_first_are_said() -> None:
    notes = read_svg(svg("".join(f"<t{k}/>" for k in range(50))), SHEET).notes
    assert len(notes) == 21
    assert notes[0] == "Left out: 1 <t0>."
    assert notes[-1] == "And 30 more remarks like these."


@pytest.mark.parametrize(
    ("transform", "said"),
    [
        ("rotate(1) " * 1_001, "has more than 1,000 functions; write fewer."),
        ("scale(1e300)", "in its matrix; give smaller ones."),
        ("rotate(1,2)", "cannot be read; correct it."),
        ("rotate(1) " * 1_000, ""),
    ],
)
def test_a_transform_is_refused_for_what_is_wrong_with_it(transform: str, said: str) -> None:
    note = " ".join(read_svg(svg(f'<line x2="3" transform="{transform}"/><line x2="3"/>'), SHEET).notes)
    assert said in note
    assert bool(note) == bool(said)


def test_each_gradient_that_is_left_out_is_counted_once() -> None:
    loop = (
        '<linearGradient id="a" href="#b"/><linearGradient id="b" href="#a"/>'
        '<defs><linearGradient id="c"/></defs><rect width="5" height="5" fill="url(#a)"/>'
        '<rect width="5" height="5" fill="url(#c)" stroke="url(#c)"/>'
    )
    assert read_svg(svg(loop), SHEET).notes[0] == "Left out: 3 × <linearGradient>."


def test_uses_that_nest_without_end_are_refused() -> None:
    groups = "".join(f'<g id="g{k}">{"<g>" * 90}<use href="#g{k + 1}"/>{"</g>" * 90}</g>' for k in range(20))
    with pytest.raises(SvgError, match="nested more than 200 deep"):
        read_svg(svg(f'{groups}<g id="g20"><line x2="1"/></g>'), SHEET)


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
