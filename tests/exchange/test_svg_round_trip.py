"""SVG out and in again: the same figures, or, for other programs, the same geometry within the error."""

import re
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
import svgelements
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.curves.made_curves import knot_vectors
from tests.document.views import seen_through
from workbench.document.building import without_ids
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.model import (
    SPLINES,
    Circle,
    Curve,
    CurvePoint,
    Ellipse,
    Knot,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
    View,
    WorldPoint,
    whole_sheet,
)
from workbench.document.transforms.links import Rotate, Scale, Translate
from workbench.exchange.svg_paths import read_svg, write_svg

PALETTE = (0xFFFFFF, 0x000000, 0xCC3300, 0x0055AA)


def sheet_with(*figures: Any, window: Rectangle = Rectangle(-20, -10, 180, 90)) -> Sheet:  # noqa: B008
    view = View("v1", window, whole_sheet(200, 100))
    return Sheet("s1", "sheet", 200, 100, (view,), PALETTE, tuple(figures))


def bare(text: str) -> str:
    """The SVG as another program leaves it that keeps nothing of ours."""
    return re.sub(r" workbench:\w+=('[^']*'|\"[^\"]*\")", "", text)


coordinate = st.floats(-50, 150, allow_subnormal=False)


@st.composite
def curves(draw: st.DrawFn) -> Curve:
    spline = draw(st.sampled_from(SPLINES))
    count = draw(st.integers(4, 9))
    points = tuple(
        CurvePoint(
            f"p{k}",
            draw(coordinate),
            draw(coordinate),
            weight=draw(st.sampled_from([1.0, 0.25, 7.0])),
            tangent_x=draw(coordinate),
            joint=draw(st.sampled_from(["corner", "smooth"])),
        )
        for k in range(count)
    )
    degree = draw(st.integers(1, min(count - 1, 5)))
    knots: tuple[Knot, ...] = ()
    if draw(st.booleans()):
        knots = tuple(
            Knot(f"k{k}", u) for k, u in enumerate(draw(knot_vectors(count, degree, degree)).tolist())
        )
    return Curve(
        "f1",
        points,
        Curve.algorithms[0],
        draw(st.integers(0, 3)),
        draw(st.text(max_size=10)),
        spline=spline,
        degree=degree,
        closed=not knots and draw(st.booleans()),
        knot_rule="free" if knots else "open_uniform",
        knots=knots,
    )


@given(curves())
def test_a_curve_comes_back_as_it_was(curve: Curve) -> None:
    sheet = sheet_with(curve)
    (back,) = read_svg(write_svg(sheet).text, sheet).figures
    assert back == without_ids(curve)


@settings(max_examples=60)
@given(curves(), st.sampled_from([1.0, 1e-3]))
def test_other_programs_see_the_same_curve_within_the_error(curve: Curve, tolerance: float) -> None:
    sheet = sheet_with(curve)
    out = write_svg(sheet, tolerance)
    if fault_of(curve):
        assert out.notes
        return
    pieces = pieces_of(curve)
    exact = pieces.weights is None and pieces.degree <= 3
    assert out.error == 0.0 if exact else 0.0 <= out.error <= tolerance
    found = read_svg(bare(out.text), sheet, tolerance).figures
    drawn = [np.concatenate([_along(pieces_of(f)) for f in found])]
    if exact:
        assert len(pieces_of(found[0]).controls) in (len(pieces.controls), len(pieces.controls) + 1)
        size = np.abs(pieces.controls).max()
        assert np.abs(drawn[0][: 65 * len(pieces.controls)] - _along(pieces)).max() <= 1e-12 * max(size, 1.0)
        return
    line = shapely.LineString(drawn[0])
    apart = shapely.distance(line, shapely.points(_along(pieces))).max()
    steps = np.hypot(*np.diff(drawn[0], axis=0).T).max()
    assert apart <= out.error + 0.01 * steps


def _along(pieces: Any) -> Any:
    us = np.linspace(0, 1, 65)
    from workbench.algorithms.curves import bernstein

    basis = bernstein(pieces.degree, us)
    weights = np.ones(pieces.controls.shape[:2]) if pieces.weights is None else pieces.weights
    whole = np.einsum("ui,mi,mik->muk", basis, weights, pieces.controls)
    return (whole / np.einsum("ui,mi->mu", basis, weights)[..., None]).reshape(-1, 2)


def some_figures() -> list[Any]:
    points = tuple(
        WorldPoint(f"p{k}", x, y) for k, (x, y) in enumerate([(1, 2), (30, 4.5), (7, 0.1), (9, 60)])
    )
    return [
        Line("f1", points[:2], "dda_line", 2, "a <line> & \x07 \ufffe more"),
        Polyline("f2", points, "bresenham_line", 3, closed=True),
        Polyline("f3", points, "wu_line", 1),
        Polygon("f4", points + points[:3], "scan_line_exact", 2, ring_ends=(4, 7), nonzero=True),
        Circle("f5", points[:1], "circle_fill", 1, radius_world=3.5),
        Ellipse("f6", points[1:2], "midpoint_ellipse", 2, radius_x_world=3.5, radius_y_world=0.5),
        SeedFill("f7", points[:1], "flood_fill_4", 3),
        Curve("f8", tuple(CurvePoint(p.id, p.x, p.y) for p in points[:1]), "dda_line", 1),
    ]


def test_every_figure_comes_back_as_it_was() -> None:
    sheet = sheet_with(*some_figures(), replace(some_figures()[0], id="f9", visible=False))
    out = write_svg(sheet)
    assert [note.split()[0] for note in out.notes] == ["f7", "f8"]
    assert list(read_svg(out.text, sheet).figures) == [without_ids(figure) for figure in some_figures()]


def test_another_reader_understands_the_file() -> None:
    sheet = sheet_with(*some_figures())
    text = write_svg(sheet).text
    assert ElementTree.fromstring(text).tag == "{http://www.w3.org/2000/svg}svg"
    read = svgelements.SVG.parse(__import__("io").StringIO(text), reify=True)
    line = next(e for e in read.elements() if isinstance(e, svgelements.SimpleLine))
    assert (line.x1, line.y1, line.x2, line.y2) == pytest.approx((21, 88, 50, 85.5))
    circle = next(e for e in read.elements() if isinstance(e, svgelements.Circle))
    assert (circle.cx, circle.cy, circle.rx) == pytest.approx((21, 88, 3.5))


def nurbs() -> Curve:
    points = tuple(CurvePoint(f"p{k}", 10.0 * k, 5.0 * (k % 2), weight=1.0 + k) for k in range(5))
    return Curve("f1", points, "bresenham_line", 2, "arch", spline="nurbs")


def test_an_original_moves_and_grows_with_its_group() -> None:
    sheet = sheet_with(nurbs())
    text = write_svg(sheet).text
    moved = text.replace("<path", '<g transform="translate(5,-3) scale(2)"><path').replace(
        "</path>", "</path></g>"
    )
    (back,) = read_svg(moved, sheet).figures
    assert isinstance(back, Curve)
    assert back.spline == "nurbs"
    assert back.points_world == without_ids(nurbs()).points_world
    assert back.transforms == (Scale("", sx=2.0, sy=2.0), Translate("", tx=5.0, ty=3.0))


def test_an_original_turns_with_a_transform_of_its_own() -> None:
    sheet = sheet_with(nurbs())
    turned = write_svg(sheet).text.replace("<path", '<path transform="rotate(10)"')
    (back,) = read_svg(turned, sheet).figures
    assert back == replace(without_ids(nurbs()), transforms=(Rotate("", angle=-10.0),))


def test_what_was_changed_elsewhere_is_taken_as_it_is_drawn() -> None:
    sheet = sheet_with(nurbs())
    text = write_svg(sheet).text
    changed = re.sub(r' d="M [^C]*C', ' d="M 1,1 C', text)
    broken = text.replace("&quot;nurbs&quot;", "&quot;other&quot;").replace('"nurbs"', '"other"')
    for other in (changed, broken, bare(text)):
        assert other != text
        (back,) = read_svg(other, sheet).figures
        assert isinstance(back, Curve)
        assert back.spline == "bezier_path"
    recoloured = text.replace("#cc3300", "#0055aa")
    (back,) = read_svg(recoloured, sheet).figures
    assert back == replace(without_ids(nurbs()), colour=3)


def test_a_window_of_another_size_takes_the_picture_whole() -> None:
    text = write_svg(sheet_with(nurbs())).text
    other = sheet_with(window=Rectangle(0, 0, 400, 400))
    (back,) = read_svg(text, other).figures
    expected = [(2 * (p.x + 20), 2 * (p.y + 10) + 100) for p in nurbs().points_world]
    assert [(p.x, p.y) for p in back.points_world] == expected


def test_the_clip_window_is_kept_for_other_programs() -> None:
    sheet = seen_through(sheet_with(nurbs()), clip_world=Rectangle(0, 0, 10, 20))
    text = write_svg(sheet).text
    assert '<rect x="0" y="-20" width="10" height="20"/>' in text
    assert read_svg(text, sheet).figures == (without_ids(nurbs()),)


def test_a_circle_of_weights_is_written_round() -> None:
    corner = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    points = tuple(
        CurvePoint(f"p{k}", 40 + 30 * x, 40 + 30 * y, weight=0.5**0.5 if k % 2 else 1.0)
        for k, (x, y) in enumerate(corner)
    )
    knots = tuple(Knot(f"k{k}", float(u)) for k, u in enumerate([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]))
    curve = Curve("f1", points, "dda_line", 1, spline="nurbs", degree=2, knot_rule="free", knots=knots)
    out = write_svg(sheet_with(curve), 1e-3)
    (back,) = read_svg(bare(out.text), sheet_with()).figures
    off = np.abs(np.hypot(*(_along(pieces_of(back)) - 40).T) - 30).max()
    assert off <= out.error + 1e-12 <= 1e-3
