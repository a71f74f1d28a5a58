"""Figures under chains, against the same figures whose points NumPy has transformed."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import chains
from tests.document.views import seen_through
from workbench.algorithms.curves import piece_points
from workbench.document.model import (
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
from workbench.document.transforms.links import AnyLink, Reflect, Rotate, Scale, Shear, Translate
from workbench.rendering import display_list, figure_calls, figure_map, frame_buffer, painter_of, why
from workbench.rendering.clipping import clipper_calls
from workbench.rendering.curves import device_pieces, polylines_of
from workbench.rendering.rounds import reason, stays_round

Chain = tuple[AnyLink, ...]
CLIP = Rectangle(10.0, 8.0, 42.5, 33.0)


def points(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


def sheet_of(*figures: AnyFigure, clip: Rectangle | None = None) -> Sheet:
    return document_of("Transformed", 60, 40, figures, clip).sheets[0]


FIGURES = (
    Line("", points((3, 4), (40, 21)), "bresenham_line"),
    Line("", points((30, 4), (4, 31)), "wu_line", 2),
    Polyline("", points((3, 4), (30, 9), (20, 30)), "dda_line", 3, closed=True),
    Polygon("", points((12, 4), (40, 9), (20, 30), (8, 28)), "scan_line_exact", 4),
)


def baked(figure: AnyFigure) -> AnyFigure:
    """The figure without a chain, its points where NumPy takes them."""
    if figure.matrix is None:
        return replace(figure, transforms=())
    places = np.array([(p.x, p.y, 1.0) for p in figure.points_world]) @ figure.matrix[:2].T
    moved = zip(figure.points_world, places.tolist(), strict=True)
    return replace(figure, transforms=(), points_world=tuple(replace(p, x=x, y=y) for p, (x, y) in moved))


@given(st.sampled_from(FIGURES), chains(), st.booleans())
def test_points_are_drawn_where_the_chain_takes_them(figure: AnyFigure, chain: Chain, clips: bool) -> None:
    clip = CLIP if clips else None
    whole = sheet_of(replace(figure, transforms=chain), clip=clip)
    # Where rounding in another order decides a tie, both are right.
    places = np.array([(p.x, p.y) for p in baked(whole.figures[0]).points_world])
    assume(np.abs(np.abs(places - np.floor(places)) - 0.5).min() > 1e-6)
    assume(np.abs(places).max() < 1e4)
    plain = replace(whole, figures=(baked(whole.figures[0]),))
    differ = np.count_nonzero(frame_buffer(whole) != frame_buffer(plain))
    # A line that is clipped ends where its clipper says, which may be half way between two pixels.
    assert differ <= (2 if clips else 0)
    first, other = (np.array([s[:4] for s in display_list(s_)]).reshape(-1, 4) for s_ in (whole, plain))
    assert first.shape == other.shape
    assert np.allclose(first, other, atol=1e-6)


@given(chains())
def test_a_seed_falls_where_the_chain_takes_it(chain: Chain) -> None:
    frame = Polyline("", points((1, 1), (55, 1), (55, 35), (1, 35)), "bresenham_line", closed=True)
    seed = SeedFill("", points((20, 20)), "boundary_fill_4", 2, transforms=chain)
    whole = sheet_of(frame, seed)
    plain = replace(whole, figures=(whole.figures[0], baked(whole.figures[1])))
    places = np.array([(p.x, p.y) for p in plain.figures[1].points_world])
    assume(np.abs(np.abs(places - np.floor(places)) - 0.5).min() > 1e-6)
    assert np.array_equal(frame_buffer(whole), frame_buffer(plain))


SPLINES = ("bezier", "bezier_path", "nurbs", "catmull_rom", "hermite", "natural_cubic")


@given(st.sampled_from(SPLINES), chains())
def test_a_curve_is_transformed_point_by_point(spline: str, chain: Chain) -> None:
    controls = tuple(
        CurvePoint("", 8.0 * k, 7.0 * (k % 3), weight=1.0 + k, tangent_x=9.0, tangent_y=-4.0)
        for k in range(7)
    )
    plain = sheet_of(Curve("", controls, "bresenham_line", spline=spline))
    (curve,) = plain.figures
    assert isinstance(curve, Curve)
    whole = replace(curve, transforms=chain)
    u = np.linspace(0.0, 1.0, 33)
    before, after = (
        piece_points(pieces, pieces.knots[0] + u * (pieces.knots[-1] - pieces.knots[0]))
        for pieces in (device_pieces(plain, curve), device_pieces(plain, whole))
    )
    matrix = np.eye(3) if whole.matrix is None else whole.matrix
    expected = before @ matrix[:2, :2].T + matrix[:2, 2]
    assert np.allclose(after, expected, atol=1e-7 * max(1.0, np.abs(expected).max()))


ROUNDS = (
    Circle("", points((30, 20)), "midpoint_circle", radius_world=9.0),
    Circle("", points((30, 20)), "circle_fill", radius_world=9.0),
    Ellipse("", points((30, 20)), "midpoint_ellipse", radius_x_world=14.0, radius_y_world=6.0),
    Ellipse("", points((30, 20)), "ellipse_fill", radius_x_world=14.0, radius_y_world=6.0),
)


def ring(figure: Circle | Ellipse, count: int = 721) -> np.ndarray:
    """Points of what the chain makes of a circle or ellipse."""
    rx, ry = (
        (figure.radius_world,) * 2
        if isinstance(figure, Circle)
        else (figure.radius_x_world, figure.radius_y_world)
    )
    angle, centre = np.linspace(0, 2 * math.pi, count), figure.points_world[0]
    local = np.column_stack([centre.x + rx * np.cos(angle), centre.y + ry * np.sin(angle), np.ones(count)])
    return local @ (np.eye(3) if figure.matrix is None else figure.matrix)[:2].T


@given(st.sampled_from(ROUNDS), chains())
def test_what_does_not_stay_round_is_drawn_as_its_exact_curve(figure: Circle | Ellipse, chain: Chain) -> None:
    whole = sheet_of(replace(figure, transforms=chain))
    (round_,) = whole.figures
    assert isinstance(round_, Circle | Ellipse)
    ideal = ring(round_)
    assume(np.abs(ideal).max() < 2000)
    strokes = display_list(whole)
    corners = np.array([place for s in strokes for place in (s[:2], s[2:4])]).reshape(-1, 2)
    if len(corners):
        apart = np.hypot(*(corners[:, None] - ideal[None]).transpose(2, 0, 1)).min(axis=1)
        step = np.hypot(*np.diff(ideal, axis=0).T).max()
        assert apart.max() < 0.05 + step
    if stays_round(round_):
        assert reason(round_) == ""
    else:
        (line,) = polylines_of(whole, [round_])
        assert np.allclose(line[0], line[-1])
        gap = np.hypot(*(ideal[:, None] - _between(line)[None]).transpose(2, 0, 1)).min(axis=1)
        assert gap.max() < 0.1 + np.hypot(*np.diff(line, axis=0).T).max() / 60
        assert "exact curve" in reason(round_)
    slugs = {call.entry.slug for call in figure_calls(whole, round_)}
    filled = figure.algorithm.endswith("fill")
    expected = figure.algorithm if stays_round(round_) else "scan_line_exact" if filled else "bresenham_line"
    assert slugs <= {expected}


def _between(line: np.ndarray) -> np.ndarray:
    share = np.linspace(0, 1, 31)[:, None, None]
    return (line[:-1] + share * np.diff(line, axis=0)).reshape(-1, 2)


@pytest.mark.parametrize(
    ("figure", "chain", "stays"),
    [
        (ROUNDS[0], (Rotate("", angle=33.0), Scale("", sx=2.0, sy=-2.0), Reflect("", angle=20.0)), True),
        (ROUNDS[0], (Scale("", sx=2.0),), False),
        (ROUNDS[0], (Shear("", sh_x=1.0),), False),
        (ROUNDS[2], (Scale("", sx=2.0), Rotate("", angle=90.0), Translate("", tx=3.0)), True),
        (ROUNDS[2], (Rotate("", angle=45.0),), False),
        (ROUNDS[2], (Rotate("", angle=45.0), Rotate("", angle=-45.0)), True),
        (ROUNDS[2], (Shear("", sh_x=1.0),), False),
    ],
)
def test_circles_stay_under_similarities_and_ellipses_along_the_axes(
    figure: Circle | Ellipse, chain: Chain, stays: bool
) -> None:
    assert stays_round(replace(figure, transforms=chain)) is stays


def test_a_filled_circle_that_is_sheared_has_its_area() -> None:
    chain = (Shear("", sh_x=0.5, y_ref=20.0),)
    sheet = sheet_of(replace(ROUNDS[1], transforms=chain))
    assert np.count_nonzero(painter_of(sheet) == 0) == pytest.approx(math.pi * 81, rel=0.03)
    clipped = sheet_of(replace(ROUNDS[1], transforms=chain), clip=Rectangle(0.0, 0.0, 30.0, 40.0))
    assert [call.entry.slug for call in clipper_calls(clipped, clipped.figures[0])] == ["sutherland_hodgman"]
    assert np.array_equal(painter_of(clipped)[:, :30], painter_of(sheet)[:, :30])
    assert not (painter_of(clipped)[:, 32:] == 0).any()


@given(st.sampled_from((*FIGURES, *ROUNDS)), chains())
def test_why_names_the_figure_that_is_seen(figure: AnyFigure, chain: Chain) -> None:
    sheet = sheet_of(replace(figure, transforms=chain))
    painter = painter_of(sheet)
    seen = np.argwhere(painter == 0)
    for y, x in seen[:: max(1, len(seen) // 5)].tolist():
        touches = why(sheet, x, y)
        assert touches[-1].figure == 0
        assert touches[-1].last


@given(chains())
def test_the_way_back_through_the_chain(chain: Chain) -> None:
    sheet = sheet_of(Line("", points((3, 4), (40, 21)), "bresenham_line", transforms=chain))
    sheet = seen_through(sheet, window_world=Rectangle(-10.0, -10.0, 50.0, 90.0))
    (line,) = sheet.figures
    scale = figure_map(sheet, line)
    matrix = np.eye(3) if line.matrix is None else line.matrix
    assume(np.linalg.matrix_rank(matrix[:2, :2]) == 2)
    assume(np.linalg.cond(matrix) < 1e5)
    assert np.allclose(scale.world_point(*scale.point(7.0, -3.0)), (7.0, -3.0), atol=1e-6)
    assert np.allclose(scale.world(scale.points(np.array([[7.0, -3.0]]))), [[7.0, -3.0]], atol=1e-6)
    x, y = scale.world_way(2.0, 1.0)
    (ax, ay), (bx, by) = scale.point(7.0, -3.0), scale.point(7.0 + x, -3.0 + y)
    assert np.allclose((bx - ax, by - ay), (2.0, 1.0), atol=1e-6)
