"""Fills that start from a seed."""

from workbench.algorithms.seed_fill.boundary_fill_4 import boundary_fill_4
from workbench.algorithms.seed_fill.boundary_fill_8 import boundary_fill_8
from workbench.algorithms.seed_fill.boundary_fill_recursive import boundary_fill_recursive
from workbench.algorithms.seed_fill.boundary_fill_spans import boundary_fill_spans
from workbench.algorithms.seed_fill.flood_fill_4 import flood_fill_4
from workbench.algorithms.seed_fill.flood_fill_8 import flood_fill_8

__all__ = [
    "boundary_fill_4",
    "boundary_fill_8",
    "boundary_fill_recursive",
    "boundary_fill_spans",
    "flood_fill_4",
    "flood_fill_8",
]
