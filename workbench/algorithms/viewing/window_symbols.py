"""The window-to-viewport transformation with symbols, factor by factor."""

from collections.abc import Sequence

from workbench.algorithms.transforms.symbols import SymbolicMatrix, symbolic_scaling, translation_by
from workbench.algorithms.transforms.terms import place
from workbench.algorithms.viewing.window_to_viewport import Mode, origin_to_viewport, scale_factors


def window_chain(
    window: Sequence[float], viewport: Sequence[float], mode: Mode = "stretch"
) -> tuple[SymbolicMatrix, ...]:
    """T(x_{vmin}, y_{vmin}), S(s_x, s_y) and T(−x_{wmin}, −y_{wmin}), in the order of writing.

    To fit or to fill, the window's corner goes to (x_0, y_0) instead, which is not the viewport's.
    Raises: ValueError when a rectangle is not finite or has no area.
    """
    corner = "{vmin}" if mode == "stretch" else "0"
    x, y, _w = origin_to_viewport(window, viewport, mode)[:, 2].tolist()
    return (
        translation_by(place(f"x_{corner}", x), place(f"y_{corner}", y)),
        symbolic_scaling(*scale_factors(window, viewport, mode)),
        translation_by(-place("x_{wmin}", window[0]), -place("y_{wmin}", window[1])),
    )
