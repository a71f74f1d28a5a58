"""A hand that chooses at random what it acts on in the window, and acts on it as the window system would.

A hand only looks. ``findChildren`` and ``childAt`` would make Python's objects children of the widget that
was asked: they would stay for as long as it does, and be called deleted when it is, though they had moved.
"""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QWidget,
)
from shiboken6 import isValid

PLAIN, SHIFT, CONTROL = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
)
OFTEN_HIT = (
    *("PixelCanvas", "PlaneView", "EyeView", "OutsideView", "TubeView"),
    *("HomogeneousView", "StageStrip", "MatrixStrip", "MatrixRow"),
    *("GunView", "SteeredTube", "RasterView", "StrokeView", "StorageView", "TimingDiagram", "ColourView"),
    *("SolidView", "FlickerMap", "LightPlot", "RefreshPlot", "LitView", "MethodTile"),
)


@dataclass
class Hand:
    """A hand over ``window`` that goes by its own random numbers, mostly in ``workspace`` if it has one."""

    window: Any
    rng: Random
    tell: Callable[[str], None]
    workspace: str = ""

    def top(self) -> QWidget:
        """The window that the hand is over: what pops up, else mostly the main one."""
        over = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if over is not None:
            return over
        others = [w for w in QApplication.topLevelWidgets() if w.isVisible() and w is not self.window]
        if others and self.rng.random() < 0.2:
            return self.rng.choice(sorted(others, key=lambda w: (type(w).__name__, w.windowTitle())))
        return self.window

    def parts(self, top: QWidget | None = None) -> list[QWidget]:
        """What can be seen of a window, or of all of them; what a dock behind a tab holds is out of sight."""
        seen = [w for w in QApplication.allWidgets() if w.isVisible() and not w.visibleRegion().isEmpty()]
        return [w for w in seen if top is None or w.window() is top]

    def one_of(self, parts: list[QWidget]) -> QWidget:
        """One of these, whose own order is that of their addresses: it may depend only on what is seen."""
        return self.rng.choice(
            sorted(parts, key=lambda w: (name_of(w), *w.mapTo(w.window(), QPoint()).toTuple(), w.height()))
        )

    def under(self, top: QWidget, at: QPoint) -> QWidget:
        """The part of a window that is seen at a place."""
        seen = QApplication.widgetAt(top.mapToGlobal(at))
        return seen if seen is not None and seen.window() is top else top

    def target(self, top: QWidget) -> QWidget:
        """A visible part of a window, chosen as ``among`` chooses."""
        return self.among(self.parts(top) or [top])

    def among(self, parts: list[QWidget]) -> QWidget:
        """One of these; rare kinds are hit as often as common ones, canvases more often."""
        kinds: dict[str, list[QWidget]] = {}
        for widget in parts:
            kinds.setdefault(type(widget).__name__, []).append(widget)
        canvases = [name for name in OFTEN_HIT if name in kinds]
        if canvases and self.rng.random() < 0.4:
            return self.one_of(kinds[self.rng.choice(canvases)])
        return self.one_of(kinds[self.rng.choice(sorted(kinds))])

    def place(self, top: QWidget, widget: QWidget) -> QPoint:
        """Somewhere in what is seen of a part of a window, in the window's coordinates; corners more often
        than by chance."""
        x, y = (self.rng.choice((0.0, 0.999, self.rng.random(), self.rng.random())) for _axis in "xy")
        if not (isValid(widget) and isValid(top) and top.isAncestorOf(widget)):
            return QPoint(int(x * self.window.width()), int(y * self.window.height()))
        seen = widget.visibleRegion().boundingRect()
        inside = seen.topLeft() + QPoint(int(x * seen.width()), int(y * seen.height()))
        return widget.mapTo(top, inside)

    def modifiers(self) -> Qt.KeyboardModifier:
        """Mostly none."""
        return self.rng.choice((PLAIN, PLAIN, PLAIN, PLAIN, SHIFT, CONTROL))

    def act(self, event: Callable[..., None], top: QWidget, *how: Any) -> None:
        """A mouse or key event of a window that may have gone, as a menu does when it is pressed."""
        if isValid(top) and top.isVisible():
            event(top.windowHandle(), *how)

    def key(self, keys: str, asked: QWidget | None = None) -> None:
        """Press a key, as written in the key table, where the focus is."""
        combination = QKeySequence(keys)[0]
        # A popup gets the keys of any window; asked for its own, QTest goes on with it when it has closed
        top = (QApplication.focusWidget() or asked or self.window).window()
        # One after the other: what is pressed may close the window that would be released
        for event in (QTest.keyPress, QTest.keyRelease):
            self.act(event, top, combination.key(), combination.keyboardModifiers())


def name_of(widget: QWidget) -> str:
    return f"{type(widget).__name__} {widget.objectName() or widget.accessibleName()}".strip()
