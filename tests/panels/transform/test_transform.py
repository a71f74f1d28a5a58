"""The Transform panel as a person uses it: dragged, typed, put in order, stepped, asked, taken back."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from tests.panels.by_hand import LEFT, SHIFT, at, drag, settle
from tests.panels.transform.hand import chain, device, figure, handle, type_into, whole
from workbench.document.samples.examples import example
from workbench.document.transforms.chains import matrix_of
from workbench.document.transforms.edits import add_transform
from workbench.document.transforms.links import Affine, Reflect, Rotate, Scale, Shear, Translate
from workbench.exchange.formulas.terms import displayed
from workbench.panels.transform.chain_edits import FigureChain
from workbench.panels.transform.scene import curves_of
from workbench.panels.transform.told import place_text
from workbench.rendering.mapping import device_map

ALT = Qt.KeyboardModifier.AltModifier


def test_the_paper_s_numbers_are_there(panel, session):
    assert panel.matrices.rows[0].terms[1].cells[0][2].symbol == "x_p(1 − cos θ) + y_p sin θ"
    assert np.round(whole(panel), 4).tolist() == [[0.7071, -0.7071, 3], [0.7071, 0.7071, -1.2426], [0, 0, 1]]
    words = [each.text for each in panel.canvas.overlay.drawn if hasattr(each, "text")]
    assert {"(2.2929, 6.5355)", "(5, 6)", "0", "1", "2", "3"} <= set(words)


def test_the_round_handle_turns_about_the_pivot_as_one_step(qtbot, panel, session):
    before = session.document
    start = handle(panel, "turn")
    pivot = np.array(device(session, 3.0, 3.0))
    arm = np.array(start) - pivot
    for_each = [
        pivot + (arm @ [[math.cos(a), math.sin(a)], [-math.sin(a), math.cos(a)]]) for a in (0.3, math.pi / 6)
    ]
    drag(qtbot, panel, start, *map(tuple, for_each))
    (turn,) = chain(session)
    assert isinstance(turn, Rotate)
    assert (turn.x_pivot, turn.y_pivot) == (3.0, 3.0)
    assert turn.angle == pytest.approx(75.0, abs=1.0)
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-9)
    assert panel.chain.cards[0].fields["angle"].value() == turn.angle
    session.undo_stack.undo()
    assert session.document == before


def test_the_inside_moves_and_a_corner_scales_the_last_link_of_its_kind(qtbot, panel, session):
    middle = panel.view.chain_box.box.box.centre
    inside = middle[0] - 2, middle[1] + 2
    drag(qtbot, panel, inside, (inside[0] + 4, inside[1]), (inside[0] + 8, inside[1] + 4))
    drag(qtbot, panel, (inside[0] + 8, inside[1] + 4), (inside[0] + 12, inside[1] + 8))
    _turn, move = chain(session)
    assert isinstance(move, Translate)
    assert (move.tx, move.ty) == pytest.approx((3.0, 2.0), abs=0.1)
    corner, fixed = handle(panel, "top right"), handle(panel, "bottom left")
    drag(qtbot, panel, corner, (corner[0] + 3, corner[1] + 3), (corner[0] + 6, corner[1] + 6))
    _turn, _move, scaled = chain(session)
    assert isinstance(scaled, Scale)
    assert scaled.sx > 1.2
    assert scaled.sy > 1.2
    assert device(session, scaled.x_pivot, scaled.y_pivot) == pytest.approx(fixed, abs=1e-6)
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-9)
    assert session.undo_stack.count() == 3


def test_alt_on_a_side_shears(qtbot, panel, session):
    side = handle(panel, "top")
    drag(qtbot, panel, side, (side[0] + 3, side[1]), (side[0] + 6, side[1]), modifiers=ALT)
    shear = chain(session)[-1]
    # offscreen a move has no modifiers, so what a click inside switches is used where Alt is not seen
    if not isinstance(shear, Shear):
        session.undo_stack.undo()
        settle()
        x, y = panel.view.chain_box.box.box.centre
        qtbot.mouseClick(panel.canvas, LEFT, Qt.KeyboardModifier.NoModifier, at(panel, x - 2, y + 2))
        settle()
        side = handle(panel, "top")
        drag(qtbot, panel, side, (side[0] + 3, side[1]), (side[0] + 6, side[1]))
        shear = chain(session)[-1]
    assert isinstance(shear, Shear)
    assert shear.sh_x > 0
    assert shear.sh_y == 0.0


def test_the_cross_moves_the_pivot_as_one_step(qtbot, panel, session):
    before = session.document
    start = handle(panel, "pivot")
    drag(qtbot, panel, start, (start[0] - 4, start[1]), (start[0] - 8, start[1] - 4))
    (turn,) = chain(session)
    assert (turn.x_pivot, turn.y_pivot) == pytest.approx((1.0, 2.0), abs=0.1)
    assert turn.angle == 45.0
    session.undo_stack.undo()
    assert session.document == before


def test_a_point_is_dragged_where_it_was_drawn_although_the_box_lies_over_it(qtbot, panel, session):
    assert panel.view.chain_box.box.box.holds(device(session, 5.0, 6.0))
    drag(qtbot, panel, device(session, 5, 6), device(session, 5.5, 6.5), device(session, 6, 7))
    assert (figure(session).points_world[0].x, figure(session).points_world[0].y) == (6.0, 7.0)
    assert len(chain(session)) == 1


def test_keys_turn_move_and_step(qtbot, panel, session):
    qtbot.keyClick(panel.canvas, "[")
    settle()
    assert chain(session)[0].angle == 46.0
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Right, SHIFT)
    settle()
    assert chain(session)[1].tx == pytest.approx(2.5)
    panel._actions["ghosts"].trigger()
    assert not panel.card.ghosts.isChecked()
    panel._actions["axes"].trigger()
    assert panel.card.axes.isChecked()


def test_numbers_of_a_card_are_typed_and_refused(qtbot, panel, session):
    field = panel.chain.cards[0].fields["angle"]
    type_into(qtbot, field, "30")
    assert chain(session)[0].angle == 30.0
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-12)
    type_into(qtbot, field, "1e9")
    assert chain(session)[0].angle == 30.0
    assert "too large" in field.complaint.text()
    type_into(qtbot, field, "turn")
    assert chain(session)[0].angle == 30.0
    assert field.complaint.text()


def test_every_link_of_the_list_is_added_with_a_card_and_its_matrix(qtbot, panel, session):
    for number, action in enumerate(panel.chain.menu.actions(), 2):
        action.trigger()
        settle()
        assert len(chain(session)) == len(panel.chain.cards) == number
        np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-9)
    assert len(chain(session)) == 1 + len(FigureChain().offers())
    panel.view.chain_box.follow(figure(session))
    kinds = {type(link) for link in chain(session)}
    assert kinds == {Translate, Rotate, Scale, Reflect, Shear, Affine}
    session.undo_stack.undo()
    settle()
    assert len(panel.chain.cards) == len(FigureChain().offers())


def test_links_are_put_in_another_order_by_key_and_by_hand(qtbot, panel, session):
    session.apply(add_transform(figure(session).id, Translate("", tx=2.0)), "")
    session.apply(add_transform(figure(session).id, Scale("", sx=2.0)), "")
    settle()
    first = [type(link) for link in chain(session)]
    assert first == [Rotate, Translate, Scale]
    grip = panel.chain.cards[0].grip
    grip.setFocus()
    qtbot.keyClick(grip, Qt.Key.Key_Down)
    settle()
    assert [type(link) for link in chain(session)] == [Translate, Rotate, Scale]
    qtbot.keyClick(panel.chain.cards[1].grip, Qt.Key.Key_Down)
    settle()
    assert [type(link) for link in chain(session)] == [Translate, Scale, Rotate]
    qtbot.keyClick(panel.chain.cards[2].grip, Qt.Key.Key_Down)  # there is no place below
    settle()
    assert [type(link) for link in chain(session)] == [Translate, Scale, Rotate]
    count = session.undo_stack.count()
    card = panel.chain.cards[2]
    grip = card.grip
    qtbot.mousePress(grip, LEFT, pos=QPoint(8, 8))
    for _turn in range(2):
        above = panel.chain.cards[panel.chain.cards.index(card) - 1]
        place = above.mapToGlobal(QPoint(8, above.height() // 2 - 6))
        qtbot.mouseMove(grip, grip.mapFromGlobal(place))
        settle()
    qtbot.mouseRelease(grip, LEFT, pos=QPoint(8, 8))
    settle()
    assert [type(link) for link in chain(session)] == [Rotate, Translate, Scale]
    assert session.undo_stack.count() == count + 1
    session.undo_stack.undo()
    assert [type(link) for link in chain(session)] == [Translate, Scale, Rotate]


def test_a_link_is_switched_off_and_removed_and_an_empty_chain_offers_a_rotation(qtbot, panel, session):
    card = panel.chain.cards[0]
    qtbot.mouseClick(card.eye, LEFT)
    settle()
    assert not chain(session)[0].on
    assert not panel.matrices.rows
    assert card.title.text().endswith("switched off")
    qtbot.mouseClick(card.eye, LEFT)
    settle()
    assert chain(session)[0].on
    assert panel.matrices.rows
    qtbot.mouseClick(card.bin, LEFT)
    settle()
    assert chain(session) == ()
    assert session.run.entry is None
    assert panel.chain.sentence.text() == "This figure is as it was drawn."
    qtbot.mouseClick(panel.chain.first, LEFT)
    settle()
    assert [type(link) for link in chain(session)] == [Rotate]
    assert panel.chain.sentence.isHidden()


def test_a_stage_that_is_pointed_at_lights_its_ghost_and_its_matrix(qtbot, panel, session):
    panel.chain.cards[0].rows[1].setFocus()
    panel.chain.cards[0].rows[1].pointed.emit(2)
    settle()
    assert panel.view.lit == 2
    assert any(light.term == 4 for light in panel.matrices.views[0]._highlights)
    view = panel.matrices.views[1]
    view.cell_hovered.emit(3, 0, 0)
    settle()
    assert panel.view.lit == 2
    view.cell_hovered.emit(1, 0, 0)
    settle()
    assert panel.view.lit == 2  # the product up to the second stage
    view.hover_left.emit()
    settle()
    assert panel.view.lit is None


def test_a_number_in_a_matrix_changes_its_link(qtbot, panel, session):
    view = panel.matrices.views[1]
    assert view.editable((4, 0, 2))
    assert not view.editable((3, 0, 0))
    assert not view.editable((4, 2, 2))
    view.edit((4, 0, 2), "−1")
    qtbot.keyClick(view.editor, Qt.Key.Key_Return)
    settle()
    assert chain(session)[0].x_pivot == 1.0
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-12)
    count = session.undo_stack.count()
    box = view.cell_box((4, 1, 2)).center().toPoint()
    qtbot.mousePress(view, LEFT, pos=box)
    for far in (10, 30, 50):
        qtbot.mouseMove(view, box + QPoint(far, 0))
        settle()
    qtbot.mouseRelease(view, LEFT, pos=box + QPoint(50, 0))
    settle()
    assert chain(session)[0].y_pivot < 3.0
    assert session.undo_stack.count() == count + 1
    session.undo_stack.undo()
    assert chain(session)[0].y_pivot == 3.0


def test_a_drag_says_the_numbers_of_the_link_that_it_becomes(qtbot, panel, session):
    cross = handle(panel, "pivot")
    said = dragged_to(qtbot, panel, cross, (cross[0] + 4, cross[1]))
    at_pivot = place_text(round(chain(session)[-1].x_pivot, 2), round(chain(session)[-1].y_pivot, 2))
    assert said == f"pivot {at_pivot}"
    x, y = panel.view.chain_box.box.box.centre
    inside = x - 2, y + 2
    said = dragged_to(qtbot, panel, inside, (inside[0] + 8, inside[1] - 4))
    move = chain(session)[-1]
    assert said == f"move by ({displayed(move.tx)}, {displayed(move.ty)})"
    assert move.tx == pytest.approx(2.0, abs=0.1)
    corner = handle(panel, "top right")
    said = dragged_to(qtbot, panel, corner, (corner[0] + 6, corner[1] + 3))
    scale = chain(session)[-1]
    at_pivot = place_text(round(scale.x_pivot, 2), round(scale.y_pivot, 2))
    assert said == f"scale {displayed(scale.sx)} × {displayed(scale.sy)} about {at_pivot}"


def dragged_to(qtbot, panel, start, end):
    """Drag, and give what stood beside the pointer before it was let go."""
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, *start))
    for share in (0.5, 1.0):
        between = (a + share * (b - a) for a, b in zip(start, end, strict=True))
        qtbot.mouseMove(panel.canvas, at(panel, *between))
        settle()
    tag = panel.canvas.overlay.drawn[-1].text
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, *end))
    settle()
    return tag


def test_the_pivot_goes_with_the_figure_through_the_links_after_it(panel, session):
    address = figure(session).id
    session.apply(add_transform(address, Translate("", tx=2.0, ty=1.0)), "move")
    settle()
    assert panel.view.chain_box.pivot == (5.0, 4.0)
    session.apply(add_transform(address, Reflect("", angle=90.0, x_pivot=-1.0)), "mirror")
    settle()
    assert panel.view.chain_box.pivot == (-1.0, 0.0)


def test_a_pivot_that_was_put_somewhere_goes_with_the_figure_and_comes_back(qtbot, panel, session):
    address = figure(session).id
    session.apply(add_transform(address, Translate("", tx=2.0, ty=1.0)), "move")
    settle()
    start = handle(panel, "pivot")
    drag(qtbot, panel, start, (start[0] - 5, start[1]), (start[0] - 11, start[1] - 3))
    x, y = panel.view.chain_box.pivot
    assert (x, y) == pytest.approx((2.25, 3.25), abs=0.3)
    session.apply(add_transform(address, Translate("", tx=-3.0, ty=0.5)), "move")
    settle()
    assert panel.view.chain_box.pivot == pytest.approx((x - 3.0, y + 0.5))
    session.undo_stack.undo()
    settle()
    assert panel.view.chain_box.pivot == pytest.approx((x, y))


def test_round_figures_stand_in_the_plane_once_and_whole_whatever_the_views_show(panel, session):
    sheet = example("view-house").document.sheets[0]
    (sun,) = [each for each in sheet.figures if each.name == "Sun"]
    (ring,) = curves_of(sheet, sun)
    world = device_map(sheet).world(ring)
    middle = sun.points_world[0]
    far = np.hypot(world[:, 0] - middle.x, world[:, 1] - middle.y)
    np.testing.assert_allclose(far, sun.radius_world, atol=1e-3)
    assert len(sheet.views) == 2
    assert np.ptp(np.unwrap(np.arctan2(*(world - (middle.x, middle.y)).T))) == pytest.approx(2 * math.pi)
