"""Clipping: points by comparing, lines by region codes and by their parameter, polygons edge by edge."""

from workbench.algorithms.clipping.clip_point import clip_point
from workbench.algorithms.clipping.cohen_sutherland import cohen_sutherland
from workbench.algorithms.clipping.degenerate_edges import degenerate_edges
from workbench.algorithms.clipping.liang_barsky import liang_barsky
from workbench.algorithms.clipping.sutherland_hodgman import sutherland_hodgman

__all__ = ["clip_point", "cohen_sutherland", "degenerate_edges", "liang_barsky", "sutherland_hodgman"]
