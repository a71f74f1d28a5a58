"""Fast Phong shading: the cosines of each row by second-order differences, two additions for a pixel.

bend        the normal in the middle of the triangle, and how it changes on the screen
shines      of each light what arrives at the middle, and its cosines there as series
scattered   N . L along the row, by its differences
mirrored    N . H along the row, or N . V, of which V . R = 2 (N . L) (N . V) - L . V
here        the light of the pixel, linear
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.shading.directions import middle_of
from workbench.algorithms.shading.normal_corners import normal_corners_of
from workbench.algorithms.shading.pixel_views import pixel_view
from workbench.algorithms.shading.series import bend_of
from workbench.algorithms.shading.shaded_scene import PARAMETERS, shaded_scene
from workbench.algorithms.shading.shine import RowShine, light_of, next_shine, on_row, shine_of
from workbench.algorithms.shading.triangle_marks import marks
from workbench.algorithms.visibility.surfaces import depth_at, end_row, first_row, span_on, surface_of

Array = NDArray[Any]


def fast_phong(
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
    """Shade triangles by series for their cosines; the nearest one wins.

    L and V are those of the middle of the triangle.

    Args: light and depth (h, w), floats, written in place; vertices (n, 3) in
    pixels, z; faces (m, 3); places and normals (n, 3), world; materials (m, 4),
    eye (4,), lights (k, 8), by_halfway, blockers as of ``illuminate``.
    Emits: (x, y, light) of each pixel written.
    Source: Bishop and Weimer, Fast Phong Shading, 1986; Hearn and Baker,
    Computer Graphics, C Version, section 14-5.
    """
    height, width = light.shape
    for face in range(len(faces)):
        surface = surface_of(vertices, faces, face)
        if surface.C == 0.0:
            continue

        # Expand the cosines about the middle of the triangle
        low, middle, high = normal_corners_of(vertices, faces, places, normals, face)
        row = materials[face]
        bend = bend_of(low, middle, high)
        P = middle_of(low.place, middle.place, high.place)
        shines = [shine_of(P, bend, eye, lights, k, by_halfway, blockers) for k in range(len(lights))]

        for y in range(first_row(surface), end_row(surface, height)):
            # Begin the row: a value, its first and its second difference
            x_left, x_right = span_on(surface, y, width)
            ahead = [on_row(shine, x_left - bend.x, y - bend.y) for shine in shines]

            for x in range(x_left, x_right):
                # Light the pixel where the triangle is nearer
                z = depth_at(surface, x, y)
                stored = float(depth[y, x])
                here = light_of(ahead, row, by_halfway)
                if z < stored:
                    depth[y, x] = z
                    light[y, x] = here
                    yield x, y, here

                # Add the differences
                for k in range(len(ahead)):
                    ahead[k] = next_shine(ahead[k])


def difference_rows(shines: list[RowShine]) -> tuple[tuple[object, ...], ...]:
    """Of each light both cosines with their differences."""
    return tuple(
        (light, name, *differences)
        for light, shine in enumerate(shines)
        for name, differences in (("scattered", shine.scattered), ("mirrored", shine.mirrored))
    )


_LIGHT = "Light the pixel where the triangle is nearer"
_TABLES = {"Differences": ("difference_rows(ahead)", ("light", "cosine", "value", "first", "second"))}
_FIRST = "ahead[0].scattered.value if len(ahead) else 0.0"


def _pixel_view(when: str, written: bool, sentence: str) -> View:
    row = f"(x, y, {_FIRST}, here, {int(written)})"
    return pixel_view(_LIGHT, row, when, written, sentence, _TABLES)


ENTRY = Entry(
    function=fast_phong,
    topic="shading",
    title="Fast Phong shading",
    summary="Phong shading with each cosine as a series of degree two, stepped along the row by two "
    "additions.",
    parameters=PARAMETERS,
    arguments=shaded_scene,
    emits="coverage",
    emitted_columns=("x", "y", "light"),
    source="Bishop and Weimer, Fast Phong Shading, 1986; Hearn and Baker, Computer Graphics, C Version, "
    "section 14-5",
    columns=("x", "y", "N · L of light 0", "light", "written"),
    view_functions=(difference_rows,),
    views=(
        View(
            block="Expand the cosines about the middle of the triangle",
            sentence="In the middle of triangle {face} the normal is {bend.N}; from a pixel to the next it "
            "changes by {bend.per_x}.",
        ),
        View(
            block="Begin the row: a value, its first and its second difference",
            tables=_TABLES,
            sentence="Row {y} begins at x = {x_left}: each cosine is stepped by its differences.",
        ),
        _pixel_view("z < stored", True, "{(x, y)}: the light is {here}."),
        _pixel_view(
            "True", False, "{(x, y)}: z = {z} is not less than {stored}, so the triangle is hidden here."
        ),
        View(
            block="Add the differences",
            tables=_TABLES,
            sentence="Two additions for each cosine carry it to the pixel after {(x, y)}.",
        ),
    ),
    laws=(
        Law(
            "Each cosine is the expansion of N · L / |N| to the second degree about the middle, to the last "
            "digits.",
            "shading/test_shadings.py::test_the_differences_are_the_expansion",
        ),
        Law(
            "With lights and eye far away it comes to Phong shading, and the difference falls with the third "
            "power of the bend.",
            "shading/test_shadings.py::test_fast_phong_comes_to_phong",
        ),
        Law(
            "It lights the pixels that the depth buffer draws, and leaves the same depths.",
            "shading/test_shadings.py::test_the_pixels_are_those_of_the_depth_buffer",
        ),
    ),
    not_laws=(
        "It is Phong shading: far from the middle of a large, strongly bent triangle the series leaves it.",
        "A near light is given by its direction: L and V are those of the middle of the triangle.",
    ),
    labs=("Shading: fast Phong",),
    tie="Strictly nearer wins, so the first drawn stays",
    writes="light",
    marks=marks,
)
