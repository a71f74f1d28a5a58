"""The structure of an SVG: transforms, uses, style sheets, frames, entities."""

import numpy as np
import pytest

from tests.exchange.svg_texts import SHEET, cubics, seen, svg
from workbench.document.model import Circle, Curve, Line, Polygon, Polyline
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms.links import Affine, Rotate, Scale, Translate
from workbench.exchange.svg_paths import SvgError, read_svg


def test_transforms_follow_one_another() -> None:
    inner = '<g transform="translate(10,0)"><path transform="rotate(90) scale(2)" d="M 1 0 L 3 1"/></g>'
    (figure,) = read_svg(svg(inner), SHEET).figures
    assert [type(link) for link in figure.transforms] == [Scale, Rotate, Translate]
    assert np.allclose(seen(figure)[[0, -1]], [[10, 2], [8, 6]])
    (skewed,) = read_svg(svg('<path transform="matrix(1 0 1 1 0 5)" d="M 1 2 L 3 4"/>'), SHEET).figures
    assert [type(link) for link in skewed.transforms] == [Affine]
    assert np.allclose(seen(skewed)[[0, -1]], [[3, 7], [7, 9]])


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


def test_what_a_property_cannot_be_is_not_there() -> None:
    said = "<style>line{stroke:nothing;fill:#000}</style>"
    line = '<line x2="9" style="stroke:red;stroke:no-such" fill="none"/>'
    assert [figure.colour for figure in read_svg(svg(said + line), SHEET).figures] == [2]


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
    assert [figure.colour for figure in figures] == [1, 1, 2, 2, 1, 1]
    assert [type(figure) for figure in figures[-2:]] == [Polygon, Polyline]


def test_a_drawing_inside_a_drawing_has_a_frame_of_its_own() -> None:
    inner = '<svg x="10" y="-20" width="40" height="20" viewBox="0 0 2 2"{}><path d="M 0 0 L 2 2"/></svg>'
    (fitted,) = read_svg(svg(inner.format("")), SHEET).figures
    (stretched,) = read_svg(svg(inner.format(' preserveAspectRatio="none"')), SHEET).figures
    assert np.allclose(cubics(fitted)[0, [0, -1]], [[20, -20], [40, 0]])
    assert np.allclose(cubics(stretched)[0, [0, -1]], [[10, -20], [50, 0]])


def test_entities_that_only_abbreviate_are_read() -> None:
    text = '<!DOCTYPE svg [<!ENTITY ns "http://www.w3.org/2000/svg">]><svg xmlns="&ns;"><line x2="1"/></svg>'
    assert len(read_svg(text, SHEET).figures) == 1


def test_an_inside_and_an_outline_are_two_figures() -> None:
    body = '<rect width="9" height="5" fill="#102030" stroke="red"/><path d="M0 0Q9 0 9 9Z" fill="red"/>'
    drawing = read_svg(svg(body), SHEET)
    area, outline, curved, curve = drawing.figures
    assert [type(area), type(outline), type(curved), type(curve)] == [Polygon, Polyline, Polygon, Curve]
    assert drawing.palette == (*SHEET.palette, 0x102030)
    assert [figure.colour for figure in drawing.figures] == [3, 2, 2, 2]


def test_what_has_the_colour_of_the_paper_is_still_seen() -> None:
    drawing = read_svg(svg('<line x2="9" stroke="white"/><line x2="9" stroke="#f00" opacity=".5"/>'), SHEET)
    assert [drawing.palette[figure.colour] for figure in drawing.figures] == [0x7F7F7F, 0xFF8080]
    assert drawing.notes == (
        "What has the background colour is drawn in grey, so that it can be seen.",
        "Opacity is blended with the background colour.",
    )


def test_one_bad_element_is_left_out_and_said() -> None:
    bad = (
        '<path d="M 0 0 L nan 1"/>',
        '<polygon points="1,2 3"/>',
        '<use href="http://example.org/a.svg#b"/>',
        '<circle r="1e400"/>',
        '<line x2="5" transform="spin(3)"/>',
        '<line x2="1e11"/>',
    )
    good = '<line x2="9" transform="none" stroke="red"/>'
    for element in bad:
        drawing = read_svg(svg(f"<g>{element}</g>{good}"), SHEET)
        assert [type(figure) for figure in drawing.figures] == [Line]
        assert len(drawing.notes) == 1
        assert drawing.notes[0].startswith("Left out: Line 1, column ")
        assert drawing.notes[0].endswith(".")
        with pytest.raises(SvgError, match="Line 1, column"):
            read_svg(svg(element), SHEET)


def test_css_transforms_have_units_and_an_origin() -> None:
    how = "transform: translate(10px, 10%) rotate(.25turn); transform-origin: 50% 0"
    (line,) = read_svg(svg(f'<line x2="9" stroke="red" style="{how}"/>'), SHEET).figures
    assert np.allclose(seen(line), [[60, -40], [60, -31]])
    (line,) = read_svg(
        svg('<line x2="9" stroke="red" style="transform:scaleY(2)translateX(3px)"/>'), SHEET
    ).figures
    assert np.allclose(seen(line), [[3, 0], [12, 0]])


@pytest.mark.parametrize(
    ("style", "told"),
    [
        ("", False),
        ("stroke-width: 1", False),
        ("stroke-width: 2", False),
        ("stroke-width: 3", True),
        ("stroke-dasharray: 4 2", True),
        ("stroke-dasharray: none", False),
    ],
)
@pytest.mark.parametrize("around", ['<g stroke="red" style="{}">', '<g style="stroke: red; {}">'])
def test_a_line_that_loses_its_width_or_dashes_is_told_of(style: str, told: bool, around: str) -> None:
    inside = around.format(style) + '<line x2="9" y2="9"/></g>'
    assert any("one pixel wide" in each for each in _notes(inside)) == told


def test_a_shape_that_a_gradient_filled_is_told_of() -> None:
    shapes = [f'<rect width="9" height="9" fill="{fill}"/>' for fill in ("url(#a)", "red")]
    assert [any("Gradients" in each for each in _notes(shape)) for shape in shapes] == [True, False]


def _notes(inside: str) -> tuple[str, ...]:
    width, height = SHEET.width_px, SHEET.height_px
    view = f'viewBox="0 0 {width} {height}" xmlns="http://www.w3.org/2000/svg"'
    return read_svg(f"<svg {view}>{inside}</svg>", blank_sheet(width, height).sheets[0]).notes


@pytest.mark.parametrize("between", [";", "; ", " ;\n\t", ";;", "; /* so */ "])
def test_declarations_stand_apart_in_any_way(between: str) -> None:
    style = between.join(["fill: none", "stroke: #ff0000", "stroke-width: 9", "stroke-opacity: 1"])
    found = read_svg(svg(f'<circle r="3" style="{style}{between}"/>'), SHEET)
    (figure,) = found.figures
    assert isinstance(figure, Circle)
    assert (found.palette or SHEET.palette)[figure.colour] == 0xFF0000
    assert any("one pixel wide" in each for each in found.notes)
