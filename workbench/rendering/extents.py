"""How far figures reach where the first view shows them, before clipping and rounding."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import AnyFigure, Curve, Sheet
from workbench.rendering.curves import polyline_of
from workbench.rendering.mapping import Box, FigureMap, device_map, device_points, figure_map


def extent_of(sheet: Sheet, figures: Sequence[AnyFigure]) -> Box | None:
    """(xmin, ymin, xmax, ymax), device coordinates, of the ideal geometry of figures, as far as visible.

    None where nothing of it is finite. A seed fill is where its seed is.
    """
    visible = [figure for figure in figures if figure.visible]
    # Of straight figures all points at once: there may be thousands.
    straight = [f for f in visible if not any(f.radii_world) and not isinstance(f, Curve)]
    places = [device_points(sheet, straight, [figure.points_world for figure in straight])]
    for figure in visible:
        if any(figure.radii_world):
            places.append(_corners_of(sheet, figure))
        elif isinstance(figure, Curve):
            line = polyline_of(sheet, figure)
            places.append(line if len(line) else device_points(sheet, [figure], [figure.points_world]))
    return extent_of_points(np.concatenate(places))


def extent_of_points(points: NDArray[np.float64]) -> Box | None:
    """(xmin, ymin, xmax, ymax) of the finite ones of points (n, 2); None without any."""
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return None
    (xmin, ymin), (xmax, ymax) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return xmin, ymin, xmax, ymax


def _corners_of(sheet: Sheet, figure: AnyFigure) -> NDArray[np.float64]:
    """Two opposite corners (2, 2) of the box around a circle or ellipse under its chain."""
    scale, centre = figure_map(sheet, figure), figure.points_world[0]
    if isinstance(scale, FigureMap):
        linear = np.array([(scale.xx, scale.xy), (scale.yx, scale.yy)])
    else:
        linear = np.diag(device_map(sheet)[:2])
    # x = c + A (rx cos t, ry sin t) reaches as far as the rows of A diag(rx, ry) are long.
    half = np.hypot(*(linear * figure.radii_world).T)
    middle = np.array(scale.point(centre.x, centre.y))
    return np.array([middle - half, middle + half])
