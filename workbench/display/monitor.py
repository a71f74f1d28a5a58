"""The knobs of a monitor, and what they do to the gun: contrast scales the video signal, brightness moves the
bias of the grid. A level of the signal is 0 for black and 1 for white; blanking is a little below black.
"""

from typing import NamedTuple

from workbench.algorithms.scanning.electron_optics import beam_current

CUT_OFF_V = -60.0
SWING = 0.75
"""White is this share of the way from the cut-off to 0 V of the grid, so that the knobs can go beyond it."""

BLANKING = -0.075
"""The level during retraces (set-up of the television signal, 7.5 of 100)."""


class Knobs(NamedTuple):
    """``brightness`` in levels of the signal, ``contrast`` as a factor."""

    brightness: float = 0.0
    contrast: float = 1.0


IN_THE_MIDDLE = Knobs()


def grid_voltage(level: float, knobs: Knobs, v_cut: float = CUT_OFF_V) -> float:
    """The voltage of the grid for a level of the signal; the grid is never positive."""
    return min(v_cut * (1.0 - SWING * (knobs.brightness + knobs.contrast * level)), 0.0)


def level_of(v_grid: float, knobs: Knobs, v_cut: float = CUT_OFF_V) -> float:
    """The level that puts the grid at a voltage. Raises ZeroDivisionError without contrast."""
    return ((1.0 - v_grid / v_cut) / SWING - knobs.brightness) / knobs.contrast


def level_current(level: float, knobs: Knobs, gamma: float) -> float:
    """The beam current of a level, where white is 1 while the knobs are in their middle."""
    white = beam_current(grid_voltage(1.0, IN_THE_MIDDLE), CUT_OFF_V, 1.0, gamma)
    return beam_current(grid_voltage(level, knobs), CUT_OFF_V, 1.0, gamma) / white
