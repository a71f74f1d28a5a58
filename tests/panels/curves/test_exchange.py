"""Curves in and out of the panel: freehand, clipboard, SVG, CSV, pictures; the nearest point."""

from itertools import starmap
from xml.etree import ElementTree

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    ZIGZAG,
    click,
    drag,
    opened,
    places,
    send,
    the_curve,
)
from workbench.algorithms import marks
from workbench.document.building import moved_by, without_ids
from workbench.document.model import Curve, CurvePoint
from workbench.exchange.svg_paths import write_svg
from workbench.exchange.writing import format_for, write
from workbench.panels.stage.pages import formats_of
from workbench.rendering.curves import polyline_of
from workbench.widgets.canvas.drawing import Marker
from workbench.widgets.look.tokens import LIGHT

CIRCLE = [(40 + 12 * np.cos(a), 24 + 12 * np.sin(a)) for a in np.linspace(0, 2 * np.pi, 90)]


def told(panel):
    said = []
    panel.hover_text.connect(said.append)
    return said


def test_what_is_drawn_freehand_becomes_a_smooth_closed_path(qtbot):
    panel = opened(qtbot)
    panel.choose_tool("freehand")
    said = told(panel)
    drag(panel, CIRCLE[0], *CIRCLE[1:])
    curve = the_curve(panel)
    assert curve.spline == "bezier_path"
    assert curve.closed
    assert len(curve.points_world) <= 36
    line = polyline_of(panel.session.sheet, curve)
    away = np.abs(np.hypot(*(line - (40, 24)).T) - 12)
    assert away.max() < 1.0
    assert any("pieces" in text for text in said)
    panel.session.undo_stack.undo()
    assert panel.session.sheet.figures == ()


def test_a_freehand_click_is_no_line_and_that_is_said(qtbot):
    panel = opened(qtbot)
    panel.choose_tool("freehand")
    said = told(panel)
    click(panel, 40, 20)
    assert panel.session.sheet.figures == ()
    assert any("length" in text for text in said)


def test_points_are_copied_as_a_table_and_pasted_on_the_end(qtbot, zigzag):
    click(zigzag, *ZIGZAG[1])
    zigzag.copy()
    assert QApplication.clipboard().text().splitlines()[1] == "32.0\t34.0"
    zigzag.paste()
    settle()
    assert places(zigzag) == [*ZIGZAG, ZIGZAG[1]]
    zigzag.session.undo_stack.undo()
    assert places(zigzag) == list(ZIGZAG)


def test_pasted_points_make_a_curve_of_the_pens_kind_where_none_is_selected(qtbot):
    panel = opened(qtbot)
    QApplication.clipboard().setText("x;y\n1,5;2\n20;30,5\n40;10")
    panel.exchange.paste()
    assert places(panel) == [(1.5, 2), (20, 30.5), (40, 10)]
    assert the_curve(panel).spline == panel.pen.model.spline


def test_a_table_with_a_word_in_it_is_refused_with_its_place(zigzag):
    said = told(zigzag)
    QApplication.clipboard().setText("1;2\n3;four")
    zigzag.exchange.paste()
    assert any("2" in text for text in said)
    assert places(zigzag) == list(ZIGZAG)


def test_points_that_are_refused_are_not_said_to_be_there(qtbot, zigzag):
    said = told(zigzag)
    QApplication.clipboard().setText("\n".join("1;2" for _point in range(10_000)))
    zigzag.exchange.paste()
    qtbot.waitUntil(lambda: bool(said))
    assert places(zigzag) == list(ZIGZAG)
    assert not any("added" in text for text in said)


def test_an_svg_path_on_the_clipboard_becomes_a_figure(qtbot):
    panel = opened(qtbot)
    drawn = '<path fill="none" stroke="black" d="M8 8C20 40 40 40 56 8"/>'
    path = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 48">{drawn}</svg>'
    QApplication.clipboard().setText(path)
    panel.exchange.paste()
    assert the_curve(panel).spline == "bezier_path"
    assert len(places(panel)) == 4


def test_path_data_on_the_clipboard_becomes_a_curve(qtbot):
    panel = opened(qtbot)
    QApplication.clipboard().setText(" M10 10 C 20 40 40 40 56 8\n")
    panel.exchange.paste()
    assert the_curve(panel).spline == "bezier_path"
    assert len(places(panel)) == 4


def test_a_broken_svg_says_where_and_leaves_everything(zigzag):
    said = told(zigzag)
    zigzag.exchange.take_svg('<svg xmlns="http://www.w3.org/2000/svg"><path d="M 1 2 L 3 oops"/></svg>')
    assert "oops" in said[-1]
    assert places(zigzag) == list(ZIGZAG)


def test_points_fitted_from_the_clipboard_tell_their_error(qtbot):
    panel = opened(qtbot)
    said = told(panel)
    QApplication.clipboard().setText("\n".join(starmap("{}\t{}".format, CIRCLE)))
    panel.exchange.paste_fitted()
    assert the_curve(panel).spline == "bezier_path"
    assert any("px away" in text for text in said)


def test_curves_are_written_as_svg_and_come_back(qtbot, zigzag, tmp_path):
    path = tmp_path / "curves.svg"
    write(format_for(formats_of("drawing"), path), write_svg(zigzag.session.sheet), path)
    other = opened(qtbot)
    said = []
    other.exchange.take_file(path, said.append, pytest.fail)
    assert said == ["curves.svg: 1 figure imported."]
    assert the_curve(other).spline == "b_spline"
    assert places(other) == pytest.approx(np.array(ZIGZAG))


@pytest.mark.parametrize("ending", ["csv", "txt"])
def test_points_are_saved_and_come_back(qtbot, zigzag, tmp_path, ending):
    path = tmp_path / f"points.{ending}"
    write(format_for(formats_of("points"), path), zigzag.points(), path)
    other = opened(qtbot)
    said = []
    other.exchange.take_file(path, said.append, pytest.fail)
    assert said == [f"points.{ending}: {len(ZIGZAG)} points added."]
    assert places(other) == list(ZIGZAG)


def test_only_the_chosen_points_are_saved(zigzag):
    click(zigzag, *ZIGZAG[1])
    assert zigzag.points() == [ZIGZAG[1]]


@pytest.mark.parametrize("ending", ["svg", "png", "pdf"])
def test_the_construction_is_saved_as_a_picture(zigzag, tmp_path, ending):
    zigzag.focus.switch("construction", True)
    path = tmp_path / f"construction.{ending}"
    write(format_for(formats_of("step"), path), zigzag.exporter.this_step(), path)
    begin = path.read_bytes()[:5]
    assert {"svg": b"<?xml", "png": b"\x89PNG\r", "pdf": b"%PDF-"}[ending] == begin
    if ending == "png":
        picture = QImage(str(path))
        seen = {picture.pixel(x, y) for x in range(picture.width()) for y in range(picture.height())}
        assert {QColor(LIGHT.accent).rgb(), QColor(LIGHT.data[1]).rgb()} <= seen
    if ending == "svg":
        shapes = [element.tag.rpartition("}")[2] for element in ElementTree.parse(path).iter()]
        assert shapes.count("polyline") + shapes.count("path") > 5


def test_a_long_svg_is_read_beside_and_comes_in_as_one_step_of_undo(qtbot):
    panel = opened(qtbot)
    said = told(panel)
    paths = "".join(
        f'<path fill="none" stroke="red" d="M {k} 0 C {k} 20 {k + 9} 20 {k + 9} 0"/>' for k in range(2000)
    )
    panel.exchange.take_svg(f'<svg xmlns="http://www.w3.org/2000/svg">{paths}</svg>')
    assert panel.session.sheet.figures == ()
    assert said == []  # that it is read is said by the window, once
    qtbot.waitUntil(lambda: len(panel.session.sheet.figures) == 2000, timeout=15000)
    assert said[-1].startswith("2000 figures")
    panel.session.undo_stack.undo()
    assert panel.session.sheet.figures == ()
    panel.exchange.take_svg(f'<svg xmlns="http://www.w3.org/2000/svg">{paths}</svg')
    qtbot.waitUntil(lambda: "XML is broken" in said[-1], timeout=15000)
    assert panel.session.sheet.figures == ()


def test_the_nearest_point_is_shown_and_a_click_goes_to_its_u(zigzag):
    zigzag.choose_tool("probe")
    from workbench.panels.curves.scene import point_at

    at = point_at(zigzag.session.sheet, the_curve(zigzag), 0.3)
    click(zigzag, *at)
    assert zigzag.focus.u == pytest.approx(0.3, abs=2e-3)
    away = at[0] + 3, at[1]
    send(zigzag, QEvent.Type.MouseMove, *away)
    zigzag.refresh()
    *_others, spot = [each for each in zigzag.view.drawn() if isinstance(each, Marker)]
    assert (spot.ink, spot.shape) == ("data2", "dot")
    line = polyline_of(zigzag.session.sheet, the_curve(zigzag))
    nearest = np.hypot(*(line - away).T).min()
    assert np.hypot(spot.x - away[0], spot.y - away[1]) == pytest.approx(nearest, abs=0.2)
    assert np.hypot(*(line - (spot.x, spot.y)).T).min() < 1


def test_every_page_of_a_run_has_the_points_made_so_far(qtbot, zigzag):
    qtbot.waitUntil(lambda: zigzag.session.run.done, timeout=15000)
    pages = [zigzag.view.on_paper(number) for number in range(len(zigzag.session.run.steps) + 1)]
    dots = [sum(isinstance(d, marks.Spot) and d.shape == "dot" for d in page.overlay.drawn) for page in pages]
    assert dots[0] == 0
    assert dots == sorted(dots)
    assert dots[-1] >= 5


@pytest.mark.parametrize("chosen", ["nothing", "all points"])
@pytest.mark.parametrize("spline", ["bezier_path", "nurbs", "hermite", "b_spline", "catmull_rom"])
def test_a_curve_that_is_copied_and_pasted_is_the_same_curve(qtbot, spline, chosen):
    """With its weights, tangents, joints and knots; also when the keys chose all of its points before."""
    chance = np.random.default_rng(5)
    points = tuple(
        CurvePoint("", *place, weight=1.0 + k % 3, tangent_x=6.0 - k, tangent_y=float(k), joint="smooth")
        for k, place in enumerate(chance.uniform(5, 40, (7, 2)).round(2).tolist())
    )
    panel = opened(qtbot, Curve("", points, "bresenham_line", 1, spline=spline))
    before = the_curve(panel)
    if chosen == "all points":
        panel.select_all()
        assert len(panel.focus.points) == 7
    panel.copy()
    panel.paste()
    settle()
    old, new = panel.session.sheet.figures
    assert old == before
    back = without_ids(moved_by(new, -1.0, 1.0))
    for one, other in zip(back.points_world, without_ids(old).points_world, strict=True):
        assert (one.x, one.y) == pytest.approx((other.x, other.y))
        assert replace(one, x=0.0, y=0.0) == replace(other, x=0.0, y=0.0)
    assert replace(back, points_world=()) == replace(without_ids(old), points_world=())
    assert panel.session.state.selection == (new.id,)
