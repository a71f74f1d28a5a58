"""The plane of a triangle on the device, against its equation in fractions."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.visibility import depth_buffer
from workbench.algorithms.visibility.device_plane import Corner, corners_of, plane
from workbench.algorithms.visibility.views import left_slope, up_left_edge
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

whole = st.integers(-20, 60)
corners = st.tuples(whole, whole, st.integers(0, 64).map(lambda n: n / 64))


def exact_plane(triangle: list[tuple[int, int, float]]) -> tuple[Fraction, ...]:
    a, b, c = [[Fraction(value) for value in corner] for corner in triangle]
    u, v = [q - p for p, q in zip(a, b, strict=True)], [q - p for p, q in zip(a, c, strict=True)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return (*n, -sum(p * q for p, q in zip(n, a, strict=True)))


def test_the_plane_of_the_example() -> None:
    A, B, C, D = plane(Corner(0, 0, 10), Corner(10, 0, 20), Corner(0, 10, 40))
    assert (A, B, C, D) == (-100, -300, 100, -1000)
    assert -(A * 2 + B * 3 + D) / C == 21
    assert -A / C == 1


@given(triangle=st.tuples(corners, corners, corners))
def test_the_plane_is_that_of_fractions(triangle: tuple[tuple[int, int, float], ...]) -> None:
    """On whole pixels and 64ths every product is exact; only the order of the corners may turn its sign."""
    low, middle, high = corners_of(np.array(triangle, float), np.array([[0, 1, 2]]), 0)
    assert low.y <= middle.y <= high.y
    found = plane(low, middle, high)
    exact = exact_plane(list(triangle))
    assert found in (exact, tuple(-value for value in exact))
    for x, y, z in triangle:
        A, B, C, D = found
        assert A * x + B * y + C * z + D == 0


@given(triangle=st.tuples(corners, corners, corners))
def test_z_changes_along_a_scan_line_and_up_an_edge_as_the_plane_says(
    triangle: tuple[tuple[int, int, float], ...],
) -> None:
    image, depth = np.zeros((40, 50), np.int64), np.full((40, 50), 1e9)
    vertices, faces = np.array(triangle, float), np.array([[0, 1, 2]])
    rows: dict[int, dict[int, float]] = {}
    for x, y, z, _won in depth_buffer(image, depth, vertices, faces, np.ones(1, np.int64)):
        rows.setdefault(y, {})[x] = z
    if not rows:
        return
    A, B, C, D = (float(value) for value in exact_plane(list(triangle)))
    low, middle, high = corners_of(vertices, faces, 0)
    size = 1e-12 * (1 + (abs(A) + abs(B)) * 100 / abs(C))
    for y, row in rows.items():
        for x, z in row.items():
            assert abs(A * x + B * y + C * z + D) <= size * abs(C)
            if x + 1 in row:
                assert row[x + 1] - z == pytest.approx(-A / C, abs=size)
        # From the left edge on this scan line to where it is on the next one
        edge = (
            (low, high) if _on_left(low, middle, high) else (low, middle) if y < middle.y else (middle, high)
        )
        m = Fraction(edge[1].x - edge[0].x) / Fraction(edge[1].y - edge[0].y)
        assert left_slope(low, middle, high, y) == pytest.approx(float(m))
        up = up_left_edge(low, middle, high, y, A, B, C)
        assert up == pytest.approx(-(A * float(m) + B) / C, abs=size)
        along = Fraction(edge[1].z - edge[0].z) / Fraction(edge[1].y - edge[0].y)
        assert up == pytest.approx(float(along), abs=size)


def _on_left(low: Corner, middle: Corner, high: Corner) -> bool:
    """Whether the edge from the lowest corner to the highest is on the left."""
    return (middle.x - low.x) * (high.y - low.y) > (high.x - low.x) * (middle.y - low.y)


def test_the_hand_table_has_the_device_plane_beside_it() -> None:
    entry = catalogue.get("depth_buffer")
    steps = Steps(entry, record(entry.function, *entry.example))
    headings, rows = steps[1].tables["Plane of the triangle, in device coordinates"]
    assert headings[:4] == ("A", "B", "C", "D")
    assert tuple(rows[0][:5]) == (-4, 0, 96, -24, 4 / 96)
