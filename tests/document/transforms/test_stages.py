"""A chain stage by stage: symbols that come to the numbers, products that come to the chain."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import transforms
from workbench.algorithms.transforms import matrix_product
from workbench.document.transforms.chains import matrix_of, unfolded
from workbench.document.transforms.links import Affine, Reflect, Rotate, Scale, Shear, Translate
from workbench.document.transforms.stages import products, stages

numbers = st.one_of(st.just(0.0), st.integers(-9, 9).map(float), st.floats(-1e3, 1e3, allow_subnormal=False))
switches = st.booleans()
links = st.one_of(
    st.builds(Translate, st.just(""), switches, tx=numbers, ty=numbers),
    st.builds(Rotate, st.just(""), switches, angle=numbers, x_pivot=numbers, y_pivot=numbers),
    st.builds(Scale, st.just(""), switches, sx=numbers, sy=numbers, x_pivot=numbers, y_pivot=numbers),
    st.builds(
        Reflect,
        st.just(""),
        switches,
        mirror=st.sampled_from(("line", "point")),
        angle=numbers,
        x_pivot=numbers,
        y_pivot=numbers,
    ),
    st.builds(Shear, st.just(""), switches, sh_x=numbers, sh_y=numbers, x_ref=numbers, y_ref=numbers),
    st.builds(
        Affine,
        st.just(""),
        switches,
        m11=numbers,
        m12=numbers,
        m13=numbers,
        m21=numbers,
        m22=numbers,
        m23=numbers,
    ),
)
chains = st.lists(links, max_size=4).map(tuple)


@given(chains)
def test_the_symbols_of_every_stage_come_to_its_matrix(chain):
    made = stages(chain)
    assert [stage.number for stage in made] == list(range(1, len(made) + 1))
    assert [stage.elementary.name for stage in made] == [part.name for part in unfolded(chain)]
    for stage in made:
        np.testing.assert_allclose(stage.symbols.matrix, stage.elementary.matrix, rtol=1e-12, atol=1e-12)


@given(chains)
def test_no_stage_is_called_as_the_factors_or_the_whole_of_a_product(chain):
    assert not {stage.symbols.name for stage in stages(chain)} & {"A", "B", "M", "P"}


@given(chains)
def test_the_entries_of_a_stage_are_numbers_of_its_link(chain):
    for stage in stages(chain):
        for (row, column), (attribute, sign) in stage.entries.items():
            assert stage.elementary.matrix[row, column] == sign * getattr(stage.link, attribute)


@given(chains)
def test_the_last_product_is_the_matrix_of_the_chain(chain):
    made = products(stages(chain))
    whole = matrix_of(chain)
    assert (whole is None) == (not made)
    if whole is not None:
        assert np.isfinite(made[-1]).all()
        largest = max(1.0, *(float(np.abs(each).max()) for each in made))
        np.testing.assert_allclose(made[-1], whole, rtol=0, atol=1e-9 * largest**2)


@given(chains)
def test_a_product_is_to_the_last_bit_what_the_text_adds_up(chain):
    listed = stages(chain)
    made = products(listed)
    for stage, before, after in zip(listed[1:], made, made[1:], strict=False):
        cells = [value for *_place, value in matrix_product(stage.elementary.matrix, before)]
        assert np.reshape(cells, (3, 3)).tolist() == after.tolist()


def test_the_paper_s_turn_about_a_point():
    turn = Rotate("t1", angle=45.0, x_pivot=3.0, y_pivot=3.0)
    listed = stages([turn])
    assert [stage.symbols.name for stage in listed] == ["T(−x_p, −y_p)", "R(θ)", "T(x_p, y_p)"]
    product = transforms.multiplied_out([stage.symbols for stage in reversed(listed)])[-1]
    assert product.texts[0][2] == "x_p(1 − cos θ) + y_p sin θ"
    assert product.texts[1][2] == "y_p(1 − cos θ) − x_p sin θ"
    whole = products(listed)[-1]
    assert whole[0, 2] == 3.0
    assert round(whole[1, 2], 4) == -1.2426
    corners = np.array([(5, 6, 1), (6, 2, 1), (4, 1, 1)]).T
    expected = [(2.2929, 6.5355), (5.8284, 4.4142), (5.1213, 2.2929)]
    assert np.round((whole @ corners)[:2].T, 4).tolist() == [list(each) for each in expected]


def test_two_links_of_one_kind_have_symbols_of_their_own():
    names = [
        stage.symbols.name for stage in stages([Translate("t1"), Translate("t2", on=False), Translate("t3")])
    ]
    assert names == ["T(t_{x1}, t_{y1})", "T(t_{x2}, t_{y2})"]


@pytest.mark.parametrize("link", [Rotate(""), Scale(""), Shear(""), Reflect("", mirror="point")])
def test_what_is_about_the_origin_is_one_stage(link):
    assert [stage.parts for stage in stages([link])] == [1]
