"""The four edges of the window: the bit of each in a region code, and where a line crosses one.

code        top, bottom, right, left from the highest bit; a bit is set where the point is beyond that edge
edge        one of these bits
"""

TOP, BOTTOM, RIGHT, LEFT = 8, 4, 2, 1


def region_code(x: float, y: float, xmin: float, ymin: float, xmax: float, ymax: float) -> int:
    """Which edges the point (x, y) is beyond; 0 inside and on the edge.

    Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    code = 0
    if y > ymax:
        code = TOP
    elif y < ymin:
        code = BOTTOM
    if x > xmax:
        code += RIGHT
    elif x < xmin:
        code += LEFT
    return code


def between(value: float, end_0: float, end_1: float) -> float:
    """``value``, or the end that rounding has carried it past."""
    return min(max(value, min(end_0, end_1)), max(end_0, end_1))


def intersection(
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    edge: int,
    xmin: float,
    ymin: float,
    xmax: float,
    ymax: float,
) -> tuple[float, float]:
    """Where the line from (x0, y0) to (x1, y1) crosses ``edge``, which has one end on either side.

    The product comes before the quotient: of whole numbers it is exact, and a touched corner is not missed.
    Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Find the intersection
    if edge in (TOP, BOTTOM):
        y = ymax if edge == TOP else ymin
        x = x0 + (x1 - x0) * (y - y0) / (y1 - y0)
    else:
        x = xmax if edge == RIGHT else xmin
        y = y0 + (y1 - y0) * (x - x0) / (x1 - x0)

    # Let no rounding carry it past an end
    return between(x, x0, x1), between(y, y0, y1)
