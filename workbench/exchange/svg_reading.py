"""SVG in: paths and basic shapes become figures of a sheet, exact but for arcs, whose error is stated.

The rule of the frame: the drawing's ``viewBox`` (or its width and height, or else the box around what is
drawn) is put into the middle of the sheet's window as large as fits, in its own proportions, y upwards. So a
picture that this program wrote comes back to where it was.

A path becomes one Curve of Bézier pieces for each of its runs, quadratic and straight ones raised to cubics;
line, polyline, polygon and rect become lines, polylines or, when filled, polygons; circle and ellipse stay
themselves. Transforms, of groups too, become the links of the figures' chains.
"""

from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.building import without_ids
from workbench.document.model import AnyFigure, Rectangle, Sheet
from workbench.document.storage.content import Progress, part, silent
from workbench.document.transforms.chains import matrix_of
from workbench.exchange.path_data import MOST_POINTS, TooManyPointsError
from workbench.exchange.svg_colours import nearest_colour
from workbench.exchange.svg_figures import Made, Shape, figures_of
from workbench.exchange.svg_originals import fault_in, first_fault, moved, original
from workbench.exchange.svg_outlines import length_of
from workbench.exchange.svg_transforms import after, chain_of, framed_inside, functions_in, transform_text
from workbench.exchange.svg_tree import Element, read_tree
from workbench.exchange.svg_walk import drawing_of, stated_frame
from workbench.language import ngettext
from workbench.rendering.mapping import device_map

Array = NDArray[np.float64]

_MOST_NOTES = 20
_BETWEEN_REPORTS = 50
_TOLERANCE_PX = 0.05
_ROUNDING = 1e-12


class Imported(NamedTuple):
    """What an SVG holds.

    ``figures`` without ids, from back to front; ``approximated``: what is not exact, with its error in world
    units; ``notes``: a sentence for each thing that did not come along.
    """

    figures: tuple[AnyFigure, ...]
    approximated: tuple[tuple[str, float], ...]
    notes: tuple[str, ...]

    @property
    def error(self) -> float:
        """How far any figure is from what the SVG describes, at most, in world units."""
        return max((error for _name, error in self.approximated), default=0.0)


def read_svg(
    drawing: str | bytes | Element,
    sheet: Sheet,
    tolerance: float | None = None,
    progress: Progress = silent,
) -> Imported:
    """The figures of an SVG, its text or its tree, for ``sheet``.

    Arcs are within ``tolerance``, world, by default a 20th of a pixel.
    Raises: SvgError, one sentence with line, column and number of the path's command; nothing is half read.
    """
    root = drawing if isinstance(drawing, Element) else read_tree(drawing, part(progress, 0.0, 0.2))
    stated = stated_frame(root)
    shapes, notes = drawing_of(root, stated[2:] if stated else (0.0, 0.0), part(progress, 0.2, 0.5))
    window = sheet.first_view.window_world
    box = stated or _drawn(shapes)
    scale = min((window.xmax - window.xmin) / box[2], (window.ymax - window.ymin) / box[3])
    scale = 1.0 if abs(scale - 1.0) <= _ROUNDING else scale
    dx = _shift(window.xmin, window.xmax, scale * box[0], scale * box[2])
    dy = _shift(window.ymin, window.ymax, -scale * (box[1] + box[3]), scale * box[3])
    frame = np.array([[scale, 0.0, dx], [0.0, -scale, dy]])
    pixel = max(abs(v) for v in device_map(sheet)[:2])
    within = tolerance or _TOLERANCE_PX / pixel
    figures: list[AnyFigure] = []
    sources: list[Element] = []
    approximated: list[tuple[str, float]] = []
    originals: dict[Element, AnyFigure | None] = {}
    points = 0
    for number, shape in enumerate(shapes):
        if number % _BETWEEN_REPORTS == 0:
            progress(0.5 + 0.4 * number / len(shapes))
        if shape.element not in originals:
            originals[shape.element] = original(shape.element.tag, shape.element.attributes)
        restored = _restored(shape, originals[shape.element], sheet, scale, dx, dy)
        if restored is not None:
            figures.append(restored)
        else:
            made = _made(shape, frame, sheet, within)
            figures += made.figures
            approximated += [(made.name, made.error)] if made.error else []
            notes += made.notes
        points += sum(len(figure.points_world) for figure in figures[len(sources) :])
        sources += [shape.element] * (len(figures) - len(sources))
        if points > MOST_POINTS:
            raise shape.element.refusal(str(TooManyPointsError()))
    progress(0.9)
    wrong = first_fault(figures, sheet)
    if wrong is not None:
        raise sources[wrong[0]].refusal(wrong[1])
    return Imported(tuple(figures), tuple(approximated), _bounded(notes))


def _bounded(notes: list[str]) -> tuple[str, ...]:
    """Each note once, and of too many the first ones."""
    once = tuple(dict.fromkeys(notes))
    more = len(once) - _MOST_NOTES
    if more <= 0:
        return once
    text = ngettext("And {count} more remark like these.", "And {count} more remarks like these.", more)
    return (*once[:_MOST_NOTES], text.format(count=more))


def frame_of(root: Element) -> Rectangle:
    """The window, world, in which the drawing keeps its own coordinates, but for y, which goes upwards.

    Raises: SvgError.
    """
    stated = stated_frame(root)
    if stated is None:
        stated = _drawn(drawing_of(root, (0.0, 0.0)).shapes)
    x, y, width, height = stated
    return Rectangle(x, -(y + height), x + width, -y)


def size_of(root: Element) -> tuple[float, float] | None:
    """Width and height that the drawing wants to be shown in, pixels of 1/96 inch, if it states both."""
    if any("%" in root.attributes.get(name, "%") for name in ("width", "height")):
        return None
    width, height = length_of(root, "width"), length_of(root, "height")
    return (width, height) if width > 0 and height > 0 else None


def _shift(low: float, high: float, begin: float, length: float) -> float:
    """What brings the middle of a length to the middle of low and high; 0 where only rounding parts them."""
    found = 0.5 * (low + high) - (begin + 0.5 * length)
    return 0.0 if abs(found) <= _ROUNDING * max(abs(low), abs(high)) else found


def _drawn(shapes: list[Shape]) -> tuple[float, float, float, float]:
    """The box around the control points of all shapes; a little wider where it would have no size."""
    points = np.vstack([np.zeros((0, 2)), *(shape.corners() for shape in shapes)])
    if not len(points):
        return 0.0, 0.0, 1.0, 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    wide = max(float(size.max()), 1e-9 * float(np.abs(points).max()), 1e-9)
    size = np.maximum(size, 1e-3 * wide)
    low = 0.5 * (low + high - size)
    return float(low[0]), float(low[1]), float(size[0]), float(size[1])


def _made(shape: Shape, frame: Array, sheet: Sheet, within: float) -> Made:
    """The figures of a shape, its transforms as their chains; these are put into the points where they have
    numbers that no figure can have."""
    scale, dx, dy = float(frame[0, 0]), float(frame[0, 2]), float(frame[1, 2])
    functions, inner = framed_inside(shape.placing.functions)
    chain = chain_of(functions, scale, dx, dy)
    if chain:
        matrix = matrix_of(chain)
        assert matrix is not None
        stretch = float(np.linalg.norm(matrix[:2, :2], 2))
        made = figures_of(shape, after(frame, inner), sheet, within / max(stretch, 1.0))
        made.figures = [replace(figure, transforms=chain) for figure in made.figures]
        made.error *= stretch
        if not any(fault_in(figure, sheet) for figure in made.figures):
            return made
    return figures_of(shape, after(frame, shape.placing.matrix), sheet, within)


def _restored(
    shape: Shape, figure: AnyFigure | None, sheet: Sheet, scale: float, dx: float, dy: float
) -> AnyFigure | None:
    """The ``figure`` that a shape was made of, under what was put around it since."""
    if figure is None:
        return None
    functions, own = shape.placing.functions, transform_text(figure.transforms)
    if own and shape.element.attributes.get("transform", "") == own:
        functions = functions[: -len(functions_in(own))]
    elif own:
        figure = replace(figure, transforms=())
    functions, inner = framed_inside(functions)
    around = chain_of(functions, scale, dx, dy)
    (a, c, e), (b, d, f) = inner.tolist()
    if around is None or (b, c) != (0.0, 0.0) or a != d or a <= 0:
        return None
    figure = moved(without_ids(figure), scale * a, scale * e + dx, dy - scale * f)
    figure = replace(figure, transforms=(*figure.transforms, *around))
    colour = figure.colour
    wanted = nearest_colour(shape.paint, sheet)
    if not (colour < len(sheet.palette) and sheet.palette[colour] == sheet.palette[wanted]):
        figure = replace(figure, colour=wanted)
    figure = replace(figure, visible=not shape.hidden)
    return None if fault_in(figure, sheet) else figure
