"""A point on its way from an object to the screen: model, view, projection, division by w, viewport.

x, y, z         the point in the world, after the model's own transformation
x_v, y_v, z_v   in view coordinates: x right, y up, z into the picture
x_h, y_h, z_h, w    after the projection's matrix, before the division
x_p, y_p, z_p   after the division: on the view plane
x_d, y_d        on the device, in pixels
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.marks import Mark
from workbench.algorithms.projection.axonometric import isometric
from workbench.algorithms.projection.parallel import cabinet, cavalier, orthographic
from workbench.algorithms.projection.perspective import perspective, perspective_depth, perspective_from_plane
from workbench.algorithms.projection.projected_point_views import VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.projection.view import standard_view
from workbench.algorithms.projection.view import view as view_from
from workbench.algorithms.transforms.products import matrix_mark

Array = NDArray[Any]
Column = tuple[float, float, float, float]


def times(matrix: Array, x: float, y: float, z: float) -> Column:
    """The 4 x 4 matrix times the column x, y, z, 1."""
    x_h = matrix[0, 0] * x + matrix[0, 1] * y + matrix[0, 2] * z + matrix[0, 3]
    y_h = matrix[1, 0] * x + matrix[1, 1] * y + matrix[1, 2] * z + matrix[1, 3]
    z_h = matrix[2, 0] * x + matrix[2, 1] * y + matrix[2, 2] * z + matrix[2, 3]
    w = matrix[3, 0] * x + matrix[3, 1] * y + matrix[3, 2] * z + matrix[3, 3]
    return float(x_h), float(y_h), float(z_h), float(w)


def refuse_shapes(model: Array, view: Array, projection: Array, viewport: Array, point: Array) -> None:
    """Raise ValueError unless these are three (4, 4) matrices, a (3, 3) one, and a point (3,)."""
    for matrix in (model, view, projection):
        if matrix.shape[0] != 4 or matrix.shape[1] != 4:
            raise ValueError("Model, view and projection are matrices of 4 rows and 4 columns.")
    if viewport.shape[0] != 3 or viewport.shape[1] != 3:
        raise ValueError("The viewport is a matrix of 3 rows and 3 columns.")
    if len(point) != 3:
        raise ValueError("A point in space has x, y and z.")


def project_point(
    model: Array, view: Array, projection: Array, viewport: Array, point: Array
) -> Iterator[tuple[float, float, float, float]]:
    """Take a point of an object to the device, one matrix after another.

    Args: (4, 4) model and view, whose last row is 0 0 0 1, and projection;
    (3, 3) viewport, likewise 0 0 1; the point (3,). Emits: (x, y, z, w) in
    the world, in view coordinates, after the projection, after the
    division and on the device; the last two only where w > 0.
    Source: Hearn and Baker, Computer Graphics, C Version, chapter 12.
    """
    # Place the point in the world
    refuse_shapes(model, view, projection, viewport, point)
    x, y, z, one = times(model, float(point[0]), float(point[1]), float(point[2]))
    yield x, y, z, one

    # Turn to view coordinates
    x_v, y_v, z_v, one = times(view, x, y, z)
    yield x_v, y_v, z_v, one

    # Multiply by the projection
    x_h, y_h, z_h, w = times(projection, x_v, y_v, z_v)
    yield x_h, y_h, z_h, w
    if w <= 0.0:
        return

    # Divide by w
    x_p, y_p, z_p = x_h / w, y_h / w, z_h / w
    yield x_p, y_p, z_p, 1.0

    # Map to the viewport
    x_d = float(viewport[0, 0]) * x_p + float(viewport[0, 1]) * y_p + float(viewport[0, 2])
    y_d = float(viewport[1, 0]) * x_p + float(viewport[1, 1]) * y_p + float(viewport[1, 2])
    yield x_d, y_d, z_p, 1.0


_VIEWPORT = np.array([[10.0, 0, 20], [0, 10, 15], [0, 0, 1]])


def _matrices_and_point(chance: Random) -> tuple[Any, ...]:
    """Every kind of projection; some points lie behind the eye or level with it."""
    eye = [chance.choice((-1, 1)) * chance.uniform(1, 9), chance.uniform(-5, 5), chance.uniform(1, 9)]
    view = view_from(eye, (0, 0, 0))
    d = chance.choice((1.0, 2.0, chance.uniform(0.5, 9)))
    phi = math.radians(chance.choice((30, 45)))
    projection = chance.choice(
        (
            orthographic(),
            cavalier(phi),
            cabinet(phi),
            perspective(d),
            perspective_from_plane(d),
            perspective_depth(d, 1.0, 20.0),
        )
    )
    if chance.random() < 0.2:
        view = isometric()
        projection = orthographic()
    model = np.eye(4)
    model[:3, 3] = [chance.randint(-3, 3) for _axis in range(3)]
    if chance.random() < 0.2:
        view, model = np.eye(4), np.eye(4)
    return model, view, projection, _VIEWPORT, np.array([float(chance.randint(-4, 9)) for _axis in range(3)])


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The matrix of the projection."""
    yield matrix_mark("P", arguments[2])


ENTRY = Entry(
    function=project_point,
    topic="projection",
    title="Projecting a point",
    summary="Model, view and projection are matrices; dividing by w puts the point on the view plane.",
    parameters=(
        Parameter("model", "M", "matrix", np.eye(4), meaning="of the object, 4 × 4"),
        Parameter("view", "V", "matrix", standard_view("front"), meaning="to view coordinates, 4 × 4"),
        Parameter("projection", "P", "matrix", perspective(2.0), meaning="4 × 4"),
        Parameter("viewport", "W", "matrix", _VIEWPORT, meaning="from the view plane to pixels, 3 × 3"),
        Parameter("point", "point", "floats", np.array([3.0, 4.0, -8.0]), meaning="x, y and z"),
    ),
    arguments=_matrices_and_point,
    emits="points",
    emitted_columns=("x", "y", "z", "w"),
    source="Hearn and Baker, Computer Graphics, C Version, chapter 12",
    columns=("stage", "x", "y", "z", "w"),
    view_functions=VIEW_FUNCTIONS,
    views=VIEWS,
    laws=(
        Law(
            "The point on the view plane is the product of all three matrices with the point, over its w.",
            "projection/test_projecting.py::test_a_point_is_projected_by_the_product_of_the_matrices",
        ),
        Law(
            "Centre, point and projected point lie on one line.",
            "projection/test_projecting.py::test_centre_point_and_image_lie_on_one_line",
        ),
        Law(
            "In a parallel projection equal parallel lengths stay equal, at any depth.",
            "projection/test_projecting.py::test_a_parallel_projection_keeps_parallels_and_their_ratios",
        ),
        Law(
            "In perspective lines along an axis run together at its vanishing point, "
            "unless they are parallel to the view plane.",
            "projection/test_projecting.py::test_parallel_lines_run_together_at_the_vanishing_point",
        ),
    ),
    not_laws=(
        "As d grows without bound, w = z/d becomes the parallel projection: it tends to 0, and the limit "
        "divides by zero. With the view plane at z = 0 instead, w = 1 + z/d tends to 1, and the limit is "
        "the parallel projection.",
        "A parallel projection keeps true lengths and angles: only of what is parallel to the view plane.",
        "A parallel projection knows no foreshortening: it shortens what is at an angle to the view plane; "
        "it is only depth that changes nothing.",
        "In perspective all parallel lines converge: those parallel to the view plane do not.",
    ),
    questions=(1, 5),
    labs=("Projections",),
    marks=marks,
    frame="view",
)
