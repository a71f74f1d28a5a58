"""What is said of a figure that reaches so far that it is cut, or not drawn, before its algorithm begins."""

import numpy as np

from workbench.algorithms.numerals import with_minus
from workbench.document.model import AnyFigure, Sheet
from workbench.language import _
from workbench.rendering.clipping import drawn_rings, line_ends, visible_rings, visible_segments
from workbench.rendering.limits import POLYGON_REACH_PX, REACH_PX, polygon_reach, reach
from workbench.rendering.pipeline import reach_of
from workbench.rendering.rounds import Area, Lines, is_area, is_lines
from workbench.rendering.segments import inside


def cut_before(sheet: Sheet, figure: AnyFigure) -> str:
    """One sentence where the algorithm gets less than the figure, in the first view; else empty."""
    if is_lines(figure):
        return _cut_lines(sheet, figure)
    if is_area(figure):
        return _cut_area(sheet, figure)
    reached = reach_of(sheet, figure)
    if reached <= REACH_PX:
        return ""
    sentence = _(
        "This figure is not drawn: it reaches {reach:,.0f} pixels, and {most:,} is the most. Make it "
        "smaller, or bring it nearer."
    )
    return sentence.format(reach=reached, most=REACH_PX)


def _cut_lines(sheet: Sheet, figure: Lines) -> str:
    whole = visible_segments(sheet, [figure]).table
    beyond = ~inside(whole, reach(sheet.width_px, sheet.height_px))
    if not beyond.any():
        return ""
    left, _of = line_ends(sheet, [figure])
    if not len(left):
        sentence = _("Nothing of this figure comes within {most:,} pixels of the picture.")
        return sentence.format(most=REACH_PX)
    if len(whole) > 1:
        sentence = _(
            "This figure reaches more than {most:,} pixels beyond the picture: {count:,} of its {all:,} "
            "segments are cut there."
        )
        return sentence.format(most=REACH_PX, count=int(beyond.sum()), all=len(whole))
    x0, y0, x1, y1 = (with_minus(f"{value:,}") for value in left[0].tolist())
    sentence = _(
        "This line is cut {most:,} pixels beyond the picture: the algorithm draws it from ({x0}; {y0}) to "
        "({x1}; {y1})."
    )
    return sentence.format(most=REACH_PX, x0=x0, y0=y0, x1=x1, y1=y1)


def _cut_area(sheet: Sheet, figure: Area) -> str:
    rings, _of = visible_rings(sheet, [figure])
    xmin, ymin, xmax, ymax = polygon_reach(sheet.width_px, sheet.height_px)
    if not rings:
        return ""
    corners = np.concatenate(rings)
    if not ((corners < (xmin, ymin)) | (corners > (xmax, ymax))).any():
        return ""
    if not drawn_rings(sheet, [figure])[0]:
        sentence = _("Nothing of this figure comes within {most:,} pixels of the picture.")
        return sentence.format(most=POLYGON_REACH_PX)
    sentence = _(
        "This figure reaches more than {most:,} pixels beyond the picture: it is cut there, and the "
        "algorithm gets the corners of what is left."
    )
    return sentence.format(most=POLYGON_REACH_PX)
