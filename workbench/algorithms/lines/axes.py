"""The two frames of a line that swaps its axes when it is steep."""


def pixel(x: int, y: int, steep: bool) -> tuple[int, int]:
    """The device pixel of (x, y), whose axes are swapped on a steep line."""
    return (y, x) if steep else (x, y)


def neighbours(x: int, y: int, step_x: int, step_y: int, steep: bool) -> tuple[tuple[int, int], ...]:
    """The straight and the diagonal neighbour of a pixel: E and NE on a flat rising line."""
    return pixel(x + step_x, y, steep), pixel(x + step_x, y + step_y, steep)
