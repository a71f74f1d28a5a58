"""The Visibility page as a person uses it: stepped, clicked, asked first, rounded, framed."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QLabel

from tests.panels.by_hand import recorded, settle
from workbench.document.scene.edits import set_camera
from workbench.document.scene.viewing import projection_matrix
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Sentence
from workbench.panels.space.visibility.depth_run import depth_run
from workbench.panels.stage.picture import packed
from workbench.rendering import render_scene
from workbench.rendering.subjects.visibility import window_of
from workbench.widgets.fields.option_buttons import OptionButtons
from workbench.widgets.look.tokens import tokens
from workbench.widgets.stepping.step_slider import StepSlider

LEFT = Qt.MouseButton.LeftButton
TELLING = 684
"""The step in which the second triangle comes in front of the first, at (23, 15)."""


def go(qtbot, session, step):
    session.update_state(step=step)
    recorded(qtbot, session)


def click(qtbot, page, x, y):
    qtbot.mouseClick(page.canvas, LEFT, pos=page.canvas.widget_position(x, y).toPoint())
    settle()


def shown(page):
    return page.canvas.picture.pixels


def test_the_run_is_that_of_the_depth_buffer_and_begins_before_its_first_fragment(page, session):
    assert session.run.entry.slug == "depth_buffer"
    assert session.run.total_steps == 893
    run = depth_run(session)
    assert run.reached == 0
    assert run.now is None
    assert page.plot.row is None
    assert not page.lens.isVisible()


def test_at_the_telling_step_picture_plot_lens_and_legend_tell_the_same(qtbot, page, session):
    go(qtbot, session, TELLING)
    orange, blue = (packed(tokens().data[k]) for k in (1, 0))
    assert shown(page)[15, 23] == orange
    assert shown(page)[15, 22] == blue
    assert page.canvas.overlay.current == ((23, 15),)
    row = page.plot.row
    assert (row.y, row.column) == (15, 23)
    assert row.stored[23] == pytest.approx(0.52)
    assert row.won.tolist() == [[23, pytest.approx(0.5075)]]
    assert len(row.refused) == 16
    assert (row.refused[:, 1] >= row.stored[row.refused[:, 0].astype(int)]).all()
    assert row.to_come[0].tolist() == [24, pytest.approx(0.495)]
    assert row.step == "−A/C = −0.0125"
    assert "A −10.188  B 3.26  C −815" in row.plane
    cells = page.lens.cells
    assert cells.texts[2] == ("0.500", "0.510", "0.508", "0.530", "0.540")
    assert cells.notched[2].tolist() == [False, False, True, False, False]
    assert "Triangle 1, now" in page.card.legend.text()


def test_what_is_to_come_is_pale_and_the_last_step_shows_the_rendered_scene(qtbot, page, session):
    assert len(np.unique(shown(page))) == 3  # the ground and two pale colours
    go(qtbot, session, 893)
    image, _depth = render_scene(
        session.sheet.scene, "depth_buffer", (48, 32), window=window_of(session.sheet)
    )
    of_theme = {0: packed(tokens().canvas), 0x0072B2: packed(tokens().data[0])}
    of_theme[0xD55E00] = packed(tokens().data[1])
    assert shown(page).tolist() == [[of_theme[pixel] for pixel in row] for row in image.tolist()]


def test_a_click_goes_to_the_fragment_and_lists_all_that_came(qtbot, page, session):
    click(qtbot, page, 23, 15)
    assert session.state.step == 332
    assert session.state.pixel == (23, 15)
    click(qtbot, page, 23, 15)
    assert session.state.step == TELLING
    listed = [page.fragments.list.item(k).text() for k in range(page.fragments.list.count())]
    assert listed == [
        "Step 332: Triangle 0, won.\n0.5200 is less than 1.0000, which is stored there.",
        "Step 684: Triangle 1, won, and remains.\n0.5075 is less than 0.5200, which is stored there.",
    ]
    assert page.fragments.list.currentRow() == 1


def test_a_line_of_the_list_goes_to_its_step(qtbot, page, session):
    page.fragments.resize(300, 300)
    page.fragments.show()
    qtbot.addWidget(page.fragments)
    click(qtbot, page, 20, 15)
    assert "refused" in page.fragments.list.item(1).text()
    place = page.fragments.list.visualItemRect(page.fragments.list.item(1)).center()
    qtbot.mouseClick(page.fragments.list.viewport(), LEFT, pos=place)
    settle()
    assert session.state.step == TELLING - 3


def test_a_pixel_that_nothing_covers_says_so(qtbot, page, session):
    said = []
    page.hover_text.connect(said.append)
    click(qtbot, page, 46, 30)
    assert said[-1] == "No fragment reaches (46, 30)."
    assert "No surface covers it" in page.fragments.caption.text()
    assert session.state.step == 0


def test_asked_first_the_choice_is_whether_the_fragment_wins(qtbot, page, session):
    go(qtbot, session, TELLING - 1)
    session.run.set_ask_first(True)
    settle()
    buttons = OptionButtons(session.run)
    qtbot.addWidget(buttons)
    buttons.show()
    settle()
    assert buttons.buttons[0].text() == "Nearer: write z and the colour"
    click(qtbot, page, 23, 15)  # which asks why, and shows nothing that is to come
    assert session.state.step == TELLING - 1
    assert page.fragments.list.count() == 1
    qtbot.mouseClick(buttons.buttons[1], LEFT)
    assert session.run.refused
    qtbot.mouseClick(buttons.buttons[0], LEFT)
    settle()
    assert session.run.number == TELLING
    assert (session.run.right, session.run.wrong) == (0, 1)


def test_the_slider_marks_where_a_surface_begins(qtbot, page, session):
    slider = StepSlider(session.run)
    qtbot.addWidget(slider)
    assert slider.marks == (486,)
    assert depth_run(session).fragments.surface[[484, 485]].tolist() == [0, 1]


def choose(qtbot, box, data):
    """Choose by the keyboard, as a person may."""
    box.setFocus()
    wanted = box.findData(data)
    while box.currentIndex() != wanted:
        key = Qt.Key.Key_Down if box.currentIndex() < wanted else Qt.Key.Key_Up
        qtbot.keyClick(box, key)
        settle()


def test_few_bits_make_surfaces_fight_and_the_pixels_are_marked(qtbot, page, session):
    session.open_example("almost-one-plane")
    session.visit("visibility", page.usual)
    recorded(qtbot, session)
    go(qtbot, session, 1796)
    assert "wrong" not in page.card.legend.text()
    choose(qtbot, page.card.bits, 8)
    recorded(qtbot, session)
    assert session.subject.arguments["bits"] == 8
    assert session.state.step == 1796
    assert "204 pixels show the wrong surface." in page.card.legend.text()
    choose(qtbot, page.card.bits, 24)
    recorded(qtbot, session)
    assert "wrong" not in page.card.legend.text()


def test_the_size_is_chosen(qtbot, page, session):
    choose(qtbot, page.card.size_box, 24)
    recorded(qtbot, session)
    assert page.canvas.picture_size == (24, 16)
    assert session.state.step == 0


@pytest.mark.parametrize("shown_as", [1, 2, 3])
def test_depths_tests_and_overdraw_are_pictures_of_their_own(qtbot, page, session, shown_as):
    go(qtbot, session, 893)
    before = shown(page)
    qtbot.mouseClick(page.card.buttons.button(shown_as), LEFT)
    settle()
    assert (shown(page) != before).any()
    run = depth_run(session)
    if shown_as == 1:
        # The nearest fragment is the lightest.
        near = np.argmin(np.where(run.fragments.won, run.fragments.z, np.inf))
        written = run.so_far.writes(run.size) > 0
        assert shown(page)[run.fragments.y[near], run.fragments.x[near]] == shown(page)[written].max()
    else:
        counts = run.so_far.tests(run.size) if shown_as == 2 else run.so_far.writes(run.size)
        assert str(counts.sum()) in page.card.legend.text()
        assert len(np.unique(shown(page))) == len(np.unique(counts))


def test_in_the_other_order_the_last_picture_is_the_same(qtbot, page, session):
    go(qtbot, session, 893)
    before = shown(page).copy()
    qtbot.mouseClick(page.card.backwards, LEFT, pos=QPoint(12, page.card.backwards.height() // 2))
    recorded(qtbot, session)
    assert session.subject.arguments["backwards"] is True
    go(qtbot, session, 893)
    # At (22, 10) both depths are exactly 0.5, and there the first drawn stays.
    assert np.argwhere(shown(page) != before).tolist() == [[10, 22]]


def test_gains_and_costs_are_measured_on_the_scene(qtbot, page, session):
    page.cost.resize(320, 500)
    qtbot.addWidget(page.cost)
    page.cost.show()
    qtbot.waitUntil(lambda: page.cost.measures is not None, timeout=5000)
    text = page.cost.words.text()
    assert "Drawn in the opposite order, 1 of 622 pixels differs: its depths are equal." in text
    assert "1 pair of triangles pierces" in text
    assert "2 triangles, 893 fragments" in text
    assert "12,288 bytes" in text
    assert "Δz = (f − n) / (2<sup>b</sup> − 1)" in text


def test_a_matrix_of_ones_own_has_no_formula_for_its_depths(qtbot, page, session):
    scene = session.sheet.scene
    own = replace(
        scene.camera,
        projection="matrix",
        entries=tuple(projection_matrix(scene.camera).ravel().tolist()),
    )
    session.apply(set_camera(session.sheet.id, own), "Own")
    recorded(qtbot, session)
    qtbot.addWidget(page.cost)
    page.cost.show()
    qtbot.waitUntil(lambda: page.cost.measures is not None, timeout=5000)
    assert "Depths are not rounded now" in page.cost.words.text()
    assert "Δz" not in page.cost.words.text()


def test_near_beyond_the_scene_leaves_nothing_and_framing_brings_it_back(qtbot, page, session):
    field = page.card.planes["near"].field
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "10.5")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    settle()
    assert session.sheet.scene.camera.near == 10.5
    assert page.bare.isVisible()
    assert page.bare.sentence.text() == "No surface covers a pixel."
    assert session.run.number == 0
    qtbot.mouseClick(page.bare.button, LEFT)
    recorded(qtbot, session)
    assert not page.bare.isVisible()
    assert len(depth_run(session).fragments) > 0
    session.undo_stack.undo()
    settle()
    assert page.bare.isVisible()


def test_near_behind_far_is_refused_in_place(qtbot, page, session):
    field = page.card.planes["far"].field
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "0.5")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    settle()
    camera = session.sheet.scene.camera
    assert (camera.near, camera.far) == (1.0, 11.0)
    said = [label.text() for label in page.card.planes["far"].findChildren(QLabel) if label.isVisible()]
    assert any("near" in text for text in said)


def test_a_sheet_without_a_scene_offers_an_example(qtbot, page, session):
    session.new()
    session.visit("visibility", page.usual)
    settle()
    assert page.nothing.isVisible()
    assert page.card.isHidden()
    qtbot.mouseClick(page.nothing.button, LEFT)
    session.visit("visibility", page.usual)
    recorded(qtbot, session)
    assert not page.nothing.isVisible()
    assert session.sheet.scene is not None


def test_keys_step_and_ask(qtbot, page, session):
    page.activateWindow()
    page.canvas.setFocus()
    QApplication.processEvents()
    qtbot.keyClick(page.canvas, Qt.Key.Key_Right)
    assert session.run.number == 1
    qtbot.keyClick(page, Qt.Key.Key_End, Qt.KeyboardModifier.ControlModifier)
    assert session.run.number == 1
    qtbot.keyClick(page.canvas, Qt.Key.Key_End)
    assert session.run.number == 893
    qtbot.keyClick(page.canvas, Qt.Key.Key_Home)
    assert session.run.number == 0
    qtbot.mouseMove(page.canvas, page.canvas.widget_position(23, 15).toPoint())
    page._actions[0].trigger()
    assert session.state.pixel == (23, 15)


def test_in_detail_a_fragment_counts_from_the_line_that_emits_it(qtbot, page, session):
    go(qtbot, session, 5)
    session.run.set_detail(True)
    settle()
    assert depth_run(session).reached == 5
    while depth_run(session).reached == 5:
        session.run.forward()
    assert depth_run(session).reached == 6


def test_pointing_names_the_depth_and_its_surface(qtbot, page, session):
    go(qtbot, session, TELLING)
    assert page.describe(23, 15) == "(23, 15) depth 0.5075, Triangle 1"
    assert page.describe(0, 0) == "(0, 0) depth 1.0000, empty"


def test_back_faces_are_told_one_after_the_other(qtbot, page, session):
    session.open_example("almost-one-plane")
    session.visit("visibility", page.usual)
    recorded(qtbot, session)
    choose(qtbot, page.card.method, "back_faces")
    recorded(qtbot, session)
    assert session.run.entry.slug == "back_faces"
    assert session.run.total_steps == 12
    assert not page.plot.isVisible()
    assert page.card.bits.isHidden()
    go(qtbot, session, 12)
    # Of each box, turned by 20 degrees and seen from in front, two sides are seen.
    assert page.card.legend.text() == "4 faces seen, 8 turned away (dotted)."
    choose(qtbot, page.card.method, "depth_buffer")
    recorded(qtbot, session)
    go(qtbot, session, 1796)
    everything = shown(page)
    choose(qtbot, page.card.method, "back_faces")
    recorded(qtbot, session)
    go(qtbot, session, 12)
    # Two convex solids, one before the other: with the back faces gone the nearest of the rest is seen.
    assert (shown(page) == everything).all()


def test_parallel_projectors_leave_back_faces_out(page, session):
    assert page.card.method.findData("back_faces") < 0
    session.update_state(subject=Subject("visibility", entry="back_faces"))
    settle()
    assert session.run.entry.slug == "depth_buffer"


def test_the_page_to_export_has_the_numbers_of_the_step(qtbot, page, session):
    from workbench.exchange.diagram_svg import write_diagram

    go(qtbot, session, TELLING)
    settle()
    made = page.derivation()
    assert made is not None
    words = " ".join(block.text for block in made.blocks if isinstance(block, Sentence))
    for number in ("0.5075", "0.52", "−0.0125", "−10.1875"):
        assert number in words
    assert "it wins" in words
    assert "Triangle" in write_diagram(made)
    go(qtbot, session, 0)
    settle()
    before = page.derivation()
    assert before is not None
    assert not any("wins" in block.text for block in before.blocks if isinstance(block, Sentence))


def test_other_methods_are_stepped_with_their_own_marks(qtbot, page, session):
    """The painter's algorithm on planes that pierce one another: what is painted, pale what will be."""
    choose(qtbot, page.card.method, "painter")
    recorded(qtbot, session)
    assert session.run.entry.slug == "painter"
    assert not page.plot.isVisible()
    go(qtbot, session, 1)
    some = shown(page)
    assert session.run.marks()
    painted, whole = (
        int(part) for part in page.card.legend.text().replace(",", "").split() if part.isdigit()
    )
    assert 0 < painted < whole
    go(qtbot, session, session.run.total_steps)
    assert page.card.legend.text().startswith(f"{whole} of {whole} ")
    assert (shown(page) != some).any()
