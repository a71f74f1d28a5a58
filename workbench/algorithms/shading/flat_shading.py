"""Flat shading: one place of each triangle is lit, and all of the triangle has that light.

P, N        the middle of the triangle in the world, and its normal there
here        the light of the triangle, linear
z, stored   depth of the triangle at a pixel, and what the depth buffer had there
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.shading.directions import cross_product, middle_of, minus
from workbench.algorithms.shading.illumination import light_at
from workbench.algorithms.shading.pixel_views import pixel_view
from workbench.algorithms.shading.shaded_scene import PARAMETERS, shaded_scene
from workbench.algorithms.shading.triangle_marks import marks
from workbench.algorithms.visibility.back_faces import dot_product, vector_of
from workbench.algorithms.visibility.surfaces import depth_at, end_row, first_row, span_on, surface_of

Array = NDArray[Any]


def flat_shading(
    light: Array,
    vertices: Array,
    faces: Array,
    places: Array,
    normals: Array,
    materials: Array,
    eye: Array,
    lights: Array,
    by_halfway: bool,
    blockers: Array,
    depth: Array,
) -> Iterator[tuple[int, int, float]]:
    """Shade triangles by one light for each; the nearest one wins.

    Args: light and depth (h, w), floats, written in place; vertices (n, 3) in
    pixels, z; faces (m, 3); places and normals (n, 3), world; materials (m, 4),
    eye (4,), lights (k, 8), by_halfway, blockers as of ``illuminate``.
    Emits: (x, y, light) of each pixel written.
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-5.
    """
    height, width = light.shape
    for face in range(len(faces)):
        # Find the middle of the triangle and its normal
        a, b, c = faces[face, 0], faces[face, 1], faces[face, 2]
        A, B, C = vector_of(places, a), vector_of(places, b), vector_of(places, c)
        P, N = middle_of(A, B, C), cross_product(minus(B, A), minus(C, A))
        if dot_product(N, vector_of(normals, a)) < 0.0:
            N = cross_product(minus(C, A), minus(B, A))

        # Light it there, once
        row = materials[face]
        here = light_at(P, N, row, eye, lights, by_halfway, blockers)
        surface = surface_of(vertices, faces, face)
        if surface.C == 0.0:
            continue

        for y in range(first_row(surface), end_row(surface, height)):
            x_left, x_right = span_on(surface, y, width)
            for x in range(x_left, x_right):
                # Give each pixel that light, where the triangle is nearer
                z = depth_at(surface, x, y)
                stored = float(depth[y, x])
                if z < stored:
                    depth[y, x] = z
                    light[y, x] = here
                    yield x, y, here


def _pixel_view(when: str, written: bool, sentence: str) -> View:
    row = f"(face, x, y, z, stored, here, {int(written)})"
    return pixel_view(
        "Give each pixel that light, where the triangle is nearer", row, when, written, sentence
    )


ENTRY = Entry(
    function=flat_shading,
    topic="shading",
    title="Flat shading",
    summary="Lights each triangle once, at its centre and with its own normal.",
    parameters=PARAMETERS,
    arguments=shaded_scene,
    emits="coverage",
    emitted_columns=("x", "y", "light"),
    source="Hearn and Baker, Computer Graphics, C Version, section 14-5",
    columns=("face", "x", "y", "z", "stored z", "light", "written"),
    views=(
        View(
            block="Find the middle of the triangle and its normal",
            sentence="Triangle {face} is lit in its middle {P}, with the normal {N} of its plane.",
        ),
        View(block="Light it there, once", sentence="All of triangle {face} gets the light {here}."),
        _pixel_view("z < stored", True, "{(x, y)} has the light of its triangle, {here}."),
        _pixel_view(
            "True", False, "{(x, y)}: z = {z} is not less than {stored}, so the triangle is hidden here."
        ),
    ),
    laws=(
        Law(
            "All pixels of a triangle have the light of its middle, by the illumination model.",
            "shading/test_shadings.py::test_flat_is_the_light_of_the_middle",
        ),
        Law(
            "It lights the pixels that the depth buffer draws, and leaves the same depths.",
            "shading/test_shadings.py::test_the_pixels_are_those_of_the_depth_buffer",
        ),
    ),
    not_laws=(
        "With enough faces it looks smooth: the eye still sees the edges between almost equal "
        "shades, the Mach "
        "bands.",
    ),
    labs=("Shading: flat",),
    next_rung="gouraud",
    tie="Strictly nearer wins, so the first drawn stays",
    writes="light",
    marks=marks,
)
