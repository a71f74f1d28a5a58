"""The mask of a colour tube: a factor on each beam's light that changes no mean."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.display.colour_tube import ColourSetup, ColourTube, as_levels, packed_levels
from workbench.display.mask import KINDS, lit_share, mask_maps

MASKS = [kind for kind in KINDS if kind != "none"]
WINDOW = (100.0, 80.0, 112.0, 89.0)
SIZE = (160, 120)
WHITE = np.full((48, 64), 0xFFFFFF, np.uint32)


@pytest.mark.parametrize("kind", MASKS)
@pytest.mark.parametrize("pitch", [0.31, 0.9])
def test_a_mask_changes_no_mean(kind, pitch: float) -> None:
    """Over a whole number of its cells."""
    up = {"delta": math.sqrt(3.0), "in_line": 1.6, "grille": 1.0}[kind]
    across, high = 12, 8
    window = (0.0, 0.0, 2 * across * pitch, high * up * pitch)
    size = 2 * across * 16, round(high * up * 16)
    for one in mask_maps(kind, pitch, window, size):
        assert abs(float(one.mean()) - 1.0) < 0.005
        assert math.isclose(float(one.max()), 1.0 / lit_share(kind), rel_tol=0.01)


@pytest.mark.parametrize("kind", MASKS)
def test_no_place_glows_in_two_colours(kind) -> None:
    """But for the edges, whose pixels a grain covers in part."""
    maps = mask_maps(kind, 1.2, WINDOW, (800, 600))
    full = [one * lit_share(kind) > 0.999 for one in maps]
    assert sum(map(np.sum, full)) > 0
    assert not (full[0] & full[1]).any()
    assert not (full[1] & full[2]).any()
    assert not (full[0] & full[2]).any()


@pytest.mark.parametrize("kind", MASKS)
@given(shift=st.integers(-40, 40), rise=st.integers(-40, 40))
@settings(max_examples=12, deadline=None)
def test_the_mask_lies_still_whatever_part_is_looked_at(kind, shift: int, rise: int) -> None:
    left, bottom, right, top = WINDOW
    dx, dy = shift * (right - left) / SIZE[0], rise * (top - bottom) / SIZE[1]
    here = mask_maps(kind, 0.7, WINDOW, SIZE)[1]
    there = mask_maps(kind, 0.7, (left + dx, bottom + dy, right + dx, top + dy), SIZE)[1]
    columns = slice(max(shift, 0), SIZE[0] + min(shift, 0)), slice(max(-shift, 0), SIZE[0] - max(shift, 0))
    rows = slice(max(rise, 0), SIZE[1] + min(rise, 0)), slice(max(-rise, 0), SIZE[1] - max(rise, 0))
    assert np.allclose(here[rows[0], columns[0]], there[rows[1], columns[1]], atol=1e-3)


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_too_fine_to_draw_is_its_mean(kind) -> None:
    for one in mask_maps(kind, 0.05, WINDOW, SIZE):
        assert (one == 1.0).all()


@pytest.mark.parametrize("kind", KINDS)
def test_the_light_of_a_white_field_is_the_same_behind_every_mask(kind) -> None:
    """Every gun's mean is that without a mask, since a mask is a factor whose mean is 1."""
    wide = (100.0, 70.0, 100.0 + 40 * 0.9, 70.0 + 30 * 0.9)
    bare = ColourTube(WHITE, wide, SIZE, ColourSetup("none"))
    tube = ColourTube(WHITE, wide, SIZE, ColourSetup(kind, 0.9))
    for light, even in zip(tube.lights, bare.lights, strict=True):
        assert math.isclose(float(light.mean()), float(even.mean()), rel_tol=0.03)


def test_an_error_of_convergence_moves_one_beam_and_keeps_its_energy() -> None:
    image = np.zeros((48, 64), np.uint32)
    image[20:28, 28:36] = 0xFFFFFF
    face = (0.0, 0.0, 240.0, 180.0)
    true = ColourTube(image, face, SIZE, ColourSetup("none"))
    off = ColourTube(image, face, SIZE, ColourSetup("none", 0.6, ((3.0, -1.5), (0.0, 0.0), (0.0, 0.0))), true)
    y, x = np.mgrid[0 : SIZE[1], 0 : SIZE[0]] * 1.5
    red, moved = true.lights[0], off.lights[0]
    assert math.isclose(float(moved.sum()), float(red.sum()), rel_tol=1e-4)
    assert math.isclose(
        float((x * moved).sum() / moved.sum() - (x * red).sum() / red.sum()), 3.0, abs_tol=1e-3
    )
    assert math.isclose(
        float((y * moved).sum() / moved.sum() - (y * red).sum() / red.sum()), -1.5, abs_tol=1e-3
    )
    for before, after in zip(true.lights[1:], off.lights[1:], strict=True):
        assert np.array_equal(before, after)


def test_a_colour_lights_the_grains_of_its_beams_alone() -> None:
    yellow = np.full((48, 64), 0xFFFF00, np.uint32)
    red, green, blue = ColourTube(yellow, WINDOW, SIZE, ColourSetup("delta", 0.9)).lights
    assert red.max() > 1.0
    assert green.max() > 1.0
    assert blue.max() == 0.0


def test_a_close_up_is_a_part_of_the_face() -> None:
    """The same light, seen larger: the mean of a part is what the whole face has there."""
    image = np.zeros((48, 64), np.uint32)
    image[:, 32:] = 0x808080
    whole = ColourTube(image, (0.0, 0.0, 240.0, 180.0), (240, 180), ColourSetup("none"))
    part = ColourTube(image, (150.0, 80.0, 162.0, 89.0), (120, 90), ColourSetup("none"))
    assert math.isclose(
        float(part.lights[1].mean()), float(whole.lights[1][80:89, 150:162].mean()), rel_tol=0.02
    )


def test_three_beams_keep_one_time() -> None:
    tube = ColourTube(WHITE, WINDOW, SIZE, ColourSetup())
    tube.advance(Fraction(10**9), False)
    changed = ColourTube(
        WHITE, WINDOW, SIZE, ColourSetup(errors_mm=((0.0, 0.0), (1.0, 0.0), (0.0, 0.0))), tube
    )
    assert {driver.tube.seconds for driver in changed.drivers} == {Fraction(1, 1000)}


@given(st.integers(0, 0xFFFFFF))
def test_a_coded_colour_and_its_levels_are_the_same(packed: int) -> None:
    assert packed_levels(as_levels(packed)) == packed
