"""From world coordinates to the device."""

from workbench.algorithms.viewing.window_to_viewport import (
    Mode,
    normalised_to_viewport,
    origin_to_viewport,
    scale_factors,
    window_scaling,
    window_to_normalised,
    window_to_origin,
    window_to_viewport,
)
from workbench.algorithms.viewing.window_to_viewport_point import window_to_viewport_point

__all__ = [
    "Mode",
    "normalised_to_viewport",
    "origin_to_viewport",
    "scale_factors",
    "window_scaling",
    "window_to_normalised",
    "window_to_origin",
    "window_to_viewport",
    "window_to_viewport_point",
]
