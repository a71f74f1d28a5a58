"""Fills that start from a seed."""

from workbench.algorithms.seed_fill.boundary_fill_4 import boundary_fill_4

__all__ = ["boundary_fill_4"]
