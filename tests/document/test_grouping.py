"""Groups of figures: made, dissolved, copied, and moved in the order as one."""

from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.building import without_ids
from workbench.document.edits import (
    add_figures,
    duplicate_figures,
    group_figures,
    remove_figures,
    shift_order,
    ungroup_figures,
)
from workbench.document.model import Document, Line, Sheet, View, WorldPoint, whole_sheet
from workbench.document.storage.files import Stored, decode, encode


def picture(*groups: int) -> Document:
    """Lines f1, f2 and so on from the back, in these groups."""
    figures = tuple(
        Line(f"f{k}", (WorldPoint(f"p{2 * k}", 0, k), WorldPoint(f"p{2 * k + 1}", 9, k)), "dda_line", group=g)
        for k, g in enumerate(groups, 1)
    )
    view = View("v1", whole_sheet(20, 20), whole_sheet(20, 20))
    return Document((Sheet("s1", "sheet", 20, 20, (view,), (0, 1), figures),))


def order(document: Document) -> str:
    return " ".join(figure.id for figure in document.sheets[0].figures)


def groups(document: Document) -> list[int]:
    return [figure.group for figure in document.sheets[0].figures]


def test_a_group_lies_behind_its_front_figure_and_leaves_the_groups_it_was_of() -> None:
    made = group_figures(["f4", "f1"])(picture(0, 1, 1, 1, 0))
    assert order(made) == "f2 f3 f1 f4 f5"
    assert groups(made) == [1, 1, 2, 2, 0]
    assert groups(group_figures(["f2"])(picture(0, 0))) == [0, 0]


def test_ungrouping_one_dissolves_its_whole_group_and_no_other() -> None:
    assert groups(ungroup_figures(["f1"])(picture(1, 2, 1, 2, 0))) == [0, 2, 0, 2, 0]


def test_what_is_chosen_comes_with_its_groups() -> None:
    sheet = picture(1, 0, 1, 2, 2).sheets[0]
    assert sheet.together(["f3", "f2"]) == ("f3", "f2", "f1")
    assert sheet.together(["f2"]) == ("f2",)
    assert sheet.together([]) == ()


def test_copies_of_a_group_are_a_group_in_front_of_it() -> None:
    copied = duplicate_figures(["f1", "f2"])(picture(1, 1, 0))
    assert order(copied).split()[:2] == ["f1", "f2"]
    assert groups(copied) == [1, 1, 2, 2, 0]
    heights = [figure.points_world[0].y for figure in copied.sheets[0].figures]
    assert heights == [1, 2, 0, 1, 3]
    assert groups(duplicate_figures(["f1"])(picture(1, 1, 0))) == [1, 1, 0, 0]


def test_pasted_groups_are_not_those_that_are_there() -> None:
    there = picture(1, 1, 0)
    pasted = [without_ids(figure) for figure in picture(1, 1, 5).sheets[0].figures]
    assert groups(add_figures("s1", pasted)(there)) == [1, 1, 0, 2, 2, 0]


def test_a_group_goes_and_is_passed_as_one() -> None:
    assert order(shift_order(["f1"], 1)(picture(0, 1, 1, 0))) == "f2 f3 f1 f4"
    assert order(shift_order(["f2", "f3"], 1)(picture(0, 1, 1, 2, 2))) == "f1 f4 f5 f2 f3"
    assert order(shift_order(["f2", "f3"], -1)(picture(0, 1, 1, 0))) == "f2 f3 f1 f4"
    assert order(shift_order(["f2"], 1)(picture(0, 1, 1, 0))) == "f1 f3 f2 f4"
    assert order(shift_order(["f1", "f3"], 1)(picture(0, 0, 0, 0))) == "f2 f1 f4 f3"
    assert order(shift_order(["f3"], 1)(picture(0, 0, 0))) == "f1 f2 f3"


@given(
    st.lists(st.integers(0, 3), min_size=1, max_size=9),
    st.sets(st.integers(1, 9)),
    st.sampled_from([-1, 1]),
)
def test_whole_groups_that_move_stay_whole(numbers: list[int], chosen: set[int], by: int) -> None:
    before = picture(*sorted(numbers))
    picked = before.sheets[0].together(f"f{k}" for k in chosen if k <= len(numbers))
    after = shift_order(picked, by)(before)
    assert sorted(order(after).split()) == sorted(order(before).split())
    runs = [g for k, g in enumerate(groups(after)) if g and (k == 0 or groups(after)[k - 1] != g)]
    assert len(runs) == len(set(runs))
    unchosen = [f for f in order(before).split() if f not in picked]
    assert [f for f in order(after).split() if f in unchosen] == unchosen
    assert [f for f in order(after).split() if f not in unchosen] == [
        f for f in order(before).split() if f in picked
    ]


def test_a_file_keeps_groups() -> None:
    document = picture(3, 3, 0)
    stored = decode(encode(Stored(document)))
    assert stored.document == document
    last = remove_figures(["f1"])(stored.document)
    assert groups(last) == [3, 0]
    assert replace(last.sheets[0].figures[0], group=0) == replace(document.sheets[0].figures[1], group=0)
