"""What every plot on pyqtgraph does: cursor, keys, zoom, copies, the theme."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QFontMetrics, QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.display.flicker import Zones
from workbench.widgets.look.elided_label import ElidedLabel
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.plots.depth_plot import DepthPlot
from workbench.widgets.plots.distance_plot import MOST_DRAWN, MOST_SYMBOLS, DistancePlot
from workbench.widgets.plots.flicker_map import FlickerMap
from workbench.widgets.plots.plot import Plot
from workbench.widgets.plots.trace_plot import TracePlot

KEY = Qt.Key


def seen(qtbot: QtBot, plot: Plot) -> Plot:
    qtbot.addWidget(plot)
    plot.resize(420, 200)
    plot.show()
    qtbot.waitUntil(lambda: plot._plot is not None, timeout=30_000)
    return plot


@pytest.fixture
def depths(qtbot: QtBot) -> DepthPlot:
    plot = DepthPlot()
    seen(qtbot, plot)
    plot.show_depths(np.array([0, 1, 2, 3, 2, 1, 2, 1, 0] * 5), calls=False)
    plot.show_cursor(20, 1)
    return plot


@pytest.mark.parametrize(
    ("key", "modifier", "step"),
    [
        (KEY.Key_Left, Qt.KeyboardModifier.NoModifier, 19),
        (KEY.Key_Right, Qt.KeyboardModifier.NoModifier, 21),
        (KEY.Key_Left, Qt.KeyboardModifier.ShiftModifier, 10),
        (KEY.Key_Right, Qt.KeyboardModifier.ShiftModifier, 30),
        (KEY.Key_Home, Qt.KeyboardModifier.NoModifier, 0),
        (KEY.Key_End, Qt.KeyboardModifier.NoModifier, 44),
    ],
)
def test_keys_choose_a_step(qtbot: QtBot, depths: DepthPlot, key: KEY, modifier: object, step: int) -> None:
    with qtbot.waitSignal(depths.step_wanted) as wanted:
        QTest.keyClick(depths, key, modifier)  # type: ignore[call-overload]
    assert wanted.args == [step]


def test_a_click_chooses_the_step_under_it_and_none_beyond_the_last(qtbot: QtBot, depths: DepthPlot) -> None:
    box = depths._plot.getPlotItem().vb
    place = depths._plot.mapFromScene(box.mapViewToScene(QPointF(7.2, 1.0)))
    with qtbot.waitSignal(depths.step_wanted) as wanted:
        qtbot.mouseClick(depths._plot.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert wanted.args == [7]
    depths.show_cursor(44, 0)
    with qtbot.waitSignal(depths.step_wanted) as wanted:
        QTest.keyClick(depths, KEY.Key_Right)
    assert wanted.args == [44]


def test_one_call_is_not_told_as_several(depths: DepthPlot) -> None:
    for whole in (True, False):
        depths.show_depths(np.array([0, 1, 2, 1]), calls=True, whole=whole)
        for step, said in ((1, "1 call active"), (2, "2 calls active")):
            depths.show_cursor(step, step)
            assert depths.caption.text().startswith(said)


def test_the_wheel_and_keys_zoom_along_x_and_0_shows_all(depths: DepthPlot) -> None:
    def spans() -> tuple[float, float]:
        QApplication.processEvents()
        (left, right), (low, high) = depths._plot.getPlotItem().vb.viewRange()
        return right - left, high - low

    whole = spans()
    middle = QPointF(depths._plot.rect().center())
    wheel = QWheelEvent(
        middle, middle, QPoint(), QPoint(0, 240), Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(depths._plot.viewport(), wheel)
    by_wheel = spans()
    assert by_wheel[0] < 0.95 * whole[0]
    QTest.keyClick(depths, KEY.Key_Plus)
    assert spans()[0] == pytest.approx(0.8 * by_wheel[0])
    QTest.keyClick(depths, KEY.Key_Minus)
    assert spans()[0] == pytest.approx(by_wheel[0])
    QTest.keyClick(depths, KEY.Key_0)
    assert spans() == pytest.approx(whole)


def test_numbers_are_copied_as_a_table_and_the_picture_as_a_picture(qtbot: QtBot) -> None:
    plot = DistancePlot()
    seen(qtbot, plot)
    assert plot.copy() is False
    assert plot.reach is None
    plot.show_distances([("Bresenham", np.array([0.0, 0.25, -0.25])), ("DDA", np.array([0.0, 0.125]))])
    assert plot.copy() is True
    said = QGuiApplication.clipboard().mimeData()
    assert said.text().splitlines() == ["pixel k\tBresenham\tDDA", "0\t0\t0", "1\t0.25\t0.125", "2\t-0.25\t"]
    assert said.hasHtml()
    assert "at most 0.250 px" in plot.accessibleDescription()
    assert "<" not in plot.accessibleDescription()
    plot.copy_picture()
    assert QGuiApplication.clipboard().pixmap().size() == plot.grab().size()
    QGuiApplication.clipboard().clear()


def test_what_was_plotted_before_is_gone(qtbot: QtBot) -> None:
    plot = DistancePlot()
    seen(qtbot, plot)
    items = len(plot._plot.getPlotItem().items)
    for _turn in range(20):
        plot.show_distances([("one", np.random.default_rng(_turn).normal(size=9))])
    assert len(plot._plot.getPlotItem().items) == items + 1
    plot.show_distances([])
    assert len(plot._plot.getPlotItem().items) == items
    assert plot._plot.isHidden()


@pytest.mark.parametrize("count", [MOST_SYMBOLS, MOST_SYMBOLS + 1, 300_000])
def test_the_work_of_a_plot_has_a_bound_and_its_peaks_stay(qtbot: QtBot, count: int) -> None:
    plot = DistancePlot()
    seen(qtbot, plot)
    values = np.zeros(count)
    values[count // 3] = 9.0
    plot.show_distances([("a long line", values)])
    drawn = plot._lines[0].scatter.data if plot._lines[0].scatter.isVisible() else []
    x, y = plot._lines[0].curve.getData()
    assert len(drawn) <= MOST_SYMBOLS
    assert len(x) <= MOST_DRAWN
    assert y.max() == 9.0
    table = plot.numbers()
    assert table is not None
    assert len(table.rows) == count


def test_a_trace_reads_its_value_and_says_why_there_is_none(qtbot: QtBot) -> None:
    plot = TracePlot("Light", "cd", 2)
    seen(qtbot, plot)
    plot.show_curve([0.0, 1.0, 2.0], [100.0, 1.0, 0.01], (0.01, 100.0), "2 s", 1.1, logarithmic=True)
    assert plot.accessibleDescription() == "1 cd, 2 s"
    levels = plot._plot.getAxis("left")._tickLevels
    assert [text for _place, text in levels[0]] == ["0.01", "", "1", "", "100"]
    assert [place for place, _text in levels[0]] == pytest.approx([-2, -1, 0, 1, 2])
    plot.show_words("The beam is dark.")
    assert plot.accessibleDescription() == "The beam is dark."
    assert plot.numbers() is None
    assert plot._plot.isHidden()
    assert not plot.caption.isHidden()


def test_every_plot_follows_the_theme(qtbot: QtBot, depths: DepthPlot) -> None:
    try:
        for now in (DARK, LIGHT):
            theme.use(now)
            assert depths._plot.backgroundBrush().color().name() == now.surface.lower()
            assert depths._cursor_line.pen.color().name() == now.text.lower()
    finally:
        theme.use(LIGHT)


@pytest.mark.parametrize(("height", "titled"), [(110, False), (320, True)])
def test_a_low_plot_does_without_the_titles_of_its_axes(qtbot: QtBot, height: int, titled: bool) -> None:
    plot = FlickerMap()
    plot.show_map(Zones((1e-6, 1e-3, 1.0), (60.0, 58.0, 20.0), 0.01), 50.0, 1e-3, "flickers")
    seen(qtbot, plot)
    plot.resize(300, height)
    qtbot.waitUntil(lambda: plot._plot.getAxis("bottom").label.isVisible() == titled)
    assert plot._plot.getAxis("left").label.isVisible() == titled
    ticks = plot._plot.getAxis("left")._tickLevels[0]
    line = plot.fontMetrics().height()
    assert 1 <= len(ticks) <= max((plot._plot.height() - plot._plot.getAxis("bottom").height()) / line + 2, 1)
    assert (len(ticks) == 7) == titled


@pytest.mark.parametrize("far", [QPoint(-200_000, -200_000), QPoint(200_000, 200_000)])
def test_a_point_of_the_map_stays_on_it_however_far_it_is_dragged(qtbot: QtBot, far: QPoint) -> None:
    plot = FlickerMap()
    plot.show_map(Zones((1e-6, 1e-3, 1.0), (60.0, 58.0, 20.0), 0.01), 50.0, 1e-3, "flickers")
    seen(qtbot, plot)
    plot.resize(300, 200)
    QApplication.processEvents()
    moved: list[tuple[float, float]] = []
    plot.moved.connect(lambda *point: moved.append(point))
    port = plot._plot.viewport()
    qtbot.mousePress(port, Qt.MouseButton.LeftButton, pos=port.rect().center())
    qtbot.mouseMove(port, far)
    qtbot.mouseRelease(port, Qt.MouseButton.LeftButton, pos=far)
    assert moved[-1] == ((10.0, 1.0) if far.x() < 0 else (120.0, 1e-6))


def test_a_narrow_trace_ends_its_words_with_dots(qtbot: QtBot) -> None:
    plot = TracePlot("Light at the probe", "of its mean", 2)
    seen(qtbot, plot)
    plot.show_curve([0.0, 1.0], [0.5, 0.5], (0.0, 1.0), "(32, 24), 1 picture, 16.7 ms", 0.5)
    plot.resize(120, 100)
    QApplication.processEvents()
    cut = [label for label in plot.findChildren(ElidedLabel) if label.wide > label.width()]
    assert [label.text() for label in cut] == ["Light at the probe", "(32, 24), 1 picture, 16.7 ms"]
    assert all(label.text() in label.toolTip() for label in cut)


@pytest.mark.parametrize("deepest", [9, 99_999, 999_999])
def test_the_title_of_an_axis_stands_beside_its_numbers(qtbot: QtBot, deepest: int) -> None:
    plot = DepthPlot()
    seen(qtbot, plot)
    plot.resize(420, 260)
    plot.show_depths(np.array([0, deepest]), calls=False)
    axis = plot._plot.getAxis("left")
    qtbot.waitUntil(axis.label.isVisible)
    for _turn in range(3):  # the axis widens when it has painted its numbers
        plot.grab()
        QApplication.processEvents()
    box = axis.label.mapRectToParent(axis.label.boundingRect())
    title = box.right() - axis.label.document().documentMargin()
    number = QFontMetrics(plot._font()).horizontalAdvance(str(deepest))
    assert title <= axis.width() - 4 - number


def test_what_is_dropped_on_a_plot_is_for_what_it_lies_in(depths: DepthPlot) -> None:
    """Qt's part of it warns of what leaves where it never let it in."""
    assert not depths._plot.acceptDrops()
    assert not depths._plot.viewport().acceptDrops()
