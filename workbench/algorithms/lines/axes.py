"""The two frames of a line that swaps its axes when it is steep."""


def pixel(x: int, y: int, steep: bool) -> tuple[int, int]:
    """The device pixel of (x, y), whose axes are swapped on a steep line."""
    return (y, x) if steep else (x, y)
