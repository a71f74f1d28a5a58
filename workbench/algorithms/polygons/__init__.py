"""Areas filled by scan lines, and the test of one point."""

from workbench.algorithms.polygons.scan_line_fill import scan_line_fill

__all__ = ["scan_line_fill"]
