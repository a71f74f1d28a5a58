"""The hand that works on the canvas of a panel of figures, and turns of the event loop."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

LEFT = Qt.MouseButton.LeftButton
SHIFT = Qt.KeyboardModifier.ShiftModifier


def keep_until_the_end(qtbot, panel):
    """End a panel, or a part of one, with the test, and its docks, which would outlive it."""
    docks = panel.docks() if hasattr(panel, "docks") else ()
    for widget in (panel, *(dock for _name, _title, dock, _area in docks)):
        qtbot.addWidget(widget)


def settle():
    for _turn in range(4):
        QApplication.processEvents()


def at(panel, x, y):
    return panel.canvas.widget_position(x, y).toPoint()


def drag(qtbot, panel, *places, modifiers=Qt.KeyboardModifier.NoModifier):
    canvas = panel.canvas
    qtbot.mousePress(canvas, LEFT, modifiers, at(panel, *places[0]))
    for place in places[1:]:
        qtbot.mouseMove(canvas, at(panel, *place))
        settle()
    qtbot.mouseRelease(canvas, LEFT, modifiers, at(panel, *places[-1]))
    settle()


def begin_number(qtbot, line, text):
    """Type a number into a line that keeps the focus, without Enter."""
    line.window().activateWindow()
    line.setFocus()
    qtbot.waitUntil(line.hasFocus)
    line.selectAll()
    qtbot.keyClicks(line, text)


def points(figure):
    return [(p.x, p.y) for p in figure.points_world]


def recorded(qtbot, session):
    settle()
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=5000)
    settle()
