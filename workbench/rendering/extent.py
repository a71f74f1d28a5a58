"""How far the figures of a sheet reach in the world."""

import numpy as np

from workbench.document.model import AnyFigure, Sheet
from workbench.document.transforms.chains import transformed
from workbench.rendering.mapping import Box


def world_extent(sheet: Sheet) -> Box | None:
    """The least rectangle around all visible figures' points and radii (world); None without figures.

    A curve may leave its control points behind and reach a little farther.
    """
    corners = [_corners(figure) for figure in sheet.figures if figure.visible and figure.points_world]
    if not corners:
        return None
    places = np.concatenate(corners)
    (xmin, ymin), (xmax, ymax) = places.min(axis=0).tolist(), places.max(axis=0).tolist()
    return xmin, ymin, xmax, ymax


def _corners(figure: AnyFigure) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Points (n, 2), world, around a figure."""
    points = np.array([(point.x, point.y) for point in figure.points_world], np.float64)
    rx, ry = figure.radii_world
    if rx or ry:
        points = points[0] + np.array([(i * rx, j * ry) for i in (-1, 1) for j in (-1, 1)], np.float64)
    return points if figure.matrix is None else transformed(figure.matrix, points)
