"""Curvature and hodograph as a person uses them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.plots.curvature_plot import CurvaturePlot
from workbench.widgets.plots.hodograph_plot import HodographPlot
from workbench.widgets.plots.parameter_plot import ParameterPlot

LEFT = Qt.MouseButton.LeftButton
US = np.linspace(0, 4, 401)
BEND = 0.02 * np.sin(2 * US)
WAYS = np.stack([80 * np.cos(US) + 30, 50 * np.sin(US) - 10], axis=1)


def shown(qtbot: QtBot, plot: ParameterPlot, width: int = 400, height: int = 200) -> None:
    qtbot.addWidget(plot)
    plot.resize(width, height)
    plot.show()
    QApplication.processEvents()


def hover(part: QWidget, place: QPoint) -> None:
    """Move the pointer with no button down, whatever a test before left down."""
    spot, none = QPointF(place), Qt.MouseButton.NoButton
    plain = Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(
        part, QMouseEvent(QEvent.Type.MouseMove, spot, part.mapToGlobal(spot), none, none, plain)
    )


@pytest.fixture
def curvature(qtbot: QtBot) -> CurvaturePlot:
    made = CurvaturePlot()
    made.set_curvature(US, BEND, joints=[1.0, 2.0], inflections=[np.pi / 2])
    made.set_u(0.5)
    shown(qtbot, made)
    return made


@pytest.fixture
def hodograph(qtbot: QtBot) -> HodographPlot:
    made = HodographPlot()
    made.set_hodograph(US, WAYS)
    made.set_u(1.0)
    shown(qtbot, made)
    return made


def inked(plot: ParameterPlot, ink: str) -> np.ndarray:
    """(n, 2) the pixels in exactly this colour."""
    image = plot.grab().toImage()
    wanted = QColor(ink).rgb()
    return np.array([(x, y) for y in range(image.height()) for x in range(image.width())
                     if image.pixel(x, y) == wanted]).reshape(-1, 2)  # fmt: skip


def test_the_curve_of_curvature_passes_where_it_should(curvature: CurvaturePlot):
    curvature.set_u(None)
    pixels = inked(curvature, LIGHT.data[0])
    assert len(pixels) > 100
    for x, y in pixels.tolist():
        u = curvature.u_at(x + 0.5)
        near = [
            float(curvature._ys(np.array(0.02 * np.sin(2 * v)))) for v in np.linspace(u - 0.02, u + 0.02, 9)
        ]
        assert min(near) - 1.5 <= y + 0.5 <= max(near) + 1.5


@given(st.floats(0, 4))
def test_the_reading_is_the_curvature_there(qapp, u):
    plot = CurvaturePlot()
    plot.set_curvature(US, BEND)
    plot.set_u(u)
    assert plot.curvature_at(u) == pytest.approx(0.02 * np.sin(2 * u), abs=1e-5)
    assert "curvature" in plot.reading
    plot.deleteLater()


def test_u_is_asked_for_by_hand_and_keys(qtbot: QtBot, curvature: CurvaturePlot):
    told = []
    curvature.u_dragged.connect(told.append)
    qtbot.mousePress(curvature, LEFT, pos=QPoint(round(curvature.x_of(1)), 60))
    qtbot.mouseMove(curvature, QPoint(round(curvature.x_of(3)), 190))
    qtbot.mouseRelease(curvature, LEFT, pos=QPoint(round(curvature.x_of(3)), 190))
    qtbot.keyClick(curvature, Qt.Key.Key_Right)
    assert told == pytest.approx([1, 3, 0.54], abs=0.01)


def test_one_cusp_leaves_the_rest_readable(curvature: CurvaturePlot):
    spiked = BEND.copy()
    spiked[200] = 1e6
    spiked[300] = np.inf
    spiked[100] = np.nan
    curvature.set_curvature(US, spiked)
    curvature.set_u(None)
    low, high = (float(curvature._ys(np.array(v))) for v in (-0.02, 0.02))
    assert low - high > curvature.area.height() / 3
    pixels = inked(curvature, LIGHT.data[0])
    assert len(pixels) > 100
    assert all(curvature.rect().contains(*map(int, place)) for place in pixels.tolist())
    assert curvature.heading == "Curvature (1/px); peaks are cut off"
    curvature.set_u(float(US[100]))
    assert "no curvature here" in curvature.reading
    assert curvature.heading == curvature.reading + "; peaks are cut off"
    curvature.set_curvature(US, BEND)
    assert curvature.heading == curvature.reading


@pytest.mark.parametrize(
    ("value", "said", "drawn"),
    [
        (0.0, "radius infinite", True),
        (np.nan, "no curvature here", False),
        (1e-12, "radius 1.0e12 px", True),
        (np.inf, "no curvature here", True),
    ],
)
def test_what_is_straight_or_has_no_curvature_is_plotted_too(curvature: CurvaturePlot, value, said, drawn):
    curvature.set_curvature(US, np.full(401, value))
    assert said in curvature.reading
    curvature.set_u(None)
    # A level line lies between rows of pixels, so none of them has its whole colour.
    image = curvature.grab().toImage().copy(curvature.area.toRect())
    colours = [image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height())]
    assert (sum(c.blue() - c.red() > 60 for c in colours) > 100) == drawn


def test_the_axes_of_the_hodograph_have_one_scale_and_hold_it_all(hodograph: HodographPlot):
    origin = hodograph.place_of(0, 0)
    across, up = hodograph.place_of(10, 0) - origin, hodograph.place_of(0, 10) - origin
    assert across.x() == pytest.approx(-up.y()) == pytest.approx(10 * hodograph.scale)
    assert across.y() == up.x() == 0
    for x, y in [(0.0, 0.0), *WAYS.tolist()]:
        assert hodograph.area.adjusted(-1, -1, 1, 1).contains(hodograph.place_of(x, y))


@given(st.floats(0, 4), st.floats(-3, 3), st.floats(-3, 3))
def test_the_nearest_place_of_the_hodograph_is_taken(qapp, u, right, down):
    plot = HodographPlot()
    plot.resize(400, 200)
    plot.set_hodograph(US, WAYS)
    spot = plot.place_of(*plot.derivative_at(u)) + QPointF(right, down)
    found = plot.place_of(*plot.derivative_at(plot.u_under(spot)))
    least = min((spot - plot.place_of(x, y)).manhattanLength() for x, y in WAYS.tolist())
    assert np.hypot(found.x() - spot.x(), found.y() - spot.y()) <= least + 1e-6
    plot.deleteLater()


def test_dragging_along_the_hodograph_asks_for_u(qtbot: QtBot, hodograph: HodographPlot):
    told = []
    hodograph.u_dragged.connect(told.append)
    start, end = (hodograph.place_of(*hodograph.derivative_at(u)).toPoint() for u in (0.5, 2.5))
    qtbot.mousePress(hodograph, LEFT, pos=start)
    qtbot.mouseMove(hodograph, end)
    qtbot.mouseRelease(hodograph, LEFT, pos=end)
    qtbot.keyClick(hodograph, Qt.Key.Key_Home)
    assert told == pytest.approx([0.5, 2.5, 0], abs=0.03)
    assert "speed" in hodograph.accessibleDescription()


@pytest.mark.parametrize("which", ["curvature", "hodograph"])
def test_the_pointer_shows_where_u_can_be_taken(request, which):
    plot = request.getfixturevalue(which)
    marker = QPointF(plot.x_of(0.5), 90)
    if which == "hodograph":
        marker = plot.place_of(*plot.derivative_at(1.0))
    for place, shape in (
        (marker.toPoint(), Qt.CursorShape.SizeHorCursor),
        (QPoint(3, 3), Qt.CursorShape.ArrowCursor),
    ):
        hover(plot, place)
        assert plot.cursor().shape() == shape


def test_a_line_traced_evenly_has_a_hodograph_of_one_point(hodograph: HodographPlot):
    hodograph.set_hodograph(US, np.full((401, 2), 7.0))
    assert not hodograph.grab().isNull()
    assert hodograph.u_under(QPointF(50, 50)) >= 0
    hodograph.set_hodograph(US, np.zeros((401, 2)))
    assert not hodograph.grab().isNull()
    hodograph.set_hodograph(US, np.full((401, 2), np.nan))
    assert not hodograph.grab().isNull()


def test_moving_u_paints_nothing_else_anew(curvature: CurvaturePlot, hodograph: HodographPlot):
    kept = curvature._kept, hodograph._kept
    for plot in (curvature, hodograph):
        plot.set_u(1.7)
        plot.repaint()
    curvature.set_curvature(US.copy(), BEND.copy(), joints=[1.0, 2.0], inflections=[np.pi / 2])
    hodograph.set_hodograph(US.copy(), WAYS.copy())
    QApplication.processEvents()
    assert (curvature._kept, hodograph._kept) == kept


def test_without_a_curve_they_say_so(qtbot: QtBot, curvature: CurvaturePlot, hodograph: HodographPlot):
    curvature.set_curvature(np.zeros(0), np.zeros(0))
    hodograph.set_hodograph(np.zeros(0), np.zeros((0, 2)))
    told = []
    for plot in (curvature, hodograph):
        plot.u_dragged.connect(told.append)
        qtbot.mouseClick(plot, LEFT, pos=QPoint(60, 60))
        qtbot.keyClick(plot, Qt.Key.Key_Right)
        assert plot.accessibleDescription() == plot.words != ""
        assert plot.accessibleName()
        assert plot.toolTip()
        assert not plot.grab().isNull()
    assert told == []


def test_the_theme_shows(curvature: CurvaturePlot, hodograph: HodographPlot):
    light = [plot.grab().toImage() for plot in (curvature, hodograph)]
    theme.use(DARK)
    try:
        assert [
            plot.grab().toImage() != seen for plot, seen in zip((curvature, hodograph), light, strict=True)
        ] == [
            True,
            True,
        ]
    finally:
        theme.use(LIGHT)
