"""A Curves panel and the hand that works in it: presses, moves and releases, with modifiers."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.edits import add_figure
from workbench.document.model import Curve, CurvePoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.curves.panel import CurvesPanel
from workbench.session.session import Session

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
PLAIN = Qt.KeyboardModifier.NoModifier
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
ZIGZAG = ((26.0, 10.0), (32.0, 34.0), (40.0, 40.0), (46.0, 12.0), (58.0, 30.0))


def opened(qtbot, *curves):
    session = Session(document=blank_sheet(64, 48))
    for curve in curves:
        session.apply(add_figure(session.sheet.id, curve), "Draw")
    session.undo_stack.clear()
    panel = CurvesPanel(session)
    session.setParent(panel)  # goes with it, as with the window of the program
    keep_until_the_end(qtbot, panel)
    panel.resize(1000, 640)
    panel.show()
    qtbot.waitExposed(panel)
    figures = session.sheet.figures
    if figures:
        session.update_state(active=figures[-1].id, selection=(figures[-1].id,))
    settle()
    return panel


def curve_through(*places, spline="b_spline", **attributes):
    points = tuple(CurvePoint("", x, y) for x, y in places)
    return Curve("", points, "bresenham_line", 1, spline=spline, **attributes)


def hover(panel, x, y):
    """Move the pointer to a device point with no button down, and let the panel follow."""
    place = panel.canvas.widget_position(x, y)
    where = panel.canvas.mapToGlobal(place)
    move = QMouseEvent(QEvent.Type.MouseMove, place, where, NONE, NONE, PLAIN)
    QApplication.sendEvent(panel.canvas, move)
    panel.refresh()
    settle()


def send(panel, kind, x, y, modifiers=PLAIN):
    """A mouse event at a device point with modifiers, which qtbot.mouseMove cannot send."""
    place = panel.canvas.widget_position(x, y)
    button = NONE if kind == QEvent.Type.MouseMove else LEFT
    buttons = NONE if kind == QEvent.Type.MouseButtonRelease else LEFT
    where = panel.canvas.mapToGlobal(place)
    QApplication.sendEvent(panel.canvas, QMouseEvent(kind, place, where, button, buttons, modifiers))
    settle()


def drag(panel, start, *ways, modifiers=PLAIN):
    send(panel, QEvent.Type.MouseButtonPress, *start, modifiers)
    for way in ways:
        send(panel, QEvent.Type.MouseMove, *way, modifiers)
    send(panel, QEvent.Type.MouseButtonRelease, *ways[-1], modifiers)


def click(panel, x, y, modifiers=PLAIN):
    send(panel, QEvent.Type.MouseButtonPress, x, y, modifiers)
    send(panel, QEvent.Type.MouseButtonRelease, x, y, modifiers)


def the_curve(panel):
    (figure,) = panel.session.sheet.figures
    assert isinstance(figure, Curve)
    return figure


def places(panel):
    return [(p.x, p.y) for p in the_curve(panel).points_world]
