"""What a matrix is found to be, against how it was made and against exact ranks."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.projection.inputs import Matrix, angles, distances, image, parallels, perspectives, views
from workbench.algorithms.projection import (
    cabinet,
    cavalier,
    classify,
    dimetric,
    isometric,
    oblique,
    orthographic,
    perspective,
    perspective_depth,
    perspective_from_plane,
    standard_view,
    trimetric,
    view,
)

whole = st.lists(st.lists(st.integers(-2, 2), min_size=4, max_size=4), min_size=4, max_size=4)
POINTS = np.array([[x, y, z, 1.0] for x in (-1, 2) for y in (0, 3) for z in (1, 5)])


def minors(rows: list[list[int]]) -> list[Fraction]:
    """What is perpendicular to three rows of four, by cofactors, exactly."""
    a, b, c = [[Fraction(value) for value in row] for row in rows]
    found = []
    for k in range(4):
        i, j, m = (n for n in range(4) if n != k)
        det = a[i] * (b[j] * c[m] - b[m] * c[j]) - a[j] * (b[i] * c[m] - b[m] * c[i])
        found.append((-1) ** k * (det + a[m] * (b[i] * c[j] - b[j] * c[i])))
    return found


@given(rows=whole)
def test_of_any_matrix_the_centre_is_what_rows_1_2_and_4_send_to_nothing(rows: list[list[int]]) -> None:
    found = classify(rows)
    null = minors([rows[0], rows[1], rows[3]])
    if not any(null):
        assert found.name == "no picture"
        assert found.centre is None
        return
    assert found.centre is not None
    exact = np.array([float(value) for value in null])
    cosine = exact @ found.centre / np.linalg.norm(exact) / np.linalg.norm(found.centre)
    assert abs(cosine) == pytest.approx(1, abs=1e-12)
    assert (found.centre[3] == 0) == (null[3] == 0)
    assert found.keeps_depth == (sum(Fraction(a) * b for a, b in zip(rows[2], null, strict=True)) != 0)
    assert [point is not None for point in found.vanishing] == [value != 0 for value in rows[3][:3]]
    assert "perspective" in found.name or null[3] == 0


@given(seen=views(), projection=perspectives)
def test_the_centre_of_a_perspective_is_found_again(seen: Matrix, projection: Matrix) -> None:
    found = classify(projection @ seen, seen)
    assert found.centre is not None
    centre = seen @ found.centre
    behind = 0.0 if projection[3, 3] == 0 else -1 / projection[3, 2]
    assert centre == pytest.approx([0, 0, behind, 1], abs=1e-9 * (1 + abs(behind)))
    count = int((np.abs(seen[2, :3]) > 1e-9).sum())
    assert found.name == ("one-point", "two-point", "three-point")[count - 1] + " perspective"
    assert not found.mirrored
    assert not found.stretched


@given(seen=views(), phi=angles, alpha=st.floats(0.3, 2.8))
def test_oblique_projections_are_told_by_how_long_receding_lines_are(
    seen: Matrix, phi: float, alpha: float
) -> None:
    assume(min(abs(1 / math.tan(alpha) - x) for x in (-1, -0.5, 0, 0.5, 1)) > 1e-6)
    assert classify(cavalier(phi) @ seen, seen).name == "cavalier"
    assert classify(cabinet(phi) @ seen, seen).name == "cabinet"
    assert classify(oblique(alpha, phi) @ seen, seen).name == "oblique"


@given(seen=views())
def test_orthographic_projections_are_told_by_their_foreshortenings(seen: Matrix) -> None:
    found = classify(orthographic() @ seen, seen)
    assert found.foreshortenings == pytest.approx(np.hypot(*seen[:2, :3]), abs=1e-12)
    sizes = np.abs(seen[2, :3]).round(9).tolist()
    if 1.0 in sizes:
        assert found.name == "orthographic"
    else:
        assert found.name == {1: "isometric", 2: "dimetric", 3: "trimetric"}[len(set(sizes))]


@pytest.mark.parametrize(
    ("matrix", "name"),
    [
        (isometric(), "isometric"),
        (dimetric(0.5), "dimetric"),
        (trimetric(0.9, 0.8), "trimetric"),
        (standard_view("top"), "orthographic"),
        (np.zeros((4, 4)), "no picture"),
        (np.diag([1.0, 0, 1, 1]), "no picture"),
    ],
)
def test_named_projections(matrix: Matrix, name: str) -> None:
    assert classify(matrix, matrix if np.linalg.det(matrix) else None).name == name


@given(seen=views(), projection=st.one_of(parallels, perspectives), factor=st.sampled_from([-3.0, 0.01, 7.0]))
def test_mirrored_or_multiplied_matrices(seen: Matrix, projection: Matrix, factor: float) -> None:
    plain = classify(projection @ seen, seen)
    assert not plain.mirrored
    assert classify(np.diag([-1.0, 1, 1, 1]) @ projection @ seen, seen).mirrored
    assert classify(projection @ np.diag([1, -1.0, 1, 1]) @ seen, seen).mirrored
    assert classify(np.diag([2.0, 1, 1, 1]) @ projection @ seen, seen).stretched
    multiple = classify(factor * (projection @ seen), seen)
    assert (multiple.name, multiple.mirrored, multiple.keeps_depth) == (
        plain.name,
        plain.mirrored,
        plain.keeps_depth,
    )


@given(d=distances, eye=st.tuples(*[st.integers(1, 9)] * 3))
def test_row_3_keeps_depth_or_flattens_it(d: float, eye: tuple[int, int, int]) -> None:
    seen = view(eye, (0, 0, 0))
    assert not classify(perspective(d) @ seen).keeps_depth
    assert classify(perspective_from_plane(d) @ seen).keeps_depth
    assert classify(perspective_depth(d, 1, 20) @ seen).keeps_depth
    flat = image(perspective(d), (1, 2, 3))[2], image(perspective(d), (1, 2, 30))[2]
    assert flat == pytest.approx((d, d))


def test_the_words() -> None:
    seen = view((5, 0, 5), (0, 0, 0))
    assert classify(perspective(5) @ seen, seen).words == (
        "Perspective projection: all projectors meet at (5, 0, 5), the centre of projection. "
        "It has two principal vanishing points, of x, z, at (−5, 0), (5, 0). "
        "Row 3 flattens depth, so hidden surfaces cannot be found."
    )
    assert classify(cabinet(0.5)).name == "parallel"
    front = standard_view("front")
    assert "half as long" in classify(cabinet(0.5) @ front, front).words
    assert classify(np.zeros((4, 4))).words.startswith("No picture")
    with pytest.raises(ValueError, match="cannot be undone"):
        classify(np.eye(4), np.diag([1.0, 1, 0, 1]))
