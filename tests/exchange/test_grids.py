"""Grids on paper: every word in its own cell, every cell between its rules."""

from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.exchange.diagram_svg import PaperMetrics, write_diagram
from workbench.exchange.diagrams import MARGIN_PT, Derivation, lay_out_derivation
from workbench.exchange.formulas.layout import Glyphs, Line, Typesetter
from workbench.exchange.grids import Grid

SVG = "{http://www.w3.org/2000/svg}"
words = st.lists(st.sampled_from(["beam", "row by row", "display list", "x", "mm"]), max_size=14).map(
    " ".join
)


@st.composite
def grids(draw):
    columns = draw(st.integers(1, 4))
    row = st.lists(words, min_size=columns, max_size=columns)
    shares = draw(st.lists(st.floats(0.5, 2), min_size=columns, max_size=columns))
    return Grid(draw(row), draw(st.lists(row, max_size=5)), shares)


def laid(grid, width=480.0):
    return lay_out_derivation(Derivation("Test", [grid], width=width), Typesetter(PaperMetrics()))


def rules(page):
    """Where the vertical and the level rules are."""
    lines = [each.points for each in page.primitives if isinstance(each, Line)]
    return sorted(a[0] for a, b in lines if a[0] == b[0]), sorted(a[1] for a, b in lines if a[1] == b[1])


@given(grids(), st.sampled_from([160.0, 300.0, 480.0]))
def test_every_word_is_between_the_rules_of_its_own_cell(grid, width):
    page = laid(grid, width)
    across, down = rules(page)
    assert (len(across), len(down)) == (len(grid.headings) + 1, len(grid.rows) + 2)
    for number, row in enumerate((grid.headings, *grid.rows)):
        for column, text in enumerate(row):
            inside = [
                each.text
                for each in page.primitives
                if isinstance(each, Glyphs)
                and across[column] < each.x
                and each.x + each.width < across[column + 1]
                and down[number] < each.y - 0.7 * each.size
                and each.y < down[number + 1]
            ]
            assert " ".join(inside).split() == text.split()


def test_columns_share_the_page_as_told():
    across, _down = rules(laid(Grid(("a", "b", "c"), [("x", "y", "z")], (1, 2, 1))))
    assert [at - MARGIN_PT for at in across] == pytest.approx([0, 111, 333, 444])


def test_a_word_wider_than_its_column_widens_it():
    page = laid(Grid(("a", "b"), [("w" * 60, "y")]))
    across, _down = rules(page)
    assert across[-1] > 480 - MARGIN_PT
    assert page.width >= across[-1] + MARGIN_PT


@pytest.mark.parametrize("shares", [(), (1.0,)])
def test_a_row_of_another_length_is_refused(shares):
    with pytest.raises(ValueError, match="as many cells"):
        Grid(("a", "b"), [("x",)], shares)


def test_the_svg_says_every_cell():
    grid = Grid(("Feature", "Raster", "Random"), [("Beam", "row by row", "stroke by stroke")])
    root = ElementTree.fromstring(write_diagram(Derivation("Test", [grid])).encode())
    said = " ".join("".join(each.itertext()) for each in root.iter(f"{SVG}text"))
    for word in ("Feature", "Beam", "row", "stroke"):
        assert word in said
