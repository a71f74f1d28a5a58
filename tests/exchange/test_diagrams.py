"""Derivations on paper: what is on the page is all there, in its place, and nothing sticks out."""

import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from workbench.algorithms.marks import Ray, Region, Spot, Stroke, Word, along
from workbench.exchange.diagram_svg import PaperMetrics, write_diagram
from workbench.exchange.diagrams import (
    MARGIN_PT,
    Arrow,
    Axes,
    Derivation,
    Drawing,
    Formulas,
    Heading,
    Sentence,
    lay_out_derivation,
)
from workbench.exchange.formulas.layout import Area, Disc, Glyphs, Line, Typesetter
from workbench.exchange.formulas.terms import Phrase, Sign, matrix
from workbench.exchange.writing import of_kind, write
from workbench.exchange.written import ROWS

SVG = "{http://www.w3.org/2000/svg}"
WINDOW = (-2.0, -1.0, 8.0, 4.0)
words = st.text(alphabet="abcdefgxyz ,.", min_size=1, max_size=60)


def laid(*blocks, width=480.0):
    return lay_out_derivation(Derivation("Test", blocks, width=width), Typesetter(PaperMetrics()))


def svg(*blocks, **named):
    return ElementTree.fromstring(write_diagram(Derivation("Test", blocks, **named)).encode())


def texts(page):
    return [each.text for each in page.primitives if isinstance(each, Glyphs)]


def corners(primitive):
    match primitive:
        case Glyphs(x=x, y=y, width=width):
            return [(x, y), (x + width, y)]
        case Disc(x=x, y=y, radius=r):
            return [(x - r, y - r), (x + r, y + r)]
        case _:
            return primitive.points


def on_page(x, y):
    """Where a point of WINDOW lies: 444 points of room, 240 high, so 44.4 points a unit at most by width."""
    scale = min(444 / 10, 240 / 5)
    return MARGIN_PT + (444 - 10 * scale) / 2 + (x + 2) * scale, MARGIN_PT + 5 * scale - (y + 1) * scale


def test_marks_lie_where_they_are_in_the_plane():
    items = [
        Spot(3, 2, "data1", "dot"),
        Stroke(along((0, 0), (8, 4)), "accent", "medium", "dash"),
        Region(along((0, 0), (1, 0), (0, 1)), "data2"),
    ]
    spot, stroke, region = laid(Drawing(WINDOW, items)).primitives
    assert (spot.x, spot.y) == pytest.approx(on_page(3, 2))
    np.testing.assert_allclose(stroke.points, [on_page(0, 0), on_page(8, 4)])
    assert (stroke.ink, stroke.pattern) == ("accent", "dash")
    np.testing.assert_allclose(region.points, [on_page(0, 0), on_page(1, 0), on_page(0, 1)])
    assert region.share < 0.5


@given(st.floats(-2, 8), st.floats(-1, 4), st.floats(-math.pi, math.pi), st.booleans())
def test_a_ray_ends_at_the_edge_of_its_window(x, y, angle, both_ways):
    ray = Ray(x, y, math.cos(angle), math.sin(angle), both_ways=both_ways)
    (line,) = laid(Drawing(WINDOW, [ray])).primitives
    low, high = on_page(-2, 4), on_page(8, -1)
    ends = line.points if both_ways else line.points[1:]
    for end in ends:
        edges = [abs(end[k] - side[k]) for k in (0, 1) for side in (low, high)]
        assert min(edges) < 1e-6
    for end in line.points:
        assert low[0] - 1e-6 <= end[0] <= high[0] + 1e-6
        assert low[1] - 1e-6 <= end[1] <= high[1] + 1e-6


@given(st.floats(-2, 8), st.floats(-1, 4), st.floats(-2, 8), st.floats(-1, 4))
def test_an_arrow_has_its_tip_where_it_ends(x0, y0, x1, y1):
    assume(math.hypot(x1 - x0, y1 - y0) > 1e-3)
    head = laid(Drawing(WINDOW, [Arrow(along((x0, y0), (x1, y1)))])).primitives[-1]
    assert isinstance(head, Area)
    assert head.points[0] == pytest.approx(on_page(x1, y1))
    back = np.mean(head.points[1:], axis=0) - head.points[0]
    way = np.subtract(on_page(x0, y0), on_page(x1, y1))
    assert np.dot(back, way) == pytest.approx(np.hypot(*back) * np.hypot(*way), rel=1e-6)


def test_an_arrow_that_goes_nowhere_is_none():
    assert laid(Drawing(WINDOW, [Arrow(along((1, 1), (1, 1)))])).primitives == ()


@given(words, st.floats(140, 600))
def test_a_sentence_folds_between_words_and_keeps_them_all(text, width):
    page = laid(Sentence(f"{text} $x_p = 3$."), width=width)
    glyphs = [each for each in page.primitives if isinstance(each, Glyphs)]
    assert "".join(texts(page)) == f"{''.join(text.split())}xp=3."
    longest = max(each.width for each in glyphs)
    assert all(each.x + each.width <= max(width - MARGIN_PT, MARGIN_PT + longest) + 60 for each in glyphs)
    places = [(round(each.y), each.x) for each in glyphs if each.size > 9]
    assert places == sorted(places)


def test_a_dollar_sign_alone_is_itself_and_full_stops_stay_at_their_formula():
    page = laid(Sentence("costs $ 3"), Sentence("turn by $theta$, then"))
    assert texts(page) == ["costs", "$", "3", "turn", "by", "θ", ",", "then"]
    theta, comma = page.primitives[5:7]
    assert comma.x == pytest.approx(theta.x + theta.width)


@given(words, st.floats(-2, 8), st.floats(-1, 4), st.sampled_from([-1, 0, 1]), st.sampled_from([-1, 0, 1]))
def test_nothing_sticks_out_of_the_page(text, x, y, right, up):
    terms = (Phrase("M"), Sign("="), *[matrix(np.full((4, 4), -1234.5678), name="T(x_p)")] * 4)
    label = Word(text[:20], x, y, "text", right, up)
    drawing = Drawing(WINDOW, [Axes(), label, Spot(7, 3, "text", "ring")])
    beside = Drawing((0, 0, 4 * abs(x) + 1, 2 + abs(y)), [Axes("x_w", "y_w")])
    page = laid(Heading(text), Sentence(text), drawing, beside, Formulas(terms))
    for primitive in page.primitives:
        for across, down in corners(primitive):
            assert 0 <= across <= page.width
            assert 0 <= down <= page.height
    assert texts(page).count("−1234.5678") == 64


@pytest.mark.parametrize("window", [(0, 0, 4, 2), (10, -3000, 6000, 9), (1.5, 0.25, 2, 0.5)])
def test_numbers_left_of_a_drawing_keep_to_its_room(window):
    page = laid(Drawing(window, [Axes()]))
    assert min(each.x for each in page.primitives if isinstance(each, Glyphs)) >= MARGIN_PT - 1e-6


def test_a_word_wider_than_the_page_widens_it():
    page = laid(Sentence("W" * 90))
    (word,) = page.primitives
    assert page.width == pytest.approx(word.width + 2 * MARGIN_PT)


@pytest.mark.parametrize("window", [(0, 0, 0, 1), (0, 1, 1, 1), (2, 0, 1, 1), (0, 0, math.inf, 1)])
def test_a_window_without_area_is_refused(window):
    with pytest.raises(ValueError, match="xmin < xmax"):
        Drawing(window, [])


@pytest.mark.parametrize("window", [(-1, -1, 9, 8), (3, 5, 4, 5.5), (-9e5, -1, 2e5, 1e6), (0, 0, 1e-3, 1e-3)])
def test_axes_have_a_few_round_numbers_each(window):
    numbers = [text for text in texts(laid(Drawing(window, [Axes("x_w", "y_w")]))) if text not in "xyw"]
    assert 2 <= len(numbers) <= 20
    values = [abs(float(text.replace("−", "-"))) for text in numbers]
    digits = {f"{value:.6e}".partition("e")[0].rstrip("0").rstrip(".") for value in values if value}
    assert all(len(each) <= 4 for each in digits)


def test_the_svg_says_all_in_the_colours_given():
    blocks = (
        Heading("Scale & turn"),
        Sentence('<b> "$x_p$" \x00'),
        Drawing(
            WINDOW,
            [Axes(), Spot(1, 1, "data1", "ring"), Stroke(along((0, 0), (1, 1)), "data2", pattern="dot")],
        ),
        Formulas((matrix([[1, 0.1 + 0.2]], [["", "s_x"]]),), "both"),
    )
    root = svg(*blocks, inks={"data1": "#0072B2", "text": "#1B1F24"})
    page = laid(*blocks)
    assert root.find(f"{SVG}title").text == "Test"
    said = [each.text for each in root.iter(f"{SVG}text")]
    assert said == [text.replace("\x00", " ") for text in texts(page)]
    assert {"Scale", "&", "<b>", "0.3"} <= set(said)
    assert root.get("viewBox") == f"0 0 480 {float(root.get('height')[:-2]):g}"
    circle = root.find(f"{SVG}circle")
    assert (circle.get("stroke"), circle.get("fill")) == ("#0072B2", "#FFFFFF")
    dotted = [each for each in root.iter(f"{SVG}polyline") if each.get("stroke-dasharray")]
    assert [each.get("stroke") for each in dotted] == ["#000000"]
    drawn = [each for each in page.primitives if isinstance(each, Line)]
    assert len(list(root.iter(f"{SVG}polyline"))) == len(drawn)


def test_every_run_keeps_its_width_whatever_face_it_is_shown_in():
    for text in svg(Sentence("turn by $theta_1 = 45°$")).iter(f"{SVG}text"):
        assert float(text.get("textLength")) > 0
        assert text.get("lengthAdjust") == "spacingAndGlyphs"


def test_a_derivation_is_written_under_its_suffix(tmp_path: Path):
    (row,) = of_kind(ROWS, "derivation")
    derivation = Derivation("Turn", (Heading("Turn"),))
    (path,) = write(row, derivation, tmp_path / "turn.svg")
    assert path.read_text(encoding="utf-8") == write_diagram(derivation)
