"""The octree: the order of its octants, and cells front to back."""

from itertools import permutations

from tests.visibility.exact_scenes import arrays, mesh, scenes
from workbench.algorithms.visibility import octree
from workbench.algorithms.visibility.boxes import extents_of
from workbench.algorithms.visibility.octants import X, Y, Z, front_to_back, octant_of, whole_cell
from workbench.algorithms.visibility.surfaces import surfaces_of


def test_the_octants_from_front_to_back() -> None:
    """The order in which the octree draws: that of the worked example for an eye in octant 5."""
    order = front_to_back(5)
    assert order == [5, 4, 7, 1, 6, 0, 3, 2]
    assert "front_to_back" in octree.__code__.co_names


def test_from_any_octant_what_is_nearer_along_an_axis_comes_first() -> None:
    for eye in range(8):
        order = front_to_back(eye)
        assert sorted(order) == list(range(8))
        for a, b in permutations(range(8), 2):
            if (a ^ b) in (X, Y, Z) and (a & (a ^ b)) == (eye & (a ^ b)):
                assert order.index(a) < order.index(b)


def test_the_octants_of_a_cell_fill_it_and_hold_what_reaches_into_them() -> None:
    for scene in scenes(mesh, 5):
        surfaces = surfaces_of(*arrays(scene)[:2])
        cell = whole_cell(surfaces, 16)
        parts = [octant_of(cell, octant, extents_of(surfaces)) for octant in range(8)]
        assert {(p.x, p.y) for p in parts} == {(0, 0), (8, 0), (0, 8), (8, 8)}
        assert {(p.z_near, p.z_far) for p in parts} == {
            (cell.z_near, (cell.z_near + cell.z_far) / 2),
            ((cell.z_near + cell.z_far) / 2, cell.z_far),
        }
        for number in cell.members:
            for corner in surfaces[number][:3]:
                inside = [
                    part
                    for part in parts
                    if part.x <= corner.x <= part.x + 7
                    and part.y <= corner.y <= part.y + 7
                    and part.z_near <= corner.z < part.z_far
                ]
                assert all(number in part.members for part in inside)
