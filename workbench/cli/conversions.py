"""Files of one kind made into another: pictures, SVG, points, surfaces."""

import argparse
import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.cli import outputs
from workbench.cli.failure import BadInputError
from workbench.cli.sheets import sheet_of
from workbench.document import DocumentError, Stored
from workbench.document.edits import set_palette
from workbench.document.model import (
    MAX_SIDE_PX,
    WEIGHTS,
    AnyFigure,
    Document,
    Rectangle,
    Sheet,
)
from workbench.document.numbers import MAX_COORDINATE
from workbench.document.samples.figures import document_of
from workbench.document.storage.content import read_content, read_text
from workbench.document.storage.files import MAX_BYTES, decode
from workbench.document.view_edits import set_window
from workbench.exchange.readable import SUFFIXES, kind_of
from workbench.language import _, at_most, ngettext

_LONGER_SIDE_PX = 200
_MOST_NET_BYTES = 8 * 2**20
_MOST_NET_POINTS = 10_000
_MOST_DEGREE = 15
_LEAST_SIDE_PX = 16
_LEAST_EXTENT, _LEAST_SHARE = 1e-6, 1e-9  # of points: of itself, and beside their coordinates
_SHARE = 0.005  # of the size of the points, the tolerance of a curve fitted to them


def convert(options: argparse.Namespace) -> str:
    """Read one file and write it as the other; what was approximated or left out, a line for each thing."""
    source, target = options.file, options.output
    if options.tolerance is not None and not (math.isfinite(options.tolerance) and options.tolerance > 0):
        raise BadInputError(
            _("The tolerance is {value:g}; give a finite number above 0.").format(value=options.tolerance)
        )
    file_format = outputs.format_for("document", "drawing", path=target)
    document, said = _read(source, options.sheet, options.tolerance, options.size)
    if file_format.kind == "document":
        outputs.write(file_format, Stored(document), target)
    else:
        from workbench.exchange.svg_paths import write_svg

        out = write_svg(document.sheets[0], options.tolerance)
        outputs.write(file_format, out, target)
        said += _approximated(out.approximated) + list(out.notes)
    return "".join(f"{line}\n" for line in said)


def surface(options: argparse.Namespace) -> str:
    """Write the triangles of an example or of a control net in a JSON file as a mesh."""
    from workbench.algorithms.surfaces import EXAMPLES, tessellate

    file_format = outputs.format_for("mesh", path=options.output)
    try:
        made = EXAMPLES.get(options.surface)
        patches = made() if made else _patches(Path(options.surface))
        vertices, faces = tessellate(patches, options.tolerance)
    except ValueError as error:
        raise BadInputError(str(error)) from None
    outputs.write(file_format, (vertices, faces), options.output)
    sentence = _("{vertices:,} vertices, {faces:,} triangles, within {tolerance:g}.\n")
    return sentence.format(vertices=len(vertices), faces=len(faces), tolerance=options.tolerance)


def size(text: str) -> tuple[int, int]:
    """Width and height from a text such as 640x480. Raises: ArgumentTypeError."""
    words = text.lower().split("x")
    if len(words) != 2 or not all(word.isascii() and word.isdecimal() for word in words):
        raise argparse.ArgumentTypeError(
            _("{text!r} is not a size; write it as 640x480").format(text=text[:20])
        )
    sides = int(words[0][:9]), int(words[1][:9])
    if not all(1 <= side <= MAX_SIDE_PX for side in sides):
        sentence = _("{text!r} is not a size; each side has 1 to {most} pixels")
        raise argparse.ArgumentTypeError(sentence.format(text=text[:20], most=MAX_SIDE_PX))
    return sides


def _read(
    source: Path, number: int, tolerance: float | None, wanted: tuple[int, int] | None
) -> tuple[Document, list[str]]:
    """A document of one sheet, and what there is to say about it."""
    from workbench.exchange.mesh_reading import MOST_BYTES as MOST_MESH_BYTES
    from workbench.exchange.point_lists import MOST_CHARACTERS, text_of
    from workbench.exchange.svg_tree import MOST_BYTES

    kind = kind_of(source)
    most = {"picture": MAX_BYTES, "drawing": MOST_BYTES, "points": MOST_CHARACTERS, "mesh": MOST_MESH_BYTES}
    if not kind:
        sentence = _("{file}: this cannot be read; give one of {kinds}.")
        raise BadInputError(sentence.format(file=source, kinds=", ".join(SUFFIXES)))
    try:
        content = read_content(source, most[kind])
        text = text_of(content, source) if kind == "points" else ""
    except DocumentError as error:
        raise BadInputError(str(error)) from None
    try:
        if kind == "picture":
            document = decode(content).document
            return replace(document, sheets=(sheet_of(document, source, number),)), []
        if kind == "drawing":
            return _from_svg(source, content, tolerance, wanted)
        if kind == "mesh":
            return _from_mesh(source, content, wanted)
        return _from_points(source, text, tolerance, wanted)
    except ValueError as error:
        raise BadInputError(f"{source}: {error}") from None


def _from_svg(
    source: Path, content: bytes, tolerance: float | None, wanted: tuple[int, int] | None
) -> tuple[Document, list[str]]:
    from workbench.exchange.svg_paths import frame_of, read_svg, read_tree, size_of

    root = read_tree(content)
    window = frame_of(root)
    sheet = _blank(window, wanted or _pixels(size_of(root) or (0.0, 0.0), window))
    drawing = read_svg(root, sheet, tolerance)
    document = _filled(source, sheet, drawing.figures, drawing.palette)
    return document, _approximated(drawing.approximated) + list(drawing.notes)


def _from_points(
    source: Path, text: str, tolerance: float | None, wanted: tuple[int, int] | None
) -> tuple[Document, list[str]]:
    from workbench.algorithms.curves import fit_pieces
    from workbench.exchange.point_lists import read_points
    from workbench.exchange.svg_figures import MOST_PIECES, path_of

    points = read_points(text)
    window = _window_around(points)
    extent = float(np.ptp(points, axis=0).max())
    within = tolerance or max(_SHARE * extent, 1e-9)
    pieces, error = fit_pieces(points, within, most_pieces=MOST_PIECES)
    closed = len(points) > 2 and np.array_equal(points[0], points[-1])
    sheet = _blank(window, wanted or _pixels((0.0, 0.0), window))
    document = _filled(source, sheet, [path_of(pieces.controls, closed, 1)])
    count = len(pieces.controls)
    if error > 0.0:
        sentence = ngettext(
            "{count} Bézier piece passes within {error} of all {points} points.",
            "{count} Bézier pieces pass within {error} of all {points} points.",
            count,
        )
    else:
        sentence = ngettext(
            "{count} Bézier piece passes exactly through all {points} points.",
            "{count} Bézier pieces pass exactly through all {points} points.",
            count,
        )
    return document, [sentence.format(count=count, points=len(points), error=at_most(error))]


def _window_around(points: NDArray[np.float64]) -> Rectangle:
    """A window with an edge around points (n, 2), within what a coordinate may be. Raises: PointsError."""
    from workbench.exchange.point_lists import PointsError

    low, high = points.min(axis=0), points.max(axis=0)
    extent, size = float((high - low).max()), float(np.abs(points).max())
    if 0.0 < extent <= max(_LEAST_EXTENT, _LEAST_SHARE * size):
        sentence = _(
            "The points lie within {extent:.3g} of one another; scale them up, or give other points."
        )
        raise PointsError(sentence.format(extent=extent))
    edge = 0.05 * extent
    low, high = np.maximum(low - edge, -MAX_COORDINATE), np.minimum(high + edge, MAX_COORDINATE)
    return Rectangle(*low.tolist(), *high.tolist())


def _from_mesh(source: Path, content: bytes, wanted: tuple[int, int] | None) -> tuple[Document, list[str]]:
    from workbench.document.scene.edits import add_object, set_camera
    from workbench.document.scene.meshes import blob_of
    from workbench.document.scene.model import Object
    from workbench.document.scene.solids import MeshSolid
    from workbench.exchange.mesh_reading import read_mesh
    from workbench.rendering.scene.around import camera_around, window_of

    mesh, notes = read_mesh(content, source.suffix, to_keep=True)
    camera = camera_around(mesh.vertices)
    sides = wanted or (_LONGER_SIDE_PX, _LONGER_SIDE_PX * 3 // 4)
    document = _filled(source, _blank(window_of(camera, sides, mesh.vertices), sides), ())
    sheet = document.sheets[0].id
    named = Object("", MeshSolid(blob_of(mesh)), "", name=source.stem[:200])
    return set_camera(sheet, camera)(add_object(sheet, named)(document)), list(notes)


def _blank(window: Rectangle, sides: tuple[int, int]) -> Sheet:
    document = document_of("", *sides, ())
    return set_window(document.sheets[0].first_view.id, window)(document).sheets[0]


def _filled(
    source: Path, sheet: Sheet, figures: Sequence[AnyFigure], palette: tuple[int, ...] = ()
) -> Document:
    filled = document_of(source.stem[:200], sheet.width_px, sheet.height_px, figures)
    only = filled.sheets[0]
    if palette:
        filled = set_palette(only.id, palette)(filled)
    return set_window(only.first_view.id, sheet.first_view.window_world)(filled)


def _pixels(stated: tuple[float, float], window: Rectangle) -> tuple[int, int]:
    """The size of a sheet: the one that is stated, if it is a fit one, else in the window's proportions."""
    sides = tuple(round(side) for side in stated)
    if all(_LEAST_SIDE_PX <= side <= MAX_SIDE_PX for side in sides):
        return sides[0], sides[1]
    width, height = window.xmax - window.xmin, window.ymax - window.ymin
    scale = _LONGER_SIDE_PX / max(width, height)
    return max(round(scale * width), _LEAST_SIDE_PX), max(round(scale * height), _LEAST_SIDE_PX)


def _approximated(rows: Sequence[tuple[str, float]]) -> list[str]:
    sentence = _("{name} is approximated within {error}.")
    return [sentence.format(name=name, error=at_most(error)) for name, error in rows]


def _patches(path: Path) -> Any:
    """The surface in a JSON file. Raises: ValueError.

    It has ``points``, rows of [x, y, z], and, if there are any, ``weights``, ``degrees`` [p, q], ``u_knots``
    and ``v_knots``; without degrees it is one Bézier patch.
    """
    from workbench.algorithms.curves import open_uniform_knots
    from workbench.algorithms.surfaces import EXAMPLES, b_spline_patch, bezier_patch

    try:
        text = read_text(path, _MOST_NET_BYTES)
    except DocumentError as error:
        if isinstance(error.__cause__, FileNotFoundError):
            sentence = _("There is no file {file}; give a JSON file or one of {examples}.")
            raise ValueError(sentence.format(file=path, examples=", ".join(EXAMPLES))) from None
        raise
    try:
        found = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise ValueError(_("{file} is not JSON ({reason}).").format(file=path, reason=error)) from None
    try:
        net = _numbers("points", found["points"], -MAX_COORDINATE, MAX_COORDINATE)
        weights = _numbers("weights", found.get("weights"), *WEIGHTS)
        if "degrees" not in found:
            _refuse_degrees(len(net) - 1, len(net[0]) - 1)
            return bezier_patch(net, weights)
        p, q = (int(degree) for degree in found["degrees"])
        _refuse_degrees(p, q)
        if net.size > 3 * _MOST_NET_POINTS:
            sentence = _("the net has {count:,} points, but at most {most:,} can be read.")
            raise ValueError(sentence.format(count=net.size // 3, most=_MOST_NET_POINTS))
        knots = []
        for name, count, degree in (("u_knots", len(net), p), ("v_knots", len(net[0]), q)):
            given = _numbers(name, found.get(name) or None, -MAX_COORDINATE, MAX_COORDINATE)
            knots.append(open_uniform_knots(count, degree) if given is None else given)
        return b_spline_patch(net, knots[0], knots[1], (p, q), weights)
    except (KeyError, TypeError, AttributeError, IndexError, OverflowError):
        sentence = _('{file} holds no surface; write {{"points": [[[x, y, z], …], …]}}.')
        raise ValueError(sentence.format(file=path)) from None
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


def _refuse_degrees(*degrees: int) -> None:
    """Raises: ValueError."""
    for degree in degrees:
        if not 1 <= degree <= _MOST_DEGREE:
            sentence = _("the surface has degree {degree}; it can be 1 to {most}.")
            raise ValueError(sentence.format(degree=degree, most=_MOST_DEGREE))


def _numbers(name: str, value: Any, low: float, high: float) -> Any:
    """Nested lists of numbers, all rows equally long, as an array; None stays.

    Raises: TypeError where it is none; ValueError for a number that is not between ``low`` and ``high``.
    """
    if value is None:
        return None
    try:
        numbers = np.array(value, float)
    except ValueError:
        raise TypeError from None
    if not ((numbers >= low) & (numbers <= high)).all():
        sentence = _("{name} has a number that is not between {low:g} and {high:g}.")
        raise ValueError(sentence.format(name=name, low=low, high=high))
    return numbers
