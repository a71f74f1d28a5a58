"""What hides what."""

from workbench.algorithms.visibility.depth_buffer import depth_buffer

__all__ = ["depth_buffer"]
