"""A display list that is changed by hand: the figures are drawn by it afterwards, and stay what they can."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document import DocumentError
from workbench.document.edits import add_view
from workbench.document.model import Document, Line, Polyline
from workbench.document.samples.examples import example
from workbench.rendering.display_program import program_of, strokes_of
from workbench.rendering.list_edits import (
    Row,
    dimmed,
    drawn_by,
    inserted,
    rows_of,
    set_strokes,
    swapped,
    with_colour,
    with_place,
    without,
)

HOUSE = example("house").document


def edited(rows: list[Row], document: Document = HOUSE) -> Document:
    """The document drawn by these instructions."""
    sheet = document.sheets[0]
    return set_strokes(sheet, strokes_of(sheet), drawn_by(rows))(document)


def program(document: Document = HOUSE) -> list[Row]:
    """Its instructions."""
    return rows_of(program_of(strokes_of(document.sheets[0])))


def places(rows: list[Row]) -> np.ndarray:
    """What they draw, (n, 4)."""
    return np.array([stroke[:4] for stroke in drawn_by(rows)])


def test_an_unchanged_list_changes_nothing() -> None:
    assert edited(program()) == HOUSE


@given(st.data())
@settings(max_examples=40, deadline=None)
def test_the_sheet_draws_what_the_list_says(data: st.DataObject) -> None:
    """Whatever is done to a list, the sheet made of it has that list."""
    document, rows = HOUSE, program()
    for _change in range(data.draw(st.integers(1, 3))):
        address = data.draw(st.integers(1, len(rows) - 1))
        match data.draw(st.sampled_from(["place", "without", "stroke", "jump", "swap"])):
            case "place":
                rows = with_place(rows, address, data.draw(st.integers(0, 60)), data.draw(st.integers(0, 40)))
            case "without":
                rows = without(rows, address)
            case "stroke":
                rows = inserted(rows, address, (64, 48), False, 0x0072B2)
            case "jump":
                rows = inserted(rows, address, (64, 48), True, 0x0072B2)
            case "swap":
                strokes = swapped(rows, address, True)
                if strokes is None:
                    continue
                sheet = document.sheets[0]
                document = set_strokes(sheet, strokes_of(sheet), strokes)(document)
                rows = program(document)
                continue
        expected = places(rows)
        document = edited(rows, document)
        rows = program(document)
        assert np.allclose(places(rows), expected, atol=1e-6)


def test_only_the_figure_that_was_changed_is_taken_apart() -> None:
    rows = program()
    walls = next(k for k, row in enumerate(rows) if row.stroke == 2 and row.operation == 1)
    after = edited(with_place(rows, walls, 30.0, 30.0)).sheets[0]
    before = HOUSE.sheets[0]
    kept = [figure for figure in before.figures if figure in after.figures]
    assert len(kept) == len(before.figures) - 1
    lines = [figure for figure in after.figures if figure not in before.figures]
    assert all(isinstance(line, Line) for line in lines)
    assert len(lines) == 3
    assert len({figure.id for figure in after.figures}) == len(after.figures)


def test_a_line_stays_itself() -> None:
    document = example("line").document
    rows = program(document)
    after = edited(with_place(rows, 1, 33.0, 9.0), document).sheets[0].figures[0]
    before = document.sheets[0].figures[0]
    assert after.id == before.id
    assert [point.id for point in after.points_world] == [point.id for point in before.points_world]
    assert (after.points_world[1].x, after.points_world[1].y) == (33.0, 9.0)


def test_a_dimmer_stroke_is_another_colour_of_the_palette() -> None:
    document = example("line").document
    rows = program(document)
    dim = dimmed(rows[1].colour, 0.5)
    assert max(dim >> shift & 255 for shift in (16, 8, 0)) == 128
    sheet = edited(with_colour(rows, 1, dim), document).sheets[0]
    assert sheet.palette[sheet.figures[0].colour] == dim
    assert dimmed(0, 1.0) == 0xFFFFFF


def test_what_is_deleted_is_joined_over() -> None:
    rows = [Row(0, 0, 0), Row(1, 5, 0, 1), Row(1, 5, 5, 1), Row(0, 9, 9), Row(1, 9, 0, 1)]
    assert places(without(rows, 1)).tolist() == [[0, 0, 5, 5], [9, 9, 9, 0]]
    assert places(without(rows, 3)).tolist() == [[0, 0, 5, 0], [5, 0, 5, 5], [5, 5, 9, 0]]
    with pytest.raises(DocumentError, match="first MOVE places the beam"):
        without(rows, 0)


def test_the_first_and_the_last_stroke_go_no_further() -> None:
    rows = program()
    assert swapped(rows, 1, False) is None
    assert swapped(rows, len(rows) - 1, True) is None


def test_strokes_that_are_not_one_figure_s_are_refused() -> None:
    sheet = HOUSE.sheets[0]
    twice = add_view(sheet.id, replace(sheet.first_view, id=""))(HOUSE).sheets[0]
    with pytest.raises(DocumentError, match="Several views"):
        set_strokes(twice, strokes_of(twice), [])
    street = example("space-house").document.sheets[0]
    with pytest.raises(DocumentError, match="edges of the scene"):
        set_strokes(street, strokes_of(street), [])


def test_figures_without_strokes_stay_where_they_were() -> None:
    document = example("pond").document
    sheet = document.sheets[0]
    strokes = strokes_of(sheet)
    rows = rows_of(program_of(strokes))
    after = edited(with_place(rows, 1, 3.0, 3.0), document).sheets[0]
    silent = [f for n, f in enumerate(sheet.figures) if n not in set(strokes.figures.tolist())]
    assert silent
    assert [figure for figure in after.figures if figure in silent] == silent
    assert not any(isinstance(f, Polyline) and f in after.figures for f in sheet.figures[:1])
