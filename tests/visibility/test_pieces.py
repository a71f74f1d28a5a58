"""Cutting pieces by planes, against areas in fractions."""

from collections.abc import Callable
from fractions import Fraction
from random import Random

import numpy as np
import pytest

from tests.visibility.exact_scenes import HEIGHT, KINDS, WIDTH, Scene, arrays, corner, piercing, scenes
from workbench.algorithms.visibility.depth_tests import edge_plane
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.piece_painting import bounding, on_its_side, paint_piece
from workbench.algorithms.visibility.pieces import (
    CUT_THROUGH,
    MOST_PIECES,
    Piece,
    add_piece,
    part_of,
    plane_of,
    side_of,
    side_of_box,
    side_of_corners,
    whole,
)
from workbench.algorithms.visibility.surfaces import Surface, covers, in_view, surface_of, surfaces_of


def area(corners: list[Corner]) -> Fraction:
    """As the eye sees it."""
    exact = [(Fraction(x), Fraction(y)) for x, y, _z in corners]
    total = sum((x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(exact, exact[1:] + exact[:1], strict=True)))
    return abs(Fraction(total)) / 2


def test_the_areas_of_the_parts_add_up_and_each_is_on_its_side() -> None:
    cut = 0
    for scene in scenes(piercing, 60):
        surfaces = surfaces_of(*arrays(scene)[:2])
        for number in in_view(surfaces):
            pieces = [whole(surfaces, number)]
            for other in in_view(surfaces):
                plane = plane_of(surfaces, other)
                for piece in list(pieces):
                    if side_of(plane, piece) != CUT_THROUGH:
                        continue
                    cut += 1
                    front, behind = part_of(plane, piece, 1), part_of(plane, piece, -1)
                    assert side_of(plane, front) == 1
                    assert side_of(plane, behind) == -1
                    pieces.remove(piece)
                    pieces += [front, behind]
            assert float(sum(area(p.corners) for p in pieces)) == pytest.approx(
                float(area(whole(surfaces, number).corners)), rel=1e-12
            )
    assert cut > 100


def pieces_of(scene: Scene) -> tuple[list[Surface], list[Piece]]:
    """All surfaces, each cut by the planes of all others."""
    surfaces = surfaces_of(*arrays(scene)[:2])
    pieces = [whole(surfaces, number) for number in in_view(surfaces)]
    for other in in_view(surfaces):
        plane = plane_of(surfaces, other)
        for piece in list(pieces):
            if side_of(plane, piece) == CUT_THROUGH:
                pieces.remove(piece)
                pieces += [part_of(plane, piece, 1), part_of(plane, piece, -1)]
    return surfaces, pieces


def test_the_box_of_a_piece_tells_no_other_side_than_its_corners() -> None:
    sides = set()
    for scene in scenes(piercing, 20):
        surfaces, pieces = pieces_of(scene)
        for other in in_view(surfaces):
            plane = plane_of(surfaces, other)
            for piece in pieces:
                side = side_of_corners(plane, piece.corners)
                assert side_of(plane, piece) == side
                sides.add(side)
    assert sides >= {-1, 0, 1}


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_a_piece_is_painted_where_each_pixel_by_itself_is_found_in_it(
    kind: Callable[[Random], Scene],
) -> None:
    """Ends of rows that are reckoned at once lose and add nothing."""
    for scene in scenes(kind, 25):
        surfaces, pieces = pieces_of(scene)
        for piece in pieces:
            image = np.zeros((HEIGHT, WIDTH), np.int64)
            colours = np.ones(len(surfaces), np.int64)
            for _span in paint_piece(image, surfaces, piece, colours):
                pass
            single = [
                [
                    covers(surfaces[piece.number], x, y) and on_its_side(surfaces, piece, x, y)
                    for x in range(WIDTH)
                ]
                for y in range(HEIGHT)
            ]
            assert np.array_equal(image == 1, single)


def test_a_box_is_only_said_to_be_beside_a_plane_where_all_corners_are() -> None:
    told = 0
    for scene in (scene for kind in KINDS for scene in scenes(kind, 15)):
        surfaces, pieces = pieces_of(scene)
        for number in in_view(surfaces):
            plane = plane_of(surfaces, number)
            for piece in pieces:
                side = side_of_box(plane, piece.box)
                if side != CUT_THROUGH:
                    told += 1
                    exact = [Fraction(v) for v in plane[:4]]
                    for place in piece.corners:
                        value = sum(a * Fraction(v) for a, v in zip(exact, (*place, 1.0), strict=True))
                        assert value * side > 0
    assert told > 50


def test_of_many_cuts_only_the_sides_of_the_piece_are_looked_at() -> None:
    """From left to right each plane cuts off a strip: what is left has only the last one for a side."""
    corners = [(-100, -100, 0), (100, -100, 0), (0, 100, 0)]
    walls = [[(x, -9, -1), (x, 9, -1), (x + Fraction(1, 64), 0, 2)] for x in range(-8, 9)]
    surfaces, pieces = pieces_of([tuple(corner(*place) for place in t) for t in (corners, *walls)])  # type: ignore[misc]
    strips = [piece for piece in pieces if piece.number == 0]
    assert len(strips) == 18
    assert max(len(strip.cuts) for strip in strips) == 17
    assert sorted(len(bounding(surfaces, strip)) for strip in strips) == [1, 1, *16 * [2]]


def test_the_plane_of_a_surface_faces_the_side_from_which_it_goes_round_counter_clockwise() -> None:
    """C < 0: that side is the eye's. What the corners' order is does not matter to z."""
    corners = np.array([[0.0, 0, 0.5], [4, 1, 0.25], [1, 3, 0.75]])
    seen, turned = (surface_of(corners, np.array([order]), 0) for order in ((0, 1, 2), (2, 1, 0)))
    assert seen.C < 0 < turned.C
    assert seen[3:7] == tuple(-value for value in turned[3:7])
    assert seen[7:] == turned[7:]
    A, B, C, D = seen[3:7]
    for x, y, z in corners.tolist():
        assert A * x + B * y + C * z + D == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize(
    ("start", "end", "is_right"),
    [
        ((4, 0), (4, 8), lambda x, _y: x >= 4),
        ((0, 3), (8, 3), lambda _x, y: y >= 3),
        ((0, 6), (6, 0), lambda x, y: x + y >= 6),
        ((0, 0), (6, 6), lambda x, y: x >= y),
    ],
)
def test_a_centre_on_a_cut_is_where_half_open_has_it(
    start: tuple[int, int], end: tuple[int, int], is_right: Callable[[int, int], bool]
) -> None:
    """In the part to the right of the cut, or above it where it is level; whichever way the edge goes."""
    surfaces = surfaces_of(np.array([[0.0, 0, 0], [9, 0, 0], [0, 9, 0]]), np.array([[0, 1, 2]]))
    for first, second in ((start, end), (end, start)):
        plane = edge_plane(Corner(*map(float, first), 0.0), Corner(*map(float, second), 0.0))
        parts = [part_of(plane, whole(surfaces, 0), side) for side in (1, -1)]
        for x, y in ((x, y) for x in range(9) for y in range(9) if covers(surfaces[0], x, y)):
            (here,) = [part for part in parts if on_its_side(surfaces, part, x, y)]
            middle = np.mean([corner[:2] for corner in here.corners], axis=0)
            assert is_right(x, y) == is_right(*middle)


def test_too_many_pieces_are_refused_in_a_sentence() -> None:
    surfaces = surfaces_of(*arrays(piercing(Random(1)))[:2])
    piece = whole(surfaces, 0)
    pieces: list[Piece] = [piece] * MOST_PIECES
    with pytest.raises(ValueError, match="more than 40,000 pieces"):
        add_piece(pieces, piece)
