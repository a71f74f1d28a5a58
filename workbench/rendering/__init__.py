"""Document to frame buffer and display list, through the viewing pipeline; and why a pixel is as it is."""

from workbench.rendering.clipping import clip_box, clipper_calls, clipper_of
from workbench.rendering.display_list import Stroke, display_list, unshown
from workbench.rendering.limits import REACH_PX
from workbench.rendering.mapping import Call, device_map, figure_map, view_map
from workbench.rendering.pipeline import reach_of
from workbench.rendering.raster import arguments, emitted, figure_calls, frame_buffer, painter_of
from workbench.rendering.scene import render_mesh, render_scene
from workbench.rendering.triangles import depth_buffer_triangles
from workbench.rendering.why import Touch, why

__all__ = [
    "REACH_PX",
    "Call",
    "Stroke",
    "Touch",
    "arguments",
    "clip_box",
    "clipper_calls",
    "clipper_of",
    "depth_buffer_triangles",
    "device_map",
    "display_list",
    "emitted",
    "figure_calls",
    "figure_map",
    "frame_buffer",
    "painter_of",
    "reach_of",
    "render_mesh",
    "render_scene",
    "unshown",
    "view_map",
    "why",
]
