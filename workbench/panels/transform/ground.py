"""The ground of what stands in a dock or under the canvas."""

from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from workbench.widgets.look.tokens import colour, theme, tokens


class Ground(QWidget):
    """Painted in the colour of panels, whatever scrolls it."""

    def __init__(self) -> None:
        super().__init__()
        theme.changed.connect(self.update)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The surface of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))
