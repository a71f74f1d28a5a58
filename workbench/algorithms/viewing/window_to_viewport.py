"""The window-to-viewport transformation.

sx, sy      scale factors: sides of the viewport over sides of the window
"""

import math
from collections.abc import Sequence
from typing import Literal

from workbench.algorithms.transforms.chain import Matrix
from workbench.algorithms.transforms.plane import scaling, translation

Mode = Literal["stretch", "fit", "fill"]
"""How a window comes into a viewport of another shape.

``stretch`` takes the corners to the corners and may distort. The others scale x and y alike, and the middle
goes to the middle: ``fit`` shows the whole window, ``fill`` leaves nothing of the viewport empty, and what
lies beyond it is to be clipped.
"""

Rectangle = Sequence[float]
UNIT_SQUARE = (0.0, 0.0, 1.0, 1.0)


def window_to_viewport(window: Rectangle, viewport: Rectangle, keep_aspect: bool | Mode = False) -> Matrix:
    """The matrix that takes the window to the viewport: translate, scale, translate.

    ``keep_aspect`` is a mode; False is ``stretch`` and True is ``fit``.

    Args: rectangles (xmin, ymin, xmax, ymax), the window in world coordinates, the viewport in device
    coordinates. Returns: (3, 3), homogeneous, for points as columns. Raises: ValueError when a rectangle
    is not finite or has no area. Source: Hearn and Baker, Computer Graphics, C Version, section 6-3.
    """
    mode: Mode = keep_aspect if isinstance(keep_aspect, str) else "fit" if keep_aspect else "stretch"
    moved, scaled = window_to_origin(window), window_scaling(window, viewport, mode)
    return origin_to_viewport(window, viewport, mode) @ scaled @ moved


def window_to_origin(window: Rectangle) -> Matrix:
    """The first factor: the window's lower left corner goes to the origin."""
    return translation(-window[0], -window[1])


def window_scaling(window: Rectangle, viewport: Rectangle, mode: Mode = "stretch") -> Matrix:
    """The second factor: the window, its corner at the origin, gets its size on the device.

    Raises: ValueError when a rectangle is not finite or has no area.
    """
    return scaling(*scale_factors(window, viewport, mode))


def origin_to_viewport(window: Rectangle, viewport: Rectangle, mode: Mode = "stretch") -> Matrix:
    """The third factor: the origin goes to the viewport's lower left corner, or where the middles agree.

    Raises: ValueError when a rectangle is not finite or has no area.
    """
    if mode == "stretch":
        return translation(viewport[0], viewport[1])
    sx, sy = scale_factors(window, viewport, mode)
    window_width, window_height = _sides("window", window)
    width, height = _sides("viewport", viewport)
    return translation(
        viewport[0] + (width - sx * window_width) / 2, viewport[1] + (height - sy * window_height) / 2
    )


def scale_factors(window: Rectangle, viewport: Rectangle, mode: Mode = "stretch") -> tuple[float, float]:
    """sx and sy of a mode: both the smaller one to fit, both the larger one to fill.

    Raises: ValueError when a rectangle is not finite or has no area.
    """
    window_width, window_height = _sides("window", window)
    width, height = _sides("viewport", viewport)
    sx, sy = width / window_width, height / window_height
    if mode == "stretch":
        return sx, sy
    both = min(sx, sy) if mode == "fit" else max(sx, sy)
    return both, both


def window_to_normalised(window: Rectangle) -> Matrix:
    """From the world to normalised device coordinates: the window becomes the unit square.

    Raises: ValueError when the window is not finite or has no area.
    """
    return window_to_viewport(window, UNIT_SQUARE)


def normalised_to_viewport(viewport: Rectangle) -> Matrix:
    """From normalised device coordinates to a device: the unit square becomes the viewport.

    Raises: ValueError when the viewport is not finite or has no area.
    """
    return window_to_viewport(UNIT_SQUARE, viewport)


def _sides(name: str, rectangle: Rectangle) -> tuple[float, float]:
    """Width and height of a rectangle that has an area."""
    xmin, ymin, xmax, ymax = rectangle
    width, height = xmax - xmin, ymax - ymin
    if not (math.isfinite(width) and math.isfinite(height) and width > 0 and height > 0):
        raise ValueError(f"The {name} {tuple(rectangle)} has no area; give xmin < xmax and ymin < ymax.")
    return width, height
