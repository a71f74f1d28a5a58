"""Makes the picture of a screen of one colour by compiled texts, in arrays that are made once."""

import numpy as np
from numpy.typing import NDArray

from workbench.display.face_kernels import print_picture, run, shrink_rows
from workbench.display.spot import ends

Array = NDArray[np.float32]

_NEGLIGIBLE = 1e-3
"""Of the halo's greatest share, which is itself a small part of the light."""


class Printer:
    """``table`` are colours, ``noise`` (rows, columns) the dither; ``halo`` are the matrices that shrink and
    enlarge (down x, down y, up x, up y); ``scale`` is how many steps a root of 1 has, and the last step.
    """

    def __init__(
        self,
        table: NDArray[np.uint32],
        noise: Array,
        halo: tuple[Array, Array, Array, Array],
        scale: tuple[float, float],
    ) -> None:
        down_x, self._down, up_x, self._up = halo
        rows, columns = noise.shape
        few_rows, few = len(self._down), len(down_x)
        self._table, self._noise = table[None], noise
        self._across = np.ascontiguousarray(down_x.T)
        self._wide = np.ascontiguousarray(up_x.T)
        self._down_bands = ends(self._down.T, _NEGLIGIBLE * float(self._down.max()))
        self._wide_bands = ends(self._wide, _NEGLIGIBLE * float(up_x.max()))
        self._scale = np.array([[*scale, 0.0]], np.float32)
        self._shrunk = np.empty((few_rows, columns), np.float32)
        self._small = np.empty((few_rows, few), np.float32)
        self._halo = np.empty((rows, few), np.float32)
        self._row = np.empty((1, columns), np.float32)
        self._picture = np.empty((rows, columns), np.uint32)

    def picture(self, light: Array) -> NDArray[np.uint32]:
        """0xFFRRGGBB, top row first, of a luminance (rows, columns); the same array each time."""
        run(shrink_rows, self._shrunk, light, self._down, self._down_bands)
        np.matmul(self._shrunk, self._across, out=self._small)
        np.matmul(self._up, self._small, out=self._halo)
        run(
            print_picture,
            self._picture,
            self._row,
            light,
            self._halo,
            self._wide,
            self._wide_bands,
            self._noise,
            self._table,
            self._scale,
        )
        return self._picture
