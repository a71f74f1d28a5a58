"""The window-to-viewport transformation.

sx, sy      scale factors: sides of the viewport over sides of the window
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def window_to_viewport(
    window: Sequence[float], viewport: Sequence[float], keep_aspect: bool = False
) -> NDArray[np.float64]:
    """The matrix that takes the window's rectangle to the viewport's: translate, scale, translate back.

    With ``keep_aspect`` both scale factors are the smaller one, and the window's picture lies in the
    middle of the viewport.

    Args: rectangles (xmin, ymin, xmax, ymax), the window in world coordinates, the viewport in device
    coordinates. Returns: (3, 3), homogeneous, for points as columns. Raises: ValueError when a rectangle
    is not finite or has no area. Source: Hearn and Baker, Computer Graphics, C Version, section 6-3.
    """
    # Measure both rectangles
    window_width, window_height = _sides("window", window)
    viewport_width, viewport_height = _sides("viewport", viewport)

    # Find the scale factors
    sx = viewport_width / window_width
    sy = viewport_height / window_height
    if keep_aspect:
        sx = sy = min(sx, sy)

    # Move the window's corner to the origin, scale, move to the viewport's corner
    left = viewport[0] + (viewport_width - sx * window_width) / 2 if keep_aspect else viewport[0]
    low = viewport[1] + (viewport_height - sy * window_height) / 2 if keep_aspect else viewport[1]
    to_origin = np.array([[1, 0, -window[0]], [0, 1, -window[1]], [0, 0, 1]], np.float64)
    scale = np.diag([sx, sy, 1.0])
    to_corner = np.array([[1, 0, left], [0, 1, low], [0, 0, 1]], np.float64)
    return to_corner @ scale @ to_origin


def _sides(name: str, rectangle: Sequence[float]) -> tuple[float, float]:
    """Width and height of a rectangle that has an area."""
    xmin, ymin, xmax, ymax = rectangle
    width, height = xmax - xmin, ymax - ymin
    if not (math.isfinite(width) and math.isfinite(height) and width > 0 and height > 0):
        raise ValueError(f"The {name} {tuple(rectangle)} has no area; give xmin < xmax and ymin < ymax.")
    return width, height
