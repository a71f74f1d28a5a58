"""Tables: what a person reads lines up, what a program reads comes back whole."""

import csv
import io
import json
import math
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.numerals import decimal
from workbench.exchange.tables import (
    Table,
    plain,
    shown,
    to_csv,
    to_html,
    to_json,
    to_text,
    to_tsv,
    typeset,
)

HAND = Table(("k", "p_k", "(x_{k+1}, y_{k+1})"), ((0, 6, (21, 11)), (1, 2, (22, 12)), (10, -2, (23, 12))))

values = st.one_of(
    st.integers(-(10**9), 10**9),
    st.floats(allow_nan=False),
    st.text(st.characters(blacklist_categories=("Cs", "Cc"))),
    st.booleans(),
    st.tuples(st.integers(), st.integers()),
)


@st.composite
def tables(draw: st.DrawFn) -> Table:
    width = draw(st.integers(1, 4))
    names = draw(st.lists(st.from_regex(r"[a-z]{1,8}", fullmatch=True), min_size=width, max_size=width))
    rows = draw(st.lists(st.tuples(*[values] * width), max_size=5))
    return Table(tuple(names), rows)


def test_text_is_the_table_of_the_book() -> None:
    assert to_text(HAND) == (
        " k  pₖ  (xₖ₊₁, yₖ₊₁)\n"
        " 0   6  (21, 11)\n"
        " 1   2  (22, 12)\n"
        "10  -2  (23, 12)\n"
    )  # fmt: skip


def test_names_of_variables_are_no_formulas() -> None:
    table = Table(("two_dy_minus_dx", "step_x"), ((1, 2),), formulas=False)
    assert to_text(table).split() == ["two_dy_minus_dx", "step_x", "1", "2"]


def test_text_without_subscripts() -> None:
    assert to_text(HAND, subscripts=False).splitlines()[0] == " k  p_k  (x_k+1, y_k+1)"


def test_table_without_rows_has_its_headings() -> None:
    empty = Table(("k", "p_k"), ())
    assert to_text(empty) == "k  pₖ\n"
    assert to_csv(empty) == "k,p_k\n"
    assert json.loads(to_json(empty)) == {"columns": ["k", "p_k"], "rows": []}


@pytest.mark.parametrize(
    ("heading", "small", "flat"),
    [
        ("p_k", "pₖ", "p_k"),
        ("x_{k+1}", "xₖ₊₁", "x_k+1"),
        ("p_{20}", "p₂₀", "p_20"),
        ("2Δy", "2Δy", "2Δy"),
        ("2r_x^2", "2rₓ²", "2r_x^2"),
        ("d_{i-1}^{r-1}", "dᵢ₋₁ʳ⁻¹", "d_i-1^r-1"),
        ("x_{Q}", "x_Q", "x_Q"),
        ("a_{k?}", "a_k?", "a_k?"),
    ],
)
def test_headings(heading: str, small: str, flat: str) -> None:
    assert typeset(heading) == small
    assert plain(heading) == flat


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (6, "6"),
        (-2.0, "-2"),
        (20.8, "20.8"),
        (1 / 3, "0.3333"),
        (-1e-9, "-1e-09"),
        (-0.0, "0"),
        (0.1 + 0.2, "0.3"),
        (math.inf, "inf"),
        (1e20, "1e+20"),
    ],
)
def test_numbers_as_the_course_writes_them(value: float, text: str) -> None:
    assert decimal(value) == text


@given(st.floats(-1e6, 1e6))
def test_a_shown_number_is_near_the_true_one(value: float) -> None:
    assert abs(float(decimal(value)) - value) <= 0.5e-4 + abs(value) * 1e-12


def test_values_of_arrays_and_numpy() -> None:
    assert shown(np.float64(3.5)) == "3.5"
    assert shown((np.int64(2), 3.0)) == "(2, 3)"
    assert shown([1, 2]) == "[1, 2]"
    assert shown(np.zeros((20, 30))) == "30 × 20"
    assert shown(True) == "True"
    assert shown(None) == ""


@given(tables())
def test_text_keeps_every_row_and_lines_up(table: Table) -> None:
    lines = to_text(table).split("\n")
    assert len(lines) == len(table.rows) + 2
    for row, line in zip(table.rows, lines[1:], strict=False):
        for value in row:
            assert shown(value).rstrip() in line


@given(tables())
def test_csv_keeps_every_digit(table: Table) -> None:
    heading, *rows = csv.reader(io.StringIO(to_csv(table)))
    assert tuple(heading) == table.columns
    assert len(rows) == len(table.rows)
    for row, cells in zip(table.rows, rows, strict=True):
        for value, cell in zip(row, cells, strict=True):
            if isinstance(value, float):
                assert float(cell) == value
            else:
                assert cell == str(value)


@given(tables())
def test_json_comes_back(table: Table) -> None:
    content = json.loads(to_json(table), parse_constant=lambda name: pytest.fail(f"{name} is no JSON"))
    assert content["columns"] == list(table.columns)
    for row, back in zip(table.rows, content["rows"], strict=True):
        finite = [str(v) if isinstance(v, float) and not math.isfinite(v) else v for v in row]
        assert back == [list(v) if isinstance(v, tuple) else v for v in finite]


def test_tsv_pastes_as_cells() -> None:
    assert to_tsv(HAND).splitlines()[1] == "0\t6\t(21, 11)"


class _Cells(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.rows: list[list[str]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_data(self, data: str) -> None:
        self.rows[-1][-1] += data


@given(tables())
def test_html_has_every_cell(table: Table) -> None:
    cells = _Cells()
    cells.feed(to_html(table))
    shown_rows = [[shown(value) for value in row] for row in table.rows]
    assert cells.rows == [list(table.columns), *shown_rows]


def test_html_escapes() -> None:
    assert re.search("<td>&lt;b&gt; &amp; c</td>", to_html(Table(("text",), (("<b> & c",),))))
