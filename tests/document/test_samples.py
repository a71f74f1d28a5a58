"""What is there from the start is sound, worth looking at, and legible on both canvases."""

from typing import get_args

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.algorithms.curves import piece_points
from workbench.document.check import check
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.edits import set_algorithm
from workbench.document.model import AnyFigure, Circle, Curve, Ellipse, Line, Polygon, Polyline, SeedFill
from workbench.document.samples.examples import PALETTE, blank_sheet, example, example_document, examples
from workbench.rendering import figure_map

KINDS: list[type[AnyFigure]] = [Line, Polyline, Polygon, Circle, Ellipse, SeedFill]


def test_the_first_picture_is_the_line_of_the_course() -> None:
    (sheet,) = example_document().sheets
    (line,) = sheet.figures
    assert isinstance(line, Line)
    assert [(p.x, p.y) for p in line.points_world] == [(20, 10), (30, 18)]
    assert line.algorithm == "bresenham_line"
    assert (sheet.width_px, sheet.height_px) == (40, 28)
    assert sheet.first_view.window_world == sheet.first_view.viewport_device


def test_a_blank_sheet_is_blank() -> None:
    assert check(blank_sheet(12, 7)).sheets[0].figures == ()


def test_the_examples_are_made_once() -> None:
    """All of them are made to find one, and a page asks for several."""
    assert example("house").document is example("house").document


@pytest.mark.parametrize("slug", [one.slug for one in examples()])
def test_every_example_is_sound_and_in_its_picture(slug: str) -> None:
    one = example(slug)
    assert check(one.document) is one.document
    assert one.title
    assert one.description.endswith(".")
    for sheet in one.document.sheets:
        inside = [
            -0.5 <= x <= sheet.width_px - 0.5 and -0.5 <= y <= sheet.height_px - 0.5
            for figure in sheet.figures
            for x, y in (figure_map(sheet, figure).point(p.x, p.y) for p in figure.points_world)
        ]
        # The world of a view reaches beyond its window
        assert all(inside) or (one.workspace == "view" and any(inside))


def test_there_is_no_example_of_another_name() -> None:
    with pytest.raises(LookupError, match="octants"):
        example("octant")


@pytest.mark.parametrize("kind", KINDS)
def test_the_algorithms_of_a_kind_are_those_of_the_catalogue(kind: type[AnyFigure]) -> None:
    name = kind.__struct_config__.tag
    assert set(kind.algorithms) == {entry.slug for entry in catalogue.entries() if name in entry.draws}
    for entry in map(catalogue.get, kind.algorithms):
        fills = entry.emits == "spans" and kind.topic == "circles"
        assert entry.topic == ("polygons" if fills else kind.topic)
    if kind is Line:
        assert set(kind.algorithms) == {entry.slug for entry in catalogue.topic("lines")}


def test_what_an_entry_draws_is_a_kind_of_figure() -> None:
    kinds = {kind.__struct_config__.tag for kind in get_args(AnyFigure)}
    assert {name for entry in catalogue.entries() for name in entry.draws} <= kinds


def test_an_algorithm_can_be_chosen_for_every_figure_that_it_draws() -> None:
    for slug in Line.algorithms:
        assert set_algorithm("f1", slug)(example_document()).sheets[0].figures[0].algorithm == slug


def _luminance(colour: int) -> float:
    parts = [(colour >> shift & 255) / 255 for shift in (16, 8, 0)]
    red, green, blue = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("colour", PALETTE[1:], ids=hex)
@pytest.mark.parametrize("canvas", [0xFFFFFF, 0x101316], ids=hex)
def test_every_colour_is_legible_on_light_and_dark(colour: int, canvas: int) -> None:
    low, high = sorted([_luminance(colour), _luminance(canvas)])
    assert (high + 0.05) / (low + 0.05) >= 3.0


def test_every_curve_of_an_example_can_be_drawn_and_the_circle_is_one() -> None:
    curves = [
        figure
        for one in examples()
        for sheet in one.document.sheets
        for figure in sheet.figures
        if isinstance(figure, Curve)
    ]
    assert len(curves) > 10
    for curve in curves:
        assert [fault_of(curve, spline) for spline in ("", *curve.beside)] == [""] * (1 + len(curve.beside))
    (circle,) = example("curve-circle").document.sheets[0].figures
    assert isinstance(circle, Curve)
    pieces = pieces_of(circle)
    points = piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], 1000))
    np.testing.assert_allclose(np.hypot(*(points - (120.0, 75.0)).T), 58.0, rtol=1e-12)
