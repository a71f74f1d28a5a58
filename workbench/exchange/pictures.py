"""Pictures as PNG files."""

import io

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.conventions import top_row_first
from workbench.language import _

_LARGEST_SIDE = 32_767


def png(image: NDArray[np.uint32], cell: int = 1) -> bytes:
    """A PNG of ``image``, an (h, w) array of 0xRRGGBB with row 0 lowest; each pixel becomes cell x cell.

    Raises:
        ValueError: the cell is not at least 1, or a side of the result would exceed 32767 pixels.
    """
    height, width = image.shape
    refuse_cell((height, width), cell)
    packed = top_row_first(image)
    channels = np.stack([packed >> 16 & 255, packed >> 8 & 255, packed & 255], axis=-1).astype(np.uint8)
    from PIL import Image

    picture = Image.fromarray(channels)
    if cell > 1:
        picture = picture.resize((width * cell, height * cell), Image.Resampling.NEAREST)
    file = io.BytesIO()
    picture.save(file, "PNG")
    return file.getvalue()


def refuse_cell(shape: tuple[int, ...], cell: int) -> None:
    """Raises: ValueError, as ``png`` does for an image (h, w) of this shape."""
    height, width = shape
    if cell < 1:
        raise ValueError(_("The cell is {cell} pixels wide; it must be at least 1.").format(cell=cell))
    if max(height, width) * cell > _LARGEST_SIDE:
        sentence = _(
            "A picture of {width} × {height} pixels is too large; with at most {most} for a cell it fits."
        )
        most = _LARGEST_SIDE // max(height, width)
        raise ValueError(sentence.format(width=width * cell, height=height * cell, most=most))
