"""Parts side by side, or one above the other, which share their room as they did at first when asked to."""

from collections.abc import Sequence
from weakref import WeakSet

from PySide6.QtCore import Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QSplitter, QSplitterHandle, QWidget
from shiboken6 import isValid

_splits: "WeakSet[Split]" = WeakSet()


def reset_splits(within: QWidget) -> None:
    """Let all that lie ``within`` a widget share their room as at first.

    They are not asked for by ``findChildren``: PySide takes what that returns for gone once the widget goes.
    """
    for split in list(_splits):
        if isValid(split) and within.isAncestorOf(split):
            split.reset()


class Split(QSplitter):
    """No part can be drawn so small that it is gone."""

    def __init__(
        self, orientation: Qt.Orientation = Qt.Orientation.Horizontal, parent: QWidget | None = None
    ) -> None:
        super().__init__(orientation, parent)
        self.setChildrenCollapsible(False)
        self._first: list[int] = []
        _splits.add(self)

    def setSizes(self, sizes: Sequence[int]) -> None:
        """Shares of the room, which ``reset`` brings back."""
        self._first = []
        super().setSizes(sizes)

    def reset(self) -> None:
        """Share the room as before a line between parts was first moved by hand."""
        if self._first:
            self.setSizes(self._first)

    def createHandle(self) -> QSplitterHandle:
        """A line that remembers how it lay."""
        return _Line(self.orientation(), self)

    def remember(self) -> None:
        """Take the sizes, if none were taken yet, for ``reset``."""
        self._first = self._first or self.sizes()


class _Line(QSplitterHandle):
    """Between two parts."""

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """It may be moved now."""
        split = self.splitter()
        if isinstance(split, Split):
            split.remember()
        super().mousePressEvent(event)
