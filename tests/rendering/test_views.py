"""Several views of one world on one device."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.views import seen_through
from workbench.document import DocumentError, edits
from workbench.document.model import Circle, Line, Polygon, Rectangle, SeedFill, Sheet, View, WorldPoint
from workbench.document.samples.figures import document_of
from workbench.rendering import display_list, figure_calls, frame_buffer, painter_of, view_map, why
from workbench.rendering.why_steps import why_steps

WINDOW = Rectangle(0.0, 0.0, 20.0, 10.0)
sides = st.integers(-20, 60).map(float)


def points(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


def sheet() -> Sheet:
    figures = [
        Polygon("", points((2, 1), (18, 2), (9, 9)), "scan_line_exact", 1),
        Line("", points((0, 0), (20, 10)), "bresenham_line", 2),
        Circle("", points((10, 5)), "midpoint_circle", 3, radius_world=3.0),
        SeedFill("", points((10, 7)), "flood_fill_4", 4),
    ]
    made = document_of("Views", 60, 40, figures).sheets[0]
    left = View("v1", WINDOW, Rectangle(-0.5, -0.5, 29.5, 39.5))
    right = View("v2", WINDOW, Rectangle(20.5, 10.5, 59.5, 30.5), clip_world=Rectangle(5.0, 2.0, 15.0, 8.0))
    return replace(made, views=(left, right))


def alone(whole: Sheet, number: int) -> Sheet:
    return replace(whole, views=(whole.views[number],))


def test_views_are_painted_in_their_order_each_within_its_viewport() -> None:
    whole = sheet()
    first, second = (painter_of(alone(whole, k)) for k in (0, 1))
    strokes = replace(whole, figures=whole.figures[:3])
    under, over = (painter_of(alone(strokes, k)) for k in (0, 1))
    assert np.array_equal(painter_of(strokes), np.where(over >= 0, over, under))
    x, y = np.nonzero(second >= 0)[1], np.nonzero(second >= 0)[0]
    assert x.min() >= 21
    assert x.max() <= 59
    assert y.min() >= 11
    assert y.max() <= 30
    turned = replace(strokes, views=strokes.views[::-1])
    assert np.array_equal(painter_of(turned), np.where(under >= 0, under, over))
    assert (first[:, 30:] == -1).all()


def test_a_fill_of_a_later_view_reads_what_the_earlier_ones_left() -> None:
    whole = sheet()
    image = frame_buffer(whole)
    before = frame_buffer(replace(whole, figures=whole.figures[:3]))
    calls = figure_calls(whole, whole.figures[3])
    assert len(calls) == 2
    first, other = (call.arguments[0] for call in calls)
    assert np.array_equal(first, frame_buffer(replace(alone(whole, 0), figures=whole.figures[:3])))
    assert not np.array_equal(first, other)
    assert not np.array_equal(image, before)


def test_strokes_of_all_views_are_drawn() -> None:
    whole = sheet()
    expected = [stroke for k in (0, 1) for stroke in display_list(alone(whole, k))]
    assert display_list(whole) == expected


def test_why_counts_the_calls_of_all_views() -> None:
    whole = sheet()
    painter = painter_of(whole)
    for y, x in np.argwhere(painter >= 0)[::37].tolist():
        touches = why(whole, x, y)
        figure = whole.figures[touches[-1].figure]
        assert touches[-1].last
        assert touches[-1].figure == painter[y, x]
        for touch in touches:
            if isinstance(figure, Line | Circle) and touch.figure == touches[-1].figure:
                assert figure_calls(whole, figure)[touch.call_number] == touch.call
    line = replace(whole, figures=whole.figures[1:2])
    (y, x) = np.argwhere(painter_of(alone(line, 1)) >= 0)[3].tolist()
    answers = why_steps(line, x, y)
    assert answers[-1].stands
    assert answers[-1].step > 20


@given(sides, sides, st.integers(1, 60), st.integers(1, 60), st.sampled_from(["fit", "fill"]))
def test_fit_and_fill_keep_proportions_and_the_middle(
    x: float, y: float, wide: int, high: int, mode: str
) -> None:
    viewport = Rectangle(x, y, x + wide, y + high)
    scale = view_map(View("v", WINDOW, viewport, mode=mode))
    assert scale.sx == pytest.approx(scale.sy)
    assert scale.point(10.0, 5.0) == pytest.approx((x + wide / 2, y + high / 2))
    sides_px = scale.sx * 20, scale.sx * 10
    if mode == "fit":
        assert sides_px[0] <= wide + 1e-9
        assert sides_px[1] <= high + 1e-9
    else:
        assert sides_px[0] >= wide - 1e-9
        assert sides_px[1] >= high - 1e-9
    assert min(abs(sides_px[0] - wide), abs(sides_px[1] - high)) < 1e-9


def test_nothing_of_a_window_that_fills_is_painted_beyond_its_viewport() -> None:
    line = Line("", points((-100, 5), (100, 5)), "bresenham_line")
    made = document_of("Fill", 60, 40, [line]).sheets[0]
    small = seen_through(
        made, window_world=WINDOW, viewport_device=Rectangle(10.5, 10.5, 20.5, 30.5), mode="fill"
    )
    rows, columns = np.nonzero(painter_of(small) >= 0)
    assert (columns.min(), columns.max()) == (11, 20)
    assert set(rows.tolist()) == {21}


def test_zoom_and_pan_change_the_window_alone() -> None:
    document = document_of("Zoom", 60, 40, [])
    near = edits.zoom("v1", 4.0, 10.0, 20.0)(document)
    view, old = near.sheets[0].first_view, document.sheets[0].first_view
    assert view_map(view).point(10.0, 20.0) == pytest.approx(view_map(old).point(10.0, 20.0))
    assert view_map(view).sx == pytest.approx(4 * view_map(old).sx)
    beside = edits.pan("v1", 3.0, -2.0)(document).sheets[0].first_view
    assert replace(beside, window_world=old.window_world) == old
    assert view_map(beside).point(3.0, -2.0) == pytest.approx(view_map(old).point(0.0, 0.0))
    back = edits.zoom("v1", 0.25, 10.0, 20.0)(near).sheets[0].first_view.window_world
    assert (back.xmin, back.ymax) == pytest.approx((old.window_world.xmin, old.window_world.ymax))
    for factor in (0.0, -1.0, float("nan")):
        with pytest.raises(DocumentError, match="above 0"):
            edits.zoom("v1", factor, 0.0, 0.0)(document)


def test_a_sheet_keeps_one_view_and_ids_are_not_given_twice() -> None:
    document = document_of("Views", 60, 40, [])
    with pytest.raises(DocumentError, match="at least 1 view"):
        edits.remove_view("v1")(document)
    two = edits.add_view("s1", View("", WINDOW, WINDOW, "Detail", mode="fit"))(document)
    assert [view.id for view in two.sheets[0].views] == ["v1", "v2"]
    turned = edits.reorder_view("v2", 0)(two)
    assert [view.id for view in turned.sheets[0].views] == ["v2", "v1"]
    one = edits.remove_view("v2")(turned)
    again = edits.add_view("s1", View("", WINDOW, WINDOW))(one)
    assert again.sheets[0].views[-1].id == "v3"
    named = edits.rename_view("v1", "Whole")(edits.set_mode("v1", "fill")(again))
    assert (named.sheets[0].first_view.name, named.sheets[0].first_view.mode) == ("Whole", "fill")
    with pytest.raises(DocumentError, match="mode is 'wide'"):
        edits.set_mode("v1", "wide")(again)
