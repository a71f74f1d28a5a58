"""Curvature and hodograph as a person uses them."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.widgets.plots.by_hand import LEFT, drag, hover, send
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.plots.curvature_plot import CurvaturePlot
from workbench.widgets.plots.hodograph_plot import HodographPlot
from workbench.widgets.plots.scrubbed_plot import ScrubbedPlot

US = np.linspace(0, 4, 401)
BEND = 0.02 * np.sin(2 * US)
WAYS = np.stack([80 * np.cos(US) + 30, 50 * np.sin(US) - 10], axis=1)


def shown(qtbot: QtBot, plot: ScrubbedPlot, width: int = 400, height: int = 200) -> None:
    qtbot.addWidget(plot)
    plot.resize(width, height)
    plot.show()
    qtbot.waitUntil(lambda: plot._plot is not None, timeout=30_000)
    QApplication.processEvents()


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


def inked(plot: ScrubbedPlot, ink: str) -> np.ndarray:
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
        near = [curvature.y_of(0.02 * np.sin(2 * v)) for v in np.linspace(u - 0.02, u + 0.02, 9)]
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
    drag(qtbot, curvature, QPoint(round(curvature.x_of(1)), 60), QPoint(round(curvature.x_of(3)), 190))
    qtbot.keyClick(curvature, Qt.Key.Key_Right)
    assert told == pytest.approx([1, 3, 0.54], abs=0.01)


def test_one_cusp_leaves_the_rest_readable(curvature: CurvaturePlot):
    spiked = BEND.copy()
    spiked[200] = 1e6
    spiked[300] = np.inf
    spiked[100] = np.nan
    curvature.set_curvature(US, spiked)
    curvature.set_u(None)
    low, high = (curvature.y_of(v) for v in (-0.02, 0.02))
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
    drag(qtbot, hodograph, start, end)
    qtbot.keyClick(hodograph, Qt.Key.Key_Home)
    assert told == pytest.approx([0.5, 2.5, 0], abs=0.03)
    assert "speed" in hodograph.accessibleDescription()


@pytest.mark.parametrize("which", ["curvature", "hodograph"])
def test_the_pointer_shows_where_u_can_be_taken(request, which):
    plot = request.getfixturevalue(which)
    if which == "hodograph":
        marker = plot.place_of(*plot.derivative_at(1.0))
    else:
        marker = QPointF(plot.x_of(0.5), 90)
    for place, shape in (
        (marker.toPoint(), Qt.CursorShape.SizeHorCursor),
        (QPoint(3, 3), Qt.CursorShape.ArrowCursor),
    ):
        hover(plot, place)
        assert plot._plot.viewport().cursor().shape() == shape


def test_a_line_traced_evenly_has_a_hodograph_of_one_point(hodograph: HodographPlot):
    hodograph.set_hodograph(US, np.full((401, 2), 7.0))
    assert not hodograph.grab().isNull()
    assert hodograph.u_under(QPointF(50, 50)) >= 0
    hodograph.set_hodograph(US, np.zeros((401, 2)))
    assert not hodograph.grab().isNull()
    hodograph.set_hodograph(US, np.full((401, 2), np.nan))
    assert not hodograph.grab().isNull()


def test_moving_u_and_telling_the_same_plots_nothing_anew(
    curvature: CurvaturePlot, hodograph: HodographPlot, monkeypatch: pytest.MonkeyPatch
):
    anew = []
    for plot in (curvature, hodograph):
        monkeypatch.setattr(plot._line, "setData", lambda *_data: anew.append(1))
        plot.set_u(1.7)
    curvature.set_curvature(US.copy(), BEND.copy(), joints=[1.0, 2.0], inflections=[np.pi / 2])
    hodograph.set_hodograph(US.copy(), WAYS.copy())
    assert anew == []
    curvature.set_curvature(US, 2 * BEND)
    hodograph.set_hodograph(US, 2 * WAYS)
    assert anew == [1, 1]


@given(u=st.floats(0, 4), share=st.floats(-1, 1), low=st.floats(0, 1.5), length=st.floats(0.5, 2.5))
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_places_are_those_that_the_library_paints_at(
    curvature: CurvaturePlot, hodograph: HodographPlot, u, share, low, length
):
    def painted(plot: ScrubbedPlot, x: float, y: float) -> tuple[float, float]:
        place = plot._plot.getPlotItem().vb.mapViewToScene(QPointF(x, y))
        return place.x() + plot._plot.x(), place.y() + plot._plot.y()

    curvature.show_view(low, low + length)
    height = share * curvature.heights[1]
    assert painted(curvature, u, height) == pytest.approx(
        (curvature.x_of(u), curvature.y_of(height)), abs=0.6
    )
    x, y = hodograph.derivative_at(u)
    place = hodograph.place_of(x, y)
    assert painted(hodograph, x, y) == pytest.approx((place.x(), place.y()), abs=1.1)


def test_keys_zoom_at_u_and_0_shows_all(qtbot: QtBot, curvature: CurvaturePlot):
    seen = []
    curvature.view_changed.connect(lambda *view: seen.append(view))
    qtbot.keyClick(curvature, Qt.Key.Key_Plus)
    assert curvature.range == seen[-1] == pytest.approx((0.1, 3.3))
    assert curvature.u_at(curvature.x_of(2.0)) == pytest.approx(2.0)
    for _time in range(9):
        qtbot.keyClick(curvature, Qt.Key.Key_Minus)
    assert curvature.range == pytest.approx((0, 4))
    qtbot.keyClick(curvature, Qt.Key.Key_Plus)
    curvature.set_curvature(US, 2 * BEND)
    assert curvature.range == pytest.approx((0.1, 3.3))
    qtbot.keyClick(curvature, Qt.Key.Key_0)
    assert curvature.range == (0, 4)


def test_a_drag_with_shift_moves_the_view_and_not_u(qtbot: QtBot, curvature: CurvaturePlot):
    told = []
    curvature.u_dragged.connect(told.append)
    curvature.show_view(1.0, 2.0)
    shift, kinds = Qt.KeyboardModifier.ShiftModifier, QEvent.Type
    send(curvature, kinds.MouseButtonPress, QPoint(200, 90), LEFT, shift)
    for x in (160, 120):
        send(curvature, kinds.MouseMove, QPoint(x, 90), LEFT, shift)
    send(curvature, kinds.MouseButtonRelease, QPoint(120, 90), modifiers=shift)
    low, high = curvature.range
    assert low > 1.05
    assert high - low == pytest.approx(1.0)
    assert told == []


def test_numbers_are_those_plotted(curvature: CurvaturePlot, hodograph: HodographPlot):
    table = curvature.numbers()
    assert table is not None
    assert [float(cell) for cell in table.rows[100]] == pytest.approx([US[100], BEND[100]], rel=1e-5)
    table = hodograph.numbers()
    assert table is not None
    assert [float(cell) for cell in table.rows[100]] == pytest.approx([US[100], *WAYS[100]], rel=1e-5)
    curvature.set_curvature(np.zeros(0), np.zeros(0))
    assert curvature.numbers() is None


def test_without_a_curve_they_say_so(qtbot: QtBot, curvature: CurvaturePlot, hodograph: HodographPlot):
    curvature.set_curvature(np.zeros(0), np.zeros(0))
    hodograph.set_hodograph(np.zeros(0), np.zeros((0, 2)))
    told = []
    for plot in (curvature, hodograph):
        plot.u_dragged.connect(told.append)
        qtbot.mouseClick(plot, LEFT, pos=QPoint(60, 60))  # what is painted on is hidden
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
