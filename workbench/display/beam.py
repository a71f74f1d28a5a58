"""What every beam tells about itself, whatever it scans."""

from fractions import Fraction
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from workbench.display.tube import Tube


class BeamState(NamedTuple):
    """The beam at one instant: where it points (mm), its current per gun, its place in the scan.

    ``part`` is the line of a raster or the stroke of a display list, ``place`` the pixel clock in that line
    or the time in that stroke in nanoseconds, ``frame`` the number of the picture since the tube was
    switched on.
    """

    x_mm: float
    y_mm: float
    currents: tuple[float, ...]
    lit: bool
    part: int
    place: int
    frame: int


class Beam(Protocol):
    """A beam as a function of time."""

    @property
    def frame_s(self) -> Fraction:
        """Seconds from one picture to the next."""

    def energy_per_frame(self, gun: int = 0) -> NDArray[np.floating[Any]]:
        """What one picture deposits, (face rows, face columns)."""

    def play(self, tube: Tube, ticks: int | Fraction) -> None:
        """Let time pass on the tube while the beam runs."""

    def settle(self, tube: Tube) -> None:
        """Bring the tube to the state it would have, had this picture always been shown until now."""

    def state(self, seconds: Fraction) -> BeamState:
        """Where the beam is and what it does at a time."""
