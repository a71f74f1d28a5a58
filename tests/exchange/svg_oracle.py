"""The figures read from an SVG beside what an independent renderer, resvg, shows of the same file."""

import io
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from shapely import affinity
from shapely.geometry import LinearRing, Point, box
from shapely.geometry import Polygon as Area
from shapely.geometry.base import BaseGeometry
from shapely.ops import polygonize, unary_union

from workbench.algorithms import catalogue
from workbench.document.model import AnyFigure, Circle, Ellipse, Polygon, Rectangle, Sheet, View, whole_sheet
from workbench.exchange.svg_paths import frame_of, read_svg, read_tree

SIDE = 200
PAPER = 0xFFFFFF


def sheet_for(text: str) -> Sheet:
    """A sheet of white paper in the frame of the drawing, SIDE pixels wide and high."""
    window = frame_of(read_tree(text))
    view = View("v1", window, whole_sheet(SIDE, SIDE))
    return Sheet("s1", "sheet", SIDE, SIDE, (view,), (PAPER, 0x123456))


def rendered(text: str) -> NDArray[np.uint8]:
    """What resvg shows of it, SIDE x SIDE x 3, on white."""
    import resvg_py

    data = bytes(
        resvg_py.svg_to_bytes(
            svg_string=text,
            width=SIDE,
            height=SIDE,
            background="white",
            shape_rendering="crisp_edges",
            skip_system_fonts=True,
            dpi=96.0,
        )
    )
    picture = Image.open(io.BytesIO(data)).convert("RGB")
    assert picture.size == (SIDE, SIDE)
    return np.asarray(picture)


def pixels_of(picture: NDArray[np.uint8], colour: int) -> NDArray[np.bool_]:
    """Where a picture has a colour, 0xRRGGBB, within one step of each channel."""
    rgb = np.array([colour >> 16 & 255, colour >> 8 & 255, colour & 255])
    same: NDArray[np.bool_] = (np.abs(picture.astype(int) - rgb) <= 1).all(axis=2)
    return same


def assert_same(text: str) -> int:
    """Boxes within a pixel, areas within half the pixels of the outline, colours equal; how many are seen.

    What a later figure covers is left out of an earlier one.
    """
    picture, compared = rendered(text), 0
    filled = list(areas(text))
    frame = box(0, 0, SIDE, SIDE)
    for k, (colour, area) in enumerate(filled):
        visible = area.intersection(frame)
        for _colour, other in filled[k + 1 :]:
            visible = visible.difference(other)
        if visible.buffer(-1.0).is_empty or sum(colour == other for other, _area in filled) > 1:
            continue
        rows, columns = np.nonzero(pixels_of(picture, colour))
        assert len(rows), f"{colour:06x} is not there: {text}"
        seen = box(columns.min(), rows.min(), columns.max() + 1, rows.max() + 1)
        # Slivers that no pixel centre need lie in are allowed to be missing, and nothing else.
        thick = visible.buffer(-0.75).buffer(0.75)
        assert box(*visible.bounds).buffer(1.01).contains(seen), f"{seen} {visible.bounds} {text}"
        assert seen.buffer(1.01).contains(box(*thick.bounds)), f"{seen} {thick.bounds} {text}"
        assert abs(len(rows) - visible.area) <= 0.5 * visible.length + 2, f"{len(rows)} {visible.area} {text}"
        compared += 1
    return compared


def areas(text: str) -> Iterator[tuple[int, BaseGeometry]]:
    """Colour and inside, pixels with y downwards, of each filled figure that is read."""
    sheet = sheet_for(text)
    window: Rectangle = sheet.first_view.window_world
    sx, sy = SIDE / (window.xmax - window.xmin), SIDE / (window.ymax - window.ymin)
    drawing = read_svg(text, sheet)
    palette = drawing.palette or sheet.palette
    for figure in drawing.figures:
        inside = inside_of(figure) if figure.visible else None
        if inside is not None:
            placed = affinity.affine_transform(inside, [sx, 0, 0, -sy, -sx * window.xmin, sy * window.ymax])
            yield palette[figure.colour], placed


def inside_of(figure: AnyFigure) -> BaseGeometry | None:
    """The inside of a filled figure in world units, under its chain; None of any other."""
    if catalogue.get(figure.drawn_with).emits != "spans":
        return None
    matrix = np.eye(3) if figure.matrix is None else figure.matrix
    spread = [matrix[0, 0], matrix[0, 1], matrix[1, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2]]
    if isinstance(figure, Circle | Ellipse):
        x, y = figure.points_world[0].x, figure.points_world[0].y
        rx = figure.radius_world if isinstance(figure, Circle) else figure.radius_x_world
        ry = figure.radius_world if isinstance(figure, Circle) else figure.radius_y_world
        inside: BaseGeometry = affinity.scale(Point(x, y).buffer(1.0, 64), rx, ry, origin=(x, y))
    else:
        assert isinstance(figure, Polygon)
        inside = unary_union([face for face in _faces(figure) if _is_inside(figure, face)])
    return affinity.affine_transform(inside, spread)


def _faces(figure: Polygon) -> Iterator[Area]:
    """The pieces that the outline cuts the plane into."""
    outline = unary_union([LinearRing([(p.x, p.y) for p in ring]) for ring in figure.rings])
    yield from polygonize(outline)


def _is_inside(figure: Polygon, face: Area) -> bool:
    """By the winding number of a point in the face, or by its being odd."""
    x, y = face.representative_point().coords[0]
    turns = 0.0
    for ring in figure.rings:
        angles = np.arctan2([p.y - y for p in ring], [p.x - x for p in ring])
        steps = np.diff(np.append(angles, angles[0]))
        turns += float(((steps + np.pi) % (2 * np.pi) - np.pi).sum()) / (2 * np.pi)
    winding = round(turns)
    return winding != 0 if figure.nonzero else winding % 2 == 1
