"""The pieces of a curve that wait to be drawn, as they are shown."""

from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.recorded import is_recorded

Point = tuple[float, ...]


def chord(piece: NDArray[Any]) -> tuple[Point, Point]:
    """Both ends of a piece."""
    return tuple(piece[0].tolist()), tuple(piece[-1].tolist())


def chord_of(stack: NDArray[Any], number: int) -> tuple[Point, Point] | tuple[str, str]:
    """Both ends of a piece on the stack."""
    return chord(stack[number]) if is_recorded(stack) else ("–", "–")


def waiting_rows(stack: NDArray[Any], depth: NDArray[Any], top: int) -> list[tuple[int, int, Point, Point]]:
    """The pieces on the stack, the one on top last: number, how often divided, both ends."""
    return [(piece, int(depth[piece]), *chord(stack[piece])) for piece in range(top + 1)]
