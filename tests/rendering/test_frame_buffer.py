"""From a sheet to a frame buffer: viewing pipeline, order of figures, fills, one changed figure."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document.model import (
    AnyFigure,
    Circle,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    View,
    WorldPoint,
)
from workbench.document.samples.examples import example
from workbench.rendering import arguments, emissions, frame_buffer, painter_of, raster, why

PALETTE = (0x000000, 0xFF0000, 0x00FF00, 0x0000FF)


def sheet(
    *figures: AnyFigure,
    size: tuple[int, int] = (40, 30),
    window: tuple[float, float, float, float] | None = None,
    viewport: tuple[float, float, float, float] | None = None,
) -> Sheet:
    whole = (-0.5, -0.5, size[0] - 0.5, size[1] - 0.5)
    view = View("v1", Rectangle(*(window or whole)), Rectangle(*(viewport or whole)))
    return Sheet("s1", "a", *size, (view,), PALETTE, figures)


def points(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint(f"p{i}", float(x), float(y)) for i, (x, y) in enumerate(places))


def line(a: tuple[float, float], b: tuple[float, float], colour: int = 1, name: str = "f1") -> Line:
    return Line(name, points(a, b), "bresenham_line", colour=colour)


def drawn(image: np.ndarray) -> list[str]:
    return ["".join(".rgb"[PALETTE.index(value)] for value in row) for row in image[::-1]]


@pytest.mark.parametrize("name", ["house", "circles", "pond", "curve-bezier"])
def test_where_the_catalogue_lacks_an_algorithm_the_first_of_the_kind_draws(name: str) -> None:
    (plain,) = example(name).document.sheets
    figures = [replace(figure, algorithm=figure.algorithms[0]) for figure in plain.figures]
    newer = [replace(figure, algorithm="one_of_tomorrow") for figure in plain.figures]
    first, other = (replace(plain, figures=tuple(each)) for each in (figures, newer))
    assert np.array_equal(frame_buffer(other), frame_buffer(first))
    x, y = np.argwhere(painter_of(other) >= 0)[0][::-1].tolist()
    assert [touch.figure for touch in why(other, x, y)] == [touch.figure for touch in why(first, x, y)]


def test_a_small_picture() -> None:
    circle = Circle("f2", points((4, 4)), "midpoint_circle", colour=2, radius_world=3.0)
    picture = frame_buffer(sheet(circle, line((0, 0), (8, 4)), size=(9, 9)))
    assert drawn(picture) == [
        ".........",
        "...ggg...",
        "..g...g..",
        ".g.....g.",
        ".g.....rr",
        ".g...rrg.",
        "..grr.g..",
        ".rrggg...",
        "r........",
    ]
    assert picture.dtype == np.uint32
    assert picture[0, 0] == 0xFF0000


def test_later_figures_cover_earlier_ones_and_the_painter_is_known() -> None:
    first, second = line((0, 5), (20, 5), 1, "f1"), line((10, 0), (10, 10), 2, "f2")
    picture, painter = frame_buffer(sheet(first, second)), painter_of(sheet(first, second))
    assert picture[5, 10] == 0x00FF00
    assert painter[5, 10] == 1
    assert painter[5, 9] == 0
    assert painter[0, 0] == -1
    assert frame_buffer(sheet(second, first))[5, 10] == 0xFF0000
    hidden = replace(second, visible=False)
    assert painter_of(sheet(first, hidden))[5, 10] == 0


@given(
    st.tuples(st.integers(-60, 100), st.integers(-60, 100)),
    st.tuples(st.integers(-60, 100), st.integers(-60, 100)),
)
def test_pixels_are_those_of_the_algorithm_inside_the_picture(a, b) -> None:
    function = catalogue.get("bresenham_line").function
    inside = {(x, y) for x, y in function(*a, *b) if 0 <= x < 40 and 0 <= y < 30}
    picture = frame_buffer(sheet(line(a, b)))
    assert {(int(x), int(y)) for y, x in np.argwhere(picture)} == inside


def test_the_window_is_mapped_before_rounding() -> None:
    figure = line((0.0, 0.0), (1.0, 1.0))
    one = sheet(figure, window=(0.0, 0.0, 1.0, 1.0))
    assert arguments(one, figure) == [(0, 0, 40, 30)]  # -0.5 rounds upwards, 39.5 as well
    part = sheet(figure, window=(0.0, 0.0, 1.0, 1.0), viewport=(9.5, 9.5, 19.5, 19.5))
    assert arguments(part, figure) == [(10, 10, 20, 20)]
    rows, columns = np.nonzero(frame_buffer(part))
    assert rows.min() == columns.min() == 10
    assert rows.max() == columns.max() == 19  # the pixel (20, 20) lies outside the viewport


def test_a_circle_under_unequal_scale_becomes_an_ellipse() -> None:
    circle = Circle("f", points((10, 10)), "midpoint_circle", radius_world=5.0)
    equal = sheet(circle)
    assert arguments(equal, circle) == [(10, 10, 5)]
    unequal = sheet(circle, window=(-0.5, -0.5, 19.5, 29.5))
    assert arguments(unequal, circle) == [(21, 10, 10, 5)]
    ellipse = catalogue.get("midpoint_ellipse").function
    expected = {(x, y) for x, y in ellipse(21, 10, 10, 5)}
    assert {(int(x), int(y)) for y, x in np.argwhere(frame_buffer(unequal))} == expected


def test_an_ellipse_and_a_closed_polyline() -> None:
    ellipse = Ellipse("e", points((20, 15)), "midpoint_ellipse", radius_x_world=8.0, radius_y_world=4.0)
    ring = Polyline("r", points((2, 2), (12, 2), (7, 9)), "bresenham_line", closed=True)
    assert arguments(sheet(ellipse, ring), ellipse) == [(20, 15, 8, 4)]
    assert arguments(sheet(ring), ring) == [(2, 2, 12, 2), (12, 2, 7, 9), (7, 9, 2, 2)]
    assert arguments(sheet(ring), ring, "dda_line")[0][:4] == (2, 2, 12, 2)
    with pytest.raises(LookupError):
        arguments(sheet(ring), ring, "bresenham_lin")


def test_a_seed_fill_sees_what_lies_below_it_only() -> None:
    box = Polyline("b", points((5, 5), (15, 5), (15, 12), (5, 12)), "bresenham_line", closed=True)
    fill = SeedFill("f", points((10, 8)), "boundary_fill_4", colour=2, boundary=1)
    filled = frame_buffer(sheet(box, fill))
    assert (filled[6:12, 6:15] == 0x00FF00).all()
    assert (filled == 0x00FF00).sum() == 6 * 9
    cut = line((5, 8), (15, 8), 1, "l")
    above, below = frame_buffer(sheet(box, fill, cut)), frame_buffer(sheet(box, cut, fill))
    assert above[6, 6] == 0x00FF00
    assert above[11, 6] == 0x00FF00
    assert (above[8, 5:16] == 0xFF0000).all()
    assert (below == 0x00FF00).sum() == 0  # the seed lies on the boundary


def test_only_the_changed_figure_runs_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(raster, "at_hand", lambda *_use: False)  # a kernel would not run them one by one
    figures = [line((i, 0), (i + 3, 29), 1, f"f{i}") for i in range(20)]
    frame_buffer(sheet(*figures))
    ran = []
    real = emissions._run
    monkeypatch.setattr(emissions, "_run", lambda call: ran.append(call.arguments) or real(call))
    figures[7] = line((7.2, 1.0), (31.0, 27.0), 1, "f7")
    frame_buffer(sheet(*figures))
    assert ran == [(7, 1, 31, 27)]


def test_the_answer_is_the_callers_own() -> None:
    one = sheet(line((0, 0), (5, 5)))
    frame_buffer(one)[:] = 7
    painter_of(one)[:] = 7
    assert frame_buffer(one)[0, 0] == 0xFF0000
    assert painter_of(one)[0, 0] == 0


def test_coverage_is_blended_with_what_lies_below() -> None:
    soft = Line("w", points((2, 2), (30, 9)), "wu_line", colour=1)
    picture = frame_buffer(sheet(soft))
    reds = {int(value) >> 16 for value in picture[picture > 0]}
    assert len(reds) > 3
    assert (picture & 0x00FFFF == 0).all()


@given(st.floats(-1e7, 1e7), st.floats(-1e7, 1e7), st.floats(-1e7, 1e7), st.floats(-1e7, 1e7))
@settings(max_examples=40, deadline=None)
def test_far_points_neither_hang_nor_fail(x0, y0, x1, y1) -> None:
    circle = Circle("c", points((x0, y0)), "midpoint_circle", radius_world=abs(x1))
    picture = frame_buffer(sheet(line((x0, y0), (x1, y1)), circle))
    assert picture.shape == (30, 40)


def test_a_polygon_without_height_fills_nothing() -> None:
    flat = Polygon("f1", points((2, 3), (9, 3), (5, 3)), "scan_line_exact")
    assert (painter_of(sheet(flat)) == -1).all()


def test_why_names_figure_call_and_emission() -> None:
    ring = Polyline("r", points((2, 2), (12, 2), (12, 9)), "bresenham_line", colour=1)
    over = line((8, 0), (8, 8), 2, "l")
    one = sheet(ring, over)
    touches = why(one, 8, 2)
    assert [(t.figure_id, t.call_number, t.emission, t.last) for t in touches] == [
        ("r", 0, 6, False),
        ("l", 0, 2, True),
    ]
    corner = why(one, 12, 2)
    assert [(t.call_number, t.emission, t.last) for t in corner] == [(0, 10, False), (1, 0, True)]
    assert why(one, 20, 20) == []
    assert why(one, -1, 5) == []
