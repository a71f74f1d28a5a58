"""The texts on colour beside the standard library and exact fractions."""

import colorsys
import math
from fractions import Fraction

from hypothesis import example, given
from hypothesis import strategies as st

from workbench.algorithms.colour.hsv_to_rgb import hsv_to_rgb
from workbench.algorithms.colour.rgb_to_cmy import rgb_to_cmy
from workbench.algorithms.colour.rgb_to_hsv import rgb_to_hsv

levels = st.one_of(st.sampled_from([0.0, 0.5, 1.0]), st.floats(0.0, 1.0, allow_subnormal=False))
colours = st.tuples(levels, levels, levels)
hues = st.one_of(st.sampled_from([0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0]), st.floats(0.0, 360.0))


def near(one, other, least=1e-12) -> bool:
    return all(math.isclose(a, b, rel_tol=1e-12, abs_tol=least) for a, b in zip(one, other, strict=True))


def apart(one: float, other: float) -> float:
    """Between two hues, the short way round."""
    return abs((one - other + 180.0) % 360.0 - 180.0)


@given(colours)
def test_light_and_ink_make_white(colour) -> None:
    (ink,) = rgb_to_cmy(*colour)
    assert [a + b for a, b in zip(colour, ink, strict=True)] == [1.0, 1.0, 1.0]


@given(colours)
def test_the_subtraction_undoes_itself(colour) -> None:
    (ink,) = rgb_to_cmy(*colour)
    (again,) = rgb_to_cmy(*ink)
    assert near(again, colour, 2.0**-53)


@given(colours)
@example((0.0, 0.0, 0.0))
@example((1.0, 0.0, 1.0))
def test_hue_saturation_and_value_are_those_of_the_standard_library(colour) -> None:
    ((h, s, v),) = rgb_to_hsv(*colour)
    hue, saturation, value = colorsys.rgb_to_hsv(*colour)
    assert near((s, v), (saturation, value))
    assert apart(h, 360.0 * hue) < 1e-9
    assert 0.0 <= h <= 360.0


@given(hues, levels, levels)
def test_red_green_and_blue_are_those_of_the_standard_library(h, s, v) -> None:
    (colour,) = hsv_to_rgb(h, s, v)
    assert near(colour, colorsys.hsv_to_rgb(h / 360.0, s, v))


@given(colours)
def test_there_and_back_is_the_same_colour(colour) -> None:
    (hsv,) = rgb_to_hsv(*colour)
    (again,) = hsv_to_rgb(*hsv)
    assert near(again, colour)


@given(hues, st.floats(0.01, 1.0), st.floats(0.01, 1.0))
def test_back_and_there_is_the_same_hue(h, s, v) -> None:
    (colour,) = hsv_to_rgb(h, s, v)
    ((hue, saturation, value),) = rgb_to_hsv(*colour)
    assert near((saturation, value), (s, v))
    assert apart(hue, h) < 1e-9


@given(colours)
def test_reckoned_in_fractions_it_is_the_same(colour) -> None:
    """By the angle on the hexagon that Foley draws, from the middle component alone."""
    ((h, s, v),) = rgb_to_hsv(*colour)
    r, g, b = (Fraction(level) for level in colour)
    low, middle, high = sorted((r, g, b))
    assert v == float(high)
    assert math.isclose(s, (high - low) / high if high else 0, abs_tol=1e-14)
    if high == low:
        assert h == 0.0
        return
    into = (middle - low) / (high - low)
    order = tuple("rgb"[k] for k in sorted(range(3), key=lambda k: (-(r, g, b)[k], k)))
    start, way = {
        ("r", "g", "b"): (0, 1),
        ("g", "r", "b"): (120, -1),
        ("g", "b", "r"): (120, 1),
        ("b", "g", "r"): (240, -1),
        ("b", "r", "g"): (240, 1),
        ("r", "b", "g"): (360, -1),
    }[order]
    assert apart(h, float(start + way * 60 * into)) < 1e-10


@given(hues, levels, levels)
def test_value_and_saturation_are_those_of_the_components(h, s, v) -> None:
    (colour,) = hsv_to_rgb(h, s, v)
    assert max(colour) == v
    assert math.isclose(min(colour), v * (1.0 - s), abs_tol=1e-15)
