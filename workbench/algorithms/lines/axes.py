"""The two frames of a line that swaps its axes when it is steep."""

from workbench.algorithms.entry import View


def pixel(x: int, y: int, steep: bool) -> tuple[int, int]:
    """The device pixel of (x, y), whose axes are swapped on a steep line."""
    return (y, x) if steep else (x, y)


def neighbours(x: int, y: int, step_x: int, step_y: int, steep: bool) -> tuple[tuple[int, int], ...]:
    """The straight and the diagonal neighbour of a pixel: E and NE on a flat rising line."""
    return pixel(x + step_x, y, steep), pixel(x + step_x, y + step_y, steep)


# In a sentence: the line's shorter and longer side, as its own axes name them.
SHORTER = "{'Δx' if steep else 'Δy'}"
LONGER = "{'Δy' if steep else 'Δx'}"

_SWAPPED = "The line is steep, Δy > Δx: the text swaps x and y. "


def starts(block: str, chosen: str, sentence: str) -> tuple[View, View]:
    """The views of the block that plots the first end, where it is said that the axes are swapped."""
    return (
        View(block=block, when="steep", chosen=chosen, sentence=_SWAPPED + sentence),
        View(block=block, chosen=chosen, sentence=sentence),
    )
