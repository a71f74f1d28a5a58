"""Phong shading: normals are spread along the edges, then along each row, and every pixel is lit by its own.

low, middle, high   corners of the triangle by their rows, each with its place and normal
start, end  where the scan line enters and leaves the triangle, place and normal there
at          the pixel: its place in the world, and the normal there
here        the light of the pixel, linear
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.shading.directions import length
from workbench.algorithms.shading.illumination import light_at
from workbench.algorithms.shading.normal_corners import (
    NormalPlace,
    normal_corners_of,
    normal_on_row,
    normal_row_ends,
)
from workbench.algorithms.shading.pixel_views import pixel_view
from workbench.algorithms.shading.shaded_scene import MISSED, PARAMETERS, shaded_scene
from workbench.algorithms.shading.triangle_marks import marks
from workbench.algorithms.visibility.back_faces import SpaceVector
from workbench.algorithms.visibility.surfaces import depth_at, end_row, first_row, surface_of

Array = NDArray[Any]


def phong(
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
    """Shade triangles by the normal of each pixel; the nearest one wins.

    Args: light and depth (h, w), floats, written in place; vertices (n, 3) in
    pixels, z; faces (m, 3); places and normals (n, 3), world; materials (m, 4),
    eye (4,), lights (k, 8), by_halfway, blockers as of ``illuminate``.
    Emits: (x, y, light) of each pixel written.
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-5.
    """
    height, width = light.shape
    for face in range(len(faces)):
        # Take the corners with their normals
        low, middle, high = normal_corners_of(vertices, faces, places, normals, face)
        surface = surface_of(vertices, faces, face)
        row = materials[face]
        if surface.C == 0.0:
            continue

        for y in range(first_row(surface), end_row(surface, height)):
            # Spread place and normal along both edges
            start, end = normal_row_ends(low, middle, high, y)

            for x in range(max(math.ceil(start.x), 0), min(math.ceil(end.x), width)):
                # Spread them along the scan line, and light the pixel if nearer
                at = normal_on_row(start, end, x)
                z = depth_at(surface, x, y)
                stored = float(depth[y, x])
                if z < stored:
                    here = light_at(at.place, at.normal, row, eye, lights, by_halfway, blockers)
                    depth[y, x] = z
                    light[y, x] = here
                    yield x, y, here


def normal_rows(start: NormalPlace, end: NormalPlace) -> tuple[tuple[object, ...], ...]:
    """Both ends of the scan line."""
    return tuple(
        (edge, at.x, tuple(at.place), tuple(at.normal)) for edge, at in (("enters", start), ("leaves", end))
    )


def if_not_unit(normal: SpaceVector) -> str:
    """What is said of a normal whose length, as it is shown, is not 1."""
    return "," if abs(length(normal) - 1.0) < _SHOWN else ", not yet of length 1,"


_SPREAD = "Spread them along the scan line, and light the pixel if nearer"
_HIDDEN = "'hidden'"
_SHOWN = 5e-5
_TABLES = {"Ends of the scan line": ("normal_rows(start, end)", ("edge", "x", "place", "normal"))}


def _pixel_view(when: str, written: bool, sentence: str) -> View:
    row = f"(x, y, tuple(at.place), tuple(at.normal), {'here' if written else _HIDDEN})"
    return pixel_view(_SPREAD, row, when, written, sentence, _TABLES)


ENTRY = Entry(
    function=phong,
    topic="shading",
    title="Phong shading",
    summary="Spreads the normals of the corners over the triangle, and lights each pixel by its own normal.",
    parameters=PARAMETERS,
    arguments=shaded_scene,
    emits="coverage",
    emitted_columns=("x", "y", "light"),
    source="Phong, Illumination for Computer Generated Pictures, 1975; Hearn and Baker, Computer Graphics, C "
    "Version, section 14-5",
    columns=("x", "y", "place", "normal", "light"),
    view_functions=(normal_rows, if_not_unit),
    views=(
        View(
            block="Take the corners with their normals",
            sentence="Triangle {face} has the normals {low.normal}, {middle.normal} and {high.normal} at its "
            "corners, from the lowest up.",
        ),
        View(
            block="Spread place and normal along both edges",
            tables=_TABLES,
            sentence="Row {y} enters at x = {start.x} with the normal {start.normal} and leaves at {end.x} "
            "with {end.normal}.",
        ),
        _pixel_view(
            "z < stored",
            True,
            "{(x, y)}: with the normal {at.normal}{if_not_unit(at.normal)} the light is {here}.",
        ),
        _pixel_view(
            "True", False, "{(x, y)}: z = {z} is not less than {stored}, so the triangle is hidden here."
        ),
    ),
    laws=(
        Law(
            "Each pixel has the light of the illumination model, with place and normal linear on the screen.",
            "shading/test_shadings.py::test_phong_is_the_model_at_each_pixel",
        ),
        Law(
            "Where all normals of a triangle are that of its plane and lights and eye are far, it is flat "
            "shading.",
            "shading/test_shadings.py::test_far_lights_on_a_plane_make_phong_flat",
        ),
        Law(
            "It lights the pixels that the depth buffer draws, and leaves the same depths.",
            "shading/test_shadings.py::test_the_pixels_are_those_of_the_depth_buffer",
        ),
    ),
    not_laws=(MISSED,),
    labs=("Shading: Phong",),
    next_rung="fast_phong",
    tie="Strictly nearer wins, so the first drawn stays",
    writes="light",
    marks=marks,
)
