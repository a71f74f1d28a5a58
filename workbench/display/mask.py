"""The mask of a colour tube: which places of the face glow in which colour.

Behind each hole of the mask the three beams come from different guns and so land on different grains. Only
light of its own colour comes from where a beam lands; the mask is thus a factor on the light of each gun,
whose mean over the face is 1, so that a mask changes no mean luminance. The beam is wider than a hole and
wider than a pixel of the picture: the mask samples it and is not the grid of the pixels.

delta       round dots in triangles, for three guns in a triangle
in_line     upright stripes behind slots, for three guns in a row
grille      upright stripes from top to bottom, behind taut wires

The pitch is from one dot or stripe to the next one of its colour. Sources: FOLDOC (pitch 0.28 to 0.51 mm);
how much of the face its own phosphor covers, and the height of slots, are of the usual order and uncertain.
"""

import math
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

Maps = tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]
Kind = Literal["none", "delta", "in_line", "grille"]
Window = tuple[float, float, float, float]

KINDS: tuple[Kind, ...] = get_args(Kind)
RED, GREEN, BLUE = range(3)

_HALF_ROOT_3 = 0.5 * math.sqrt(3.0)
_DOT_RADIUS = 0.26
"""Of the pitch; neighbours of all colours touch at 0.289, between them is black."""

_STRIPE = 0.27
"""Width of a stripe, of the pitch; a third would leave no black between."""

_SLOT_ROWS, _SLOT = 1.6, 1.35
"""From one slot to the next below it, and its height, of the pitch."""

_LEAST_PX = 3.0
"""A pitch of fewer pixels cannot be drawn; only its mean is left."""


def lit_share(kind: Kind) -> float:
    """Share of the face that the phosphor of one colour covers where the beam can reach it."""
    if kind == "delta":
        return math.pi * _DOT_RADIUS**2 / _HALF_ROOT_3
    if kind == "in_line":
        return _STRIPE * _SLOT / _SLOT_ROWS
    return _STRIPE if kind == "grille" else 1.0


def is_drawn(kind: Kind, pitch_mm: float, pixel_mm: float) -> bool:
    """Whether pixels of this width show the mask, or only its mean, which is 1."""
    return kind != "none" and pitch_mm >= _LEAST_PX * pixel_mm


def mask_maps(kind: Kind, pitch_mm: float, window_mm: Window, size_px: tuple[int, int]) -> Maps:
    """What the light of the red, the green and the blue gun is multiplied by, (rows, columns) each.

    ``window_mm`` (left, bottom, right, top) is the part of the face that ``size_px`` pixels show, row 0 at
    the bottom. The mask lies where it lies, whichever part is looked at.
    """
    columns, rows = size_px
    left, bottom, right, top = window_mm
    pixel = (right - left) / columns
    if not is_drawn(kind, pitch_mm, pixel):
        even = np.ones((rows, columns), np.float32)
        return even, even, even
    x = np.array((left + (np.arange(columns) + 0.5) * pixel) / pitch_mm, np.float64)
    y = np.array((bottom + (np.arange(rows) + 0.5) * ((top - bottom) / rows)) / pitch_mm, np.float64)
    soft = pixel / pitch_mm
    # A ramp as wide as a pixel adds a twelfth of its square to that of the radius of a round dot
    share = math.pi * (_DOT_RADIUS**2 + soft**2 / 12.0) / _HALF_ROOT_3 if kind == "delta" else lit_share(kind)
    cover = {"delta": _dots, "in_line": _slots, "grille": _stripes}[kind]
    red, green, blue = (
        (cover(x[None, :], y[:, None], gun, soft) / share).astype(np.float32) for gun in (RED, GREEN, BLUE)
    )
    return red, green, blue


def _inside(depth: NDArray[np.float64], soft: float) -> NDArray[np.float64]:
    """Share of a pixel ``soft`` wide that lies inside an edge, ``depth`` inwards from it."""
    share: NDArray[np.float64] = np.clip(depth / soft + 0.5, 0.0, 1.0)
    return share


def _nearest(values: NDArray[np.float64], period: float = 1.0) -> NDArray[np.float64]:
    """From the nearest whole multiple of ``period``."""
    away: NDArray[np.float64] = values - period * np.floor(values / period + 0.5)
    return away


def _dots(x: NDArray[np.float64], y: NDArray[np.float64], gun: int, soft: float) -> NDArray[np.float64]:
    """Dots of one colour lie on a lattice of triangles; the others between them."""
    across, up = x - 0.5 * gun, y - gun * _HALF_ROOT_3 / 3.0
    squares = [
        _nearest(across - 0.5 * odd) ** 2 + _nearest(up - odd * _HALF_ROOT_3, 2.0 * _HALF_ROOT_3) ** 2
        for odd in (0, 1)
    ]
    return _inside(_DOT_RADIUS - np.sqrt(np.minimum(*squares)), soft)


def _stripes(x: NDArray[np.float64], y: NDArray[np.float64], gun: int, soft: float) -> NDArray[np.float64]:
    return _inside(0.5 * _STRIPE - np.abs(_nearest(x - gun / 3.0)), soft) * np.ones_like(y)


def _slots(x: NDArray[np.float64], y: NDArray[np.float64], gun: int, soft: float) -> NDArray[np.float64]:
    """The slots of every other triad begin half a slot lower."""
    triad = np.floor(x - gun / 3.0 + 0.5)
    down = _nearest(y - 0.5 * _SLOT_ROWS * np.mod(triad, 2.0), _SLOT_ROWS)
    return _stripes(x, y, gun, soft) * _inside(0.5 * _SLOT - np.abs(down), soft)
