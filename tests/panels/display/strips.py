"""Whether everything in a strip of controls is whole at a width."""

from PySide6.QtWidgets import QComboBox, QStyle, QStyleOptionComboBox, QWidget


def cut_texts(strip: QWidget) -> list[str]:
    """What the boxes of a strip show that has no room in them."""
    cut = []
    for box in strip.findChildren(QComboBox):
        option = QStyleOptionComboBox()
        box.initStyleOption(option)
        field = QStyle.SubControl.SC_ComboBoxEditField
        room = box.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, field, box).width()
        if box.isVisible() and box.fontMetrics().horizontalAdvance(box.currentText()) > room:
            cut.append(box.currentText())
    return cut


def lies_whole(strip: QWidget) -> bool:
    """Whether the groups of a strip lie inside it, and none over another."""
    places = [
        child.geometry() for child in strip.children() if isinstance(child, QWidget) and child.isVisible()
    ]
    inside = all(strip.rect().contains(place) for place in places)
    return inside and not any(a.intersects(b) for k, a in enumerate(places) for b in places[:k])
