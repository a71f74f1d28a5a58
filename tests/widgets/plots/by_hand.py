"""Plots as a hand uses them: what takes the mouse is the library's part of a plot, or the editor itself."""

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from workbench.widgets.plots.plot import Plot

LEFT = Qt.MouseButton.LeftButton


def target(part: QWidget) -> QWidget:
    """What takes the mouse."""
    return part._plot.viewport() if isinstance(part, Plot) else part


def click(qtbot: QtBot, part: QWidget, place: QPoint) -> None:
    """Press and let go at a place of the widget."""
    qtbot.mouseClick(target(part), LEFT, pos=target(part).mapFrom(part, place))


def drag(qtbot: QtBot, part: QWidget, start: QPoint, *ends: QPoint) -> None:
    """Press at a place of the widget, move over others, let go at the last."""
    taken = target(part)
    first, *others = (taken.mapFrom(part, place) for place in (start, *ends))
    qtbot.mousePress(taken, LEFT, pos=first)
    for place in others:
        qtbot.mouseMove(taken, place)
    qtbot.mouseRelease(taken, LEFT, pos=others[-1])


def send(
    part: QWidget,
    kind: QEvent.Type,
    place: QPoint,
    buttons: Qt.MouseButton = Qt.MouseButton.NoButton,
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
) -> None:
    """One event of the mouse, with just these buttons down, whatever a test before left down."""
    taken = target(part)
    spot = QPointF(taken.mapFrom(part, place))
    moves = kind == QEvent.Type.MouseMove
    button = Qt.MouseButton.NoButton if moves else LEFT
    event = QMouseEvent(kind, spot, taken.mapToGlobal(spot), button, buttons, modifiers)
    QApplication.sendEvent(taken, event)


def hover(part: QWidget, place: QPoint) -> None:
    """Move the pointer with no button down."""
    send(part, QEvent.Type.MouseMove, place)
