"""What refers to something that went or shrank meanwhile: nothing breaks, and a person is told."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import click, curve_through, hover, opened
from workbench.document.edits import add_figure, remove_figures, set_algorithm, set_sheet_size
from workbench.document.model import Circle, Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.display.tubes_page import TubesPage
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.shared.compare import CompareView
from workbench.session.session import Session
from workbench.widgets.tube.glass import nearest_pixel

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def session() -> Iterator[Session]:
    made = Session(document=blank_sheet(64, 48))
    sheet = made.sheet.id
    line = Line("f1", (WorldPoint("p1", 2, 3), WorldPoint("p2", 40, 20)), "bresenham_line", 1)
    made.apply(add_figure(sheet, line), "Draw")
    circle = Circle("f2", (WorldPoint("p3", 30, 30),), "midpoint_circle", 1, radius_world=9.0)
    made.apply(add_figure(sheet, circle), "Draw")
    made.update_state(selection=("f1",), active="f1")
    yield made
    made.close()
    made.deleteLater()


def show(qtbot: QtBot, widget: QWidget) -> None:
    qtbot.addWidget(widget)
    widget.resize(1000, 700)
    widget.show()
    qtbot.waitExposed(widget)
    settle()


# The probe


@pytest.mark.parametrize("tube", ["raster", "vector"])
@pytest.mark.parametrize("corner", [(0, 0), (63, 47)])
def test_the_probe_stays_on_a_picture_that_shrinks(
    qtbot: QtBot, session: Session, tube: str, corner: tuple[int, int]
) -> None:
    panel = TubesPage(session)
    show(qtbot, panel)
    view = getattr(panel, tube)
    glass = view._glass
    lowest, size = view.position(*corner), (20, 12)
    assert glass.contains(lowest)
    qtbot.mouseClick(view, LEFT, pos=lowest.toPoint())
    assert view.probe == corner
    session.apply(set_sheet_size(session.sheet.id, *size), "Change sheet size")
    settle()
    panel.instruments.refresh()
    assert view.probe == nearest_pixel(*corner, size)


# Curves without a curve yet


@pytest.mark.parametrize("spline", ["b_spline", "nurbs", "bezier_path"])
@pytest.mark.parametrize(
    "name",
    [
        *("insert", "split", "remove_knot", "raise", "lower", "reverse", "closed", "flatten", "make_G1"),
        *("convert_bezier", "convert_nurbs", "convert_hermite", "mirror_x", "copy_points", "show_comb"),
    ],
)
def test_commands_say_what_a_curve_with_too_few_points_lacks(qtbot: QtBot, spline: str, name: str) -> None:
    panel = opened(qtbot, curve_through((5, 5), (20, 30), (40, 8), spline=spline))
    said: list[str] = []
    panel.hover_text.connect(said.append)
    before = panel.session.document
    panel._actions[name].trigger()
    panel.commands.insert(panel.focus.curve, 0.3) if panel.focus.curve is not None else None
    panel._insert_knot(0.4)
    settle()
    if name in ("insert", "split", "remove_knot"):
        assert panel.session.document == before or spline == "bezier_path"
        assert any(said)


@pytest.mark.parametrize("spline", ["b_spline", "bezier_path"])
def test_the_pen_does_not_go_on_with_a_curve_that_went(qtbot: QtBot, spline: str) -> None:
    places = ((10, 10), (20, 30), (30, 30), (40, 8))
    panel = opened(qtbot, curve_through(*places, spline=spline))
    session = panel.session
    panel.choose_tool("pen")
    click(panel, 40, 8)
    assert panel.pen.busy
    hover(panel, 50, 20)
    session.apply(remove_figures([session.sheet.figures[0].id]), "Delete")
    after = session.document
    hover(panel, 52, 22)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert session.document == after
    assert not panel.pen.busy


# Choices made in a list that was opened before something else became active


def test_an_algorithm_that_refuses_what_is_selected_is_said(qtbot: QtBot, session: Session) -> None:
    panel = DrawPanel(session)
    show(qtbot, panel)
    box = panel.card.algorithm
    assert box.findData("dda_line") >= 0
    session.update_state(selection=("f2",), active="f2")
    before = session.document
    box.activated.emit(box.findData("dda_line"))
    assert session.document == before
    assert "midpoint_circle" in panel.card.trouble.text()
    assert not panel.card.trouble.isHidden()
    settle()
    assert box.currentData() == "midpoint_circle"


def test_a_comparison_that_refuses_what_is_active_is_said(qtbot: QtBot, session: Session) -> None:
    view = CompareView(session)
    show(qtbot, view)
    settle()
    index = view.first.findData("dda_line")
    assert index >= 0
    session.update_state(selection=("f2",), active="f2", compare="")
    before = session.document
    view.first.activated.emit(index)
    assert session.document == before
    assert "midpoint_circle" in view.note.text()


# Fields of a figure that went


def test_a_number_typed_for_a_figure_that_went_changes_nothing(qtbot: QtBot, session: Session) -> None:
    panel = DrawPanel(session)
    show(qtbot, panel)
    field = next(iter(panel.card._fields.values())).field
    qtbot.mouseClick(field, LEFT)
    qtbot.keyClick(field, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    qtbot.keyClicks(field, "21")
    session.apply(remove_figures(["f1"]), "Delete")
    after = session.document
    field.returnPressed.emit()
    settle()
    assert session.document == after
    assert field not in [each.field for each in panel.card._fields.values()]


@pytest.mark.parametrize("kind", [DrawPanel, FillPanel])
def test_views_of_a_figure_that_went_in_the_middle_of_a_gesture(
    qtbot: QtBot, session: Session, kind: type
) -> None:
    panel = kind(session)
    show(qtbot, panel)
    panel.choose_tool("select")
    session.update_state(selection=("f1",), active="f1")
    settle()
    canvas = panel.canvas
    start = canvas.widget_position(2, 3).toPoint()
    qtbot.mousePress(canvas, LEFT, pos=start)
    qtbot.mouseMove(canvas, start + QPoint(20, -9))
    session.apply(remove_figures(["f1", "f2"]), "Delete")
    after = session.document
    qtbot.mouseMove(canvas, start + QPoint(40, -9))
    settle()
    qtbot.mouseRelease(canvas, LEFT, pos=start + QPoint(44, -9))
    settle()
    assert session.document == after
    assert panel.describe(2, 3) == "(2, 3)"


def test_a_band_that_adds_to_figures_that_went_selects_what_is_there(qtbot: QtBot, session: Session) -> None:
    panel = DrawPanel(session)
    show(qtbot, panel)
    panel.choose_tool("select")
    canvas, shift = panel.canvas, Qt.KeyboardModifier.ShiftModifier
    corner = canvas.widget_position(15, 44).toPoint()
    qtbot.mousePress(canvas, LEFT, shift, corner)
    session.apply(remove_figures(["f1"]), "Delete")
    qtbot.mouseMove(canvas, canvas.widget_position(30, 30).toPoint())
    qtbot.mouseMove(canvas, canvas.widget_position(45, 15).toPoint())
    assert session.state.selection == ("f2",)
    qtbot.mouseRelease(canvas, LEFT, shift, corner)


def test_the_plot_asks_for_a_pixel_that_a_shorter_line_lacks(qtbot: QtBot, session: Session) -> None:
    panel = DrawPanel(session)
    show(qtbot, panel)
    assert panel.view.emitted_cell(38) == (40, 20)
    assert panel.view.emitted_cell(39) is None
    panel.plot.pixel_wanted.emit(39)
    session.apply(remove_figures(["f1", "f2"]), "Delete")
    panel.plot.pixel_wanted.emit(0)
    assert panel.view.emitted_cell(0) is None


def test_an_algorithm_that_changes_behind_the_card_is_shown(qtbot: QtBot, session: Session) -> None:
    panel = DrawPanel(session)
    show(qtbot, panel)
    session.apply(set_algorithm("f1", "dda_line"), "Change algorithm")
    settle()
    assert panel.card.algorithm.currentData() == "dda_line"
