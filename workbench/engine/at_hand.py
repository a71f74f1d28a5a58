"""Which compiled readings have run in this process, and so are called without any wait.

Apart from all that compiles, since the first frame asks before that is imported.
"""

from collections.abc import Callable
from typing import Any

Function = Callable[..., Any]

_known: set[tuple[Function, str]] = set()


def at_hand(function: Function, use: str) -> bool:
    """Whether a use (paint_batch, collect, collect_many and so on) need be neither compiled nor loaded."""
    return (function, use) in _known


def note(function: Function, use: str) -> None:
    """This use has run, compiled."""
    _known.add((function, use))
