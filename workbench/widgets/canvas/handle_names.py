"""The names of handles, each on a side of its handle where it hides neither another name nor a grip."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from workbench.algorithms.numerals import numeral
from workbench.widgets.canvas.label_places import Box, around, freest, hidden_area
from workbench.widgets.canvas.lines import on_screen
from workbench.widgets.canvas.overlay import HANDLE, handle_places
from workbench.widgets.look.tokens import colour

if TYPE_CHECKING:
    from workbench.widgets.canvas.painter import Scene

MOST_NAMED = 40
_POINTER, _BESIDE, _ABOVE = 6.0, 14.0, 10.0
_PAD = 4.0


class Label(NamedTuple):
    """A text and the box of its card, in screen pixels."""

    text: str
    box: Box


def handle_names(scene: Scene) -> tuple[Label, ...]:
    """The names to be shown: those of what is selected first, each on the side away from the other handles
    unless another is freer. One that would hide another is left out, until there is room for both.

    Of many handles only those selected bear their names, as long as they are few.
    """
    return _laid_out(scene)[0]


@lru_cache(maxsize=4)
def _laid_out(scene: Scene) -> tuple[tuple[Label, ...], NDArray[np.float64]]:
    """The names to be shown, and the boxes (n, 4) that they and the grips take."""
    handles = scene.overlay.handles
    if not handles:
        return (), np.empty((0, 4))
    named = [k for k, handle in enumerate(handles) if handle.name]
    shown = named if len(named) <= MOST_NAMED else [k for k in named if handles[k].selected]
    places = handle_places(handles)
    screen = np.column_stack(on_screen(scene, places))
    grips = _grips(scene, screen)
    if not shown or len(shown) > MOST_NAMED:
        return (), grips
    middle_x, middle_y = places[named].mean(axis=0)
    side, area = HANDLE * scene.unit, scene.area
    away = side / 2 + max(side / 2, scene.view.cell / 2)
    labels: list[Label] = []
    for number in sorted(shown, key=lambda k: not handles[k].selected):
        handle, (x, y) = handles[number], screen[number].tolist()
        if not (-side <= x - area.left <= area.width + side and -side <= y - area.top <= area.height + side):
            continue
        text = f"{handle.name} ({numeral(handle.x)}, {numeral(handle.y)})"
        own = -1 if handle.x < middle_x else 1, -1 if handle.y < middle_y else 1
        boxes = _corners(text, x, y, (away, away), own, scene)
        names = _boxes(labels)
        best = boxes[freest(boxes, np.vstack([grips, names]))]
        if hidden_area(best, names) == 0.0:
            labels.append(Label(text, best))
    return tuple(labels), np.vstack([grips, _boxes(labels)])


def tag_box(text: str, x: float, y: float, scene: Scene) -> Box:
    """The card of what is said beside the pointer at x and y (screen): clear of it, of grips and of names."""
    boxes = _corners(text, x, y, (_BESIDE * scene.unit, _ABOVE * scene.unit), (1, 1), scene)
    pointer = around(np.array([[x, y]]), _POINTER * scene.unit)
    taken = np.vstack([pointer, _laid_out(scene)[1]])
    return boxes[freest(boxes, taken)]


def label_size(text: str, scene: Scene) -> tuple[float, float]:
    """Width and height of the card of a text, in screen pixels."""
    metrics, pad = QFontMetricsF(scene.caption()), _PAD * scene.unit
    lines = text.split("\n")
    width = max(metrics.horizontalAdvance(line) for line in lines)
    return width + 2 * pad, len(lines) * metrics.height() + pad


def label_box(
    size: tuple[float, float], x: float, y: float, scene: Scene, right: int = 1, up: int = 1
) -> Box:
    """A card of this size right (left: -1) of and above (below: -1) a screen point, kept in the area."""
    (width, height), pad, area = size, _PAD * scene.unit, scene.area
    left = min(max(x if right > 0 else x - width, area.left + pad), area.right - width - pad)
    top = min(max(y - height if up > 0 else y, area.top + pad), area.bottom - height - pad)
    return left, top, left + width, top + height


def paint_label(painter: QPainter, text: str, box: Box, scene: Scene) -> None:
    """A small card with text."""
    font, pad = scene.caption(), _PAD * scene.unit
    metrics = QFontMetricsF(font)
    left, top, right, bottom = box
    painter.setPen(QPen(QColor(scene.tokens.line), 1))
    painter.setBrush(colour(scene.tokens.raised, 235))
    painter.drawRoundedRect(QRectF(left, top, right - left, bottom - top), 3 * scene.unit, 3 * scene.unit)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setFont(font)
    painter.setPen(QColor(scene.tokens.text))
    for k, line in enumerate(text.split("\n")):
        painter.drawText(QPointF(left + pad, top + pad / 2 + metrics.ascent() + k * metrics.height()), line)


def _corners(
    text: str, x: float, y: float, away: tuple[float, float], own: tuple[int, int], scene: Scene
) -> list[Box]:
    """Where a label can stand about a screen point, so far away: its own corner first, its opposite last."""
    size = label_size(text, scene)
    (aside, above), (right, up) = away, own
    sides = (right, up), (-right, up), (right, -up), (-right, -up)
    return [label_box(size, x + i * aside, y - j * above, scene, i, j) for i, j in sides]


def _grips(scene: Scene, screen: NDArray[np.float64]) -> NDArray[np.float64]:
    """The boxes (n, 4) of the grips that are seen, of all at ``screen``."""
    area, reach = scene.area, HANDLE * scene.unit / 2
    seen = (screen >= (area.left - reach, area.top - reach)) & (
        screen <= (area.right + reach, area.bottom + reach)
    )
    return around(screen[seen.all(axis=1)], reach)


def _boxes(labels: Iterable[Label]) -> NDArray[np.float64]:
    return np.array([label.box for label in labels]).reshape(-1, 4)
