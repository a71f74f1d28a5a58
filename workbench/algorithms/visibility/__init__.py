"""What hides what."""

from workbench.algorithms.visibility.a_buffer import a_buffer
from workbench.algorithms.visibility.area_subdivision import area_subdivision
from workbench.algorithms.visibility.back_faces import back_faces
from workbench.algorithms.visibility.bsp_tree import bsp_tree
from workbench.algorithms.visibility.depth_buffer import depth_buffer
from workbench.algorithms.visibility.depth_sort import depth_sort
from workbench.algorithms.visibility.hidden_lines import hidden_lines
from workbench.algorithms.visibility.octree import octree
from workbench.algorithms.visibility.painter import painter
from workbench.algorithms.visibility.ray_casting import ray_casting
from workbench.algorithms.visibility.ray_casting_boxes import ray_casting_boxes
from workbench.algorithms.visibility.scan_line_surfaces import scan_line_surfaces

__all__ = [
    "a_buffer",
    "area_subdivision",
    "back_faces",
    "bsp_tree",
    "depth_buffer",
    "depth_sort",
    "hidden_lines",
    "octree",
    "painter",
    "ray_casting",
    "ray_casting_boxes",
    "scan_line_surfaces",
]
