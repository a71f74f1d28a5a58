"""A display list put in order: every stroke once, each jump to the nearest end, in both ways of reckoning."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.scanning.stroke_order import nearest_end_first
from workbench.rendering.display_program import MOST_ORDERED, Strokes, nearest_first

# On a coarse grid equal distances come up often.
corners = st.tuples(st.integers(0, 6), st.integers(0, 6))
lists = st.lists(st.tuples(corners, corners), max_size=9)


@given(lists)
@settings(deadline=None)
def test_every_stroke_is_drawn_once_and_each_jump_is_the_shortest(ends) -> None:
    table = np.array(ends, float).reshape(-1, 2)
    order = list(nearest_end_first(table))
    assert sorted(k for k, _backwards in order) == list(range(len(ends)))
    at = ends[0][0] if ends else (0, 0)
    left = set(range(len(ends)))
    for k, backwards in order:
        begin, end = ends[k][::-1] if backwards else ends[k]
        nearest = min(max(abs(x - at[0]), abs(y - at[1])) for other in left for x, y in ends[other])
        assert max(abs(begin[0] - at[0]), abs(begin[1] - at[1])) == nearest
        left.remove(k)
        at = end


@given(lists)
@settings(deadline=None)
def test_whole_arrays_give_the_order_of_the_text(ends) -> None:
    table = np.array(ends, float).reshape(-1, 2, 2)
    strokes = Strokes(table, np.arange(len(ends)), np.full(len(ends), -1))
    ordered = nearest_first(strokes)
    expected = list(nearest_end_first(table.reshape(-1, 2)))
    assert ordered.colours.tolist() == [k for k, _backwards in expected]
    for place, (k, backwards) in enumerate(expected):
        assert ordered.ends[place].tolist() == table[k][:: -1 if backwards else 1].tolist()


def test_a_very_long_list_is_left_as_it_is() -> None:
    many = Strokes(np.zeros((MOST_ORDERED + 1, 2, 2)), np.zeros(MOST_ORDERED + 1), np.zeros(MOST_ORDERED + 1))
    assert nearest_first(many) is many
