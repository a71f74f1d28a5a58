"""Generated lines, windows and polygons, near-degenerate ones on purpose."""

import math
from fractions import Fraction

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

Line = tuple[float, float, float, float]
Window = tuple[float, float, float, float]

small = st.integers(-40, 40)
quarters = small.map(lambda number: number / 4)
wild = st.floats(-1e6, 1e6, allow_subnormal=False).map(lambda number: round(number * 2**20) / 2**20)
coordinates = st.one_of(small.map(float), quarters, wild)


@st.composite
def windows(draw: st.DrawFn, numbers: st.SearchStrategy[float] = coordinates) -> Window:
    xs = sorted(draw(st.tuples(numbers, numbers)))
    ys = sorted(draw(st.tuples(numbers, numbers)))
    width, height = (1.0 if high == low else 0.0 for low, high in (xs, ys))
    return xs[0], ys[0], xs[1] + width, ys[1] + height


def next_digit(number: float, towards: float) -> float:
    """The number beside this one; beside 0 as far off as beside 1: products of smaller ones would vanish."""
    return math.nextafter(number, towards) if number else math.copysign(2.0**-52, towards)


@st.composite
def cases(draw: st.DrawFn) -> tuple[Line, Window]:
    """A line and a window: any; with ends on its edges or a digit beside them; near a corner."""
    window = draw(windows())
    xmin, ymin, xmax, ymax = window
    kind = draw(st.sampled_from(["any", "edges", "corner"]))
    if kind == "any":
        return draw(st.tuples(coordinates, coordinates, coordinates, coordinates)), window
    if kind == "edges":

        def beside(low: float, high: float) -> st.SearchStrategy[float]:
            edge = st.sampled_from([low, high])
            return st.one_of(
                edge,
                edge.map(lambda number: next_digit(number, math.inf)),
                edge.map(lambda number: next_digit(number, -math.inf)),
                st.just((low + high) / 2),
                coordinates,
            )

        across, along = beside(xmin, xmax), beside(ymin, ymax)
        return draw(st.tuples(across, along, across, along)), window
    corner = draw(st.sampled_from([(xmin, ymin), (xmin, ymax), (xmax, ymin), (xmax, ymax)]))
    direction = draw(st.tuples(small, small))
    back, forth = draw(st.integers(0, 9)), draw(st.integers(0, 9))
    # Also lines that graze an edge: all but parallel to it
    beside = draw(st.sampled_from([0.0, 1e-9, -1e-9, 2.0**-20, 1e-12]))
    axis = draw(st.integers(0, 1))
    ends = [[corner[k] - back * direction[k], corner[k] + forth * direction[k]] for k in (0, 1)]
    ends[axis][draw(st.integers(0, 1))] += beside
    return (ends[0][0], ends[1][0], ends[0][1], ends[1][1]), window


def scale(*numbers: float) -> float:
    """The size of the largest coordinate: rounding and tolerances go with it."""
    return max(1.0, *map(abs, numbers))


on_grid = st.tuples(quarters, quarters, quarters, quarters)
grid_windows = windows(quarters)


def polygons(
    numbers: st.SearchStrategy[float], least: int = 3, most: int = 9
) -> st.SearchStrategy[list[tuple[float, float]]]:
    return st.lists(st.tuples(numbers, numbers), min_size=least, max_size=most)


@st.composite
def star_shaped(draw: st.DrawFn) -> NDArray[np.float64]:
    """A polygon that does not cross itself: one corner in each of different directions from its centre.

    Coordinates are odd numbers of eighths, so that no corner lies on an edge of a window of whole numbers.
    """
    centre = draw(st.tuples(st.integers(-20, 20), st.integers(-20, 20)))
    directions: dict[Fraction | str, tuple[int, int]] = {}
    offsets = draw(st.lists(st.tuples(st.integers(-60, 60), st.integers(-60, 60)), min_size=4, max_size=16))
    for dx, dy in offsets:
        # Whole steps of 2 eighths from a centre of odd eighths keep each corner odd
        if dx or dy:
            key = ("+" if (dx, dy) > (0, 0) else "-") + (str(Fraction(dy, dx)) if dx else "up")
            directions.setdefault(key, (dx, dy))
    ordered = sorted(directions.values(), key=lambda offset: math.atan2(offset[1], offset[0]))
    return np.array(
        [(centre[0] + (2 * dx + 1) / 8, centre[1] + (2 * dy + 1) / 8) for dx, dy in ordered], float
    ).reshape(-1, 2)
