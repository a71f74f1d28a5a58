"""Chains out as ``transform`` and in again: both pictures are the same."""

import re

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.made_documents import chains
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    CurvePoint,
    Ellipse,
    Line,
    Polygon,
    Sheet,
    WorldPoint,
)
from workbench.document.samples.figures import document_of
from workbench.document.transforms.chains import is_singular
from workbench.document.transforms.links import Affine, AnyLink, Rotate, Scale, Shear, Translate
from workbench.exchange.svg_paths import read_svg, write_svg
from workbench.rendering import display_list, frame_buffer


def points(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


FIGURES: tuple[AnyFigure, ...] = (
    Line("", points((3, 4), (40, 21)), "bresenham_line"),
    Polygon("", points((12, 4), (40, 9), (20, 30)), "scan_line_exact", 2),
    Circle("", points((30, 20)), "midpoint_circle", 3, radius_world=9.0),
    Ellipse("", points((30, 20)), "ellipse_fill", 4, radius_x_world=14.0, radius_y_world=6.0),
    Curve(
        "",
        tuple(CurvePoint("", 9.0 * k, 20.0 * (k % 2), weight=1.0 + k) for k in range(5)),
        "bresenham_line",
        2,
        spline="nurbs",
    ),
)


def sheet_of(*figures: AnyFigure) -> Sheet:
    return document_of("SVG", 60, 40, figures).sheets[0]


def read_again(sheet: Sheet, text: str) -> Sheet:
    return document_of("SVG", 60, 40, read_svg(text, sheet).figures).sheets[0]


@settings(max_examples=40)
@given(st.lists(st.tuples(st.sampled_from(FIGURES), chains()), min_size=1, max_size=3))
def test_the_picture_that_comes_back_is_the_same(drawn: list[tuple[AnyFigure, tuple[AnyLink, ...]]]) -> None:
    sheet = sheet_of(*(replace(figure, transforms=chain) for figure, chain in drawn))
    text = write_svg(sheet).text
    back = read_again(sheet, text)
    assert [f.transforms for f in sheet.figures] == [
        tuple(replace(link, id=old.id) for link, old in zip(b.transforms, a.transforms, strict=True))
        for a, b in zip(sheet.figures, back.figures, strict=True)
    ]
    assert np.array_equal(frame_buffer(back), frame_buffer(sheet))


def bare(text: str) -> str:
    return re.sub(r' workbench:\w+="[^"]*"', "", text)


@settings(max_examples=40)
@given(st.sampled_from(FIGURES[:4]), chains())
def test_what_other_programs_read_is_the_same_too(figure: AnyFigure, chain: tuple[AnyLink, ...]) -> None:
    sheet = sheet_of(replace(figure, transforms=chain))
    (first,) = sheet.figures
    back = read_again(sheet, bare(write_svg(sheet).text))
    assert len(back.figures) == 1
    second = back.figures[0]
    size = max(1.0, *(abs(v) for f in (first, second) for v in _seen(f).ravel().tolist()))
    assume(size < 1e5)
    if first.matrix is None or not is_singular(first.matrix):
        assert np.allclose(_dense(sheet), _dense(back), atol=0.2)


def _seen(figure: AnyFigure) -> np.ndarray:
    places = np.array([(p.x, p.y, 1.0) for p in figure.points_world])
    return (places @ (np.eye(3) if figure.matrix is None else figure.matrix).T)[:, :2]


def _dense(sheet: Sheet) -> np.ndarray:
    """The box around all strokes, and the middle of their lengths."""
    strokes = np.array([stroke[:4] for stroke in display_list(sheet)]).reshape(-1, 2, 2)
    if not len(strokes):
        return np.zeros((3, 2))
    length = np.hypot(*(strokes[:, 1] - strokes[:, 0]).T)
    if not length.sum():
        return np.zeros((3, 2))
    middle = (strokes.mean(axis=1) * length[:, None]).sum(axis=0) / length.sum()
    return np.vstack([strokes.min(axis=(0, 1)), strokes.max(axis=(0, 1)), middle])


HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.5 -39.5 60 40">'


@pytest.mark.parametrize(
    ("written", "link"),
    [
        ("translate(3 4)", Translate("", tx=3.0, ty=-4.0)),
        ("translate(3)", Translate("", tx=3.0)),
        ("rotate(30)", Rotate("", angle=-30.0)),
        ("rotate(30, 5, 6)", Rotate("", angle=-30.0, x_pivot=5.0, y_pivot=-6.0)),
        ("scale(2)", Scale("", sx=2.0, sy=2.0)),
        ("scale(2-1)", Scale("", sx=2.0, sy=-1.0)),
        ("skewX(45)", Shear("", sh_x=-1.0)),
        ("skewY(-45)", Shear("", sh_y=1.0)),
        ("matrix(1 2 3 4 5 6)", Affine("", m11=1.0, m12=-3.0, m13=5.0, m21=-2.0, m22=4.0, m23=-6.0)),
    ],
)
def test_a_function_is_a_link_of_its_kind(written: str, link: AnyLink) -> None:
    sheet = sheet_of()
    (line,) = read_svg(f'{HEAD}<line x2="9" stroke="red" transform="{written}"/></svg>', sheet).figures
    (read,) = line.transforms
    assert type(read) is type(link)
    assert np.allclose(read.matrix, link.matrix, atol=1e-12)
    assert [(p.x, p.y) for p in line.points_world] == [(0.0, 0.0), (9.0, 0.0)]


def test_what_no_link_has_room_for_goes_into_the_points() -> None:
    body = '<line x2="9" stroke="red" transform="translate(2e7) translate(-2e7) scale(2)"/>'
    (line,) = read_svg(f"{HEAD}{body}</svg>", sheet_of()).figures
    assert [type(link) for link in line.transforms] == [Affine]
    many = "rotate(1)" * 400
    (line,) = read_svg(f'{HEAD}<line x2="9" transform="{many}" stroke="red"/></svg>', sheet_of()).figures
    assert len(line.transforms) == 1
    assert np.allclose(_seen(line)[1], (9 * np.cos(np.radians(400)), -9 * np.sin(np.radians(400))))
