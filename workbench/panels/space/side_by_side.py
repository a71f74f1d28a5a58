"""Picture and outside view side by side, one above the other, or either alone."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from workbench.widgets.look.split import Split

_LEAST_BESIDE_PX = 560


class SideBySide(Split):
    """One above the other only where the room is taller than wide; the picture alone where it is narrow."""

    def __init__(self, eye: QWidget, outside: QWidget) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._eye, self._outside = eye, outside
        self.which = "both"
        for at, view in enumerate((eye, outside)):
            self.addWidget(view)
            self.setStretchFactor(at, 1)
        self.setSizes([1000, 1000])

    def show_views(self, which: str, empty: bool) -> None:
        """Show "both", the "eye" or the "outside"; of an ``empty`` scene the picture, which says so."""
        self.which = which
        upright = self.height() > self.width()
        self.setOrientation(Qt.Orientation.Vertical if upright else Qt.Orientation.Horizontal)
        alone = which == "both" and self.width() < _LEAST_BESIDE_PX and not upright
        self._eye.setVisible(empty or which != "outside")
        self._outside.setVisible(not empty and which != "eye" and not alone)
