"""PNG files read back by another decoder."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from workbench.exchange.pictures import png
from workbench.exchange.writing import write
from workbench.exchange.written import formats

pictures = arrays.arrays(
    np.uint32, st.tuples(st.integers(1, 9), st.integers(1, 9)), elements=st.integers(0, 0xFFFFFF)
)


def decoded(data: bytes) -> np.ndarray:
    """The picture as 0xRRGGBB, top row first, by OpenCV."""
    channels = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR).astype(np.uint32)
    return channels[..., 2] << 16 | channels[..., 1] << 8 | channels[..., 0]


@given(pictures, st.integers(1, 4))
def test_every_cell_has_its_colour_and_the_top_row_comes_first(image: np.ndarray, cell: int) -> None:
    height, width = image.shape
    told = decoded(png(image, cell))
    assert told.shape == (height * cell, width * cell)
    for row in range(height * cell):
        for column in range(width * cell):
            assert told[row, column] == image[height - 1 - row // cell, column // cell]


def test_saved_is_what_was_made(tmp_path: Path) -> None:
    image = np.array([[0xFF0000, 0x00FF00]], dtype=np.uint32)
    (row,) = formats("picture")
    assert write(row, (image, 3), tmp_path / "a.png") == [tmp_path / "a.png"]
    assert (tmp_path / "a.png").read_bytes() == png(image, 3)


@pytest.mark.parametrize("cell", [0, -1, 40_000])
def test_a_cell_that_does_not_fit_is_refused(cell: int) -> None:
    with pytest.raises(ValueError, match=r"cell|large"):
        png(np.zeros((2, 2), np.uint32), cell)
