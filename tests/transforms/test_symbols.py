"""Matrices with symbols: as the course writes them, and worth what their numbers say."""

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.transforms.inputs import angles, coordinates, factors
from workbench.algorithms.transforms import (
    SymbolicMatrix,
    multiplied_out,
    product,
    reflection,
    reflection_chain,
    rotation,
    rotation_about,
    rotation_about_chain,
    row_times_column,
    scaling,
    scaling_about,
    scaling_about_chain,
    shear,
    symbolic_matrix,
    symbolic_reflection,
    symbolic_rotation,
    symbolic_scaling,
    symbolic_shear,
    symbolic_translation,
    translation,
)
from workbench.algorithms.transforms.symbols import written_out
from workbench.algorithms.transforms.terms import Expression, constant, cosine, factor, place, sine
from workbench.algorithms.viewing import Mode, window_chain, window_to_viewport

LAST = ("0", "0", "1")


def test_the_matrix_of_the_paper_is_multiplied_out_as_the_paper_writes_it() -> None:
    chain = rotation_about_chain(math.radians(45), 3, 3)
    assert [link.name for link in chain] == ["T(x_p, y_p)", "R(θ)", "T(−x_p, −y_p)"]
    assert [link.texts for link in chain] == [
        (("1", "0", "x_p"), ("0", "1", "y_p"), LAST),
        (("cos θ", "−sin θ", "0"), ("sin θ", "cos θ", "0"), LAST),
        (("1", "0", "−x_p"), ("0", "1", "−y_p"), LAST),
    ]
    first, whole = multiplied_out(chain)
    assert first.name == "R(θ) T(−x_p, −y_p)"
    assert first.texts == (
        ("cos θ", "−sin θ", "−x_p cos θ + y_p sin θ"),
        ("sin θ", "cos θ", "−x_p sin θ − y_p cos θ"),
        LAST,
    )
    assert whole.name == "T(x_p, y_p) R(θ) T(−x_p, −y_p)"
    assert whole.texts == (
        ("cos θ", "−sin θ", "x_p(1 − cos θ) + y_p sin θ"),
        ("sin θ", "cos θ", "y_p(1 − cos θ) − x_p sin θ"),
        LAST,
    )
    np.testing.assert_allclose(whole.matrix, rotation_about(math.radians(45), 3, 3), atol=1e-15)


def test_a_cell_before_it_is_worked_out() -> None:
    chain = rotation_about_chain(1.0, 3, 3)
    assert row_times_column(chain[1], chain[2], 0, 2) == "cos θ·(−x_p) + (−sin θ)·(−y_p) + 0·1"
    whole = multiplied_out(chain)[-1]
    assert row_times_column(chain[0], whole, 1, 2) == (
        "0·(x_p(1 − cos θ) + y_p sin θ) + 1·(y_p(1 − cos θ) − x_p sin θ) + y_p·1"
    )


def test_the_elementary_links_as_the_course_writes_them() -> None:
    assert symbolic_translation(3, 4).texts == (("1", "0", "t_x"), ("0", "1", "t_y"), LAST)
    assert symbolic_scaling(3, 4).texts == (("s_x", "0", "0"), ("0", "s_y", "0"), LAST)
    assert symbolic_shear(3, 4, 1, 2).texts == (
        ("1", "sh_x", "−sh_x y_{ref}"),
        ("sh_y", "1", "−sh_y x_{ref}"),
        LAST,
    )
    assert symbolic_reflection(1, 2, 0.5).texts == (
        ("cos 2φ", "sin 2φ", "x_p(1 − cos 2φ) − y_p sin 2φ"),
        ("sin 2φ", "−cos 2φ", "y_p(1 + cos 2φ) − x_p sin 2φ"),
        LAST,
    )
    assert multiplied_out(scaling_about_chain(2, 3, 1, 1))[-1].texts == (
        ("s_x", "0", "x_p(1 − s_x)"),
        ("0", "s_y", "y_p(1 − s_y)"),
        LAST,
    )
    assert symbolic_matrix(np.eye(3), index="2").texts[0] == ("m_{112}", "m_{122}", "m_{132}")


def test_two_links_of_one_kind_are_told_apart() -> None:
    (both,) = multiplied_out([symbolic_rotation(0.5, "1"), symbolic_rotation(0.25, "2")])
    assert both.name == "R(θ_1) R(θ_2)"
    assert both.texts[0][0] == "cos θ_1 cos θ_2 − sin θ_1 sin θ_2"
    (moved,) = multiplied_out([symbolic_translation(1, 2, "1"), symbolic_translation(3, 4, "2")])
    assert moved.texts[0] == ("1", "0", "t_{x1} + t_{x2}")


def test_a_reflection_by_five_matrices_is_that_of_the_double_angle() -> None:
    products = multiplied_out(reflection_chain(0, 2, math.atan(0.5)))
    assert products[2].texts[0][2] == "−x_p(cos² φ − sin² φ) − 2y_p cos φ sin φ"
    assert products[-1].texts == (
        ("cos² φ − sin² φ", "2 cos φ sin φ", "2x_p sin² φ − 2y_p cos φ sin φ"),
        ("2 cos φ sin φ", "−cos² φ + sin² φ", "−2x_p cos φ sin φ + 2y_p cos² φ"),
        LAST,
    )
    np.testing.assert_allclose(products[-1].matrix, reflection(0, 2, math.atan(0.5)), atol=1e-12)


@pytest.mark.parametrize("mode", ["stretch", "fit", "fill"])
def test_the_window_with_symbols(mode: Mode) -> None:
    window, viewport = (1.0, 1.0, 4.0, 4.0), (3.0, 2.0, 6.0, 6.0)
    whole = multiplied_out(window_chain(window, viewport, mode))[-1]
    x, y = ("x_{vmin}", "y_{vmin}") if mode == "stretch" else ("x_0", "y_0")
    assert whole.texts == (
        ("s_x", "0", f"{x} − s_x x_{{wmin}}"),
        ("0", "s_y", f"{y} − s_y y_{{wmin}}"),
        LAST,
    )
    np.testing.assert_allclose(whole.matrix, window_to_viewport(window, viewport, mode), atol=1e-12)


def test_cosine_and_sine_squared_are_one() -> None:
    cos, sin, x = cosine("θ", 0.6), sine("θ", 0.8), place("x", 5)
    other_cos, other_sin = cosine("φ", 0.0), sine("φ", 1.0)
    assert (cos * cos + sin * sin).text == "1"
    assert (x * cos * cos + x * sin * sin - x).text == "0"
    assert (constant(1) - sin * sin).text == "1 − sin² θ"
    assert (cos * cos - sin * sin).text == "cos² θ − sin² θ"
    assert (cos * cos + other_sin * other_sin).text == "cos² θ + sin² φ"
    both = (cos * cos + sin * sin) * other_cos + constant(2) * other_cos
    assert both.text == "3 cos φ"
    assert (cos * cos * cos * cos + constant(2) * cos * cos * sin * sin + sin * sin * sin * sin).text == "1"


# Each link with symbols beside the function that gives its numbers
_LINKS = (
    (symbolic_translation, translation, (coordinates, coordinates)),
    (symbolic_rotation, rotation, (angles,)),
    (symbolic_scaling, scaling, (factors, factors)),
    (symbolic_shear, shear, (factors, factors, coordinates, coordinates)),
    (symbolic_reflection, reflection, (coordinates, coordinates, angles)),
)


@st.composite
def links(draw: st.DrawFn) -> tuple[list[SymbolicMatrix], list[np.ndarray]]:
    """Some links, all their symbols with names of their own, and their matrices."""
    written, numbers = [], []
    for index in range(draw(st.integers(1, 4))):
        symbolic, plain, taken = draw(st.sampled_from(_LINKS))
        values = [draw(each) for each in taken]
        written.append(symbolic(*values, index=str(index + 1)))
        numbers.append(plain(*values))
    return written, numbers


@given(chain=links())
def test_a_chain_with_symbols_is_worth_the_product_of_its_matrices(
    chain: tuple[list[SymbolicMatrix], list[np.ndarray]],
) -> None:
    written, numbers = chain
    for link, matrix in zip(written, numbers, strict=True):
        np.testing.assert_allclose(link.matrix, matrix, atol=1e-9, rtol=1e-12)
    products = multiplied_out(written)
    sizes = product(*(np.abs(matrix) for matrix in numbers)).max() + 1e4
    for count, whole in enumerate(products, 2 if len(written) > 1 else 1):
        assert (np.abs(whole.matrix - product(*numbers[-count:])) <= 1e-10 * sizes).all()


@given(theta=angles, x=coordinates, y=coordinates, sx=factors, sy=factors)
def test_the_chains_about_a_point_are_the_closed_forms(
    theta: float, x: float, y: float, sx: float, sy: float
) -> None:
    for chain, closed in (
        (rotation_about_chain(theta, x, y), rotation_about(theta, x, y)),
        (scaling_about_chain(sx, sy, x, y), scaling_about(sx, sy, x, y)),
        (reflection_chain(x, y, theta), reflection(x, y, theta)),
    ):
        np.testing.assert_allclose(multiplied_out(chain)[-1].matrix, closed, atol=1e-9)


# What is written is read back as a reader would, apart from the algebra

_ANGLE = r"\d?[θφ](?:_\w|_\{\w+\})?"
_TURN = re.compile(rf"(cos|sin)([²³⁴-⁹]?) ({_ANGLE})")
_TOKEN = re.compile(rf"(?:cos|sin)[²³⁴-⁹]? {_ANGLE}|[a-z]+_(?:\w|\{{\w+\}})|[\d.]+|[²³⁴-⁹]|[()+−]")
_RAISED = str.maketrans("²³⁴⁵⁶⁷⁸⁹", "23456789")


def read(text: str, values: dict[str, float]) -> float:
    """The value of a text in course notation."""
    tokens = _TOKEN.findall(text)
    assert "".join(tokens).replace(" ", "") == text.replace(" ", "")
    python, after_a_factor = "", False
    for token in tokens:
        if token in "+−)":
            python += token.replace("−", "-")
            after_a_factor = token == ")"
        elif token in "²³⁴⁵⁶⁷⁸⁹":
            python += f"**{token.translate(_RAISED)}"
        else:
            turn = _TURN.fullmatch(token)
            name, power = (f"{turn[1]} {turn[3]}", turn[2]) if turn else (token, "")
            python += "*" if after_a_factor else ""
            python += f"({values[name]!r})" if name in values else name
            python += f"**{power.translate(_RAISED)}" if power else ""
            after_a_factor = token != "("
    return float(eval(python))


def named(expression: Expression) -> dict[str, float]:
    return {symbol.text: symbol.value for terms in expression.terms for symbol, _power in terms}


@given(chain=links())
def test_what_is_written_is_worth_its_number(
    chain: tuple[list[SymbolicMatrix], list[np.ndarray]],
) -> None:
    written, numbers = chain
    size = product(*(np.abs(matrix) for matrix in numbers)).max() + 1e4
    for row in multiplied_out(written)[-1].cells:
        for cell in row:
            assert read(cell.text, named(cell)) == pytest.approx(cell.value, abs=1e-9 * size)


def test_reading_back_would_see_a_wrong_sign() -> None:
    values = {"x_p": 3.0, "y_p": 5.0, "cos θ": 0.6, "sin θ": 0.8}
    assert read("x_p(1 − cos θ) + y_p sin θ", values) == pytest.approx(3 * 0.4 + 5 * 0.8)
    assert read("2x_p sin² θ − y_p³", values) == pytest.approx(2 * 3 * 0.64 - 125)
    assert read("−x_p(1 − cos θ)", values) == pytest.approx(-1.2)


@given(a=factors, b=factors)
def test_sums_and_products_follow_the_rules_of_arithmetic(a: float, b: float) -> None:
    s, x, one = factor("s", a), place("x", b), constant(1)
    assert ((s + x) * (s - x)).terms == (s * s - x * x).terms
    assert (s + one - s).text == "1"
    assert (s - s).text == "0"
    assert (-(s * x)).value == -(a * b)


@given(angles, coordinates, coordinates, factors, factors, st.integers(1, 3))
def test_a_chain_is_written_out_as_it_is_multiplied_out(
    theta: float, x: float, y: float, sx: float, sy: float, count: int
) -> None:
    links = (
        *rotation_about_chain(theta, x, y),
        *scaling_about_chain(sx, sy, y, x),
        *reflection_chain(x, y, theta),
    )[-count:]
    *factors_written, whole = written_out(links)
    assert factors_written == [link.texts for link in links]
    assert whole == multiplied_out(links)[-1].texts
