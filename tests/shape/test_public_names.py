"""What a script may rely on is where it is said to be."""

from importlib import import_module

import pytest

NAMES = {
    "algorithms.lines": "dda_line bresenham_line midpoint_line wu_line",
    "algorithms.circles": "midpoint_circle midpoint_ellipse",
    "algorithms.polygons": "scan_line_exact",
    "algorithms.seed_fill": "boundary_fill_4 boundary_fill_8 boundary_fill_recursive boundary_fill_spans "
    "flood_fill_4 flood_fill_8",
    "algorithms.clipping": "cohen_sutherland liang_barsky sutherland_hodgman",
    "algorithms.transforms": "matrix_product transform_point rotate_about_axis translation rotation scaling "
    "reflection shear rotation_about translation_3d scaling_3d rotation_x rotation_y rotation_z "
    "reflection_3d shear_3d rotation_about_axis",
    "algorithms.viewing": "window_to_viewport window_to_viewport_point",
    "algorithms.curves": "de_casteljau de_boor bernstein basis_functions nurbs_point hermite natural_cubic "
    "catmull_rom cardinal kochanek_bartels continuity b_spline_sum bernstein_curve hermite_blend "
    "natural_cubic_system",
    "algorithms.projection": "orthographic oblique cavalier cabinet axonometric isometric perspective "
    "perspective_from_plane perspective_depth vanishing_points project_point",
    "algorithms.visibility": "back_faces depth_buffer painter depth_sort bsp_tree scan_line_surfaces "
    "area_subdivision octree ray_casting ray_casting_boxes a_buffer hidden_lines",
    "algorithms.shading": "illuminate flat_shading gouraud phong fast_phong",
    "algorithms.catalogue": "entries get",
    "engine.compiled": "collect paint paint_many",
    "engine.recorder": "record",
    "document": "load save DocumentError Camera",
    "rendering": "frame_buffer display_list why depth_buffer_triangles render_mesh render_scene",
    "display": "Phosphor Tube",
}


@pytest.mark.parametrize(("module", "name"), [(m, n) for m, names in NAMES.items() for n in names.split()])
def test_a_public_name_is_in_its_module(module: str, name: str) -> None:
    assert callable(getattr(import_module(f"workbench.{module}"), name))
