"""Layouts whose widgets come and go."""

from PySide6.QtWidgets import QLayout, QWidget


def take_widgets(layout: QLayout) -> list[QWidget]:
    """Take all widgets out of a layout; they stay where they are on the screen.

    With ``takeAt`` PySide would keep, for good, the item that it returns.
    """
    items = [layout.itemAt(place) for place in range(layout.count())]
    widgets = [widget for item in items if item is not None and (widget := item.widget()) is not None]
    for widget in widgets:
        layout.removeWidget(widget)
    return widgets
