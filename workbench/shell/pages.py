"""A page fills the middle of the window in place of a dialog: a title, and one column of text and fields."""

from PySide6.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget


class Page(QScrollArea):
    """One column of at most ``width`` pixels, in the middle, scrolled when the window is low."""

    def __init__(self, title: str, width: int = 760) -> None:
        super().__init__()
        self.setObjectName("page")
        self.setWidgetResizable(True)
        body = QWidget()
        body.setObjectName("pageBody")
        outer = QHBoxLayout(body)
        outer.setContentsMargins(24, 16, 24, 24)
        outer.addStretch(1)
        inner = QWidget()
        inner.setMaximumWidth(width)
        outer.addWidget(inner, 1000)
        outer.addStretch(1)
        self.column = QVBoxLayout(inner)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.column.setSpacing(8)
        if title:
            heading(self.column, title, "title")
        self.setWidget(body)
        self.setAccessibleName(title)


def heading(column: QVBoxLayout, text: str, role: str = "section") -> QLabel:
    """The title of a page, or with some room above it of one section."""
    if role == "section":
        column.addSpacing(8)
    label = QLabel(text)
    label.setProperty("role", role)
    column.addWidget(label)
    return label


def paragraph(column: QVBoxLayout, text: str, role: str = "") -> QLabel:
    """A text in a column; ``role`` is "muted" for what only explains."""
    label = QLabel(text)
    label.setWordWrap(True)
    if role:
        label.setProperty("role", role)
    column.addWidget(label)
    return label
