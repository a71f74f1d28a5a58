"""Which vertex meets which, seen and turned: by a hand, by a number, by a key, as steps of undo."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from scipy.interpolate import BSpline
from shapely.geometry import Polygon as Shape

from tests.document.motion.moving import sheet_of, track
from tests.panels.by_hand import LEFT, settle
from workbench.algorithms.animation import morph
from workbench.document.model import Curve, CurvePoint, Document
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of
from workbench.document.samples.examples import example
from workbench.panels.animate.correspondence import corresponding, dragged, drawn, grips
from workbench.panels.animate.panel import AnimatePanel


@pytest.fixture
def letter(qtbot, panel: AnimatePanel) -> AnimatePanel:
    panel.session.open_example("animate-letter")
    qtbot.addWidget(panel.morph)
    panel.morph.resize(300, 420)
    panel.morph.show()
    panel.session.frames.show(18)
    settle()
    return panel


def shifts(panel: AnimatePanel) -> list[int]:
    return [key.shift for key in motion_of(panel.session.sheet).tracks[0].keys]


def seen(panel: AnimatePanel) -> list[tuple[float, float]]:
    return [(p.x, p.y) for p in panel.session.shown.figures[0].points_world]


def end_of(panel: AnimatePanel, vertex: int) -> QPoint:
    """Where a vertex of the second outline is drawn."""
    pair = panel.morph._pair
    assert pair is not None
    x, y = (pair.second[vertex] + pair.aside).tolist()
    return panel.morph.picture.position(x, y).toPoint()


def test_the_course_s_numbers_are_told(letter: AnimatePanel) -> None:
    assert letter.morph.title.text() == "Letter, outline: frame 6 to 30"
    assert letter.morph.sums.text().splitlines() == [
        "L_max = 12 edges, L_min = 6",
        "N_e = 12 mod 6 = 0",
        "N_s = 12 div 6 = 2",
        "each of 6 edges in 2 pieces",
    ]


def test_an_end_is_dragged_to_another_vertex_and_the_picture_follows(qtbot, letter: AnimatePanel) -> None:
    before, picture = seen(letter), letter.morph.picture
    qtbot.mousePress(picture, LEFT, pos=end_of(letter, 0))
    for vertex in (1, 2, 3):
        qtbot.mouseMove(picture, end_of(letter, vertex))
        settle()
        assert shifts(letter) == [0, vertex, 0, 0, 0]
    qtbot.mouseRelease(picture, LEFT, pos=end_of(letter, 3))
    settle()
    first, second = (
        np.array(key.value).reshape(-1, 2) for key in motion_of(letter.session.sheet).tracks[0].keys[1:3]
    )
    np.testing.assert_allclose(seen(letter), list(morph(first, second, True, 3, 0.5)))
    assert letter.morph.shift.value() == 3
    letter.session.undo_stack.undo()
    settle()
    assert shifts(letter) == [0] * 5
    assert seen(letter) == before
    assert not letter.session.undo_stack.canUndo()


def test_escape_takes_a_drag_back(qtbot, letter: AnimatePanel) -> None:
    picture = letter.morph.picture
    qtbot.mousePress(picture, LEFT, pos=end_of(letter, 0))
    qtbot.mouseMove(picture, end_of(letter, 4))
    settle()
    assert shifts(letter)[1] == 4
    qtbot.keyClick(picture, Qt.Key.Key_Escape)
    settle()
    assert shifts(letter) == [0] * 5
    assert not letter.session.undo_stack.canUndo()
    qtbot.mouseMove(picture, end_of(letter, 6))
    settle()
    assert shifts(letter) == [0] * 5


def test_any_end_turns_all_of_them(qtbot, letter: AnimatePanel) -> None:
    picture = letter.morph.picture
    qtbot.mousePress(picture, LEFT, pos=end_of(letter, 8))
    qtbot.mouseMove(picture, end_of(letter, 6))
    qtbot.mouseRelease(picture, LEFT, pos=end_of(letter, 6))
    settle()
    assert shifts(letter)[1] == 10


def test_by_number_and_by_keyboard(qtbot, letter: AnimatePanel) -> None:
    field = letter.morph.shift.field
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "14")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    settle()
    assert shifts(letter)[1] == 2
    picture = letter.morph.picture
    for key, shift in (
        (Qt.Key.Key_Right, 3),
        (Qt.Key.Key_Down, 2),
        (Qt.Key.Key_Left, 1),
        (Qt.Key.Key_Left, 0),
    ):
        qtbot.keyClick(picture, key)
        settle()
        assert shifts(letter)[1] == shift
    qtbot.keyClick(picture, Qt.Key.Key_Left)
    settle()
    assert shifts(letter)[1] == 11
    letter.session.undo_stack.undo()
    settle()
    assert shifts(letter)[1] == 0


def test_what_is_no_outline_has_nothing_to_turn(letter: AnimatePanel) -> None:
    letter.session.open_example("animate-clock")
    settle()
    assert letter.morph.title.text() == "No outline moves here"
    assert letter.morph.shift.isHidden()
    assert letter.morph.picture.isHidden()


def test_the_letter_never_crosses_itself() -> None:
    motion = example("animate-letter").document.sheets[0].motion
    assert motion is not None
    for first, second in pairwise(motion.tracks[0].keys):
        ends = (np.array(key.value).reshape(-1, 2) for key in (first, second))
        start, end = ends
        for t in np.linspace(0.0, 1.0, 13):
            assert Shape(list(morph(start, end, True, first.shift, t))).is_valid


places = st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=9, unique=True)


@settings(max_examples=40)
@given(places, places, st.integers(0, 20), st.booleans())
def test_what_is_drawn_is_what_the_text_makes(first, second, shift, closed) -> None:
    here, there = np.array(first, np.float64), np.array(second, np.float64)
    pair = corresponding(here, there, closed, shift)
    np.testing.assert_allclose(0.5 * (pair.start + pair.end), list(morph(here, there, closed, shift, 0.5)))
    own = pair.end[pair.own_places]
    np.testing.assert_allclose(own, np.roll(there, -pair.shift, axis=0) if closed else there)
    assert len(list(drawn(pair, 0.5))) >= len(pair.start)
    for handle in grips(pair):
        for vertex, (x, y) in enumerate(there.tolist()):
            turned = corresponding(here, there, closed, dragged(pair, handle.id, x + pair.aside[0], y))
            assert turned.end[int(handle.id)].tolist() == there[vertex].tolist()


@pytest.mark.parametrize(("spline", "straight"), [("b_spline", True), ("catmull_rom", False)])
def test_a_curve_between_two_is_the_mix_of_both_where_that_is_said(
    letter: AnimatePanel, spline: str, straight: bool
) -> None:
    first, second = [(2.0, 2), (9, 20), (18, 4), (30, 9)], [(6.0, 9), (3, 25), (25, 20), (31, 2)]
    curve = Curve("f1", (), "bresenham_line", spline=spline)
    points = tuple(CurvePoint(f"p{number}", x, y) for number, (x, y) in enumerate(first, 2))
    keys = [(frame, tuple(map(float, np.ravel(places)))) for frame, places in ((0, first), (10, second))]
    sheet = replace(sheet_of(track("f1/points_world", *keys)), figures=(replace(curve, points_world=points),))
    letter.session.new(Document((sheet,)))
    letter.session.frames.show(3)
    settle()
    assert letter.morph.shift.isHidden()
    assert letter.morph.note.text().startswith("Each point moves to the point with the same number.")
    assert ("straight line" in letter.morph.note.text()) == straight
    ends = [at(sheet, frame).figures[0].points_world for frame in (0, 3, 10)]
    if straight:
        start, between, end = ([de_boor_point(each, u) for u in np.linspace(3.0, 4.0, 9)] for each in ends)
        np.testing.assert_allclose(between, 0.7 * np.array(start) + 0.3 * np.array(end), atol=1e-9)


def de_boor_point(points, u: float) -> np.ndarray:
    """By SciPy, over even knots."""
    return BSpline(np.arange(8.0), np.array([(p.x, p.y) for p in points]), 3)(u)


def test_what_has_no_outline_says_what_to_do_and_leads_to_an_example(qtbot, letter: AnimatePanel) -> None:
    dock, session = letter.morph, letter.session
    session.open_example("animate-ball")
    settle()
    assert dock.note.isVisible()
    assert dock.note.text().startswith("Choose the track of an outline")
    qtbot.mouseClick(dock.example, Qt.MouseButton.LeftButton)
    settle()
    assert session.sheet.name == "A letter becomes another"
    assert (session.frames.number, dock.example.isVisible(), dock.picture.isVisible()) == (18, False, True)
