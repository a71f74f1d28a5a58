"""Segments in one go: the same rows, pixels and blends as one call after the other."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.curves.made_curves import curves as made_curves
from workbench.algorithms import catalogue
from workbench.algorithms import curves as algorithms
from workbench.document.curves.pieces import b_spline_of, fault_of, pieces_of
from workbench.document.model import LINE_CLIPPERS, Curve, Line, Polyline, Rectangle, Sheet, WorldPoint
from workbench.document.samples.figures import document_of, polyline
from workbench.engine import compiled
from workbench.rendering import display_list, emissions, frame_buffer, painter_of
from workbench.rendering.clipping import clip_box, segments_of, visible_table
from workbench.rendering.emissions import emitted_by_all
from workbench.rendering.limits import clip_segment
from workbench.rendering.pipeline import calls, colour_of, line_calls_table
from workbench.rendering.raster import Composite, _blend, emitted, pixels, seen_bounds
from workbench.rendering.segments import FEW

near = st.floats(-40, 110) | st.integers(-5, 70).map(float)
places = st.tuples(near, near)


def one_by_one(sheet: Sheet) -> Composite:
    """The picture as it is painted call by call, pixel by pixel."""
    image = np.full((sheet.height_px, sheet.width_px), sheet.palette[0], np.uint32)
    painter = np.full(image.shape, -1, np.int32)
    for index, figure in enumerate(sheet.figures):
        x_first, x_last, y_first, y_last = seen_bounds(sheet, figure)
        for call in calls(sheet, figure):
            before = image.copy()
            for row in emitted(call):
                x, y = int(row[0]), int(row[1])
                if not (x_first <= x <= x_last and y_first <= y <= y_last):
                    continue
                image[y, x] = colour_of(sheet, figure)
                if call.entry.emits == "coverage":
                    single = before[y : y + 1, x : x + 1].copy()
                    _blend(single, np.array([0]), np.array([0]), row[2:3], colour_of(sheet, figure))
                    image[y, x] = single[0, 0]
                painter[y, x] = index
    return Composite(image, painter)


@st.composite
def sheets(draw: st.DrawFn) -> Sheet:
    figures = []
    for colour in range(1, draw(st.integers(1, 3)) + 1):
        points = draw(st.lists(places, min_size=2, max_size=9))
        if draw(st.booleans()):
            points = [(x + 3 * k, y - 2 * k) for k in range(FEW) for x, y in points][: FEW + 7]
        figure = polyline(points, colour, "", draw(st.booleans()))
        figures.append(replace(figure, algorithm=draw(st.sampled_from(Line.algorithms))))
    if draw(st.booleans()):
        figures.append(draw(made_curves(most=6)))
    sheet = document_of("Lines", 60, 40, figures).sheets[0]
    clip = draw(st.none() | st.just(Rectangle(10.0, 5.0, 45.5, 30.0)))
    return replace(sheet, clip_world=clip, line_clipper=draw(st.sampled_from(LINE_CLIPPERS)))


@settings(max_examples=60)
@given(sheets(), st.lists(st.tuples(st.integers(0, 8), places), max_size=3))
def test_the_picture_is_the_same_as_call_by_call(
    sheet: Sheet, moves: list[tuple[int, tuple[float, float]]]
) -> None:
    for number, (x, y) in [(0, (0.0, 0.0)), *moves]:
        wanted = one_by_one(sheet)
        np.testing.assert_array_equal(frame_buffer(sheet), wanted.image)
        np.testing.assert_array_equal(painter_of(sheet), wanted.painter)
        line = sheet.figures[0]
        assert isinstance(line, Polyline)
        points = list(line.points_world)
        points.insert(number % len(points), WorldPoint(f"n{len(points)}", x, y))
        if number % 2:
            del points[-2]
        sheet = replace(sheet, figures=(replace(line, points_world=tuple(points)), *sheet.figures[1:]))


@settings(max_examples=60)
@given(sheets())
def test_what_is_clipped_at_once_is_clipped_as_one_by_one(sheet: Sheet) -> None:
    window = clip_box(sheet)
    for figure in sheet.figures:
        assert isinstance(figure, Line | Polyline | Curve)
        rows = segments_of(sheet, figure)
        if window is not None:
            text = catalogue.get(sheet.line_clipper).function
            rows = [tuple(map(float, kept)) for row in rows for kept in text(*row, *window)]
        assert visible_table(sheet, figure).tolist() == [list(row) for row in rows]
        bounds = (9.5, 4.5, 45.5, 30.0) if window else (-0.5, -0.5, 59.5, 39.5)
        strokes = [stroke for stroke in display_list(sheet) if sheet.figures[stroke.figure] is figure]
        if window is None:
            seen = [part for row in rows if (part := clip_segment(*row, *bounds)) is not None]
            assert [tuple(stroke[:4]) for stroke in strokes] == seen


def test_two_figures_alike_do_not_take_each_others_table(monkeypatch: pytest.MonkeyPatch) -> None:
    corners = [(float(17 * k % 53), float(29 * k % 37)) for k in range(100)]
    emissions._batches.clear()
    made = []
    real = emissions._made_from
    monkeypatch.setattr(emissions, "_made_from", lambda *given: made.append(len(given[2])) or real(*given))
    for number in range(100):
        figures = [polyline(places, 1, "", False) for places in ([*corners[:-1], (number, 3)], corners)]
        frame_buffer(document_of("Lines", 60, 40, figures).sheets[0])
    # One table for each place of the end that is dragged, and one for the figure that stays.
    assert len(made) == 101
    (kept,) = emissions._batches.values()
    assert len(kept.batches) == emissions._KEPT
    monkeypatch.setattr(emissions, "_KEPT_ROWS", 10_000)
    frame_buffer(document_of("Lines", 60, 40, [polyline(corners[::-1], 1, "", False)]).sheets[0])
    assert sum(len(batch.rows) for batch in kept.batches.values()) <= 10_000


def test_a_kernel_for_many_calls_gives_the_same_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    corners = [(float(17 * k % 53), float(29 * k % 37)) for k in range(100)]
    sheet = document_of("Lines", 60, 40, [polyline(corners, 1, "", False)]).sheets[0]
    entry, table = line_calls_table(sheet, sheet.figures[0])  # type: ignore[arg-type]
    rows, ends = emitted_by_all(entry, table)
    emissions._batches.clear()
    monkeypatch.setattr(compiled, "ready", lambda *_given: True)
    asked = []
    real = compiled.collect_many
    monkeypatch.setattr(
        compiled, "collect_many", lambda *given, **how: asked.append(len(given[1])) or real(*given, **how)
    )
    monkeypatch.setattr(compiled, "loaded", lambda: True)
    again, again_ends = emitted_by_all(entry, table)
    assert asked == [99]
    np.testing.assert_array_equal(again, rows)
    np.testing.assert_array_equal(again_ends, ends)
    assert len(pixels(entry, rows)) == ends[-1]


@settings(max_examples=80)
@given(made_curves("b_spline", most=12), st.integers(0, 3), places, st.integers(0, 11))
def test_pieces_made_anew_are_the_pieces(
    curve: Curve, copies: int, place: tuple[float, float], number: int
) -> None:
    many = tuple(replace(p, id=f"p{k}", x=p.x + k) for k, p in enumerate(curve.points_world * (10 + copies)))
    grown = replace(curve, points_world=many, knot_rule="open_uniform", knots=())
    if fault_of(grown):
        return
    points = list(many)
    points[number % len(points)] = replace(points[number % len(points)], x=place[0], y=place[1])
    moved = replace(grown, points_world=tuple(points))
    controls, knots, _weights = b_spline_of(moved)
    wanted = algorithms.b_spline_to_bezier(controls, knots, moved.degree)
    np.testing.assert_array_equal(pieces_of(moved).controls, wanted.controls)
    np.testing.assert_array_equal(pieces_of(moved).knots, wanted.knots)


def test_a_picture_does_not_wait_for_a_compiler_that_is_being_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    corners = [(float(17 * k % 53), float(29 * k % 37)) for k in range(100)]
    sheet = document_of("Lines", 60, 40, [polyline(corners, 1, "", False)]).sheets[0]
    emissions._batches.clear()
    emissions._remembered.cache_clear()
    monkeypatch.setattr(compiled, "loaded", lambda: False)
    monkeypatch.setattr(compiled, "ready", lambda *_given: True)
    monkeypatch.setattr(compiled, "collect_many", lambda *_given, **_how: pytest.fail("waits"))
    monkeypatch.setattr(compiled, "collect", lambda *_given, **_how: pytest.fail("waits"))
    assert len(emitted_by_all(*line_calls_table(sheet, sheet.figures[0]))[1]) == 99  # type: ignore[arg-type]
    far = catalogue.get("bresenham_line"), (0, 0, 10**5, 7)
    assert len(emissions._run(far[0].function, True, far[1], 0)) == 10**5 + 1
