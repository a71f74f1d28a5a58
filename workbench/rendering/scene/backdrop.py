"""The scene of a sheet behind its figures, as its camera sees it."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility import depth_buffer
from workbench.document.model import Sheet
from workbench.rendering import frame_buffer, painter_of
from workbench.rendering.scene.render import render_scene
from workbench.rendering.subjects.visibility import window_of
from workbench.rendering.triangles import are_drawn_at_once


def can_be_lit(sheet: Sheet) -> bool:
    """Whether its scene, if it has one, can be painted without keeping a person waiting."""
    return sheet.scene is None or are_drawn_at_once()


def whole_picture(sheet: Sheet) -> NDArray[np.uint32]:
    """The frame buffer (h, w), 0xRRGGBB, of figures and scene, the latter as soon as it can be lit."""
    image = frame_buffer(sheet)
    return with_scene(image, sheet) if can_be_lit(sheet) else image


def with_scene(image: NDArray[np.uint32], sheet: Sheet) -> NDArray[np.uint32]:
    """A picture (h, w) of the figures of ``sheet`` with its scene in the first viewport, where no figure is.

    One that cannot be seen from where the camera stands is left out.
    """
    if sheet.scene is None or not sheet.scene.objects:
        return image
    device = sheet.first_view.viewport_device
    left, low = round(device.xmin + 0.5), round(device.ymin + 0.5)
    size = round(device.xmax - device.xmin), round(device.ymax - device.ymin)
    try:
        seen, _depth = render_scene(sheet.scene, depth_buffer.__name__, size, window=window_of(sheet))
    except ValueError:
        return image
    whole = np.zeros_like(image)
    right, high = min(left + size[0], image.shape[1]), min(low + size[1], image.shape[0])
    x, y = max(left, 0), max(low, 0)
    whole[y:high, x:right] = seen[y - low : high - low, x - left : right - left]
    return np.where((painter_of(sheet) < 0) & (whole != 0), whole, image)
