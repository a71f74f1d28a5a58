"""The tube cut open: to scale, whole, and with labels that keep clear of one another."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely import LineString

from tests.display.overlaps import crowded
from tests.display.test_gun import guns
from workbench.algorithms.scanning.electron_optics import FACE_MM, PLATES_MM
from workbench.display.cutaway import (
    STEPS,
    beam_outline,
    ends_on_face,
    labels,
    parts_of,
    place_labels,
    shapes,
    spans,
    tangent,
    window_of,
)
from workbench.display.gun import Deflection, Gun


@given(guns)
def test_every_part_is_drawn_and_named_and_lies_in_the_window(gun: Gun) -> None:
    left, low, right, high = window_of(gun)
    drawn = {shape.part for shape in shapes(gun)} - {""}
    assert drawn | {"beam"} == set(parts_of(gun)) == {label.part for label in labels(gun)}
    assert {part for step in STEPS for part in step} >= drawn - {"coating"}
    for shape in shapes(gun):
        assert np.isfinite(shape.points).all()
        assert (shape.points.min(axis=0) >= (left, low)).all()
        assert (shape.points.max(axis=0) <= (right, high)).all()


@given(guns)
def test_the_beam_is_drawn_along_the_way_of_the_text(gun: Gun) -> None:
    way = gun.way()
    outline = beam_outline(way)
    inner = [place for place in way if place[0] > 0.0]
    half = len(outline) // 2
    upper, lower = outline[1:half], outline[half:-1][::-1]
    assert (upper[:, 0] == lower[:, 0]).all()
    assert ((upper + lower)[:, 1] / 2).tolist() == pytest.approx([place[2] for place in inner])
    assert ends_on_face(gun, way) == bool(gun.landing(np.array([gun.moment * 1e-3]))[2][0])


def test_lengths_are_those_of_the_tube() -> None:
    gun = replace(Gun(), length=30.0, gap=12.0, reach_y=180.0, reach_x=140.0)
    length, reach = spans(gun)
    assert (length.end - length.start, reach.end - reach.start) == (30.0, 180.0)
    plates = [shape.points for shape in shapes(gun) if shape.part == "plates_y"]
    assert [float(np.abs(points[:, 1]).min()) for points in plates] == [6.0, 6.0]
    assert float(np.ptp(plates[0][:, 0])) == 30.0
    face = max((shape for shape in shapes(gun) if shape.kind == "glass"), key=lambda s: len(s.points))
    assert float(face.points[:, 1].max()) == FACE_MM[1] / 2


def test_the_tangent_leads_from_the_middle_of_the_plates_to_the_spot() -> None:
    gun = Gun()
    (z0, y0), (z1, y1) = tangent(gun, gun.way()).tolist()
    assert (z0, y0) == (PLATES_MM + gun.length / 2, 0.0)
    assert (z1, y1) == pytest.approx((gun.screen, 24.0))
    assert len(tangent(gun, replace(gun, y=Deflection(900.0)).way())) == 0


@given(st.booleans(), st.floats(1.2, 3.0), st.floats(5.0, 7.0))
def test_labels_keep_clear_of_one_another(coils: bool, scale: float, letter_px: float) -> None:
    gun = Gun(coils=coils)
    left, _low, right, _high = window_of(gun)
    placed = place_labels(
        labels(gun),
        gun,
        lambda label: (len(label.short) * letter_px / scale, 16 / scale),
        5 / scale,
        window_of(gun),
    )
    assert len(placed) == len(labels(gun))
    assert not crowded(placed)
    for each in placed:
        assert left <= each.box[0] < each.box[2] <= right
        assert (each.box[1] > 0) == each.label.above
        (z0, y0), tip = each.leader
        assert each.box[0] <= z0 <= each.box[2]
        assert y0 in (each.box[1], each.box[3])
        assert tip == each.label.anchor


@pytest.mark.parametrize("coils", [False, True])
@given(st.floats(1.5, 3.0), st.floats(4.5, 5.5))
def test_no_label_stands_on_the_line_to_what_another_one_names(
    coils: bool, scale: float, letter_px: float
) -> None:
    gun = Gun(coils=coils)
    placed = place_labels(
        labels(gun),
        gun,
        lambda label: (len(label.title) * letter_px / scale, 13 / scale),
        4 / scale,
        window_of(gun),
    )
    for one in placed:
        line = LineString(one.leader)
        for other in placed:
            inside = line.intersection(shapely.box(*other.box).buffer(-1e-6)).length
            assert one is other or inside == 0.0, (one.label.title, other.label.title)


def test_a_label_gives_way_to_the_line_of_another_one_where_it_is_narrow() -> None:
    gun, wide, tall = Gun(), 505.0, 215.0
    left, low, right, high = window_of(gun)
    scale = min(wide / (right - left), tall / (high - low))
    z, y = (left + right) / 2, (low + high) / 2
    half = wide / 2 / scale, tall / 2 / scale
    placed = place_labels(
        labels(gun),
        gun,
        lambda label: ((6 * len(label.title) + 12) / scale, 19 / scale),
        6 / scale,
        (z - half[0], y - half[1], z + half[0], y + half[1]),
    )
    assert len(placed) == len(labels(gun))
    assert not crowded(placed)
    for one in placed:
        for other in placed:
            inside = LineString(one.leader).intersection(shapely.box(*other.box).buffer(-1e-6)).length
            assert one is other or inside == 0.0, (one.label.title, other.label.title)


@pytest.mark.parametrize("coils", [False, True])
def test_the_label_of_the_screen_stands_above_the_bulb_where_there_is_room(coils: bool) -> None:
    gun = Gun(coils=coils)
    placed = place_labels(labels(gun), gun, lambda label: (2.0 * len(label.title), 10.0), 2.0, window_of(gun))
    assert len(placed) == len(labels(gun))
    assert not crowded(placed)
    screen = next(each for each in placed if each.label.part == "screen")
    assert screen.box[1] > FACE_MM[1] / 2
