"""Back faces: those that turn away from the eye.

N           outward normal of the face in the world: its corners go round counter-clockwise, seen from outside
P           a corner of it
facing      N . (eye - P): positive where the eye is on the outer side of the face's plane
C           N along the line of sight: all that a parallel projection needs, and wrong in perspective
seen        1 where facing is positive, else 0
"""

from collections.abc import Iterator
from random import Random
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View

Array = NDArray[Any]


class SpaceVector(NamedTuple):
    """A point or a direction of the world."""

    x: float
    y: float
    z: float


def vector_of(rows: Array, number: int) -> SpaceVector:
    """A row of an array (n, 3)."""
    return SpaceVector(float(rows[number, 0]), float(rows[number, 1]), float(rows[number, 2]))


def dot_product(a: SpaceVector, b: SpaceVector) -> float:
    """a . b."""
    return a.x * b.x + a.y * b.y + a.z * b.z


def outward_normal(vertices: Array, faces: Array, face: int) -> SpaceVector:
    """The normal of a polygon by Newell's sums, as long as twice its area: every corner counts.

    Source: Newell, as told by Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface
    Algorithms, 1974.
    """
    x, y, z = 0.0, 0.0, 0.0
    p = vector_of(vertices, faces[face, faces.shape[1] - 1])
    for k in range(faces.shape[1]):
        q = vector_of(vertices, faces[face, k])
        x += (p.y - q.y) * (p.z + q.z)
        y += (p.z - q.z) * (p.x + q.x)
        z += (p.x - q.x) * (p.y + q.y)
        p = q
    return SpaceVector(x, y, z)


def back_faces(vertices: Array, faces: Array, eye: Array, look_at: Array) -> Iterator[tuple[int, float, int]]:
    """Tell which faces of a solid are turned towards the eye.

    Args: (n, 3) vertices of the world; (m, k) faces: numbers of vertices,
    counter-clockwise seen from outside; the eye (3,) and the point it
    looks at (3,). Emits: (face, N . (eye - P), seen).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-2.
    """
    # Find the line of sight
    to_x, to_y, to_z = float(look_at[0] - eye[0]), float(look_at[1] - eye[1]), float(look_at[2] - eye[2])

    for face in range(len(faces)):
        # Find the outward normal, and look from the face to the eye
        N = outward_normal(vertices, faces, face)
        P = vector_of(vertices, faces[face, 0])
        to_eye = SpaceVector(float(eye[0]) - P.x, float(eye[1]) - P.y, float(eye[2]) - P.z)

        # Test whether the face is turned towards the eye
        C = dot_product(N, SpaceVector(to_x, to_y, to_z))
        facing = dot_product(N, to_eye)
        seen = 0
        if facing > 0.0:
            seen = 1
        yield face, facing, seen


_CUBE = np.array([[0.0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [0, 0, 4], [4, 0, 4], [4, 4, 4], [0, 4, 4]])
_SIDES = np.array([[4, 5, 6, 7], [1, 0, 3, 2], [5, 1, 2, 6], [0, 4, 7, 3], [7, 6, 2, 3], [0, 1, 5, 4]])


def _solid_and_eye(chance: Random) -> tuple[Any, ...]:
    """A box, seen from outside, at times level with a face; or triangles at will."""
    eye = np.array([float(chance.choice((-3, 0, 2, 4, 9))) for _axis in range(3)])
    look_at = np.array([float(chance.randint(-2, 6)) for _axis in range(3)])
    if chance.random() < 0.5:
        return _CUBE.copy(), _SIDES.copy(), eye, look_at
    vertices = np.array([[float(chance.randint(-4, 4)) for _axis in range(3)] for _corner in range(6)])
    return vertices, np.array([[0, 1, 2], [3, 4, 5]]), eye, look_at


_TEST = "Test whether the face is turned towards the eye"
_FACING = "N · (eye − P) = {facing}"


def _test_view(when: str, answer: str, sentence: str) -> View:
    """The view of a face: whether it is seen, and what C alone would have said."""
    return View(
        block=_TEST,
        when=when,
        row="(face, tuple(N), tuple(to_eye), facing, C, 'yes' if seen else 'no')",
        options="('seen', 'a back face')",
        answer=repr(answer),
        sentence=f"Face {{face}}: {_FACING} {sentence}",
    )


ENTRY = Entry(
    function=back_faces,
    topic="visibility",
    title="Back faces",
    summary="A face is turned towards the eye where its outward normal is: N · (eye − P) > 0.",
    parameters=(
        Parameter("vertices", "vertices", "points", _CUBE, meaning="corners of the solid, in the world"),
        Parameter(
            "faces", "faces", "ints", _SIDES, meaning="corners of each face, counter-clockwise from outside"
        ),
        Parameter("eye", "eye", "floats", np.array([6.0, 5.0, 14.0]), meaning="where it is seen from"),
        Parameter("look_at", "look-at", "floats", np.array([8.0, 5.0, 2.0]), meaning="what is looked at"),
    ),
    arguments=_solid_and_eye,
    emits="points",
    emitted_columns=("face", "N · (eye − P)", "seen"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-2",
    columns=("face", "N", "eye − P", "N · (eye − P)", "C", "seen"),
    view_functions=(),
    views=(
        _test_view(
            "seen == 1 and C >= 0.0",
            "seen",
            "> 0: it is seen. C = {C} is not negative, so by C alone it would be taken for a back face: "
            "in perspective the direction to the eye differs from face to face.",
        ),
        _test_view("seen == 1", "seen", "> 0: it is turned towards the eye."),
        _test_view(
            "C < 0.0",
            "a back face",
            "is not positive: a back face. C = {C} is negative, so by C alone it would be taken for seen: "
            "in perspective the direction to the eye differs from face to face.",
        ),
        _test_view("True", "a back face", "is not positive: it is a back face."),
    ),
    laws=(
        Law(
            "A face of a convex solid is seen exactly where the eye is outside of its plane.",
            "visibility/test_back_faces.py::test_a_face_is_seen_where_the_eye_is_outside_its_plane",
        ),
        Law(
            "On the screen a visible face runs counter-clockwise, any other clockwise.",
            "visibility/test_back_faces.py::test_a_seen_face_goes_round_counter_clockwise_on_the_screen",
        ),
    ),
    not_laws=(
        "The sign of C decides in perspective too: it does so only where all projectors are parallel.",
        "Without its back faces a solid is drawn correctly: only a convex one, alone in the picture.",
    ),
    works_in="object space",
    fails_where="a face turned to the eye hides another such face, since nothing compares the two",
    questions=(7,),
    labs=("Hidden surfaces: back faces",),
    frame="world",
)
