"""Cutting pieces by planes, against areas in fractions."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest

from tests.visibility.exact_scenes import arrays, piercing, scenes
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.pieces import (
    CUT_THROUGH,
    MOST_PIECES,
    Piece,
    add_piece,
    part_of,
    plane_of,
    side_of,
    whole,
)
from workbench.algorithms.visibility.surfaces import in_view, surface_of, surfaces_of


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
                    if side_of(plane, piece.corners) != CUT_THROUGH:
                        continue
                    cut += 1
                    front, behind = part_of(plane, piece, 1), part_of(plane, piece, -1)
                    assert side_of(plane, front.corners) == 1
                    assert side_of(plane, behind.corners) == -1
                    pieces.remove(piece)
                    pieces += [front, behind]
            assert float(sum(area(p.corners) for p in pieces)) == pytest.approx(
                float(area(whole(surfaces, number).corners)), rel=1e-12
            )
    assert cut > 100


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


def test_too_many_pieces_are_refused_in_a_sentence() -> None:
    surfaces = surfaces_of(*arrays(piercing(Random(1)))[:2])
    piece = whole(surfaces, 0)
    pieces: list[Piece] = [piece] * MOST_PIECES
    with pytest.raises(ValueError, match="more than 40,000 pieces"):
        add_piece(pieces, piece)
