"""The Clip panel as a person uses it: a window dragged and typed, lines drawn, clippers stepped and asked."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QStyle, QStyleOptionButton
from shapely import LineString
from shapely import box as shapely_box

from tests.panels.by_hand import at, drag, recorded, settle
from workbench.algorithms import marks
from workbench.algorithms.clipping.window_marks import edge_mark
from workbench.document.edits import add_figure, set_clip, set_clipper
from workbench.document.model import Circle, Line, Polygon, Rectangle, WorldPoint
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.subjects import Subject
from workbench.exchange.run_tables import hand
from workbench.exchange.writing import format_for, write
from workbench.exchange.written import formats
from workbench.panels.clip.scene import outcomes, tally
from workbench.panels.shared.why import WhyList
from workbench.rendering import frame_buffer
from workbench.rendering.clipping import segments_of
from workbench.rendering.comparing import figure_pixels
from workbench.shell.style_sheet import style_sheet
from workbench.widgets.fields.option_buttons import OptionButtons
from workbench.widgets.look.tokens import LIGHT
from workbench.widgets.stepping.sentence_view import SentenceView

LEFT = Qt.MouseButton.LeftButton


def window(session):
    clip = session.sheet.first_view.clip_world
    return clip.xmin, clip.ymin, clip.xmax, clip.ymax


def type_into(qtbot, field, text):
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()


# The window


@pytest.mark.parametrize(
    ("start", "end", "expected"),
    [
        ((38, 20), (42, 22), (8, 10, 42, 30)),
        ((8, 20), (3, 20), (3, 10, 38, 30)),
        ((23, 30), (23, 33), (8, 10, 38, 33)),
        ((38, 10), (40, 5), (8, 5, 40, 30)),
        ((23, 20), (25, 23), (10, 13, 40, 33)),
        ((8, 26), (5, 24), (5, 10, 38, 30)),
    ],
    ids=["right", "left", "top", "corner", "whole", "anywhere on a side"],
)
def test_the_window_is_dragged_by_sides_corners_and_as_a_whole(qtbot, session, panel, start, end, expected):
    drag(qtbot, panel, start, ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), end)
    assert window(session) == expected
    assert session.undo_stack.count() == 1
    session.undo_stack.undo()
    assert window(session) == (8, 10, 38, 30)


def test_a_side_dragged_past_the_other_stops_a_pixel_before_it(qtbot, session, panel):
    drag(qtbot, panel, (38, 20), (20, 20), (2, 20))
    assert window(session) == (8, 10, 9, 30)


def test_escape_brings_the_window_back(qtbot, session, panel):
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, 38, 20))
    qtbot.mouseMove(panel.canvas, at(panel, 45, 20))
    settle()
    assert window(session)[2] == 45
    assert "8 to 45" in panel.canvas._tag
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, 45, 20))
    settle()
    assert window(session) == (8, 10, 38, 30)
    assert session.undo_stack.count() == 0


def test_the_window_is_typed_and_one_without_width_is_refused_in_place(qtbot, session, panel):
    type_into(qtbot, panel.card.sides["xmax"], "30+4/2")
    assert window(session) == (8, 10, 32, 30)
    type_into(qtbot, panel.card.sides["xmin"], "32")
    assert window(session) == (8, 10, 32, 30)
    assert panel.card.complaint.isVisible()
    assert panel.card.complaint.text() == (
        "The window has no width: x_min and x_max are both 32. Drag one of its sides, or type another value."
    )
    type_into(qtbot, panel.card.sides["xmin"], "10")
    assert window(session) == (10, 10, 32, 30)
    assert not panel.card.complaint.isVisible()


def test_an_empty_sheet_asks_for_a_window_then_for_lines(qtbot, session, panel):
    session.new(blank_sheet(50, 42))
    settle()
    assert panel.empty.isVisible()
    assert panel.card.add.isVisible()
    assert panel.tool.name == "window"
    drag(qtbot, panel, (40, 30), (20, 20), (10, 8))
    assert window(session) == (10, 8, 40, 30)
    assert panel.tool.name == "line"
    drag(qtbot, panel, (2, 15), (20, 16), (48, 18))
    recorded(qtbot, session)
    assert isinstance(session.sheet.figures[0], Line)
    assert session.run.entry.slug == "cohen_sutherland"
    assert tally(session.sheet) == {"accepted": 0, "clipped": 1, "rejected": 0}


# What the clippers keep

coordinates = st.integers(-20, 70)


@given(
    coordinates, coordinates, coordinates, coordinates, st.sampled_from(["cohen_sutherland", "liang_barsky"])
)
def test_accepted_clipped_and_rejected_are_told_apart(x0, y0, x1, y1, clipper):
    document = blank_sheet(50, 42)
    ends = (WorldPoint("", float(x0), float(y0)), WorldPoint("", float(x1), float(y1)))
    document = add_figure("s1", Line("", ends, "bresenham_line"))(document)
    document = set_clip("v1", Rectangle(8.0, 10.0, 38.0, 30.0))(document)
    document = set_clipper("s1", clipper)(document)
    sheet = document.sheets[0]
    (outcome,) = outcomes(sheet, sheet.figures[0])
    inside = shapely_box(8, 10, 38, 30)
    line = LineString([(x0, y0), (x1, y1)])
    expected = "accepted" if inside.covers(line) else "clipped" if inside.intersects(line) else "rejected"
    assert outcome.fate == expected
    for kept in outcome.kept:
        assert LineString([kept[:2], kept[2:]]).length == pytest.approx(inside.intersection(line).length)


def test_the_example_says_how_many_lines_are_inside_cut_and_outside(session, panel):
    assert tally(session.sheet) == {"accepted": 1, "clipped": 3, "rejected": 2}
    said = panel.card.outcome.text()
    for words in ("1 inside, accepted", "3 clipped", "2 outside, rejected"):
        assert words in said


def words(panel):
    return [each.text for each in panel.canvas.overlay.drawn if isinstance(each, marks.Word)]


def test_nine_regions_have_their_codes_and_can_be_without(qtbot, session, panel):
    nine = {"1001", "1000", "1010", "0001", "0000", "0010", "0101", "0100", "0110"}
    assert nine <= set(words(panel))
    panel._actions["codes"].trigger()
    settle()
    assert words(panel) == []


def test_the_code_of_an_end_keeps_clear_of_its_label(session, panel):
    below, above = [
        each.up
        for each in panel.canvas.overlay.drawn
        if isinstance(each, marks.Word) and (each.x, each.y) in {(48, 10), (18, 40)}
    ]
    assert below != above


# The stepped run


def strokes(panel, ink, weight):
    return [
        each.points.tolist()
        for each in panel.canvas.overlay.drawn
        if isinstance(each, marks.Stroke) and each.ink == ink and each.weight == weight
    ]


def test_each_step_marks_its_edge_and_shows_what_is_left(qtbot, session, panel):
    session.update_state(active="f6")
    recorded(qtbot, session)
    assert session.run.entry.slug == "cohen_sutherland"
    session.run.go(1)
    settle()
    box = (8.0, 10.0, 38.0, 30.0)
    assert strokes(panel, "accent", "heavy") == [edge_mark(box, 8).points.tolist()]
    assert strokes(panel, "data1", "medium") == [[[28, 30], [48, 10]]]
    session.run.go(2)
    settle()
    assert strokes(panel, "accent", "heavy") == [edge_mark(box, 2).points.tolist()]
    assert strokes(panel, "data1", "medium") == [[[28, 30], [38, 20]]]


def test_liang_barsky_shows_its_interval_shrinking(qtbot, session, panel):
    session.update_state(active="f4")
    box = panel.card.clipper
    box.setCurrentIndex(box.findData("liang_barsky"))
    box.activated.emit(box.currentIndex())
    recorded(qtbot, session)
    assert session.run.entry.slug == "liang_barsky"
    lengths = []
    for step in range(1, 5):
        session.run.go(step)
        settle()
        (interval,) = strokes(panel, "data1", "bold")
        lengths.append(float(np.hypot(*np.subtract(*interval))))
    assert lengths == sorted(lengths, reverse=True)
    assert lengths[0] > lengths[-1] > 0
    assert any(text.startswith("u₁ = ") for text in words(panel))


def test_a_polyline_is_clipped_side_by_side_and_the_run_knows_which(qtbot, session, panel):
    panel.choose_tool("polyline")
    for place in ((2, 2), (2, 20), (20, 20), (20, 20)):
        qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, *place))
    recorded(qtbot, session)
    calls = set()
    for step in range(1, len(session.run.steps) + 1):
        session.run.go(step)
        calls.add(session.run.own_call().number)
    assert calls == {0, 1}


def test_a_concave_polygon_leaves_degenerate_edges_which_are_said(qtbot, session, panel):
    session.open_example("clip-fork")
    recorded(qtbot, session)
    assert isinstance(session.sheet.figures[0], Polygon)
    assert session.run.entry.slug == "sutherland_hodgman"
    assert "degenerate edge" in panel.card.outcome.text()
    session.run.last()
    settle()
    assert strokes(panel, "error", "bold") != []


def test_nothing_of_the_card_is_shown_only_to_be_hidden(qtbot, session, panel, monkeypatch):
    """At each move of a drag the card would be laid out twice."""
    session.open_example("clip-fork")
    recorded(qtbot, session)
    corner = session.sheet.figures[0].points_world[0]
    asked = []
    for box in (panel.card.algorithm, panel.card.compare):
        monkeypatch.setattr(box, "setVisible", asked.append)
    drag(qtbot, panel, (corner.x, corner.y), (corner.x + 2, corner.y + 1), (corner.x + 3, corner.y))
    assert session.sheet.figures[0].points_world[0] != corner
    assert len(asked) >= 4
    assert not any(asked)


def test_a_point_is_put_and_its_four_comparisons_are_stepped(qtbot, session, panel):
    panel.choose_tool("point")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 20, 14))
    settle()
    point = session.sheet.figures[-1]
    assert isinstance(point, Circle)
    assert point.radius_world == 0
    recorded(qtbot, session)
    assert session.run.entry.slug == "clip_point"
    assert outcomes(session.sheet, point)[0].fate == "accepted"


def test_asked_first_a_person_accepts_rejects_or_says_which_side(qtbot, session, panel):
    buttons, told = OptionButtons(session.run), SentenceView(session.run)
    qtbot.addWidget(buttons)
    qtbot.addWidget(told)
    session.update_state(active="f6")
    recorded(qtbot, session)
    assert buttons.buttons == []
    session.update_state(ask_first=True)
    settle()
    by_text = {button.text(): button for button in buttons.buttons}
    assert "Accept" in by_text
    buttons.setStyleSheet(style_sheet(LIGHT))
    buttons.show()
    for button in buttons.buttons:
        option = QStyleOptionButton()
        button.initStyleOption(option)
        room = button.style().subElementRect(QStyle.SubElement.SE_PushButtonContents, option, button)
        assert room.height() >= button.fontMetrics().height()
    qtbot.mouseClick(by_text["Clip top"], LEFT)
    settle()
    assert (session.run.right, session.run.wrong) == (1, 0)
    by_text = {button.text(): button for button in buttons.buttons}
    assert told.plain.startswith("Right. ")
    qtbot.mouseClick(by_text["Reject"], LEFT)
    settle()
    assert (session.run.right, session.run.wrong) == (1, 1)
    assert told.plain.startswith("No: “reject” is not what comes next.")
    assert session.run.position == 1
    assert [button.text() for button in buttons.buttons if not button.isEnabled()] == ["Reject"]
    session.run.try_again()
    assert all(button.isEnabled() for button in buttons.buttons)
    qtbot.mouseClick(by_text["Reject"], LEFT)
    right = session.run.steps[2].answer
    qtbot.mouseClick(by_text[right[:1].upper() + right[1:]], LEFT)
    settle()
    assert (session.run.position, session.run.right, session.run.wrong) == (2, 1, 1)
    assert told.plain.startswith("Right. ")


def test_what_is_stepped_follows_the_panel_that_is_seen(qtbot, session, panel):
    recorded(qtbot, session)
    assert session.state.subject == Subject("clipper")
    session.new(example("clip-lab").document)
    settle()
    assert session.state.subject == Subject("clipper")


def test_why_leads_to_a_step_of_what_draws_the_line_and_the_canvas_back_to_the_clipper(qtbot, session, panel):
    why = WhyList(session)
    qtbot.addWidget(why)
    why.show()
    recorded(qtbot, session)
    session.run.go(1)
    line = session.sheet.figures[0]
    x, y = figure_pixels(session.sheet, line)[4].tolist()
    session.update_state(pixel=(x, y))
    session.flush()
    qtbot.waitUntil(lambda: bool(why.answers) and not why.looking, timeout=10000)
    (number,) = [k for k, answer in enumerate(why.answers) if answer.figure_id == line.id]
    why.list.itemClicked.emit(why.list.item(number))
    recorded(qtbot, session)
    assert session.run.entry.slug == line.algorithm
    assert (session.run.position, session.state.step) == (why.answers[number].step,) * 2
    assert (x, y) in session.run.step.chosen
    session.update_state(active=session.sheet.figures[-1].id)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 1, 1))
    recorded(qtbot, session)
    assert session.state.subject == Subject("clipper")
    assert session.run.entry.slug == "cohen_sutherland"


def test_one_step_on_paper_has_the_construction_and_no_grips(qtbot, session, panel):
    session.update_state(active="f6")
    recorded(qtbot, session)
    made = panel.view.on_paper(2)
    assert made.overlay.handles == ()
    assert any(isinstance(each, marks.Stroke) and each.ink == "accent" for each in made.overlay.drawn)


def test_the_hand_table_is_saved_with_every_digit(qtbot, session, panel, tmp_path):
    session.update_state(active="f6")
    recorded(qtbot, session)
    target = tmp_path / "table.csv"
    write(format_for(formats("table"), target), hand(session.run.steps), target)
    lines = target.read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + len(session.run.steps)
    assert len(lines[0].split(",")) >= len(session.run.entry.columns)


def test_a_point_outside_the_window_is_not_in_the_picture(qtbot, session, panel):
    session.new(example("clip-lab").document)
    painted = frame_buffer(session.sheet) != session.sheet.palette[0]
    rows, columns = np.nonzero(painted)
    assert painted.any()
    assert columns.min() >= 8
    assert columns.max() <= 38
    assert rows.min() >= 10
    assert rows.max() <= 30


def test_each_chord_of_a_curve_is_accepted_clipped_or_rejected():
    sheet = set_clip("v1", Rectangle(100, 40, 220, 170))(example("curve-bezier").document).sheets[0]
    counted = tally(sheet)
    assert counted["accepted"] > 3
    assert counted["clipped"] == 2
    assert counted["rejected"] > 1
    assert sum(counted.values()) == len(segments_of(sheet, sheet.figures[0]))


def test_what_is_said_of_the_cell_follows_the_window(qtbot, panel, session):
    said = []
    panel.hover_text.connect(said.append)
    panel.canvas.hovered.emit(40, 20)
    before = said[-1]
    view = session.sheet.first_view
    session.apply(set_clip(view.id, Rectangle(2.0, 2.0, 6.0, 6.0)), "Drag")
    settle()
    assert said[-1] != before
    assert "outside" in said[-1]
    session.apply(set_clip(view.id, view.clip_world), "Back")
    settle()
    assert said[-1] == before
    panel.canvas.hover_left.emit()
    session.apply(set_clip(view.id, Rectangle(2.0, 2.0, 6.0, 6.0)), "Unseen")
    settle()
    assert said[-1] == ""
