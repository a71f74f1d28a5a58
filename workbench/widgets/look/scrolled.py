"""Words that may be longer than their room: they scroll there rather than be cut."""

from PySide6.QtWidgets import QLabel, QScrollArea, QSizePolicy


def scrolled(words: QLabel) -> QScrollArea:
    """A frameless area that is as high as ``words``, where there is room, and else scrolls them."""
    area = QScrollArea()
    area.setFrameShape(QScrollArea.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
    area.setWidget(words)
    return area
