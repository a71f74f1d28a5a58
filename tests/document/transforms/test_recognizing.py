"""A matrix is told as the link that a person would have put into the chain."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.document.transforms.links import Affine, AnyLink, Reflect, Rotate, Scale, Shear, Translate
from workbench.document.transforms.recognizing import link_of

place = st.integers(-60, 60).map(lambda n: n / 2)
degrees = st.integers(-179, 180).filter(lambda n: n != 0).map(float)
factor = st.sampled_from([-3.0, -1.5, 0.5, 2.0, 2.5])

links: st.SearchStrategy[AnyLink] = st.one_of(
    st.builds(lambda x, y: Translate("", tx=x, ty=y), place, place),
    st.builds(lambda a, x, y: Rotate("", angle=a, x_pivot=x, y_pivot=y), degrees, place, place),
    st.builds(lambda s, t, x, y: Scale("", sx=s, sy=t, x_pivot=x, y_pivot=y), factor, factor, place, place),
    st.builds(lambda k, y: Shear("", sh_x=k, y_ref=y), factor, place),
    st.builds(lambda k, x: Shear("", sh_y=k, x_ref=x), factor, place),
)


@given(links)
def test_each_kind_is_found_again_with_its_numbers(link: AnyLink) -> None:
    again = link_of(link.matrix)
    np.testing.assert_allclose(again.matrix, link.matrix, rtol=1e-7, atol=1e-7)
    assert type(again) is type(link)
    if isinstance(link, Rotate) and isinstance(again, Rotate):
        turns = (again.angle - link.angle) / 360
        assert turns == pytest.approx(round(turns), abs=1e-9)
        assert (again.x_pivot, again.y_pivot) == pytest.approx((link.x_pivot, link.y_pivot), abs=1e-6)


@given(place, place, st.integers(0, 179).map(float))
def test_a_mirror_is_a_reflection(x: float, y: float, angle: float) -> None:
    again = link_of(Reflect("", angle=angle, x_pivot=x, y_pivot=y).matrix)
    assert isinstance(again, Reflect)
    assert abs(np.sin(np.radians(again.angle - angle))) < 1e-7


@given(links, links)
def test_whatever_is_found_does_what_the_matrix_does(one: AnyLink, other: AnyLink) -> None:
    matrix = other.matrix @ one.matrix
    np.testing.assert_allclose(link_of(matrix).matrix, matrix, rtol=1e-7, atol=1e-7)


def test_a_mixture_is_its_six_numbers() -> None:
    matrix = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [0.0, 0.0, 1.0]])
    assert link_of(matrix) == Affine.of("", matrix)
    glide = np.array([[-1.0, 0.0, 3.0], [0.0, 1.0, 6.0], [0.0, 0.0, 1.0]])
    assert isinstance(link_of(glide), Affine)
