"""Marks on their way from the frame of an algorithm's arguments to the device."""

import numpy as np
import pytest

from tests.document.views import seen_through
from workbench.algorithms import catalogue
from workbench.algorithms.marks import Frame, Ray, Region, Spot, Stroke, Word
from workbench.document.model import Polygon, Rectangle, Sheet
from workbench.document.samples.examples import example
from workbench.document.samples.figures import document_of
from workbench.rendering import figure_calls
from workbench.rendering.inside import verdict
from workbench.rendering.mapping import device_map
from workbench.rendering.marks import on_device


def sheet() -> Sheet:
    made = document_of("Marks", 40, 20, []).sheets[0]
    return seen_through(made, window_world=Rectangle(0.0, 0.0, 80.0, 80.0))


ALL = (
    Stroke(np.array([(0.0, 0.0), (8.0, 4.0)]), "data2", "bold", "dot"),
    Region(np.array([(0.0, 0.0), (8.0, 4.0), (8.0, 0.0)]), "warn"),
    Spot(8.0, 4.0, "accent", "cross", "small"),
    Word("here", 8.0, 4.0, "text", 1, -1, True, True),
)


def test_what_is_in_device_coordinates_stays() -> None:
    assert all(one is other for one, other in zip(on_device(sheet(), "device", ALL), ALL, strict=True))


@pytest.mark.parametrize("frame", ["world", "view"])
def test_what_is_in_the_world_goes_through_window_and_viewport(frame: Frame) -> None:
    scale = device_map(sheet())
    stroke, region, spot, word = on_device(sheet(), frame, ALL)
    assert isinstance(stroke, Stroke)
    assert isinstance(region, Region)
    assert isinstance(spot, Spot)
    assert isinstance(word, Word)
    assert stroke.points.tolist() == [[*scale.point(0, 0)], [*scale.point(8, 4)]]
    assert stroke[1:] == ALL[0][1:]
    assert region.points[1].tolist() == [*scale.point(8, 4)]
    assert (spot.x, spot.y) == scale.point(8, 4) == (word.x, word.y)
    assert (spot.x, spot.y) == (3.5, 0.5)
    assert spot[2:] == ALL[2][2:]
    assert (word.text, *word[3:]) == ("here", *ALL[3][3:])


@pytest.mark.parametrize(
    ("ray", "ends"),
    [
        (Ray(3, 5, 1, 0), [(3, 5), (39.5, 5)]),
        (Ray(3, 5, -2, 0), [(3, 5), (-0.5, 5)]),
        (Ray(3, 5, 0, 1), [(3, 5), (3, 19.5)]),
        (Ray(3, 5, 1, 0, both_ways=True), [(-0.5, 5), (39.5, 5)]),
        (Ray(30, 5, 1, 1), [(30, 5), (39.5, 14.5)]),
        (Ray(3, 5, 1, 0, least=50), [(3, 5), (53, 5)]),
        (Ray(45, 5, 1, 0), [(45, 5), (45, 5)]),
        (Ray(45, 5, 1, 0, least=3), [(45, 5), (48, 5)]),
    ],
)
def test_a_ray_ends_at_the_edge_of_the_picture(ray: Ray, ends: list[tuple[float, float]]) -> None:
    (stroke,) = on_device(sheet(), "device", [ray._replace(ink="data3", weight="bold", pattern="dash")])
    assert isinstance(stroke, Stroke)
    assert stroke.points.tolist() == [list(end) for end in ends]
    assert stroke[1:] == ("data3", "bold", "dash")


def test_a_ray_of_the_world_keeps_its_direction_on_the_device() -> None:
    (stroke,) = on_device(sheet(), "world", [Ray(8.0, 4.0, 1.0, 1.0)])
    start, end = stroke.points  # type: ignore[union-attr]
    scale = device_map(sheet())
    assert start.tolist() == [*scale.point(8, 4)]
    assert (end[1] - start[1]) / (end[0] - start[0]) == pytest.approx(scale.sy / scale.sx)
    assert end[1] == pytest.approx(19.5) or end[0] == pytest.approx(39.5)


def test_a_verdict_draws_the_crossings_that_the_test_counts() -> None:
    star = example("two-interiors").document.sheets[0]
    polygon = next(figure for figure in star.figures if isinstance(figure, Polygon) and figure.nonzero)
    found = verdict(star, polygon, 25.0, 20.0)
    assert found is not None
    vertices, ring_ends = figure_calls(star, polygon)[0].arguments[:2]
    function = catalogue.get("inside_outside").function
    crossings = sorted(x for x, _y, _way in function(vertices, ring_ends, 25.0, 20.0, True))
    rings = [m.x for m in found.marks if isinstance(m, Spot) and m.shape == "ring"]
    assert rings == pytest.approx(crossings)
    assert f"{len(crossings)} crossings" in found.sentence
    (ray,) = [mark for mark in found.marks if isinstance(mark, Stroke)]
    assert ray.points[0].tolist() == [25.0, 20.0]
    assert ray.points[1, 0] >= star.width_px - 0.5
    nothing_left = seen_through(star, clip_world=Rectangle(-90.0, -90.0, -80.0, -80.0))
    assert verdict(nothing_left, polygon, 25.0, 20.0) is None
