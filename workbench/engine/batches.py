"""Many calls of one text painted in one go, with the number of the figure that painted each pixel last.

Painting what each call emits, one after the other, gives the same bit for bit; here the loop over the calls
is part of the kernel.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.engine.arguments import kinds

Function = Callable[..., Any]
USE = "paint_batch"


class Lists(NamedTuple):
    """A list for each of many calls: their ``items`` (m, ...), and where in them each one starts (n + 1,)."""

    items: NDArray[Any]
    starts: NDArray[np.int64]


Values = NDArray[Any] | Lists
"""The arguments of many calls for one parameter: numbers (n,), or ``Lists``."""


@dataclass(frozen=True, slots=True, eq=False)
class Calls:
    """Calls of one text as its kernel takes them.

    Each has a colour (n,), 0xRRGGBB, and the number (n,) of its figure; ``values`` are a table (n, k) of all
    arguments that are numbers, then the items and the starts of each list.
    """

    function: Function
    colours: NDArray[np.uint32]
    numbers: NDArray[np.int32]
    values: tuple[NDArray[Any], ...]

    @staticmethod
    def of(
        function: Function, colours: NDArray[Any], numbers: NDArray[Any], values: Iterable[Values]
    ) -> "Calls":
        """Those with these values for each parameter. Arrays become copies: kernels take no others."""
        columns: list[NDArray[Any]] = []
        lists: list[NDArray[Any]] = []
        kind_of = [kind for _name, kind in kinds(function)]
        for kind, value in zip(kind_of, values, strict=True):
            if isinstance(value, Lists):
                items = value.items.astype(np.int64 if kind == "ints" else np.float64)
                lists += [items, value.starts.astype(np.int64)]
            else:
                columns.append(value)
        table = np.empty((len(numbers), len(columns)), np.float64 if "float" in kind_of else np.int64)
        for number, column in enumerate(columns):
            table[:, number] = column
        return Calls(function, colours.astype(np.uint32), numbers.astype(np.int32), (table, *lists))

    def painter(
        self,
        image: NDArray[np.uint32],
        painter: NDArray[np.int32],
        bounds: tuple[int, int, int, int],
        flavour: str = "",
    ) -> Callable[[int, int], None]:
        """What paints the calls from a first to before a last one into ``image`` and ``painter`` (h, w).

        What lies outside ``bounds``, first and last column, first and last row, in the picture, is left out.
        It compiles and loads what is not at hand. Raises: NotCompilable, DialectError.
        """
        from workbench.engine import compiled  # here, as the first frame is painted without

        call = compiled.kernel(self.function, flavour=flavour).call
        given = image, painter, np.array(bounds, np.int64), self.colours, self.numbers, *self.values
        return lambda first, last: call(f"_{USE}", (first, last, *given), True)


def load(function: Function, arguments: Iterable[Any]) -> None:
    """Have the painter of a text at hand: paint one call on a picture of a few pixels."""
    values = [
        Lists(value, np.array([0, len(value)])) if isinstance(value, np.ndarray) else np.array([value])
        for value in arguments
    ]
    image = np.zeros((4, 4), np.uint32)
    calls = Calls.of(function, np.ones(1), np.zeros(1), values)
    calls.painter(image, image.astype(np.int32), (0, 3, 0, 3))(0, 1)
