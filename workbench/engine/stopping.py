"""Ends a long run from another thread."""

import numpy as np
from numpy.typing import NDArray


class Stopped(Exception):  # noqa: N818 - a run that was stopped has made no error
    """A run was stopped from outside before it came to its end."""


class Stop:
    """Ends a long run from another thread: it returns at its next emission, and ``Stopped`` is raised."""

    def __init__(self) -> None:
        self.flag: NDArray[np.uint8] = np.zeros(1, np.uint8)

    def set(self) -> None:
        """Stop every run that was given this."""
        self.flag[0] = 1

    @property
    def is_set(self) -> bool:
        """Whether it was set."""
        return bool(self.flag[0])

    def check(self) -> None:
        """Raises: Stopped, where it was set."""
        if self.is_set:
            raise Stopped
