"""Every algorithm there is, in teaching order. A new one is its file and one line here."""

import difflib
from collections.abc import Iterable
from functools import cache
from importlib import import_module

from workbench.algorithms.entry import Entry

_TEACHING_ORDER = (
    "lines.dda",
    "lines.dda_single",
    "lines.dda_fixed",
    "lines.bresenham",
    "lines.bresenham_two_ends",
    "lines.midpoint",
    "lines.wu",
    "circles.midpoint_circle",
    "circles.midpoint_ellipse",
    "polygons.inside_outside",
    "polygons.scan_line_crossings",
    "polygons.scan_line_fill",
    "polygons.scan_line_integer",
    "polygons.scan_line_exact",
    "polygons.circle_fill",
    "polygons.ellipse_fill",
    "seed_fill.boundary_fill_recursive",
    "seed_fill.boundary_fill_4",
    "seed_fill.boundary_fill_8",
    "seed_fill.flood_fill_4",
    "seed_fill.flood_fill_8",
    "seed_fill.boundary_fill_spans",
    "clipping.clip_point",
    "clipping.cohen_sutherland",
    "clipping.liang_barsky",
    "clipping.sutherland_hodgman",
    "transforms.matrix_product",
    "transforms.transform_point",
    "transforms.rotate_about_axis",
    "viewing.window_to_viewport_point",
    "curves.hermite_blend",
    "curves.natural_cubic_system",
    "curves.bernstein_curve",
    "curves.de_casteljau",
    "curves.b_spline_sum",
    "curves.de_boor",
    "curves.de_boor_rational",
    "curves.b_spline_curve",
    "curves.flatten_bezier",
    "curves.closest_point",
    "projection.project_point",
    "projection.clip_to_view_volume",
    "solids.octree_of_solid",
    "solids.octree_combined",
    "visibility.back_faces",
    "visibility.depth_buffer",
    "visibility.a_buffer",
    "visibility.scan_line_surfaces",
    "visibility.painter",
    "visibility.depth_sort",
    "visibility.bsp_tree",
    "visibility.area_subdivision",
    "visibility.octree",
    "visibility.ray_casting",
    "visibility.ray_casting_boxes",
    "visibility.hidden_lines",
    "shading.illuminate",
    "shading.flat_shading",
    "shading.gouraud",
    "shading.phong",
    "shading.fast_phong",
    "animation.tween",
    "animation.spline_tween",
    "animation.morph",
    "animation.slerp",
    "scanning.electron_beam",
    "scanning.raster_scan",
    "scanning.random_scan",
    "scanning.stroke_order",
    "scanning.beam_spot",
    "scanning.beam_strokes",
    "scanning.phosphor_decay",
    "colour.rgb_to_cmy",
    "colour.rgb_to_hsv",
    "colour.hsv_to_rgb",
)

_ENTRIES: tuple[Entry, ...] = tuple(
    import_module(f"workbench.algorithms.{name}").ENTRY for name in _TEACHING_ORDER
)

_BY_SLUG = {entry.slug: entry for entry in _ENTRIES}


def entries() -> tuple[Entry, ...]:
    """All entries, in teaching order."""
    return _ENTRIES


def topic(name: str) -> tuple[Entry, ...]:
    """The entries of one topic, in teaching order; none for a topic without algorithms."""
    return tuple(entry for entry in _ENTRIES if entry.topic == name)


def drawing(kind: str, first: str) -> tuple[str, ...]:
    """The slugs that can draw this kind of figure, in teaching order, but ``first`` before all others."""
    return _with_first(first, [entry.slug for entry in _ENTRIES if kind in entry.draws])


def filling(slugs: Iterable[str]) -> tuple[str, ...]:
    """Those of ``slugs`` that paint areas, in their order."""
    return tuple(slug for slug in slugs if get(slug).emits == "spans")


def clipping(kind: str, first: str = "") -> tuple[str, ...]:
    """The slugs that can clip this kind of figure, in teaching order, but ``first`` before all others."""
    return _with_first(first, [entry.slug for entry in _ENTRIES if kind in entry.clips])


@cache  # asked for many times at each move of a drag
def constructing(*splines: str) -> tuple[str, ...]:
    """The slugs that make the curve of one of these kinds of spline, in teaching order."""
    return tuple(entry.slug for entry in _ENTRIES if not set(splines).isdisjoint(entry.constructs))


def _with_first(first: str, slugs: list[str]) -> tuple[str, ...]:
    return tuple(sorted(slugs, key=lambda slug: slug != first))


def serving(question: int) -> tuple[Entry, ...]:
    """The entries that serve this question of the paper, in teaching order."""
    return tuple(entry for entry in _ENTRIES if question in entry.questions)


def known(slug: str) -> bool:
    """Whether there is an entry of this name."""
    return slug in _BY_SLUG


def get(slug: str) -> Entry:
    """The entry named ``slug``.

    Raises:
        LookupError: there is none; the message names those that are near.
    """
    if slug in _BY_SLUG:
        return _BY_SLUG[slug]
    close = difflib.get_close_matches(slug, _BY_SLUG, n=3)
    hint = f"did you mean {', '.join(close)}?" if close else "list shows all of them."
    raise LookupError(f"There is no algorithm named {slug!r}; {hint}")
