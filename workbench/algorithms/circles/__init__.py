"""Circles and ellipses by the midpoint."""

from workbench.algorithms.circles.midpoint_circle import midpoint_circle
from workbench.algorithms.circles.midpoint_ellipse import midpoint_ellipse

__all__ = ["midpoint_circle", "midpoint_ellipse"]
