"""Figures drawn in batches: the same pixels, painters, strokes and reasons as call after call."""

import functools
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partialmethod
from itertools import pairwise, product
from unittest import mock

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.curves.made_curves import curves as made_curves
from tests.document.views import seen_through
from workbench.algorithms import catalogue
from workbench.algorithms import curves as algorithms
from workbench.algorithms.lines.wu import wu_line
from workbench.document.curves.pieces import b_spline_of, fault_of, pieces_of
from workbench.document.model import (
    LINE_CLIPPERS,
    AnyFigure,
    Circle,
    Curve,
    CurvePoint,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    WorldPoint,
)
from workbench.document.samples.figures import document_of
from workbench.engine import at_hand, batches, compiled, warm
from workbench.rendering import curves as rendered
from workbench.rendering import display_list, frame_buffer, painter_of, pipeline, raster, why
from workbench.rendering.clipping import clip_box, segments_of, visible_segments
from workbench.rendering.limits import clip_segments
from workbench.rendering.pipeline import calls
from workbench.rendering.raster import Composite, composite_below, seen_bounds

# Small kernels of each kind of emission, and one that takes lists.
KERNELS = ("bresenham_line", "wu_line", "midpoint_circle", "scan_line_exact")


def blended(under: int, over: int, coverage: float) -> int:
    """Two colours mixed, channel by channel, rounded half up."""
    colour = 0
    for shift in (0, 8, 16):
        old, new = under >> shift & 255, over >> shift & 255
        colour |= int(old + coverage * (new - old) + 0.5) << shift
    return colour


def one_by_one(sheet: Sheet, count: int) -> Composite:
    """The picture as it is painted by the plain texts: figure by figure, call by call, pixel by pixel."""
    image = np.full((sheet.height_px, sheet.width_px), sheet.palette[sheet.background], np.uint32)
    painter = np.full(image.shape, -1, np.int32)
    for index, figure in enumerate(sheet.figures[:count]):
        if not figure.visible:
            continue
        colour = sheet.palette[figure.colour % len(sheet.palette)]
        x_first, x_last, y_first, y_last = seen_bounds(sheet, figure)
        for call in calls(sheet, figure, below=image.copy()):
            function, emits = call.entry.function, call.entry.emits
            for row in list(function(*call.arguments)):
                y, left, right = row if emits == "spans" else (row[1], row[0], row[0])
                for x in range(max(left, x_first), min(right, x_last) + 1):
                    if y_first <= y <= y_last:
                        under = int(image[y, x])
                        image[y, x] = blended(under, colour, row[2]) if emits == "coverage" else colour
                        painter[y, x] = index
    return Composite(image, painter)


near = st.floats(-40, 110) | st.integers(-5, 70).map(float)
places = st.tuples(near, near)
far = st.sampled_from([-1e300, -3e5, -20_000.0, 17_000.0, 4e6, 1e300])
KINDS = (Line, Polyline, Polyline, Polygon, Polygon, Circle, Ellipse, Curve, SeedFill)
radii = st.floats(0, 30) | st.integers(0, 20).map(float)


def points(identity: str, corners: list[tuple[float, float]]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint(f"{identity}p{k}", x, y) for k, (x, y) in enumerate(corners))


@st.composite
def figures(draw: st.DrawFn, number: int) -> AnyFigure:
    """A figure of any kind, with one point far away at times."""
    corners = draw(st.lists(places, min_size=3, max_size=8))
    if draw(st.integers(0, 19)) == 0:
        corners[0] = (draw(far), corners[0][1])
    kind = draw(st.sampled_from(KINDS))
    slugs = [slug for slug in kind.algorithms if slug != "boundary_fill_recursive"]
    common = {
        "id": f"f{number}",
        "algorithm": draw(st.sampled_from(slugs[:2] + slugs)),
        "colour": draw(st.integers(0, 5)),
        "visible": draw(st.integers(0, 5)) > 0,
    }
    if kind is Curve:
        return replace(draw(made_curves(most=5)), **common)
    count = {Line: 2, Circle: 1, Ellipse: 1, SeedFill: 1}.get(kind, len(corners))
    common["points_world"] = points(common["id"], corners[:count])
    if kind is Polyline:
        return Polyline(**common, closed=draw(st.booleans()))
    if kind is Polygon:
        ends = (3, len(corners)) if len(corners) > 5 and draw(st.booleans()) else ()
        return Polygon(
            **common, ring_ends=ends, closed_interior=draw(st.booleans()), nonzero=draw(st.booleans())
        )
    if kind is Circle:
        return Circle(**common, radius_world=draw(radii))
    if kind is Ellipse:
        return Ellipse(**common, radius_x_world=draw(radii), radius_y_world=draw(radii))
    if kind is SeedFill:
        return SeedFill(**common, boundary=draw(st.integers(0, 3)))
    return Line(**common)


@st.composite
def sheets(draw: st.DrawFn) -> Sheet:
    """A sheet of several figures, equal ones among them, under any window, viewport, clipper and palette."""
    drawn = [draw(figures(k)) for k in range(draw(st.integers(1, 7)))]
    if draw(st.booleans()):
        drawn.append(replace(drawn[0], id="again"))
    sheet = document_of("Batches", 60, 40, drawn).sheets[0]
    whole = (-0.5, -0.5, 59.5, 39.5)
    window = draw(st.sampled_from([whole, (0.0, 0.0, 100.0, 40.0), (-3.0, 2.0, 30.0, 33.0)]))
    viewport = draw(st.sampled_from([whole, (4.5, 3.0, 50.2, 36.0)]))
    sheet = seen_through(
        sheet,
        window_world=Rectangle(*window),
        viewport_device=Rectangle(*viewport),
        clip_world=draw(st.none() | st.just(Rectangle(10.0, 5.0, 45.5, 30.0))),
    )
    return replace(
        sheet,
        palette=tuple(draw(st.lists(st.integers(0, 0xFFFFFF), min_size=2, max_size=4))),
        background=draw(st.integers(0, 1)),
        line_clipper=draw(st.sampled_from(LINE_CLIPPERS)),
    )


@contextmanager
def reading(name: str) -> Iterator[None]:
    """Have sheets painted call by call, by the drivers as Python, or by kernels where they are compiled."""
    asked = {"plain": lambda *_given: False, "interpreted": lambda *_given: True}.get(
        name, lambda function, _use: function.__name__ in KERNELS
    )
    flavour = partialmethod(batches.Calls.painter, flavour="interpreted" if name == "interpreted" else "")
    with (
        mock.patch.object(raster, "at_hand", asked),
        mock.patch.object(batches.Calls, "painter", flavour),
    ):
        raster._composite.cache_clear()
        yield
        raster._composite.cache_clear()


def over_the_edges() -> Sheet:
    """Figures of each kind of emission that leave the picture on all sides."""
    corners = [(-9.0, 20.0), (30.0, 49.0), (69.0, 20.0), (30.0, -9.0)]
    drawn = [
        Polyline("a", points("a", corners), "bresenham_line", 1, closed=True),
        Polyline("b", points("b", [corners[0], corners[2]]), "wu_line", 2),
        Polyline("c", points("c", [corners[3], corners[1]]), "wu_line", 3),
        Circle("d", points("d", [(30.0, 20.0)]), "midpoint_circle", 2, radius_world=33.0),
        Polygon(
            "e", points("e", [*corners, corners[0], *corners[:0:-1]]), "scan_line_exact", 4, nonzero=True
        ),
        Polygon("g", points("g", corners), "scan_line_exact", 3),
    ]
    return document_of("Edges", 60, 40, drawn).sheets[0]


@pytest.mark.parametrize("name", ["plain", "interpreted", "compiled"])
@settings(max_examples=50)
@example(sheet=over_the_edges(), count=4)
@given(sheet=sheets(), count=st.integers(0, 8))
def test_a_sheet_drawn_in_batches_is_the_sheet_drawn_one_by_one(name: str, sheet: Sheet, count: int) -> None:
    with reading(name):
        for picture, wanted in (
            (Composite(frame_buffer(sheet), painter_of(sheet)), one_by_one(sheet, len(sheet.figures))),
            (composite_below(sheet, count), one_by_one(sheet, count)),
        ):
            np.testing.assert_array_equal(picture.image, wanted.image)
            np.testing.assert_array_equal(picture.painter, wanted.painter)


@settings(max_examples=40)
@given(sheets())
def test_strokes_and_reasons_are_those_of_each_figure_alone(sheet: Sheet) -> None:
    alone = [replace(sheet, figures=(figure,)) for figure in sheet.figures]
    wanted = [stroke._replace(figure=k) for k, one in enumerate(alone) for stroke in display_list(one)]
    assert display_list(sheet) == wanted
    painter = painter_of(sheet)
    for y, x in [(0, 0), (20, 30), *np.argwhere(painter >= 0)[:3].tolist()]:
        touches = why(sheet, x, y)
        assert [touch.figure for touch in touches if touch.last] == [k for k in [painter[y, x]] if k >= 0]


@settings(max_examples=60)
@given(sheets())
def test_what_is_clipped_at_once_is_clipped_as_one_by_one(sheet: Sheet) -> None:
    window = clip_box(sheet)
    lines = [figure for figure in sheet.figures if isinstance(figure, Line | Polyline | Curve)]
    wanted = []
    for number, figure in enumerate(lines):
        rows = segments_of(sheet, figure)
        if window is not None:
            text = catalogue.get(sheet.line_clipper).function
            rows = [tuple(map(float, kept)) for row in rows for kept in text(*row, *window)]
        wanted += [(number, *row) for row in rows]
    seen = visible_segments(sheet, lines)
    assert [(k, *row) for k, row in zip(seen.of.tolist(), seen.table.tolist(), strict=True)] == wanted


numbers = st.floats(-1e3, 1e3) | st.sampled_from([-10.0, -5.0, 0.0, 10.0, 1e308, -1e308])


@settings(max_examples=200)
@given(st.lists(st.tuples(numbers, numbers, numbers, numbers), max_size=6))
def test_segments_are_cut_as_by_liang_and_barsky(rows: list[tuple[float, float, float, float]]) -> None:
    parts, kept = clip_segments(np.array(rows, np.float64).reshape(-1, 4), (-10.0, -5.0, 10.0, 5.0))
    wanted = [_cut(*row, -10.0, -5.0, 10.0, 5.0) for row in rows]
    assert kept.tolist() == [part is not None for part in wanted]
    np.testing.assert_array_equal(parts, np.array([p for p in wanted if p is not None]).reshape(-1, 4))


def _cut(x0, y0, x1, y1, xmin, ymin, xmax, ymax):
    """What of a segment lies in a rectangle, or None, by the book."""
    u1, u2 = 0.0, 1.0
    dx, dy = x1 - x0, y1 - y0
    for p, q in ((-dx, x0 - xmin), (dx, xmax - x0), (-dy, y0 - ymin), (dy, ymax - y0)):
        if p == 0.0 and q < 0.0:
            return None
        if p < 0.0:
            u1 = max(u1, q / p)
        if p > 0.0:
            u2 = min(u2, q / p)
    if u1 > u2:
        return None
    start = (x0, y0) if u1 == 0.0 else (x0 + u1 * dx, y0 + u1 * dy)
    return (*start, *((x1, y1) if u2 == 1.0 else (x0 + u2 * dx, y0 + u2 * dy)))


def test_wu_comes_to_no_pixel_twice() -> None:
    for x, y in product(range(-13, 14), repeat=2):
        cells = [row[:2] for row in wu_line(0, 0, x, y)]
        assert len(cells) == len(set(cells))


def test_consecutive_figures_of_one_text_are_one_call_of_its_kernel() -> None:
    corners = [(float(17 * k % 53), float(29 * k % 37)) for k in range(303)]
    lines = [
        Line(f"l{k}", points(f"l{k}", [a, b]), "bresenham_line") for k, (a, b) in enumerate(pairwise(corners))
    ]
    rounds = [
        Circle(f"c{k}", points(f"c{k}", [corners[k]]), "midpoint_circle", radius_world=3) for k in range(9)
    ]
    hidden = replace(rounds[0], id="h", visible=False)
    fill = SeedFill("s", points("s", [(3.0, 3.0)]), "flood_fill_4")
    sheet = document_of("x", 60, 40, [*lines[:200], hidden, *lines[200:], *rounds, fill, lines[0]]).sheets[0]
    called: list[tuple[str, int, int]] = []
    call = compiled.Kernel.call

    def counted(self: compiled.Kernel, driver: str, values: tuple[int, ...], compiling: bool) -> None:
        called.append((self.function.__name__, values[0], values[1]))
        call(self, driver, values, compiling)

    with reading("interpreted"), mock.patch.object(compiled.Kernel, "call", counted):
        frame_buffer(sheet)
    assert called == [("bresenham_line", 0, 302), ("midpoint_circle", 0, 9), ("bresenham_line", 302, 303)]


def test_one_edit_of_many_curves_flattens_one() -> None:
    def curve(number: int, *corners: tuple[float, float]) -> Curve:
        controls = tuple(CurvePoint(f"f{number}p{k}", x, y) for k, (x, y) in enumerate(corners))
        return Curve(f"f{number}", controls, "bresenham_line")

    many = [curve(k, *((k % 50 + j, (7 * k + j * j) % 40) for j in range(5))) for k in range(3000)]
    sheet = replace(document_of("x", 60, 40, []).sheets[0], figures=tuple(many))
    flattened: list[Curve] = []
    real = rendered._flattened_together
    counted = mock.Mock(side_effect=lambda keys: flattened.extend(key[1] for key in keys) or real(keys))
    with mock.patch.object(rendered, "_flattened_together", counted):
        pipeline.batches(sheet, sheet.figures)
        assert len(flattened) == 3000
        moved = curve(7, (1.0, 1.0), (30.0, 2.0), (4.0, 33.0))
        pipeline.batches(sheet, [*many[:7], moved, *many[8:]])
    assert flattened[3000:] == [moved]


def test_a_picture_waits_for_no_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_given: object) -> None:
        pytest.fail("a kernel was asked for")

    monkeypatch.setattr(compiled, "_kernel", refuse)
    monkeypatch.setattr(at_hand, "_known", set())
    corners = [(float(17 * k % 53), float(29 * k % 37)) for k in range(100)]
    figure = Polyline("f1", points("f1", corners), "dda_line_fixed")
    picture = frame_buffer(document_of("Lines", 60, 40, [figure]).sheets[0])
    assert (picture != picture[0, 0]).any()


def test_what_was_compiled_before_is_at_hand_once_it_is_loaded() -> None:
    entry = catalogue.get("bresenham_line")
    warm.compile_use(entry, batches.USE)
    fresh = functools.cache(compiled._kernel.__wrapped__)  # as in another process
    with mock.patch.object(at_hand, "_known", set()), mock.patch.object(compiled, "_kernel", fresh):
        warm.load(entry.slug, lambda: True)
        assert not at_hand.at_hand(entry.function, batches.USE)
        warm.load(entry.slug, lambda: False)
        assert at_hand.at_hand(entry.function, batches.USE)


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
