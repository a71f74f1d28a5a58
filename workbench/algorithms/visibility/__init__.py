"""What hides what."""

from workbench.algorithms.visibility.back_faces import back_faces
from workbench.algorithms.visibility.depth_buffer import depth_buffer

__all__ = ["back_faces", "depth_buffer"]
