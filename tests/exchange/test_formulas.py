"""The notation of formulas, its copies, and the layout of rows of matrices, with type of known widths."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.exchange.formulas.copying import (
    cell_text,
    latex,
    latex_formula,
    numpy_text,
    plain,
    plain_formula,
)
from workbench.exchange.formulas.layout import Glyphs, Line, Typesetter
from workbench.exchange.formulas.notation import parse
from workbench.exchange.formulas.rows import lay_out, widest_of
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Sign, displayed, matrix

CORNER = "x_p(1 - cos theta) + y_p sin theta"
finite = st.floats(allow_nan=False, allow_infinity=False)


class Typewriter:
    """Every character is 0.6 of the size wide."""

    def width(self, text, size, style):
        return 0.6 * size * len(text)

    def ascent(self, size):
        return 0.8 * size

    def descent(self, size):
        return 0.2 * size


def setter():
    return Typesetter(Typewriter())


def texts(primitives):
    return [each.text for each in primitives if isinstance(each, Glyphs)]


@pytest.mark.parametrize(
    ("written", "text", "tex"),
    [
        (CORNER, "x_p(1 − cos θ) + y_p sin θ", r"x_{p}(1 - \cos \theta) + y_{p} \sin \theta"),
        ("-sin theta", "−sin θ", r"-\sin \theta"),
        ("x_{k+1}^2", "x_k+1^2", r"x_{k + 1}^{2}"),
        ("t_i1*a_1j", "t_i1 · a_1j", r"t_{i1} \cdot a_{1j}"),
        ("x_vmin - s_x x_wmin", "x_vmin − s_x x_wmin", r"x_{\mathrm{vmin}} - s_{x} x_{\mathrm{wmin}}"),
        ("n_x/d", "n_x/d", r"n_{x}/d"),
        ("sin^2 theta", "sin^2 θ", r"\sin^{2} \theta"),
        ("T(-x_p,-y_p)", "T(−x_p, −y_p)", r"T(-x_{p}, -y_{p})"),
        ('T "waits"', "T waits", r"T \mathrm{waits}"),
        ("45°", "45°", r"45^{\circ}"),
    ],
)
def test_a_formula_reads_as_text_and_as_latex(written, text, tex):
    assert plain_formula(written) == text
    assert latex_formula(written) == tex


def test_variables_are_italic_numbers_and_functions_upright():
    glyphs = [each for each in setter().formula(CORNER, 10).primitives if isinstance(each, Glyphs)]
    italic = {each.text for each in glyphs if each.style == "italic"}
    upright = {each.text for each in glyphs if each.style == "upright"}
    assert italic == {"x", "y", "p", "θ"}
    assert upright == {"(", ")", "1", "−", "+", "cos", "sin"}


def test_a_subscript_is_smaller_and_lower_and_a_superscript_stands_over_it():
    x, below, above = setter().formula("x_p^2", 20).primitives
    assert below.y > x.y > above.y
    assert below.size == above.size < x.size
    assert below.x == above.x >= x.x + x.width


@given(st.text(alphabet="xyp_^{}()[]+-*/=,. '\"0129θcosdet\\$#&", max_size=24))
def test_no_text_breaks_the_notation_and_every_letter_stays(text):
    def letters(formula):
        for piece in formula:
            yield from (piece.text, *letters(piece.below), *letters(piece.above))

    read = "".join(letters(parse(text)))
    for letter in "xyp012θ":
        assert read.count(letter) >= text.count(letter) - text.count("theta")
    latex_formula(text)
    plain_formula(text)
    assert setter().formula(text, 13).width >= 0


@given(st.text(alphabet="xy{}_^+12", max_size=16))
def test_latex_keeps_its_braces_in_pairs(text):
    depth = 0
    tex = latex_formula(text).replace(r"\{", "").replace(r"\}", "")
    for sign in tex:
        depth += {"{": 1, "}": -1}.get(sign, 0)
        assert depth >= 0
    assert depth == 0


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1 + 0.2, "0.3"),
        (-0.0, "0"),
        (-1e-17, "0"),
        (math.cos(math.pi / 2), "0"),
        (-4.242640687, "−4.2426"),
        (1 / 3, "0.3333"),
        (-0.00004, "−4e−05"),
        (3.0, "3"),
        (12345.678912, "12345.6789"),
    ],
)
def test_numbers_are_rounded_as_the_course_writes_them(value, text):
    assert displayed(value) == text


@given(st.floats(-1e6, 1e6))
def test_a_displayed_number_is_near_and_short(value):
    text = displayed(value)
    assert abs(float(text.replace("−", "-")) - value) <= 5.1e-5
    assert text != "−0"
    assert "-" not in text


def row():
    product = Matrix(
        (
            (Cell("cos theta", 0.5), Cell(CORNER, 4.2)),
            (Cell("", -0.0), Cell("n_x/d", -0.25, hidden=True)),
        ),
        "M",
    )
    return (product, Sign("="), matrix([[1, 0.1 + 0.2]], [["1", "x_p"]], name="T(x_p)"), matrix([[2], [1]]))


def test_the_copy_as_latex():
    assert latex(row(), "symbols") == (
        r"\overset{M}{\begin{bmatrix} \cos \theta & x_{p}(1 - \cos \theta) + y_{p} \sin \theta \\ 0 & ?"
        r" \end{bmatrix}} = \overset{T(x_{p})}{\begin{bmatrix} 1 & x_{p} \end{bmatrix}}"
        r" \begin{bmatrix} 2 \\ 1 \end{bmatrix}"
    )
    assert r"\substack{\cos \theta \\ 0.5}" in latex(row(), "both")
    assert r"\substack{x_{p} \\ 0.3}" in latex(row(), "both")


def test_the_plain_copy_lines_its_columns_up():
    terms = (Phrase("M"), Sign("="), matrix([[1, -3], [0.5, 10]], name="T"), matrix([[2], [1]]))
    assert plain(terms).splitlines() == [
        "           T",
        "M  =  [   1  −3 ]  [ 2 ]",
        "      [ 0.5  10 ]  [ 1 ]",
    ]


@given(
    st.integers(1, 4).flatmap(
        lambda columns: st.lists(st.lists(finite, min_size=columns, max_size=columns), min_size=1, max_size=4)
    )
)
def test_numpy_reads_its_copy_back_to_the_last_digit(values):
    space = {"np": np}
    exec(numpy_text((matrix(values, name="M"),)), space)
    np.testing.assert_array_equal(space["M"], np.array(values))


@given(st.floats(-3, 3), st.floats(-9, 9), st.floats(-9, 9))
def test_a_symbol_without_a_number_is_copied_as_python_that_computes_it(theta, x, y):
    symbols = (CORNER, "2 x_p - -y_p^2", "-sin 2 theta", "x_p/2*y_p", "(1 - x_p)(2 + y_p)")
    wide = Matrix((tuple(Cell(symbol) for symbol in symbols[:4]),), "A")
    rest = Matrix(((Cell(symbols[4]), Cell("x_p =")),), "B")
    space = {"np": np, "theta": theta, "x_p": x, "y_p": y}
    exec(numpy_text((wide, rest)), space)
    s, c = math.sin(theta), math.cos(theta)
    np.testing.assert_allclose(
        space["A"], [[x * (1 - c) + y * s, 2 * x + y**2, -math.sin(2 * theta), x / 2 * y]], atol=1e-12
    )
    np.testing.assert_allclose(space["B"], [[(1 - x) * (2 + y), np.nan]], atol=1e-12)


def test_what_is_hidden_is_in_no_copy():
    copies = [plain(row(), "both"), latex(row(), "both"), numpy_text(row()), cell_text(row()[0].cells[1][1])]
    for copy in copies:
        assert "0.25" not in copy
        assert "n_" not in copy


@pytest.mark.parametrize("rows", [[], [[]], [[1], [1, 2]], [[1] * 5], [[1]] * 5])
def test_a_matrix_of_another_shape_is_refused(rows):
    with pytest.raises(ValueError, match="one to four rows"):
        Matrix(tuple(tuple(Cell("", value) for value in each) for each in rows))


def test_numbers_of_a_column_stand_on_their_points():
    box = setter().matrix(matrix([[0.7071, 1], [0, 1], [-4.2426, 1]]), "numbers", 10)
    points = [
        glyphs.x + 6 * len(glyphs.text.partition(".")[0])
        for glyphs in box.primitives
        if isinstance(glyphs, Glyphs) and glyphs.text in ("0.7071", "0", "−4.2426")
    ]
    assert points == pytest.approx([points[0]] * 3)


def test_every_cell_holds_its_text_and_the_brackets_hold_the_cells():
    for shows in ("symbols", "numbers", "both"):
        box = setter().matrix(row()[0], shows, 10)
        brackets = [each for each in box.primitives if isinstance(each, Line)]
        left, right = min(p[0] for p in brackets[0].points), max(p[0] for p in brackets[1].points)
        for cell in box.cells.values():
            assert left < cell.x
            assert cell.x + cell.width < right
        for glyphs in (each for each in box.primitives if isinstance(each, Glyphs) and each.text != "M"):
            assert any(
                c.x <= glyphs.x
                and glyphs.x + glyphs.width <= c.x + c.width
                and c.y <= glyphs.y <= c.y + c.height
                for c in box.cells.values()
            )


@given(st.floats(30, 900), st.sampled_from(["symbols", "numbers", "both"]))
def test_a_row_keeps_to_its_room_unless_one_term_is_wider_and_loses_nothing(room, shows):
    laid = lay_out(setter(), row(), shows, 12, room)
    assert laid.widest == widest_of(setter(), row(), shows, 12)
    assert laid.width <= max(room, laid.widest) + 1e-6
    wide = lay_out(setter(), row(), shows, 12, 1e6)
    assert texts(laid.primitives) == texts(wide.primitives)
    assert set(laid.cells) == set(wide.cells)
    for each in laid.primitives:
        if isinstance(each, Glyphs):
            assert 0 <= each.x <= each.x + each.width <= laid.width + 1e-6
            assert 0 <= each.y <= laid.height
    for a, b in itertools.combinations(laid.cells.values(), 2):
        apart = a.x + a.width <= b.x + 1e-6 or b.x + b.width <= a.x + 1e-6
        assert apart or a.y + a.height <= b.y + 1e-6 or b.y + b.height <= a.y + 1e-6


def test_a_sign_begins_the_line_of_what_follows_it():
    laid = lay_out(setter(), row(), "symbols", 12, 120)
    glyphs = [each for each in laid.primitives if isinstance(each, Glyphs)]
    sign = next(each for each in glyphs if each.text == "=")
    first_row = laid.cells[2, 0, 0]
    assert first_row.y <= sign.y <= first_row.y + first_row.height
    assert sign.x < first_row.x


def test_nothing_moves_while_numbers_grow_shorter():
    wide = lay_out(setter(), (matrix([[1.2345, 1]]), matrix([[2]])), "numbers", 12, 500)
    same = lay_out(setter(), (matrix([[1, 1]]), matrix([[2]])), "numbers", 12, 500, wide.columns)
    assert same.cells == wide.cells
