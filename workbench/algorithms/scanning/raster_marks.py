"""What is drawn of a raster scan, and how its numbers are written."""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.marks import Mark, Spot, Stroke, along
from workbench.algorithms.numerals import numeral


def hexadecimal(colour: int) -> str:
    """A colour 0xRRGGBB as it is written in a table: #FF8800."""
    return f"#{int(colour):06X}"


def places(x_mm: float, y_mm: float) -> str:
    """A place on the tube."""
    return f"({numeral(x_mm)}, {numeral(y_mm)})"


def raster_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The line that is scanned, and the pixel at which the beam is."""
    if ended or "y" not in now:
        return
    width, y = arguments[0].shape[1], float(now["y"])
    yield Stroke(along((-0.5, y), (width - 0.5, y)), "accent", "hair")
    if "x" in now:
        yield Spot(float(now["x"]), y, "accent", "ring", "medium")
