"""SVG in: paths and basic shapes become figures of a sheet, exact but for arcs, whose error is stated.

The rule of the frame: the drawing's ``viewBox`` (or its width and height, or else the box around what is
drawn) is put into the middle of the sheet's window as large as fits, in its own proportions, y upwards. So a
picture that this program wrote comes back to where it was.

A path becomes one Curve of Bézier pieces for each of its runs, quadratic and straight ones raised to cubics;
line, polyline, polygon and rect become lines and polylines; circle and ellipse stay themselves. What is
filled becomes a polygon, or a filled circle or ellipse, behind its outline. Transforms, of groups too, become
the links of the figures' chains. All figures of one element are a group; so are those of the outermost <g>
or <use>, but for layers and what holds the whole drawing. An element that cannot be read is left out, and
that is said.
"""

from contextlib import suppress
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.building import without_ids
from workbench.document.grouping import regrouped
from workbench.document.model import AnyFigure, Rectangle, Sheet
from workbench.document.motion.model import Motion
from workbench.document.storage.content import Progress, part, silent
from workbench.document.transforms.chains import matrix_of
from workbench.exchange.path_data import MOST_POINTS, TooManyPointsError
from workbench.exchange.svg_colours import Colours
from workbench.exchange.svg_figures import Made, Shape, figures_of, losses
from workbench.exchange.svg_frames import Box, fitted, stated_frame
from workbench.exchange.svg_originals import fault_in, first_fault, moved, original
from workbench.exchange.svg_outlines import length_of
from workbench.exchange.svg_transforms import after, chain_of, framed_inside, functions_in, transform_text
from workbench.exchange.svg_tree import Element, SvgError, UnreadError, read_tree
from workbench.exchange.svg_walk import drawing_of
from workbench.geometry.stretch import largest_stretch
from workbench.language import _, ngettext
from workbench.rendering.mapping import device_map

Array = NDArray[np.float64]

_MOST_NOTES = 20
_BETWEEN_REPORTS = 50
_TOLERANCE_PX = 0.05
_ROUNDING = 1e-12


class Imported(NamedTuple):
    """What an SVG holds, or the clipboard.

    ``figures`` from back to front, those of an SVG without ids; ``approximated``: what is not exact, with its
    error in world units; ``notes``: a sentence for each thing that did not come along; ``palette``: that of
    the sheet with the colours that it needs at its end, empty where it needs none; ``motion``: how those of
    the clipboard move, None where they do not; ``scale``: world units for a unit of the drawing.
    """

    figures: tuple[AnyFigure, ...]
    approximated: tuple[tuple[str, float], ...]
    notes: tuple[str, ...]
    palette: tuple[int, ...] = ()
    motion: Motion | None = None
    scale: float = 1.0

    @property
    def error(self) -> float:
        """How far any figure is from what the SVG describes, at most, in world units."""
        return max((error for _name, error in self.approximated), default=0.0)


@np.errstate(over="ignore", divide="ignore", invalid="ignore")  # what is not finite is refused by its number
def read_svg(
    drawing: str | bytes | Element,
    sheet: Sheet,
    tolerance: float | None = None,
    progress: Progress = silent,
) -> Imported:
    """The figures of an SVG, its text or its tree, for ``sheet``.

    Arcs are within ``tolerance``, world, by default a 20th of a pixel.
    Raises: SvgError, one sentence with line, column and number of the path's command, where nothing can be
    read or the whole is too much; nothing is half read.
    """
    root = drawing if isinstance(drawing, Element) else read_tree(drawing, part(progress, 0.0, 0.2))
    stated = stated_frame(root)
    shapes, notes, unread = drawing_of(root, stated and stated[2:], part(progress, 0.2, 0.5))
    frame = _frame(sheet, _shown(root, stated or _drawn(shapes)))
    pixel = 1.0 / max(abs(v) for v in device_map(sheet)[:2])
    within, scale = tolerance or _TOLERANCE_PX * pixel, abs(float(frame[0, 0])) / pixel
    colours = Colours(sheet)
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
        restored = _restored(shape, originals[shape.element], sheet, frame, colours)
        if restored is not None:
            figures.append(replace(restored, group=shape.group))
        else:
            try:
                made = _made(shape, frame, sheet, colours, within)
            except UnreadError as error:
                unread.append(str(error))
                continue
            figures += (replace(figure, group=shape.group) for figure in made.figures)
            approximated += [(made.name, made.error)] if made.error else []
            notes += [*made.notes, *losses(shape, scale)]
        points += sum(len(figure.points_world) for figure in figures[len(sources) :])
        sources += [shape.element] * (len(figures) - len(sources))
        if points > MOST_POINTS:
            raise shape.element.refusal(str(TooManyPointsError()))
    progress(0.9)
    able = replace(sheet, palette=tuple(colours.palette))
    if first_fault(figures, able) is not None:
        faults = [fault_in(figure, able) for figure in figures]
        unread += [str(source.unread(fault)) for source, fault in zip(sources, faults, strict=True) if fault]
        figures = [figure for figure, fault in zip(figures, faults, strict=True) if not fault]
    if unread and not figures:
        raise SvgError(unread[0])
    left_out = [_("Left out: {what}").format(what=sentence) for sentence in unread]
    palette = able.palette if able.palette != sheet.palette else ()
    said = _bounded([*left_out, *notes, *colours.notes])
    return Imported(
        tuple(regrouped(figures)), tuple(approximated), said, palette, scale=abs(float(frame[0, 0]))
    )


def _frame(sheet: Sheet, box: Box) -> Array:
    """The matrix (2, 3) that puts a box into the middle of the sheet's window, y upwards."""
    window = sheet.first_view.window_world
    scale = min((window.xmax - window.xmin) / box[2], (window.ymax - window.ymin) / box[3])
    scale = 1.0 if abs(scale - 1.0) <= _ROUNDING else scale
    dx = _shift(window.xmin, window.xmax, scale * box[0], scale * box[2])
    dy = _shift(window.ymin, window.ymax, -scale * (box[1] + box[3]), scale * box[3])
    return np.array([[scale, 0.0, dx], [0.0, -scale, dy]])


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

    It has the proportions of width and height, where they are stated and the drawing is not to be stretched.
    Raises: SvgError.
    """
    x, y, width, height = _shown(root, stated_frame(root) or _drawn(drawing_of(root, None).shapes))
    return Rectangle(x, -(y + height), x + width, -y)


def _shown(root: Element, box: Box) -> Box:
    """What is seen in the drawing's width and height, if it states them, when ``box`` is fitted into them."""
    size = size_of(root)
    if size is None:
        return box
    how = root.attributes.get("preserveAspectRatio", "")
    (sx, _c, left), (_b, sy, top) = fitted(box, size, how).tolist()
    return -left / sx, -top / sy, size[0] / sx, size[1] / sy


def size_of(root: Element) -> tuple[float, float] | None:
    """Width and height that the drawing wants to be shown in, pixels of 1/96 inch, if it states both."""
    if any("%" in root.attributes.get(name, "%") for name in ("width", "height")):
        return None
    width, height = length_of(root, "width"), length_of(root, "height")
    return (width, height) if width > 0 and height > 0 else None


def _shift(low: float, high: float, begin: float, length: float) -> float:
    """What brings the middle of a length to the middle of low and high; 0 where only rounding parts them."""
    shift = 0.5 * (low + high) - (begin + 0.5 * length)
    return 0.0 if abs(shift) <= _ROUNDING * max(abs(low), abs(high)) else shift


def _drawn(shapes: list[Shape]) -> Box:
    """The box around the control points of all shapes; a little wider where it would have no size."""
    corners = [np.zeros((0, 2))]
    for shape in shapes:
        with suppress(UnreadError):  # left out when its figures are made
            corners.append(shape.corners())
    points = np.vstack(corners)
    if not len(points):
        return 0.0, 0.0, 1.0, 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    wide = max(float(size.max()), 1e-9 * float(np.abs(points).max()), 1e-9)
    size = np.maximum(size, 1e-3 * wide)
    low = 0.5 * (low + high - size)
    return float(low[0]), float(low[1]), float(size[0]), float(size[1])


def _made(shape: Shape, frame: Array, sheet: Sheet, colours: Colours, within: float) -> Made:
    """The figures of a shape, its transforms as their chains; these are put into the points where they have
    numbers that no figure can have. Raises: as figures_of does."""
    scale, dx, dy = float(frame[0, 0]), float(frame[0, 2]), float(frame[1, 2])
    functions, inner = framed_inside(shape.placing.functions)
    chain = chain_of(functions, scale, dx, dy)
    if chain:
        matrix = matrix_of(chain)
        assert matrix is not None
        stretch = largest_stretch(matrix[:2, :2])
        made = figures_of(shape, after(frame, inner), colours, within / max(stretch, 1.0))
        made.figures = [replace(figure, transforms=chain) for figure in made.figures]
        made.error *= stretch
        able = replace(sheet, palette=tuple(colours.palette))
        if not any(fault_in(figure, able) for figure in made.figures):
            return made
    return figures_of(shape, after(frame, shape.placing.matrix), colours, within)


def _restored(
    shape: Shape, figure: AnyFigure | None, sheet: Sheet, frame: Array, colours: Colours
) -> AnyFigure | None:
    """The ``figure`` that a shape was made of, under what was put around it since."""
    if figure is None:
        return None
    scale, dx, dy = float(frame[0, 0]), float(frame[0, 2]), float(frame[1, 2])
    functions, own = shape.placing.functions, transform_text(figure.transforms)
    if own and shape.element.attributes.get("transform", "") == own:
        functions = functions[: -len(functions_in(own) or ())]
    elif own:
        figure = replace(figure, transforms=())
    functions, inner = framed_inside(functions)
    around = chain_of(functions, scale, dx, dy)
    (a, c, e), (b, d, f) = inner.tolist()
    if around is None or (b, c) != (0.0, 0.0) or a != d or a <= 0:
        return None
    figure = moved(without_ids(figure), scale * a, scale * e + dx, dy - scale * f)
    figure = replace(figure, transforms=(*figure.transforms, *around))
    paint, own_colour = shape.paint, sheet.palette[figure.colour : figure.colour + 1]
    if own_colour != (paint.colour,) or paint.alpha < 1.0:
        figure = replace(figure, colour=colours.index_of(paint))
    figure = replace(figure, visible=not shape.hidden)
    return None if fault_in(figure, replace(sheet, palette=tuple(colours.palette))) else figure
