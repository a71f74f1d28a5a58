"""Solids with an equation: what is shown holds for the corners of their faces."""

import numpy as np
import pytest

from workbench.algorithms.solids import blobs, polygon_tables
from workbench.algorithms.solids.blobs import blob_middles, density
from workbench.document.fields import numbers_of
from workbench.document.scene.solids import Ellipsoid, Sphere, Torus


@pytest.mark.parametrize(
    "solid", [Sphere(1.7), Ellipsoid(2.0, 0.5, 1.25), Torus(3.0, 0.8)], ids=lambda solid: type(solid).__name__
)
def test_the_equation_that_is_shown_holds_at_every_corner(solid):
    """The very text, read as Python."""
    x, y, z = solid.mesh(()).vertices.T
    names = {number.symbol: getattr(solid, name) for name, number in numbers_of(type(solid)).items()}
    left, right = (
        side.replace("²", "**2").replace("−", "-").replace("4 R**2 (", "4 * R**2 * (")
        for side in solid.equation.split("=")
    )
    values = {**names, "x": x, "y": y, "z": z}
    assert np.allclose(eval(left, {}, values), eval(right, {}, values))


@pytest.mark.parametrize(("balls", "spread"), [(1, 0.5), (2, 0.75), (2, 3.0), (5, 1.2)])
def test_blobby_balls_are_closed_and_lie_where_the_density_is_the_threshold(balls, spread):
    mesh = blobs(balls, spread, 2.0, 0.5, 40)
    assert polygon_tables(mesh).closed
    assert density(mesh.vertices, blob_middles(balls, spread), 2.0) == pytest.approx(0.5, abs=0.03)


def test_one_blobby_ball_is_a_sphere_and_encloses_its_volume():
    mesh = blobs(1, 0.001, 1.0, np.exp(-1.0), 40)
    a, b, c = (mesh.vertices[mesh.faces.corners.reshape(-1, 3)[:, k]] for k in range(3))
    volume = (a * np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(4 * np.pi / 3, rel=0.01)


def test_near_balls_flow_together_and_far_ones_stay_apart():
    for spread, parts in ((0.5, 2), (2.5, 4)):
        tables = polygon_tables(blobs(2, spread))
        characteristic = len(tables.vertices) - len(tables.edges) + len(tables.faces)
        assert characteristic == parts


@pytest.mark.parametrize("wrong", [{"balls": 0}, {"threshold": 1.0}, {"cells": 500}, {"tightness": 0.0}])
def test_what_makes_no_surface_is_refused_in_a_sentence(wrong):
    with pytest.raises(ValueError, match=r"\.$"):
        blobs(**wrong)
