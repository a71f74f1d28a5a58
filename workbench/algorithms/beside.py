"""What stands below a text for speed alone, and is compiled with it."""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple


class Beside(NamedTuple):
    """A function below a text that draws whole pictures sooner, and arguments with which it is compiled.

    The first of them is written. A law of the entry proves that it draws what the text does.
    """

    function: Callable[..., Iterator[tuple[Any, ...]]]
    example: tuple[Any, ...]
