"""Why this pixel: what stands is what is seen, for pictures made at random, and what is said is true."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.model import AnyFigure, Circle, Ellipse, Line, Polygon, Rectangle, SeedFill, Sheet
from workbench.document.samples.examples import example
from workbench.document.samples.figures import document_of, points_at
from workbench.rendering import frame_buffer, painter_of, why
from workbench.rendering.why_steps import Abandoned, nothing_happened, why_steps

SIDE = 12
places = st.tuples(st.integers(-2, SIDE + 1), st.integers(-2, SIDE + 1))


@st.composite
def sheets(draw: st.DrawFn) -> Sheet:
    """A small picture of a few figures of all kinds, clipped or not."""
    figures: list[AnyFigure] = []
    for _number in range(draw(st.integers(1, 3))):
        colour = draw(st.integers(1, 3))
        kind = draw(st.sampled_from([Line, Circle, Ellipse, Polygon, SeedFill]))
        slug = draw(st.sampled_from([s for s in kind.algorithms if s != "wu_line"]))
        if kind is Line:
            figures.append(Line("", points_at(draw(places), draw(places)), slug, colour))
        elif kind is Circle:
            radius = float(draw(st.integers(0, 7)))
            figures.append(Circle("", points_at(draw(places)), slug, colour, radius_world=radius))
        elif kind is Ellipse:
            rx, ry = float(draw(st.integers(0, 7))), float(draw(st.integers(0, 7)))
            made = Ellipse("", points_at(draw(places)), slug, colour, radius_x_world=rx, radius_y_world=ry)
            figures.append(made)
        elif kind is Polygon:
            corners = points_at(*draw(st.lists(places, min_size=3, max_size=5)))
            figures.append(Polygon("", corners, slug, colour, closed_interior=draw(st.booleans())))
        else:
            seed = points_at(draw(places))
            limit = draw(st.sampled_from([10, 1000]))
            fill = SeedFill("", seed, slug, colour, boundary=draw(st.integers(1, 3)), recursion_limit=limit)
            figures.append(fill)
    clip = Rectangle(1.5, 2.0, 9.0, 9.5) if draw(st.booleans()) else None
    return document_of("", SIDE, SIDE, figures, clip).sheets[0]


@settings(max_examples=25, deadline=None)
@given(sheets(), st.integers(0, SIDE - 1), st.integers(0, SIDE - 1))
def test_the_last_that_was_accepted_is_what_is_seen(sheet: Sheet, x: int, y: int) -> None:
    painter = int(painter_of(sheet)[y, x])
    answers = why_steps(sheet, x, y)
    wrote = [answer for answer in answers if answer.verb == "wrote"]
    assert [answer for answer in answers if answer.stands] == wrote[-1:]
    if painter < 0:
        assert wrote == []
    else:
        assert wrote[-1].figure == painter
        assert wrote[-1].figure_id == sheet.figures[painter].id
    touched = {touch.figure for touch in why(sheet, x, y)}
    assert {answer.figure for answer in wrote} == touched
    if not answers:
        assert nothing_happened(sheet, x, y)


def test_a_filled_pixel_names_who_tested_it_and_who_refused_it() -> None:
    sheet = example("pond").document.sheets[0]
    answers = why_steps(sheet, 20, 20)
    assert [answer.verb for answer in answers].count("wrote") == 1
    assert [answer.verb for answer in answers].count("refused") == 3
    assert all("(20, 20)" in answer.sentence for answer in answers)
    steps = [answer.step for answer in answers]
    assert steps == sorted(steps)


def test_a_candidate_that_lost_is_an_answer() -> None:
    sheet = example("line").document.sheets[0]
    (answer,) = why_steps(sheet, 24, 12)
    assert (answer.verb, answer.stands, answer.step) == ("refused", False, 4)


def test_what_nothing_touched_is_answered_in_words() -> None:
    line = example("line").document.sheets[0]
    assert why_steps(line, 2, 2) == []
    assert "passes 18 pixels away" in nothing_happened(line, 2, 2)
    triangle = example("triangle").document.sheets[0]
    assert "outside by even-odd" in nothing_happened(triangle, 0, 8)
    assert "No figure" in nothing_happened(replace(line, figures=()), 2, 2)


def test_what_was_clipped_away_is_said_to_be_clipped() -> None:
    line = example("line").document.sheets[0]
    pixels = frame_buffer(line)
    y, x = (int(places[-1]) for places in np.nonzero(pixels != line.background))
    left = Rectangle(-0.5, -0.5, x - 2.0, line.height_px - 0.5)
    clipped = replace(line, views=(replace(line.first_view, clip_world=left),))
    assert why_steps(clipped, x, y) == []
    assert nothing_happened(clipped, x, y).endswith(
        f" would come to ({x}, {y}), but this is right of the clip window: "
        "Cohen-Sutherland cuts it off in step 1."
    )
    assert "passes" in nothing_happened(clipped, 0, line.height_px - 1)


@pytest.mark.parametrize(
    ("clipper", "cell", "where", "step"),
    [
        ("cohen_sutherland", (1, 1), "below and left of", 1),  # P0, code 0101: cut at the bottom, (4, 4)
        ("cohen_sutherland", (18, 18), "above and right of", 2),  # P1, code 1010, at the top: (16, 16)
        ("cohen_sutherland", (14, 14), "right of", 3),  # and once more, code 0010, at the right: (12, 12)
        ("liang_barsky", (1, 1), "below and left of", 1),  # left first: u1 grows
        ("liang_barsky", (14, 14), "right of", 2),  # then right: u2 shrinks
    ],
)
def test_the_step_that_cuts_a_line_off_is_told(clipper, cell, where, step) -> None:
    line = Line("f1", points_at((0, 0), (20, 20)), "bresenham_line", 1)
    bare = example("line").document.sheets[0]
    view = replace(bare.first_view, clip_world=Rectangle(4.0, 4.0, 12.0, 16.0))
    sheet = replace(bare, figures=(line,), views=(view,), line_clipper=clipper)
    said = nothing_happened(sheet, *cell)
    assert f"is {where} the clip window: " in said
    assert said.endswith(f" cuts it off in step {step}.")


def test_a_question_is_given_up_when_nobody_waits() -> None:
    with pytest.raises(Abandoned):
        why_steps(example("pond").document.sheets[0], 20, 20, lambda: True)


def test_steps_count_over_all_segments_of_a_polyline() -> None:
    sheet = example("house").document.sheets[0]
    walls = sheet.figures[1]
    painter = painter_of(sheet)
    _rows, columns = np.nonzero(painter == 1)
    right = int(columns.max())
    answers = why_steps(sheet, right, 10)
    mine = [answer for answer in answers if answer.figure_id == walls.id]
    # Up the left wall (18 pixels), along the top (28), and down the right wall.
    assert mine[-1].step > 18 + 28
