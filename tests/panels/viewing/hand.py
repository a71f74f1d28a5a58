"""The hand that works on the pictures and the fields of View."""

from PySide6.QtCore import Qt

from tests.panels.by_hand import settle
from workbench.rendering.mapping import box

LEFT, SHIFT, ALT = (
    Qt.MouseButton.LeftButton,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
NO_KEYS = Qt.KeyboardModifier.NoModifier


def drag(qtbot, picture, *places):
    plane = picture.plane
    spots = [plane.position(*place).toPoint() for place in places]
    qtbot.mousePress(plane, LEFT, NO_KEYS, spots[0])
    for spot in spots[1:]:
        qtbot.mouseMove(plane, spot)
        settle()
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, spots[-1])
    settle()


def type_into(qtbot, field, text):
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()


def window(panel):
    return box(panel.view.window_world)


def viewport(panel):
    return box(panel.view.viewport_device)
