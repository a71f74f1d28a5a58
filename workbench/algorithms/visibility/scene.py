"""Two triangles that pierce one another, as the example of the visibility algorithms."""

import numpy as np

from workbench.algorithms.entry import Parameter

SCENE = (
    Parameter("image", "image", "image", np.zeros((10, 14), np.int64), meaning="the picture, drawn into"),
    Parameter("depth", "depth", "depth", np.ones((10, 14)), meaning="depth buffer, 1 is the farthest"),
    Parameter(
        "vertices",
        "vertices",
        "points",
        np.array(
            [[0, 1, 0.25], [12, 1, 0.75], [0, 9, 0.25], [2, 0, 0.5], [13, 4, 0.5], [4, 9, 0.5]], np.float64
        ),
        meaning="x and y in pixels, z from 0 (near) to 1 (far)",
    ),
    Parameter("faces", "faces", "ints", np.array([[0, 1, 2], [3, 4, 5]]), meaning="corners of each triangle"),
    Parameter("colours", "colours", "ints", np.array([1, 2]), meaning="colour of each triangle"),
    Parameter("low_row", "y_low", "int", 0, 0, 32767, "px", "first row of the band"),
    Parameter("high_row", "y_high", "int", 10, 0, 32768, "px", "one past the last row of the band"),
)
