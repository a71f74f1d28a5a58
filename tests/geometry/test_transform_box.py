"""What drags on the box around something do: each against what it must leave and what it must take along."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from workbench.geometry.transform_box import LEAST_FACTOR, MOVE, SIDES, TURN, Box, Keys, motion, turned_about

places = st.tuples(st.floats(-500, 500), st.floats(-500, 500))
sizes = st.floats(1, 300)
boxes = st.builds(
    lambda centre, w, h, angle: Box(*centre, w, h, angle), places, sizes, sizes, st.floats(-math.pi, math.pi)
)
keys = st.builds(Keys, st.booleans(), st.booleans(), st.booleans())
handles = st.sampled_from([MOVE, TURN, *SIDES])
corners = st.sampled_from(["bottom left", "bottom right", "top right", "top left"])
middles = st.sampled_from(["bottom", "right", "top", "left"])


def applied(matrix, point):
    x, y, w = matrix @ [*point, 1.0]
    assert w == 1
    return x, y


def opposite(box, handle):
    across, up = SIDES[handle]
    return box.place(-across, -up)


def near(point, tolerance=1e-6):
    return pytest.approx(point, abs=tolerance)


@given(boxes, places, handles, places, places, keys)
def test_it_is_always_an_affine_map_that_can_be_undone(box, pivot, handle, start, now, held):
    made = motion(box, pivot, handle, start, now, held)
    assert np.isfinite(made.matrix).all()
    assert made.matrix[2].tolist() == [0, 0, 1]
    determinant = np.linalg.det(made.matrix)
    assert abs(determinant) >= 0.99 * LEAST_FACTOR**2
    expected = {"move": 1.0, "rotate": 1.0, "shear": 1.0}.get(made.kind)
    if expected is None:
        expected = made.numbers["sx"] * made.numbers["sy"]
    assert determinant == pytest.approx(expected, rel=1e-6)


@given(boxes, places, handles, places, keys)
def test_a_drag_that_goes_nowhere_changes_nothing(box, pivot, handle, start, held):
    np.testing.assert_allclose(motion(box, pivot, handle, start, start, held).matrix, np.eye(3), atol=1e-9)


@given(boxes, places, st.sampled_from(list(SIDES)), places, places, keys)
def test_the_opposite_side_stays_or_with_the_key_the_pivot(box, pivot, handle, start, now, held):
    made = motion(box, pivot, handle, start, now, held)
    fixed = pivot if held.about_pivot else opposite(box, handle)
    size = max(1.0, float(np.abs(made.matrix).max()))
    assert applied(made.matrix, fixed) == near(fixed, 1e-9 * size + 1e-7)


@given(boxes, places, corners, places)
def test_a_corner_follows_the_pointer_wherever_it_was_taken(box, pivot, handle, way):
    grip = box.place(*SIDES[handle])
    start = grip[0] + 2.0, grip[1] - 1.0
    now = start[0] + way[0], start[1] + way[1]
    made = motion(box, pivot, handle, start, now)
    assume(min(abs(made.numbers["sx"]), abs(made.numbers["sy"])) > LEAST_FACTOR)
    assert applied(made.matrix, grip) == near((grip[0] + way[0], grip[1] + way[1]))


@given(boxes, places, middles, places, places)
def test_a_side_scales_across_itself_alone(box, pivot, handle, start, now):
    made = motion(box, pivot, handle, start, now)
    across, _up = SIDES[handle]
    assert made.kind == "scale"
    assert made.numbers["sy" if across else "sx"] == 1
    # What runs along the side keeps its length and its direction
    along = np.subtract(box.place(1, 1), box.place(-1, 1) if not across else box.place(1, -1))
    np.testing.assert_allclose(made.matrix[:2, :2] @ along, along, atol=1e-7)


@given(boxes, places, st.sampled_from(list(SIDES)), places, places, st.booleans())
def test_constrained_sides_and_corners_keep_the_ratio(box, pivot, handle, start, now, about_pivot):
    numbers = motion(box, pivot, handle, start, now, Keys(constrained=True, about_pivot=about_pivot)).numbers
    assert numbers["sx"] == numbers["sy"]


@given(boxes, corners, st.floats(-3, -0.1))
def test_dragging_through_the_opposite_corner_mirrors(box, handle, factor):
    grip, fixed = box.place(*SIDES[handle]), opposite(box, handle)
    now = tuple(f + factor * (g - f) for g, f in zip(grip, fixed, strict=True))
    numbers = motion(box, box.centre, handle, grip, now).numbers
    assert numbers["sx"] == pytest.approx(factor, rel=1e-6)
    assert numbers["sy"] == pytest.approx(factor, rel=1e-6)


@given(boxes, places, st.floats(-3.1, 3.1), st.floats(1, 100), st.floats(1, 100), st.floats(-3.1, 3.1))
def test_turning_is_by_the_angle_at_the_pivot_alone(box, pivot, angle, near_by, far, begin):
    start = pivot[0] + near_by * math.cos(begin), pivot[1] + near_by * math.sin(begin)
    now = pivot[0] + far * math.cos(begin + angle), pivot[1] + far * math.sin(begin + angle)
    made = motion(box, pivot, TURN, start, now)
    assert made.kind == "rotate"
    assert math.remainder(made.numbers["angle"] - angle, math.tau) == pytest.approx(0, abs=1e-6)
    assert applied(made.matrix, pivot) == near(pivot)
    np.testing.assert_allclose(made.matrix[:2, :2] @ made.matrix[:2, :2].T, np.eye(2), atol=1e-12)


@given(boxes, places, places, places)
def test_a_constrained_turn_is_of_whole_steps_and_at_most_half_a_step_away(box, pivot, start, now):
    free = motion(box, pivot, TURN, start, now).numbers["angle"]
    angle = math.degrees(motion(box, pivot, TURN, start, now, Keys(constrained=True)).numbers["angle"])
    assert angle / 15 == pytest.approx(round(angle / 15), abs=1e-9)
    assert abs(angle - math.degrees(free)) <= 7.5 + 1e-9


@given(boxes, places, places, places)
def test_a_constrained_move_keeps_to_the_longer_axis(box, pivot, start, now):
    dx, dy = now[0] - start[0], now[1] - start[1]
    numbers = motion(box, pivot, MOVE, start, now, Keys(constrained=True)).numbers
    assert (numbers["dx"], numbers["dy"]) == ((dx, 0) if abs(dx) >= abs(dy) else (0, dy))


@given(boxes, middles, st.floats(-100, 100))
def test_a_side_that_shears_slides_along_itself(box, handle, way):
    across, up = SIDES[handle]
    along = np.subtract(box.place(abs(up), abs(across)), box.centre)
    along /= np.hypot(*along)
    grip = np.array(box.place(across, up))
    made = motion(box, box.centre, handle, tuple(grip), tuple(grip + way * along), Keys(shearing=True))
    assert made.kind == "shear"
    np.testing.assert_allclose(applied(made.matrix, grip), grip + way * along, atol=1e-7)
    reach = box.height if up else box.width
    assert abs(made.numbers["factor"]) == pytest.approx(abs(way) / reach, abs=1e-9)
    assert made.numbers["across"] == abs(up)


@given(boxes, corners, places, places)
def test_corners_scale_also_while_sides_shear(box, handle, start, now):
    assert motion(box, box.centre, handle, start, now, Keys(shearing=True)).kind == "scale"


@pytest.mark.parametrize("handle", list(SIDES))
@pytest.mark.parametrize(
    "held", [Keys(), Keys(constrained=True), Keys(shearing=True), Keys(about_pivot=True)]
)
def test_a_box_without_area_is_left_as_it_is_where_it_has_no_size(handle, held):
    made = motion(Box(3, 4, 0, 0), (3, 4), handle, (3, 4), (50, -20), held)
    np.testing.assert_array_equal(made.matrix, np.eye(3))


def test_a_turn_as_it_is_told():
    made = motion(Box(12, 8, 4, 4), (12, 8), TURN, (14, 8), (12, 10))
    assert made.numbers == {"angle": pytest.approx(math.pi / 2), "x": 12, "y": 8}
    np.testing.assert_allclose(made.matrix, [[0, -1, 20], [1, 0, -4], [0, 0, 1]], atol=1e-12)
    np.testing.assert_array_equal(made.matrix, turned_about((12, 8), made.numbers["angle"]).matrix)


@given(boxes, st.floats(-1, 1), st.floats(-1, 1))
def test_a_box_holds_what_lies_between_its_corners(box, across, up):
    assert Box(box.x, box.y, box.width * 1.001, box.height * 1.001, box.angle).holds(box.place(across, up))
    assert not box.holds(box.place(1.01, up))
    assert not box.holds(box.place(across, -1.01))


@given(boxes, st.sampled_from(list(SIDES)), st.booleans())
def test_a_handle_put_on_the_opposite_one_leaves_a_little(box, handle, constrained):
    grip, fixed = box.place(*SIDES[handle]), opposite(box, handle)
    numbers = motion(box, box.centre, handle, grip, fixed, Keys(constrained=constrained)).numbers
    for factor in (numbers["sx"], numbers["sy"]):
        assert abs(factor) == 1 or abs(factor) == pytest.approx(LEAST_FACTOR, rel=1e-6)
    assert min(abs(numbers["sx"]), abs(numbers["sy"])) < 1
