"""From world coordinates to the device."""

from workbench.algorithms.viewing.window_to_viewport import window_to_viewport

__all__ = ["window_to_viewport"]
