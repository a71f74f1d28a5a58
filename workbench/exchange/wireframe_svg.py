"""Segments of the view plane as the lines of an SVG."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.viewing import window_to_viewport
from workbench.document.model import Rectangle

_IN_A_PIECE = 5_000


def wireframe_svg(segments: NDArray[np.float64], window: Rectangle, size: tuple[int, int]) -> Iterator[bytes]:
    """An SVG of so many pixels that shows the window, in pieces; ``segments`` (n, 4): x0, y0, x1, y1."""
    width, height = size
    sides = (window.xmin, window.ymin, window.xmax, window.ymax)
    device = window_to_viewport(sides, (0.0, 0.0, float(width), float(height)), True)
    x = segments[:, [0, 2]] * device[0, 0] + device[0, 2]
    y = height - (segments[:, [1, 3]] * device[1, 1] + device[1, 2])
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}">\n<g fill="none" stroke="#000000" stroke-linecap="round">\n'
    ).encode()
    for begin in range(0, len(segments), _IN_A_PIECE):
        rows = np.stack([x, y], axis=2).reshape(-1, 4)[begin : begin + _IN_A_PIECE].tolist()
        lines = (f'<path d="M{x0:.3f} {y0:.3f}L{x1:.3f} {y1:.3f}"/>\n' for x0, y0, x1, y1 in rows)
        yield "".join(lines).encode()
    yield b"</g>\n</svg>\n"
