"""The knobs of a monitor act on the grid, by the one law of the gun."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.scanning.electron_optics import beam_current
from workbench.display.monitor import CUT_OFF_V, Knobs, grid_voltage, level_current, level_of
from workbench.display.setup import TubeSetup, currents_of_colour, currents_of_image, raster_tube

levels = st.floats(0.0, 1.0)


@given(levels, st.floats(1.8, 3.0))
def test_in_their_middle_the_knobs_leave_the_law_of_the_gun(level: float, gamma: float) -> None:
    assert level_current(level, Knobs(), gamma) == pytest.approx(level**gamma, rel=1e-9, abs=1e-15)


@given(levels, st.floats(-0.5, 0.5), st.floats(0.0, 2.0))
def test_a_level_sets_the_grid_and_the_grid_the_current(level, brightness, contrast) -> None:
    knobs = Knobs(brightness, contrast)
    volts = grid_voltage(level, knobs)
    assert volts <= 0.0
    white = beam_current(grid_voltage(1.0, Knobs()), CUT_OFF_V, 1.0, 2.2)
    assert level_current(level, knobs, 2.2) == pytest.approx(beam_current(volts, CUT_OFF_V, 1.0, 2.2) / white)
    if volts < 0.0 and contrast > 0.01:
        assert level_of(volts, knobs) == pytest.approx(level, abs=1e-9)


def test_contrast_scales_and_brightness_moves() -> None:
    black, white = (grid_voltage(level, Knobs()) for level in (0.0, 1.0))
    assert (black, white) == (-60.0, -15.0)
    assert grid_voltage(1.0, Knobs(contrast=0.5)) == pytest.approx((black + white) / 2)
    assert grid_voltage(0.0, Knobs(contrast=0.5)) == black
    up = Knobs(brightness=0.2)
    assert grid_voltage(0.0, up) - black == pytest.approx(grid_voltage(0.6, up) - grid_voltage(0.6, Knobs()))


def test_turned_down_dim_levels_vanish_and_turned_up_blanking_shows() -> None:
    image = np.array([[0x000000, 0x303030, 0xFFFFFF]], np.uint32)
    usual, down, up = (TubeSetup(knobs=Knobs(brightness)) for brightness in (0.0, -0.25, 0.25))
    assert [(currents_of_image(image, 1, setup) > 0).ravel().tolist() for setup in (usual, down, up)] == [
        [False, True, True],
        [False, False, True],
        [True, True, True],
    ]
    assert currents_of_colour(0x303030, 1, down) == (0.0,)
    assert usual.blanked_current == 0.0
    assert up.blanked_current > 0.0
    assert up.blanked_current < up.current(0)


def test_a_brighter_tube_is_brighter_everywhere() -> None:
    image = np.zeros((12, 16), np.uint32)
    image[3:9, 4:12] = 0xFFFFFF
    maps = [
        raster_tube(image, (64, 48), TubeSetup(knobs=Knobs(brightness)))[1].energy_per_frame()
        for brightness in (0.0, 0.2)
    ]
    assert (maps[1] >= maps[0]).all()
    assert maps[1].min() >= 0.0
    assert maps[0][24, 2] < 1e-3 * maps[0].max() < maps[1][24, 10]
