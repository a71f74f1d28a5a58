"""Lines: from adding up to deciding by the sign of an integer, and to soft edges."""

from workbench.algorithms.lines.bresenham import bresenham_line
from workbench.algorithms.lines.dda import dda_line
from workbench.algorithms.lines.dda_fixed import dda_line_fixed
from workbench.algorithms.lines.dda_single import dda_line_single
from workbench.algorithms.lines.midpoint import midpoint_line
from workbench.algorithms.lines.wu import wu_line

__all__ = ["bresenham_line", "dda_line", "dda_line_fixed", "dda_line_single", "midpoint_line", "wu_line"]
