"""The pictures of View as a person uses them: rectangles dragged and nudged, stages opened, zoom and pan."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import recorded, settle
from tests.panels.viewing.hand import ALT, LEFT, NO_KEYS, SHIFT, drag, viewport, window
from workbench.algorithms.marks import Word
from workbench.document.model import Rectangle
from workbench.document.samples.examples import example
from workbench.document.view_edits import set_window
from workbench.panels.stage.labels import word_box
from workbench.panels.viewing.strip import LEISURE_MS
from workbench.rendering import frame_buffer
from workbench.rendering.mapping import box, view_map
from workbench.widgets.canvas.label_places import hidden_area
from workbench.widgets.look.tokens import DARK


def test_sides_corners_and_the_inside_of_both_rectangles_are_dragged(qtbot, session, panel):
    drag(qtbot, panel.left, (4.0, 2.0), (4.5, 2.2), (5.0, 2.4))
    assert window(panel) == (1.0, 1.0, 5.0, 4.0)
    drag(qtbot, panel.left, (1.0, 1.0), (0.0, 0.0))
    assert window(panel) == (0.0, 0.0, 5.0, 4.0)
    drag(qtbot, panel.left, (1.5, 1.5), (2.5, 2.5))
    assert window(panel) == pytest.approx((1.0, 1.0, 6.0, 5.0))
    drag(qtbot, panel.right, (6.0, 6.0), (8.0, 7.0))
    assert viewport(panel) == (3.0, 2.0, 8.0, 7.0)
    assert session.undo_stack.count() == 4
    for _each in range(4):
        session.undo_stack.undo()
    settle()
    assert window(panel) == (1.0, 1.0, 4.0, 4.0)
    assert viewport(panel) == (3.0, 2.0, 6.0, 6.0)


def test_a_side_stops_before_the_other_and_escape_brings_a_drag_back(qtbot, session, panel):
    drag(qtbot, panel.left, (4.0, 2.5), (-3.0, 2.5))
    xmin, _ymin, xmax, _ymax = window(panel)
    assert 0 < xmax - xmin < 0.5
    session.undo_stack.undo()
    settle()
    plane = panel.left.plane
    qtbot.mousePress(plane, LEFT, NO_KEYS, plane.position(2.0, 1.5).toPoint())
    qtbot.mouseMove(plane, plane.position(3.0, 2.5).toPoint())
    settle()
    assert window(panel) != (1.0, 1.0, 4.0, 4.0)
    assert panel.matrices.numbers._highlights
    assert panel.card.rectangles["window"].fields["xmin"].property("lit")
    qtbot.keyClick(plane, Qt.Key.Key_Escape)
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, plane.position(3.0, 2.5).toPoint())
    settle()
    assert window(panel) == (1.0, 1.0, 4.0, 4.0)
    assert session.undo_stack.isClean() or session.undo_stack.index() == 0
    assert not panel.matrices.numbers._highlights


def test_what_a_drag_changes_is_lit_and_nothing_else(qtbot, session, panel):
    plane = panel.right.plane
    qtbot.mousePress(plane, LEFT, NO_KEYS, plane.position(6.0, 4.0).toPoint())
    qtbot.mouseMove(plane, plane.position(8.0, 4.0).toPoint())
    settle()
    lit = [side for side, field in panel.card.rectangles["viewport"].fields.items() if field.property("lit")]
    assert lit == ["xmax"]
    assert [(h.term, h.row, h.column) for h in panel.matrices.numbers._highlights] == [
        (1, 0, 0),
        (1, 0, 2),
        (4, 0, 0),
    ]
    assert "<b" in panel.card.factors.text().partition("<br>")[0]
    assert "<b" not in panel.card.factors.text().partition("<br>")[2]
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, plane.position(8.0, 4.0).toPoint())


def test_keys_move_and_resize_the_rectangle_of_the_focused_picture(qtbot, session, panel):
    plane = panel.left.plane
    plane.setFocus()
    step = plane.grid / 10
    qtbot.keyClick(plane, Qt.Key.Key_Right)
    settle()
    assert window(panel) == pytest.approx((1 + step, 1, 4 + step, 4))
    qtbot.keyClick(plane, Qt.Key.Key_Up, ALT)
    settle()
    assert window(panel) == pytest.approx((1 + step, 1, 4 + step, 4 + step))
    other = panel.right.plane
    step = other.grid / 10
    qtbot.keyClick(other, Qt.Key.Key_Left)
    settle()
    assert viewport(panel) == pytest.approx((3 - step, 2, 6 - step, 6))


def test_asked_first_the_place_in_the_viewport_is_kept_back(qtbot, session, panel):
    recorded(qtbot, session)
    session.update_state(ask_first=True, step=0)
    settle()
    assert session.run.options
    words = [each for each in panel.right.plane.plane.drawn if "P′" in getattr(each, "text", "")]
    assert not words
    session.run.choose("the picture is distorted")
    settle()
    assert session.run.right == 1


def test_stages_open_at_the_left_and_with_shift_at_the_right(qtbot, panel):
    tiles = panel.strip.tiles
    qtbot.mouseClick(tiles["normalise"], LEFT)
    qtbot.mouseClick(tiles["device"], LEFT, SHIFT)
    assert (panel.left.stage.slug, panel.right.stage.slug) == ("normalise", "device")
    assert [slug for slug, tile in tiles.items() if tile.is_open] == ["normalise", "device"]
    qtbot.mouseClick(tiles["device"], LEFT)
    assert (panel.left.stage.slug, panel.right.stage.slug) == ("device", "normalise")


def test_the_device_shows_the_frame_buffer(qtbot, session, panel):
    session.open_example("view-house")
    settle()
    panel.open_stage("device", right=True)
    settle()
    shown = panel.right.plane.plane.pixels
    plain = frame_buffer(session.sheet)
    background = session.sheet.palette[session.sheet.background]
    canvas = int(DARK.canvas.removeprefix("#"), 16)
    assert shown.shape == plain.shape
    assert np.array_equal(shown != canvas, plain != background)
    assert (plain != background).sum() > 100


def test_the_pictures_show_what_the_device_paints(qtbot, session, panel):
    """Each lit pixel lies beside a curve of the viewport picture, none of which leaves the viewports."""
    session.open_example("view-house")
    settle()
    strokes = [
        each.points for each in panel.right.plane.plane.drawn if getattr(each, "ink", "").startswith("#")
    ]
    lit = np.argwhere(frame_buffer(session.sheet) != session.sheet.palette[0])[:, ::-1]
    corners = np.concatenate(strokes)
    inside = np.zeros(len(corners), bool)
    for view in session.sheet.views:
        xmin, ymin, xmax, ymax = box(view.viewport_device)
        inside |= (corners >= (xmin - 1e-9, ymin - 1e-9)).all(axis=1) & (
            corners <= (xmax + 1e-9, ymax + 1e-9)
        ).all(axis=1)
    assert inside.all()
    away = np.full(len(lit), np.inf)
    for stroke in strokes:
        for start, end in pairwise(stroke):
            along = end - start
            share = np.clip(((lit - start) @ along) / max(along @ along, 1e-12), 0, 1)
            away = np.minimum(away, np.hypot(*(lit - start - share[:, None] * along).T))
    assert away.max() <= 1.0


def test_the_wheel_and_the_hand_change_the_window(qtbot, session, panel):
    plane = panel.left.plane
    at = plane.position(2.0, 2.0)
    event = QWheelEvent(
        at, plane.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton, NO_KEYS,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    place = plane.place(at)
    before = [(side - place[k % 2]) for k, side in enumerate(window(panel))]
    QApplication.sendEvent(plane, event)
    settle()
    after = [(side - place[k % 2]) for k, side in enumerate(window(panel))]
    assert after == pytest.approx([side / 1.25 for side in before], abs=1e-6)
    session.undo_stack.undo()
    settle()
    panel.choose_tool("pan")
    drag(qtbot, panel.right, (4.0, 4.0), (5.0, 4.0))
    xmin, ymin, _xmax, ymax = window(panel)
    assert xmin == pytest.approx(0.0, abs=0.05)
    assert (ymin, ymax) == (pytest.approx(1.0, abs=0.05), pytest.approx(4.0, abs=0.05))
    panel.fit()
    settle()
    assert window(panel)[0] < 0 < 5 < window(panel)[2]


def test_low_the_strip_is_names_only_and_the_matrices_numbers_only(qtbot, panel):
    panel.resize(620, 340)
    settle()
    assert not panel.strip.pictured
    assert panel.matrices.symbols.isHidden()
    assert not panel.matrices.numbers.isHidden()
    assert panel.left.plane.height() >= 180
    panel.resize(1000, 640)
    settle()
    assert panel.strip.pictured
    assert not panel.matrices.symbols.isHidden()


def test_an_empty_world_offers_the_house(qtbot, session, panel):
    session.new()
    settle()
    assert panel.empty.isVisible()
    qtbot.mouseClick(panel.empty.button, LEFT)
    settle()
    assert panel.empty.isHidden()
    assert len(session.sheet.views) == 2


def test_a_window_far_away_or_tiny_is_shown(qtbot, session, panel):
    for sides in ((9e5, 9e5, 9.5e5, 9.2e5), (2.0, 2.0, 2.000001, 2.000001)):
        session.apply(set_window(panel.view.id, Rectangle(*sides)), "Set")
        settle()
        assert not panel.grab().isNull()
        corner = panel.left.plane.position(*sides[2:])
        assert QPointF(0, 0) != corner
        assert panel.left.plane.rect().contains(corner.toPoint())


def test_the_window_over_the_pane_shows_the_same_house():
    """What is seen of the outermost house in one view is what is seen of the next one in the other."""
    (sheet,) = example("view-again").document.sheets
    outer, inner = sheet.views
    for figure, again in zip(sheet.figures[:12], sheet.figures[4:], strict=True):
        for point, same in zip(figure.points_world, again.points_world, strict=True):
            x, y = view_map(outer).point(point.x, point.y)
            assert view_map(inner).point(same.x, same.y) == pytest.approx((x + 64.0, y))


def test_no_label_lies_over_a_handle(qtbot, session, panel):
    drag(qtbot, panel.left, (3.6, 2.7))  # its label at the usual side would reach the edge
    for picture in (panel.left, panel.right):
        plane, unit = picture.plane.plane, picture.plane.unit
        words = [each for each in plane.drawn if isinstance(each, Word) and each.carded]
        assert len(words) >= 2
        for word in words:
            spots = [(each.x - unit, each.y - unit, each.x + unit, each.y + unit) for each in plane.handles]
            assert hidden_area(word_box(word, unit), np.array(spots)) == 0.0, word


def test_the_picture_of_pixels_in_the_strip_waits_for_the_end_of_a_drag(qtbot, session, panel):
    tiles, plane = panel.strip.tiles, panel.left.plane
    before = {slug: tile.plane for slug, tile in tiles.items()}
    places = [plane.position(x, x).toPoint() for x in (4.0, 4.2, 4.4)]
    qtbot.mousePress(plane, LEFT, NO_KEYS, places[0])
    for place in places[1:]:
        qtbot.mouseMove(plane, place)
        settle()
    qtbot.waitUntil(lambda: all(tiles[slug].plane is not before[slug] for slug in tiles if slug != "device"))
    qtbot.wait(3 * LEISURE_MS)
    assert tiles["device"].plane is before["device"]
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, places[-1])
    settle()
    assert tiles["device"].plane is not before["device"]


def test_while_a_figure_of_another_workspace_is_stepped_it_shows_no_point(qtbot, panel, session):
    session.new(example("triangle").document)
    session.update_state(workspace="fill", active=session.sheet.figures[0].id)
    recorded(qtbot, session)
    session.run.go_to_number(3)
    panel.refresh()
    assert session.run.entry.topic == "polygons"
    assert panel._point_now() is None
    assert panel.marks() == ()
