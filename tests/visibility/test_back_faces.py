"""Back faces against half-spaces and against the picture."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.projection import perspective, view
from workbench.algorithms.visibility.back_faces import back_faces
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

whole = st.integers(-9, 9)
places = st.tuples(whole, whole, whole)
CUBE, SIDES, *_EYE = catalogue.get("back_faces").example


def seen_of(vertices: np.ndarray, faces: np.ndarray, eye: tuple[int, ...]) -> list[int]:
    look_at = np.zeros(3)
    return [seen for _face, _facing, seen in back_faces(vertices, faces, np.array(eye, float), look_at)]


@given(eye=places, move=places, scale=st.integers(1, 5))
def test_a_face_is_seen_where_the_eye_is_outside_its_plane(
    eye: tuple[int, ...], move: tuple[int, ...], scale: int
) -> None:
    """Of a box: where the eye is beyond the side, not level with it and not before it."""
    low, high = np.array(move), np.array(move) + 4 * scale
    beyond = [
        eye[2] > high[2],
        eye[2] < low[2],
        eye[0] > high[0],
        eye[0] < low[0],
        eye[1] > high[1],
        eye[1] < low[1],
    ]
    assert seen_of(CUBE * scale + move, SIDES, eye) == beyond


@given(eye=places, triangle=st.tuples(places, places, places))
def test_a_seen_face_goes_round_counter_clockwise_on_the_screen(
    eye: tuple[int, ...], triangle: tuple[tuple[int, ...], ...]
) -> None:
    corners = np.array(triangle, float)
    look_at = corners.mean(axis=0)
    sight = look_at - eye
    assume(np.linalg.norm(np.cross(sight, (0, 1, 0))) > 0)
    rows = np.hstack([corners, np.ones((3, 1))]) @ (perspective(1) @ view(eye, look_at)).T
    assume((rows[:, 3] > 0.01).all())
    (ax, ay), (bx, by), (cx, cy) = rows[:, :2] / rows[:, 3:]
    turn = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    assume(abs(turn) > 1e-9)
    assert seen_of(corners, np.array([[0, 1, 2]]), eye) == [turn > 0]


def test_c_alone_errs_in_perspective() -> None:
    """N = (-0.9, 0, 0.3) at (4, 0, 4), the eye at 0 looking along z: N . P = -2.4, seen although C > 0."""
    corners = np.array([[4.0, 0, 4], [4.1, 0, 4.3], [4, 1, 4]])
    ((_face, facing, seen),) = back_faces(corners, np.array([[0, 1, 2]]), np.zeros(3), np.array([0.0, 0, 1]))
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assert normal * 3 == pytest.approx([-0.9, 0, 0.3])
    assert facing * 3 == pytest.approx(2.4)
    assert seen == 1
    entry = catalogue.get("back_faces")
    told = [
        "".join(part.text for part in step.sentence)
        for step in Steps(entry, record(entry.function, *entry.example))
    ]
    assert sum("by C alone" in sentence for sentence in told) == 3
