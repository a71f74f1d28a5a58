"""Areas filled by scan lines, and the test of one point."""

from workbench.algorithms.polygons.circle_fill import circle_fill
from workbench.algorithms.polygons.ellipse_fill import ellipse_fill
from workbench.algorithms.polygons.inside_outside import inside_outside
from workbench.algorithms.polygons.scan_line_crossings import scan_line_crossings
from workbench.algorithms.polygons.scan_line_exact import scan_line_exact
from workbench.algorithms.polygons.scan_line_fill import scan_line_fill
from workbench.algorithms.polygons.scan_line_integer import scan_line_integer

__all__ = [
    "circle_fill",
    "ellipse_fill",
    "inside_outside",
    "scan_line_crossings",
    "scan_line_exact",
    "scan_line_fill",
    "scan_line_integer",
]
