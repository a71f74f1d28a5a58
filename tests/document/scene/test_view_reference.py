"""Hearn and Baker's names of a camera against their own formulas."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.scene.looking import kinds, projecting
from workbench.document.scene.model import Camera, Point3D
from workbench.document.scene.view_reference import view_reference
from workbench.document.scene.viewing import projection_matrix, view_matrix

SLUGS = [kind.slug for kind in kinds()]
numbers = st.floats(-9, 9)


@pytest.mark.parametrize("slug", SLUGS)
@given(st.tuples(numbers, numbers, numbers))
def test_both_ways_give_one_picture(slug: str, place: tuple[float, float, float]) -> None:
    camera = projecting(Camera(eye=Point3D(4.0, 3.0, 9.0), look_at=Point3D(1.0, 0.5, 0.0)), slug, 2.0)
    book = view_reference(camera)
    ours = projection_matrix(camera) @ view_matrix(camera)
    assert np.allclose(book.projection @ book.view @ (*place, 1.0), ours @ (*place, 1.0), atol=1e-9)
    assert np.allclose(book.view @ (*book.vrp, 1.0), (0, 0, 0, 1), atol=1e-9)
    assert np.isclose(np.linalg.det(book.view[:3, :3]), 1.0)  # right-handed
    assert np.allclose(book.view[2, :3], book.vpn)


@given(numbers, numbers, st.floats(-9, 3))
def test_perspective_is_the_book_s_formula(x: float, y: float, z: float) -> None:
    """x_p = x (z_prp - z_vp) / (z_prp - z), from the eye at z_prp = 13 onto the plane at z_vp = 8."""
    camera = Camera(eye=Point3D(3.0, 4.0, 12.0), distance=5.0)
    book = view_reference(camera)
    assert np.allclose(book.prp, (0, 0, 13, 1))
    assert book.plane == pytest.approx(8.0)
    assert np.allclose(book.vpn, np.array([3, 4, 12]) / 13)
    x_p, y_p, _depth, w = book.projection @ (x, y, z, 1.0)
    assert x_p / w == pytest.approx(x * 5.0 / (13.0 - z), abs=1e-9)
    assert y_p / w == pytest.approx(y * 5.0 / (13.0 - z), abs=1e-9)


def test_parallel_projectors_have_a_direction() -> None:
    front = Camera("orthographic", Point3D(0.0, 0.0, 9.0))
    assert np.allclose(view_reference(front).prp, (0, 0, 1, 0))
    assert view_reference(front).plane is None
    cavalier = view_reference(replace(front, projection="cavalier", oblique_phi=30.0, distance=4.0))
    x, y, z, w = cavalier.prp
    assert (w, cavalier.plane) == (0.0, pytest.approx(5.0))
    assert math.hypot(x, y) == pytest.approx(z)  # at 45 degrees to the view plane
    start = np.array([0.3, 0.2, 1.0, 1.0])
    for along in (0.0, 2.5):  # a point stays in the picture where it moves along its projector
        picture = cavalier.projection @ (start + along * cavalier.prp)
        assert np.allclose(picture[:2], (cavalier.projection @ start)[:2])
