"""Gouraud shading: the light of the corners is spread along the edges, then along each scan line.

low, middle, high   corners of the triangle by their rows, each with its light
start, end  where the scan line enters and leaves the triangle, and the light there
dz_dx, dz_dy    change of z from a pixel to the next one
step        change of the light from a pixel to the next one
here        light of the pixel
"""

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.beside import Beside
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.shading.coded_light import EXAMPLE, coded_light
from workbench.algorithms.shading.lit_corners import LitPlace, lit_corners_of, lit_row_ends
from workbench.algorithms.shading.pixel_views import pixel_view
from workbench.algorithms.shading.triangle_marks import marks
from workbench.algorithms.visibility.depth_tiles import LIT_EXAMPLE, depth_buffer_tiles
from workbench.algorithms.visibility.scene import SCENE, scene
from workbench.algorithms.visibility.surfaces import surface_of

Array = NDArray[Any]


def gouraud(
    light: Array, vertices: Array, faces: Array, intensities: Array, depth: Array
) -> Iterator[tuple[int, int, float]]:
    """Shade triangles by the light of their corners; the nearest one wins.

    Args: light and depth (h, w), floats, both written in place; vertices
    (n, 3) in pixels, z; faces (m, 3); intensities (n,): the light of each
    vertex. Emits: (x, y, light) of each pixel written.
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-5.
    """
    height, width = light.shape
    for face in range(len(faces)):
        # Take the corners with their light
        low, middle, high = lit_corners_of(vertices, faces, intensities, face)
        surface = surface_of(vertices, faces, face)
        if surface.C == 0.0:
            continue

        for y in range(max(math.ceil(low.y), 0), min(math.ceil(high.y), height)):
            # Spread the light along both edges
            start, end = lit_row_ends(low, middle, high, y)
            step = 0.0
            if start.x < end.x:
                step = (end.light - start.light) / (end.x - start.x)
            z_row = low.z + (y - low.y) * surface.dz_dy

            for x in range(max(math.ceil(start.x), 0), min(math.ceil(end.x), width)):
                # Spread it along the scan line, where the triangle is nearer
                here = start.light + (x - start.x) * step
                z = z_row + (x - low.x) * surface.dz_dx
                stored = float(depth[y, x])
                if z < stored:
                    depth[y, x] = z
                    light[y, x] = here
                    yield x, y, here


def lit_scene(chance: Random) -> tuple[Any, ...]:
    """One or two triangles and the light of their corners."""
    image, depth, vertices, faces, _colours = scene(chance)
    intensities = np.array([chance.randint(0, 8) / 8 for _vertex in vertices])
    return np.zeros(image.shape), vertices, faces, intensities, depth


def edge_rows(start: LitPlace, end: LitPlace) -> tuple[tuple[str, float, float], ...]:
    """Both ends of the scan line."""
    return ("enters", *start), ("leaves", *end)


_BY_NAME = {parameter.name: parameter for parameter in SCENE}
_SPREAD = "Spread it along the scan line, where the triangle is nearer"
_TABLES = {"Ends of the scan line": ("edge_rows(start, end)", ("edge", "x", "light"))}


def _pixel_view(when: str, written: bool, sentence: str) -> View:
    row = f"(x, y, start.light, end.light, step, here, {int(written)})"
    return pixel_view(_SPREAD, row, when, written, sentence, _TABLES)


ENTRY = Entry(
    function=gouraud,
    topic="shading",
    title="Gouraud shading",
    summary="Spreads the light of the corners along the edges, and from edge to edge along each scan line.",
    parameters=(
        Parameter("light", "light", "depth", np.zeros((12, 12)), meaning="the picture, drawn into"),
        Parameter(
            "vertices",
            "vertices",
            "points",
            np.array([[0.0, 0, 0.5], [10, 0, 0.5], [4, 10, 0.5], [0, 4, 0.2], [9, 2, 0.8], [9, 9, 0.8]]),
            meaning="x and y in pixels, z from 0 (near) to 1 (far)",
        ),
        _BY_NAME["faces"],
        Parameter(
            "intensities",
            "intensities",
            "floats",
            np.array([0.2, 0.8, 0.6, 1.0, 0.0, 0.5]),
            meaning="light of each vertex, 0 to 1",
        ),
        Parameter("depth", "depth", "depth", np.ones((12, 12)), meaning="depth buffer, 1 is the farthest"),
    ),
    arguments=lit_scene,
    emits="coverage",
    emitted_columns=("x", "y", "light"),
    source="Gouraud, Continuous Shading of Curved Surfaces, 1971; Hearn and Baker, Computer Graphics, C "
    "Version, section 14-5",
    columns=("x", "y", "enters with", "leaves with", "per pixel", "light", "written"),
    view_functions=(edge_rows,),
    views=(
        View(
            block="Take the corners with their light",
            sentence="Triangle {face} has the light {low.light}, {middle.light} and {high.light} at its "
            "corners, from the lowest up.",
        ),
        View(
            block="Spread the light along both edges",
            tables=_TABLES,
            sentence="Row {y} enters at x = {start.x} with {start.light} and leaves at {end.x} with "
            "{end.light}: {step} more from a pixel to the next.",
        ),
        _pixel_view("z < stored", True, "{(x, y)}: the light is {here}."),
        _pixel_view(
            "True", False, "{(x, y)}: z = {z} is not less than {stored}, so the triangle is hidden here."
        ),
    ),
    laws=(
        Law(
            "In a triangle the light is the linear function that has the corners' light there.",
            "shading/test_gouraud.py::test_in_a_triangle_the_light_is_linear",
        ),
        Law(
            "It lights the pixels that the depth buffer draws, and leaves the same depths.",
            "shading/test_gouraud.py::test_the_pixels_are_those_of_the_depth_buffer",
        ),
        Law(
            "Whole pictures are lit by a function of the place for each triangle, to one step of 255.",
            "shading/test_gouraud.py::test_whole_pictures_are_lit_as_the_text_does",
        ),
    ),
    not_laws=(
        "A highlight in the middle of a face is always seen: only the corners are lit, so what "
        "falls between them "
        "is lost.",
    ),
    labs=("Shading: Gouraud",),
    next_rung="phong",
    tie="Strictly nearer wins, so the first drawn stays",
    writes="light",
    marks=marks,
    beside=(Beside(depth_buffer_tiles, LIT_EXAMPLE), Beside(coded_light, EXAMPLE)),
)
