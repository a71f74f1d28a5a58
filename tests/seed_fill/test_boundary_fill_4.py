"""The boundary fill against connected components found by scikit-image."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from numpy.typing import NDArray
from skimage.measure import label

from workbench.algorithms.seed_fill import boundary_fill_4
from workbench.algorithms.seed_fill.example import picture

FILL, BOUNDARY = 2, 1
images = st.sampled_from([np.uint8, np.int64, np.uint32]).flatmap(
    lambda kind: arrays(kind, array_shapes(min_dims=2, max_dims=2, max_side=12), elements=st.integers(0, 3))
)


def text(image: NDArray[Any]) -> list[str]:
    return ["".join(map(str, row)) for row in image[::-1]]


@given(image=images, x=st.integers(-2, 13), y=st.integers(-2, 13))
def test_it_colours_the_region_of_the_seed_each_pixel_once(image: NDArray[Any], x: int, y: int) -> None:
    height, width = image.shape
    regions = label((image != BOUNDARY) & (image != FILL), connectivity=1, background=0)
    inside = 0 <= x < width and 0 <= y < height and regions[y, x] != 0
    region = regions == regions[y, x] if inside else np.zeros(image.shape, bool)
    expected = np.where(region, FILL, image)
    emitted = list(boundary_fill_4(image, x, y, FILL, BOUNDARY))
    assert np.array_equal(image, expected)
    assert len(set(emitted)) == len(emitted) == region.sum()
    assert {(x, y) for x, y in emitted} == {(x, y) for y, x in np.argwhere(region).tolist()}


def test_a_diagonal_boundary_holds() -> None:
    image = picture(
        "00100",
        "01010",
        "10001",
        "01010",
        "00100",
    )
    assert len(list(boundary_fill_4(image, 2, 2, FILL, BOUNDARY))) == 5
    assert text(image) == [
        "00100",
        "01210",
        "12221",
        "01210",
        "00100",
    ]


def test_colours_other_than_the_boundary_are_filled_over() -> None:
    image = picture("3033", "1111")
    list(boundary_fill_4(image, 0, 1, FILL, BOUNDARY))
    assert text(image) == ["2222", "1111"]


@pytest.mark.parametrize("seed", [(-1, 0), (0, -1), (4, 0), (0, 2)])
def test_a_seed_outside_the_picture_colours_nothing(seed: tuple[int, int]) -> None:
    image = picture("0000", "0000")
    assert list(boundary_fill_4(image, *seed, FILL, BOUNDARY)) == []
    assert not image.any()
