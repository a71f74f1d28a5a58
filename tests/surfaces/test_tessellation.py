"""Triangles of surfaces: within the tolerance, without cracks, turned outwards, written and read back."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.surfaces.scipy_points import patch_points
from workbench.algorithms.surfaces import (
    EXAMPLES,
    Patches,
    bezier_patch,
    cylinder,
    sphere,
    tessellate,
    tessellation,
    torus,
)
from workbench.exchange import writing
from workbench.exchange.meshes import obj, ply, stl
from workbench.exchange.written import formats

Array = NDArray[np.float64]


def mesh_of(patches: Patches, tolerance: float) -> trimesh.Trimesh:
    vertices, faces = tessellate(patches, tolerance)
    return trimesh.Trimesh(vertices, faces, process=False)


def farthest(points: Array, vertices: Array, faces: NDArray[np.int64]) -> float:
    """The largest distance of points from triangles, each looked at with each."""
    corners = vertices[faces]
    worst = 0.0
    for point in points:
        near = trimesh.triangles.closest_point(corners, np.broadcast_to(point, (len(faces), 3)))
        worst = max(worst, float(np.sqrt(((near - point) ** 2).sum(axis=1).min())))
    return worst


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.sampled_from([2.0, 0.5, 0.1]), st.sampled_from([1.0, 6.0]))
def test_the_surface_is_nowhere_farther_than_the_tolerance(seed: int, tolerance: float, pull: float) -> None:
    rng = np.random.default_rng(seed)
    x, z = np.meshgrid(np.arange(4.0), np.arange(3.0), indexing="ij")
    net = np.stack([3 * x, rng.uniform(-4, 4, (4, 3)), -3 * z], axis=-1) + rng.uniform(-1, 1, (4, 3, 3))
    patches = bezier_patch(net, rng.uniform(1 / pull, pull, (4, 3)))
    vertices, faces = tessellate(patches, tolerance)
    points = patch_points(patches, *rng.uniform(0, 1, (2, 25)))
    assert farthest(points, vertices, faces) <= tolerance


@pytest.mark.parametrize(("pull", "share"), [(1.0, 0.2), (1e4, 0.4)])
def test_a_twisted_square_is_nowhere_farther_than_the_tolerance(pull: float, share: float) -> None:
    """It is a quarter of its twist away from its two triangles, half of it where two corners pull."""
    twist = 0.1
    net = np.array([[[0, 0, 0], [0, 0, 1]], [[1, 0, 0], [1, twist, 1]]])
    patches = bezier_patch(net, [[1.0, pull], [pull, 1.0]])
    points = patch_points(patches, 0.5, [[0.5]])[0]
    mesh = tessellate(patches, share * twist)
    assert farthest(points, *tessellate(patches, twist)) > share * twist
    assert farthest(points, *mesh) <= share * twist


@pytest.mark.parametrize("tolerance", [0.3, 0.1, 0.01])
@pytest.mark.parametrize("radius", [1.0, 40.0])
def test_a_sphere_has_no_cracks(radius: float, tolerance: float) -> None:
    mesh = mesh_of(sphere(radius), tolerance * radius)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert np.abs(np.linalg.norm(mesh.vertices, axis=1) - radius).max() <= 1e-12 * radius
    whole = 4 / 3 * math.pi * radius**3
    assert whole * (1 - 3 * tolerance) <= mesh.volume <= whole
    assert radius - np.linalg.norm(mesh.triangles.mean(axis=1), axis=1).min() <= tolerance * radius
    sides = mesh.vertices[mesh.edges_unique].mean(axis=1)
    assert radius - np.linalg.norm(sides, axis=1).min() <= tolerance * radius


def test_triangles_are_not_wasted() -> None:
    assert len(mesh_of(cylinder(1, 2), 0.01).vertices) == 64
    assert len(mesh_of(sphere(), 0.01).faces) < 5_000
    flat = bezier_patch(
        np.stack([*np.meshgrid([0.0, 1, 2], [0.0, 1], indexing="ij"), np.zeros((3, 2))], axis=-1)
    )
    assert len(tessellate(flat, 1e-9)[1]) == 2


def test_a_ring_is_closed_both_ways_and_a_tube_one_way() -> None:
    ring = mesh_of(torus(), 0.05)
    assert ring.is_watertight
    assert ring.euler_number == 0
    assert ring.volume > 0.95 * 2 * math.pi**2 * 2 * 0.75**2
    tube = mesh_of(cylinder(1, 2), 0.05)
    assert tube.is_winding_consistent
    edges, counts = np.unique(np.sort(tube.edges, axis=1), axis=0, return_counts=True)
    border = tube.vertices[np.unique(edges[counts == 1])]
    assert set(np.round(border[:, 1], 12)) == {0.0, 2.0}
    assert (tube.face_normals * tube.triangles.mean(axis=1) * [1, 0, 1]).sum(axis=1).min() > 0


def test_a_tolerance_that_asks_too_much_is_said() -> None:
    with pytest.raises(ValueError, match="more than 250,000 cells"):
        tessellate(sphere(), 1e-9)
    with pytest.raises(ValueError, match="The tolerance is 0"):
        tessellate(sphere(), 0.0)


@pytest.mark.parametrize(("write", "kind"), [(obj, "obj"), (ply, "ply"), (stl, "stl")])
def test_a_mesh_reads_back(write: object, kind: str, tmp_path: Path) -> None:
    vertices, faces = tessellate(sphere(3.0), 0.1)
    path = tmp_path / f"sphere.{kind}"
    writing.write(writing.format_for(formats("mesh"), path), (vertices, faces), path)
    assert path.read_bytes() == write(vertices, faces)  # type: ignore[operator]
    back = trimesh.load_mesh(str(path), process=kind == "stl")
    assert back.is_watertight
    assert len(back.faces) == len(faces)
    exact = 1e-6 if kind == "stl" else 0.0
    assert np.abs(back.triangles - vertices[faces]).max() <= exact
    assert (back.face_normals * back.triangles.mean(axis=1)).sum(axis=1).min() > 0


def test_what_cannot_be_written_is_said(tmp_path: Path) -> None:
    with pytest.raises(writing.SuffixError, match=r"mesh.fbx: choose a name that ends in .obj, .ply or .stl"):
        writing.format_for(formats("mesh"), tmp_path / "mesh.fbx")
    with pytest.raises(ValueError, match="vertex that does not exist"):
        obj([[0, 0, 0]], [[0, 0, 1]])
    with pytest.raises(ValueError, match="three finite numbers"):
        obj([[0, 0, math.nan]], [])


def test_a_hopeless_tolerance_is_refused_before_the_surface_is_cut_up(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    measured: list[int] = []
    bounds = tessellation._bounds

    def counted(cells: Any) -> Any:
        measured.append(cells.shape[0] * cells.shape[1])
        return bounds(cells)

    monkeypatch.setattr(tessellation, "_bounds", counted)
    for made in EXAMPLES.values():
        measured.clear()
        with pytest.raises(ValueError, match="more than 250,000 cells"):
            tessellate(made(), 1e-12)
        assert sum(measured) < 10_000
