"""The beam-penetration tube: the energy of the beam, shared by two layers."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.display.penetration import (
    COLOURS,
    MOST_KV,
    STOPPED_KV,
    coded_layers,
    energy_left_kv,
    nearest_named,
    power,
    shares,
)

volts = st.floats(0.1, 40.0)


@given(volts)
def test_both_layers_together_take_all_of_the_energy(kilovolts: float) -> None:
    red, green = shares(kilovolts)
    assert math.isclose(red + green, 1.0)
    assert 0.0 <= green < 1.0
    assert (green == 0.0) == (kilovolts <= STOPPED_KV)


@given(volts, st.floats(1.01, 2.0))
def test_a_faster_beam_never_glows_redder(kilovolts: float, factor: float) -> None:
    assert shares(factor * kilovolts)[0] <= shares(kilovolts)[0]


@given(st.floats(STOPPED_KV, 40.0))
def test_the_square_of_the_energy_falls_by_the_same_in_the_layer(kilovolts: float) -> None:
    """The law of Thomson and Whiddington, by steps through the layer instead of at once."""
    square, steps = kilovolts**2, 1000
    for _layer in range(steps):
        square -= STOPPED_KV**2 / steps
    assert math.isclose(energy_left_kv(kilovolts), math.sqrt(max(square, 0.0)), abs_tol=1e-4)


def test_the_four_colours_go_from_red_to_green() -> None:
    greens = [shares(one.kilovolts)[1] for one in COLOURS]
    assert [one.name for one in COLOURS] == ["red", "orange", "yellow", "green"]
    assert greens == sorted(greens)
    assert greens[0] == 0.0
    assert greens[3] > 0.8


@pytest.mark.parametrize("gamma", [1.0, 2.2])
@pytest.mark.parametrize("kilovolts", [4.0, 6.3, 7.0, 12.0])
def test_the_coded_colour_drives_each_gun_as_its_layer_glows(kilovolts: float, gamma: float) -> None:
    packed = coded_layers(kilovolts, gamma)
    for shift, share in zip((16, 8), shares(kilovolts), strict=True):
        current = ((packed >> shift & 255) / 255.0) ** gamma
        assert abs(current - share * power(kilovolts)) < 0.01
    assert packed & 255 == 0
    assert coded_layers(MOST_KV, gamma) >> 8 & 255 == 255


@pytest.mark.parametrize(
    ("hue", "saturation", "name"),
    [
        (5, 1.0, "red"),
        (355, 1.0, "red"),
        (28, 1.0, "orange"),
        (60, 1.0, "yellow"),
        (200, 1.0, "green"),
        (0, 0.0, "yellow"),
    ],
)
def test_a_stroke_gets_the_nearest_colour_that_there_is(hue: float, saturation: float, name: str) -> None:
    assert nearest_named(hue, saturation).name == name


@pytest.mark.parametrize("kilovolts", [0.0, -3.0, math.nan])
def test_without_voltage_no_beam_reaches_the_screen(kilovolts: float) -> None:
    with pytest.raises(ValueError, match="above 0 kV"):
        shares(kilovolts)
