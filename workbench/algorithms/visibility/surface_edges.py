"""The tables of the scan-line method for surfaces: edges by their first row, active edges, open surfaces."""

import math
from typing import NamedTuple

from workbench.algorithms.visibility.device_plane import Corner, crossing
from workbench.algorithms.visibility.surfaces import Surface, in_view, nearer


class Edge(NamedTuple):
    """A row of the edge table: its first row and the one past its last, its ends, and whose edge it is."""

    y_start: int
    y_end: int
    low: Corner
    high: Corner
    surface: int


class Active(NamedTuple):
    """A row of the active edge list: where an edge crosses the scan line, whose it is, and its number."""

    x: float
    surface: int
    edge: int


def edge_of(low: Corner, high: Corner, surface: int) -> Edge:
    """An edge from its lower end up; on no row where it crosses none of the picture's."""
    return Edge(max(math.ceil(low.y), 0), math.ceil(high.y), low, high, surface)


def edge_table(surfaces: list[Surface]) -> list[Edge]:
    """The edges of all surfaces that cross a row, those of the lowest rows first."""
    edges = [edge_of(surface.low, surface.low, 0) for surface in surfaces[:0]]
    for number in in_view(surfaces):
        low, middle, high = surfaces[number].low, surfaces[number].middle, surfaces[number].high
        for edge in (edge_of(low, middle, number), edge_of(middle, high, number), edge_of(low, high, number)):
            if edge.y_start < edge.y_end:
                edges.append(edge)
    return by_first_row(edges)


def by_first_row(edges: list[Edge]) -> list[Edge]:
    """The edges in order of their first rows, counted into one bucket for each row."""
    rows = 1
    for edge in edges:
        rows = max(rows, edge.y_start + 1)
    places = [0 for _row in range(rows + 1)]
    for edge in edges:
        places[edge.y_start + 1] += 1
    for row in range(rows):
        places[row + 1] += places[row]
    table = edges[:]
    for edge in edges:
        table[places[edge.y_start]] = edge
        places[edge.y_start] += 1
    return table


def change_over(active: list[Active], edges: list[Edge], waiting: int, y: int) -> int:
    """Drop the edges that end below row y and let in those that begin on it; returns who waits then."""
    kept = 0
    for one in active:
        if edges[one.edge].y_end > y:
            active[kept] = one
            kept += 1
    while len(active) > kept:
        active.pop()
    while waiting < len(edges) and edges[waiting].y_start == y:
        active.append(Active(0.0, edges[waiting].surface, waiting))
        waiting += 1
    return waiting


def cross(active: list[Active], edges: list[Edge], y: int) -> None:
    """Find where the active edges cross row y, and put them in order from left to right."""
    for k in range(len(active)):
        number = active[k].edge
        edge = edges[number]
        x = crossing(edge.low.x, edge.low.y, edge.high.x, edge.high.y, y)
        place = k
        while place > 0 and active[place - 1].x > x:
            active[place] = active[place - 1]
            place -= 1
        active[place] = Active(x, edge.surface, number)


def nearest_of(surfaces: list[Surface], opened: list[int], x: float, y: int) -> int:
    """The nearest of the open surfaces at a place of the scan line."""
    nearest = opened[0]
    for number in opened:
        if nearer(surfaces, number, nearest, x, y):
            nearest = number
    return nearest
