"""What the Transform panel shows of a chain: stepped, asked, looked into, compared, taken out."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.panels.by_hand import LEFT, at, drag, recorded, settle
from tests.panels.transform.hand import chain, device, figure, handle, shown, whole
from workbench.algorithms.marks import Word
from workbench.document.edits import set_attribute
from workbench.document.samples.examples import blank_sheet
from workbench.document.storage.files import read
from workbench.document.transforms.chains import matrix_of
from workbench.document.transforms.edits import add_transform
from workbench.document.transforms.links import Affine, Reflect, Scale, Translate
from workbench.exchange.writing import format_for, write
from workbench.panels.stage.labels import clear_of, word_box
from workbench.panels.stage.pages import formats_of
from workbench.session.session import Session
from workbench.widgets.canvas.label_places import hidden_area


def test_the_products_are_stepped_cell_by_cell(qtbot, panel, session):
    recorded(qtbot, session)
    assert session.run.last_position == 18
    session.update_state(step=15)
    settle()
    row = panel.matrices.rows[-1]
    last = whole(panel)
    assert np.isnan(last[2]).all()
    assert round(last[1, 2], 4) == -1.2426
    assert [(light.term, light.row, light.column) for light in row.highlights] == [
        (3, 1, None),
        (4, None, 2),
        (1, 1, 2),
    ]
    assert not np.isnan(shown(panel, 1, 1)).any()
    session.update_state(step=4)
    settle()
    assert np.isnan(whole(panel)).all()
    assert np.isnan(shown(panel, 1, 1)).sum() == 5
    session.update_state(step=0)
    settle()
    assert not np.isnan(whole(panel)).any()


def test_a_chosen_point_is_taken_through_the_chain(qtbot, panel, session):
    recorded(qtbot, session)
    panel._actions["step_point"].trigger()
    recorded(qtbot, session)
    assert session.run.entry.slug == "transform_point"
    panel._actions["next_vertex"].trigger()
    recorded(qtbot, session)
    assert panel.view.vertex == 1
    assert np.round(shown(panel, -1, 1), 4).ravel().tolist() == [5.8284, 4.4142, 1.0]
    session.update_state(step=1)
    settle()
    assert np.isnan(shown(panel, -1, 1)[1:]).all()
    panel._actions["step_products"].trigger()
    recorded(qtbot, session)
    assert session.run.entry.slug == "matrix_product"


def test_asked_first_the_element_is_clicked_and_then_its_number_chosen(qtbot, panel, session):
    recorded(qtbot, session)
    said = []
    panel.hover_text.connect(said.append)
    session.update_state(ask_first=True)
    settle()
    assert np.isnan(shown(panel, 1, 1)).all()
    view = panel.matrices.views[1]
    qtbot.mouseClick(view, LEFT, pos=view.cell_box((1, 1, 1)).center().toPoint())
    settle()
    assert said[-1].startswith("Not this one")
    assert panel.view.asked is None
    qtbot.mouseClick(view, LEFT, pos=view.cell_box((1, 0, 0)).center().toPoint())
    settle()
    assert panel.matrices.rows[1].terms[1].cells[0][0].hidden
    assert session.run.choose(session.run.steps[1].answer)
    settle()
    assert round(shown(panel, 1, 1)[0, 0], 4) == 0.7071
    assert panel.view.asked is None


@pytest.mark.parametrize(
    "link",
    [Scale("", sx=0.0), Scale("", sx=0.0, sy=0.0), Affine("", m11=1.0, m12=2.0, m21=2.0, m22=4.0)],
)
def test_what_cannot_be_undone_is_said_and_has_no_box(qtbot, panel, session, link):
    session.apply(add_transform(figure(session).id, link), "")
    settle()
    assert "flattens the figure" in panel.chain.cards[-1].complaint.text()
    assert panel.view.chain_box.box.box is None
    drag(qtbot, panel, device(session, 4, 1), device(session, 4, 0))
    assert figure(session).points_world[2].y == 0.0
    panel.view._show_whole()
    assert panel.derivation() is not None


def test_huge_numbers_are_shown_or_refused(qtbot, panel, session):
    address = f"{session.sheet.id}/{figure(session).id}/{chain(session)[0].id}/x_pivot"
    session.apply(set_attribute(address, 1e6), "")
    settle()
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), rtol=1e-9, atol=1e-6)
    for _more in range(3):
        panel.chain.append(lambda _pivot: Scale("", sx=1e6, sy=1e6))
        settle()
    assert len(chain(session)) < 4  # the chain would come to more than a document holds
    assert np.isfinite(whole(panel)).all()


def test_the_other_order_stands_beside(qtbot, session, panel):
    session.open_example("transform-order")
    settle()
    assert panel.second.isHidden()
    panel.card.reversed.click()
    settle()
    assert panel.second.isVisible()
    words = [each.text for each in panel.second.overlay.drawn if hasattr(each, "text")]
    assert "(−1, 7)" in words  # moved to (7, 1) and then turned by 90 degrees


def words_of(canvas):
    return [each.text for each in canvas.overlay.drawn if isinstance(each, Word)]


def test_points_and_axes_stand_side_by_side_and_take_the_place_of_the_other_order(panel, session):
    session.open_example("transform-order")
    settle()
    panel.card.reversed.click()
    panel.card.both.click()
    settle()
    assert not panel.card.reversed.isChecked()
    assert {"the axes moved: new coordinates", "x′", "y′"} <= set(words_of(panel.second))
    assert "x′" not in words_of(panel.canvas)
    panel.card.reversed.click()
    settle()
    assert panel.card.points.isChecked()
    assert "in the opposite order" in words_of(panel.second)
    panel.card.reversed.click()
    settle()
    assert panel.second.isHidden()


def test_a_label_goes_where_no_handle_is(panel):
    label = next(
        each for each in panel.canvas.overlay.drawn if isinstance(each, Word) and each.text == "(5, 6)"
    )
    unit = panel.canvas.devicePixelRatioF() / panel.canvas.view.cell
    grips = panel.view.chain_box.box.places().values()
    near = [(x - 1.0 * unit, y, x + 1.0 * unit, y + 1.0 * unit) for x, y in grips]
    assert near
    assert hidden_area(word_box(label, unit), np.array(near)) == 0.0


def test_the_card_stays_small_beside_twenty_links(panel, session):
    high = panel.card.height()
    for k in range(19):
        session.apply(add_transform(figure(session).id, Translate("", tx=0.1 * k)), "")
    settle()
    assert panel.card.chain.links.text() == "20 transforms, the last of them Translate, Translate"
    assert panel.card.height() < high + 80
    assert len(panel.chain.cards) == 20
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-9)


@pytest.mark.parametrize(("right", "up"), [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_of_the_sides_of_a_point_the_free_one_is_taken(right, up):
    word = Word("(1, 2)", 0.0, 0.0, "text", 1, 1, True)
    boxes = {
        (i, j): word_box(word._replace(right=i, up=j), 1.0)
        for i in (-1, 0, 1)
        for j in (-1, 0, 1)
        if (i, j) != (0, 0)
    }
    middles = [((a + c) / 2, (b + d) / 2) for (i, j), (a, b, c, d) in boxes.items() if (i, j) != (right, up)]
    (placed,) = clear_of([word], middles, 1.0)
    taken = {
        side: hidden_area(box, np.array([(x - 8, y - 8, x + 8, y + 8) for x, y in middles]))
        for side, box in boxes.items()
    }
    assert taken[placed.right, placed.up] == min(taken.values())
    assert clear_of([word._replace(carded=False)], middles, 1.0) == [word._replace(carded=False)]


def test_the_axes_moved_give_the_new_coordinates(qtbot, session, panel):
    """Axes moved to (2, 1) and turned by 30 degrees: (5, 5) becomes (4.5981, 1.9641)."""
    ids = [point.id for point in figure(session).points_world]
    place = f"{session.sheet.id}/{figure(session).id}"
    session.apply(set_attribute(f"{place}/{ids[0]}/y", 5.0), "")
    session.apply(set_attribute(f"{place}/{chain(session)[0].id}/angle", 30.0), "")
    for axis in "xy":
        session.apply(set_attribute(f"{place}/{chain(session)[0].id}/{axis}_pivot", 0.0), "")
    session.apply(add_transform(figure(session).id, Translate("", tx=2.0, ty=1.0)), "")
    panel.card.axes.click()
    settle()
    words = [each.text for each in panel.canvas.overlay.drawn if hasattr(each, "text")]
    assert "x′, y′ = (4.5981, 1.9641)" in words


def test_the_inverse_and_the_parts_say_what_is_lost(panel, session):
    panel.whole.show()
    settle()
    panel.refresh()
    back = np.array([[cell.value for cell in line] for line in panel.whole.inverse.terms[1].cells])
    np.testing.assert_allclose(back @ whole(panel), np.eye(3), atol=1e-9)
    inverse, parts, _plane = panel.whole.buttons
    parts.click()
    assert "turned by 45°" in panel.whole.told.text()
    session.apply(add_transform(figure(session).id, Reflect("")), "")
    settle()
    assert "mirrored" in panel.whole.told.text()
    session.apply(add_transform(figure(session).id, Scale("", sy=0.0)), "")
    settle()
    assert "one line" in panel.whole.told.text()
    cells = panel.whole.parts.terms[-1].cells  # what the parts make together again
    again = np.array([[cell.value for cell in line] for line in cells])
    np.testing.assert_allclose(again, matrix_of(chain(session)), atol=1e-9)
    inverse.click()
    assert panel.whole.inverse.isHidden()
    assert "no matrix can undo it" in panel.whole.backwards.text()
    panel.whole.hide()


def test_the_plane_w_1_shows_the_point_and_its_image(panel):
    panel.whole.show()
    settle()
    panel.refresh()
    panel.whole.buttons[2].click()
    assert panel.whole.space_told.text().startswith("(5, 6) is written (5, 6, 1)")
    name = panel.whole.space.accessibleName()
    assert "P (5, 6)" in name
    assert "P′ (2.2929, 6.5355)" in name
    panel.whole.hide()


def test_a_figure_is_drawn_and_gets_its_first_link_from_a_drag(qtbot, panel, session):
    session.new(blank_sheet())
    settle()
    assert panel.tool.name == "polygon"
    assert panel.empty.isVisible()
    assert not panel.matrices.isVisible()
    for x, y in ((20, 10), (40, 10), (30, 30)):
        qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, x, y))
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert len(session.sheet.figures) == 1
    assert chain(session) == ()
    panel.choose_tool("select")
    session.update_state(selection=(figure(session).id,))
    settle()
    drag(qtbot, panel, (30, 18), (33, 18), (35, 20))
    assert [type(link) for link in chain(session)] == [Translate]
    assert (chain(session)[0].tx, chain(session)[0].ty) == pytest.approx((5.0, 2.0), abs=0.3)


def test_what_was_dragged_is_saved_and_read(qtbot, panel, session, tmp_path):
    start = handle(panel, "turn")
    drag(qtbot, panel, start, (start[0] - 5, start[1]), (start[0] - 10, start[1] - 2))
    session.save_as(tmp_path / "turned.gwb")
    assert read(tmp_path / "turned.gwb").document == session.document
    other = Session()
    other.open(tmp_path / "turned.gwb")
    assert other.sheet.figures[-1].transforms == chain(session)
    other.close()


@pytest.mark.parametrize("suffix", [".svg", ".pdf"])
def test_the_derivation_is_written(panel, session, tmp_path, suffix):
    path = tmp_path / f"derivation{suffix}"
    write(format_for(formats_of("derivation"), path), panel.derivation(), path)
    content = path.read_bytes()
    assert len(content) > 2000
    if suffix == ".svg":
        assert "0.7071" in content.decode()
        assert "2.2929" in content.decode()


def test_the_points_at_every_stage_are_a_table(panel, session):
    ((title, table),) = panel.tables()
    assert title == "Points at every stage"
    assert table.columns == ("k", "x_{0}", "y_{0}", "x_{1}", "y_{1}", "x_{2}", "y_{2}", "x_{3}", "y_{3}")
    assert [round(number, 4) for number in table.rows[0][-2:]] == [2.2929, 6.5355]


def test_copied_as_numpy_the_matrices_come_back(qtbot, panel, session):
    from PySide6.QtWidgets import QApplication

    copy = next(action for action in panel.matrices.views[-1].actions() if "NumPy" in action.text())
    copy.trigger()
    assert "-1.24264" in QApplication.clipboard().text()
    QApplication.clipboard().clear()


@pytest.mark.parametrize("slug", ["clock", "leaf", "shear", "order", "pivot"])
def test_every_example_shows_its_chain(panel, session, slug):
    session.open_example(f"transform-{slug}")
    settle()
    np.testing.assert_allclose(whole(panel), matrix_of(chain(session)), atol=1e-9)
    assert panel.exporter.page().picture.size == (session.sheet.width_px, session.sheet.height_px)


def test_the_dock_beside_a_drag_follows_at_leisure(qtbot, panel, session):
    panel.whole.show()
    settle()
    panel.refresh()
    before, start = panel.whole.inverse.terms, handle(panel, "turn")
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, *start))
    qtbot.mouseMove(panel.canvas, at(panel, start[0] - 8, start[1] - 2))
    qtbot.waitUntil(lambda: panel.whole.inverse.terms != before)
    assert panel.view.chain_box.busy
    back = np.array([[cell.value for cell in line] for line in panel.whole.inverse.terms[1].cells])
    np.testing.assert_allclose(back @ matrix_of(chain(session)), np.eye(3), atol=1e-9)
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, start[0] - 8, start[1] - 2))
    settle()
    panel.whole.hide()


def test_a_move_of_the_hand_is_shown_once(qtbot, panel, session, monkeypatch):
    start = handle(panel, "turn")
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, *start))
    settle()
    shown_as = []
    refresh = panel.view.refresh
    monkeypatch.setattr(
        panel.view, "refresh", lambda *given: (shown_as.append(chain(session)[0].angle), refresh(*given))
    )
    for k in range(1, 6):
        qtbot.mouseMove(panel.canvas, at(panel, start[0] - 3 * k, start[1] - 2 * k))
        settle()
        assert len(shown_as) == k
    assert sorted(set(shown_as)) == shown_as
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, start[0] - 15, start[1] - 10))
    settle()


def test_the_legend_keeps_its_rows_while_only_numbers_change(panel, session):
    address = f"{session.sheet.id}/{figure(session).id}/{chain(session)[0].id}/angle"
    session.apply(set_attribute(address, 10.0), "turn")
    settle()
    rows, words = panel.view.legend.rows, panel.view.legend.rows[2].words.text()
    session.apply(set_attribute(address, 20.0), "turn")
    settle()
    assert panel.view.legend.rows is rows
    assert (words, rows[2].words.text()) == ("turned by 10°", "turned by 20°")


def test_the_legend_goes_where_the_figure_is_not(panel, session):
    def overlaps():
        hidden = panel.view.legend.geometry().intersected(
            panel.view.chain_box.rectangle(figure(session)).toRect()
        )
        return not hidden.isEmpty()

    panel.resize(1100, 620)
    settle()
    places = set()
    for tx, ty in ((0.0, 0.0), (5.0, -5.0), (5.0, 1.0), (6.0, -5.0)):
        session.apply(add_transform(figure(session).id, Translate("", tx=tx, ty=ty)), "move")
        settle()
        assert not panel.view.legend.isHidden()
        assert not overlaps()
        places.add(panel.view.legend.y() < panel.canvas.height() / 4)
        session.undo_stack.undo()
        settle()
    assert places == {True, False}


@pytest.mark.parametrize("by", [(-14.0, 0.0), (9.0, -9.0), (0.0, 12.0)])
def test_what_a_link_moves_out_of_the_picture_stays_in_sight(qtbot, panel, session, by):
    canvas = panel.canvas
    session.apply(add_transform(figure(session).id, Translate("", tx=by[0], ty=by[1])), "Move it away")
    settle()
    matrix = matrix_of(chain(session))
    for point in figure(session).points_world:
        x, y, w = matrix @ (point.x, point.y, 1.0)
        assert w == 1.0
        screen_x, screen_y = canvas.view.to_screen(*device(session, x, y))
        assert canvas.area.left <= screen_x <= canvas.area.right
        assert canvas.area.top <= screen_y <= canvas.area.bottom
    fitted = canvas.view
    session.undo_stack.undo()
    settle()
    assert canvas.view.cell > fitted.cell or canvas.view == fitted


def test_a_picture_that_somebody_moved_is_not_moved_back_by_a_link(qtbot, panel, session):
    panel.canvas.zoom(1)
    moved = panel.canvas.view
    session.apply(add_transform(figure(session).id, Translate("", tx=20.0)), "Move it away")
    settle()
    now = panel.canvas.view
    assert (now.cell, now.left) == (moved.cell, moved.left)
