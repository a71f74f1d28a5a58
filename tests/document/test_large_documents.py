"""What an edit looks at in a large document: what is new in it, and nothing else."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import documents, figures
from workbench.document import DocumentError, check, edits, identities
from workbench.document.differences import between
from workbench.document.model import Curve, CurvePoint, Document, Polyline, WorldPoint
from workbench.document.samples.examples import blank_sheet


def curve(identity: str = "", points: int = 7) -> Curve:
    names = [f"{identity}-{k}" if identity else "" for k in range(points)]
    return Curve(identity, tuple(CurvePoint(name, 3.0 * k, 5.0) for k, name in enumerate(names)), "dda_line")


def many(count: int) -> Document:
    (sheet,) = blank_sheet().sheets
    return check.check(Document((replace(sheet, figures=tuple(curve(f"f{n}") for n in range(count))),)))


def calls(act: Callable[[], object]) -> int:
    """How many Python functions are called in ``act``."""
    count = 0

    def look(_frame: FrameType, event: str, _what: Any) -> None:
        nonlocal count
        count += event == "call"

    before = sys.getprofile()
    sys.setprofile(look)
    try:
        act()
    finally:
        sys.setprofile(before)
    return count


@pytest.fixture
def looked_at(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The ids that were checked."""
    seen: list[str] = []
    whole = identities.are_ids

    def note(some: Any) -> bool:
        these = list(some)
        seen.extend(these)
        return whole(these)

    monkeypatch.setattr(identities, "are_ids", note)
    return seen


def test_adding_looks_at_the_new_ids_only(looked_at: list[str]) -> None:
    document = many(50)
    looked_at.clear()
    added = edits.add_figure("s1", curve())(document)
    assert sorted(looked_at) == sorted(added.sheets[0].figures[-1].ids)
    assert added.sheets[0].figures[-1].id == "f50"


@pytest.mark.parametrize(
    "edit",
    [
        edits.add_figure("s1", curve()),
        edits.add_figure("s1", curve(), 0),
        edits.add_figures("s1", [curve()] * 3),
        edits.duplicate_figures(["f9"]),
        edits.reorder("f9", 3),
        edits.rename_sheet("s1", "Other"),
    ],
)
def test_an_edit_calls_no_more_in_a_larger_document(edit: edits.Edit) -> None:
    small, large = many(20), many(200)
    for document in (small, large):
        edit(document)  # ids that were looked up once are kept
    # One call a figure may be needed to find those that are edited, and to put the new list together.
    assert calls(lambda: edit(large)) - calls(lambda: edit(small)) <= 2 * 180


lists = st.lists(st.integers(0, 3), max_size=8)


@given(lists, lists, lists, lists)
def test_what_lies_between_what_two_lists_share(
    first: list[int], last: list[int], one: list[int], two: list[int]
) -> None:
    values = [object() for _number in range(4)]
    old = tuple(values[k] for k in (*first, *one, *last))
    new = tuple(values[k] for k in (*first, *two, *last))
    start, old_end, new_end = between(old, new)
    assert 0 <= start <= min(old_end, new_end)
    assert all(a is b for a, b in zip(old[:start], new[:start], strict=True))
    assert all(a is b for a, b in zip(old[old_end:], new[new_end:], strict=True))
    # Nothing more could be taken off.
    a, b = old[start:old_end], new[start:new_end]
    assert not a or not b or (a[0] is not b[0] and a[-1] is not b[-1])


@st.composite
def mangled(draw: st.DrawFn, document: Document) -> Document:
    """``document`` after one change that nobody checked, and that may give an id twice."""
    at = draw(st.integers(0, len(document.sheets) - 1))
    sheet = document.sheets[at]
    known = [identity for _field, identity in check.ids(document)]
    identity = draw(st.sampled_from([*known, "new", "f77", "9f", "f1234567890123456", ""]))
    there = list(sheet.figures)
    match draw(st.integers(0, 5)):
        case 0:
            there.insert(draw(st.integers(0, len(there))), draw(figures("n")))
        case 1 if there:
            there.insert(draw(st.integers(0, len(there))), draw(st.sampled_from(there)))
        case 2 if there:
            figure = there.pop(draw(st.integers(0, len(there) - 1)))
            there.insert(draw(st.integers(0, len(there))), replace(figure, id=identity))
        case 3 if there:
            place = draw(st.integers(0, len(there) - 1))
            points = list(there[place].points_world)
            of = draw(st.integers(0, len(points) - 1))
            points[of] = replace(points[of], id=identity)
            there[place] = replace(there[place], points_world=tuple(points))
        case 4:
            there = draw(st.permutations(there))[: draw(st.integers(0, len(there)))]
        case _:
            sheet = replace(sheet, id=identity)
    sheet = replace(sheet, figures=tuple(there))
    sheets = (*document.sheets[:at], sheet, *document.sheets[at + 1 :])
    return replace(document, sheets=sheets + draw(st.sampled_from([(), (document.sheets[0],)])))


@given(st.data(), documents())
def test_to_look_at_what_is_new_is_enough(data: st.DataObject, before: Document) -> None:
    after = data.draw(mangled(before))
    given_ids = [identity for _field, identity in check.ids(after)]
    sound = len(set(given_ids)) == len(given_ids) and not {"9f", "f1234567890123456", ""} & set(given_ids)
    said = []
    for known in (None, before):
        try:
            check.check(after, known)
        except DocumentError as error:
            said.append(error.field)
    assert said == ([] if sound else [said[0]] * 2)
    assert sound or said[0].endswith(".id")


def test_a_shorter_palette_must_still_hold_every_colour() -> None:
    line = Polyline("", (WorldPoint("", 0.0, 0.0), WorldPoint("", 1.0, 1.0)), "dda_line", colour=2)
    document = edits.add_figure("s1", line)(many(3))
    assert edits.set_palette("s1", [0, 1, 2])(document).sheets[0].palette == (0, 1, 2)
    with pytest.raises(DocumentError) as refusal:
        edits.set_palette("s1", [0, 1])(document)
    assert refusal.value.field == "sheets[0].figures[3].colour"


def test_a_sheet_is_added_beside_itself_with_numbers_that_follow(looked_at: list[str]) -> None:
    document = many(30)
    twice = edits.add_sheet(document.sheets[0])(document)
    assert len({*document.sheets[0].figures[0].ids, *twice.sheets[1].figures[0].ids}) == 16
    assert [figure.id for figure in twice.sheets[1].figures[:2]] == ["f32", "f40"]


def test_what_moves_elsewhere_keeps_its_ids() -> None:
    document = edits.add_sheet(replace(blank_sheet().sheets[0], id="s2"))(many(4))
    first, second = document.sheets
    moved = (
        replace(first, figures=first.figures[:1] + first.figures[2:]),
        replace(second, figures=first.figures[1:2]),
    )
    after = replace(document, sheets=moved)
    assert check.check(after, document) is after
