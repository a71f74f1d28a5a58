"""Under the magnifying glass the raster shows its stairs and the strokes none."""

import numpy as np
import pytest

from workbench.display.magnified import magnified_raster, magnified_vector, part_of
from workbench.display.setup import TubeSetup

SIZE = (64, 48)
SETUP = TubeSetup()


def brightness(pixels: np.ndarray) -> np.ndarray:
    """The green of each pixel."""
    return (pixels >> 8 & 0xFF).astype(float)


@pytest.mark.parametrize(("power", "side"), [(2.0, 25), (6.0, 9), (40.0, 3)])
def test_the_part_is_an_odd_number_of_pixels_around_the_place(power: float, side: int) -> None:
    x, y, across, up = part_of(SIZE, (20.0, 30.0), power)
    assert (across, up) == (side, side)
    assert (x + side // 2, y + side // 2) == (20, 30)


def test_one_line_has_stairs_on_the_raster_and_none_as_a_stroke() -> None:
    image = np.zeros((48, 64), np.uint32)
    for x in range(64):
        image[10 + (x + 1) // 4, x] = 0xFFFFFF
    place = (32.0, 18.0)
    raster = brightness(magnified_raster(image, SETUP, place, 6.0, 90))
    stroke = np.array([[0.0, 10.25, 63.0, 26.0, 0xFFFFFF]])
    vector = brightness(magnified_vector(stroke, SETUP, SIZE, place, 6.0, 90))

    def off(pixels: np.ndarray) -> float:
        """How far the brightest places of the columns lie off a straight line, at most, in rows."""
        columns = np.arange(15, 75)
        weights = pixels[:, columns] + 1e-9
        heights = (weights * np.arange(90)[:, None]).sum(axis=0) / weights.sum(axis=0)
        return float(np.abs(heights - np.polyval(np.polyfit(columns, heights, 1), columns)).max())

    assert off(vector) < 0.5
    assert off(raster) > 4 * off(vector)


def test_beyond_the_picture_it_is_dark() -> None:
    image = np.full((48, 64), 0xFFFFFF, np.uint32)
    corner = brightness(magnified_raster(image, SETUP, (0.0, 0.0), 6.0, 90))
    assert corner[:30, 60:].mean() > 100
    assert corner[70:, :20].mean() < 20
    nothing = np.empty((0, 5))
    assert brightness(magnified_vector(nothing, SETUP, SIZE, (0.0, 0.0), 6.0, 60)).max() < 32
