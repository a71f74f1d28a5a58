"""What the tests of the page Projection do with it."""

from collections.abc import Iterator

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.scene.model import Camera, Scene
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.space.scene_view import SceneView
from workbench.session.session import Session

LEFT, MIDDLE, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.NoButton
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


def shown(qtbot: QtBot) -> Iterator[ProjectionPage]:
    """The page over the example of a house, drawn."""
    session = Session()
    session.open_example("space-house")
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 560)
    panel.show()
    qtbot.waitExposed(panel)
    page = panel.page_of("space")
    assert isinstance(page, ProjectionPage)
    settle(qtbot, page)
    yield page
    session.close()


def settle(qtbot: QtBot, page: ProjectionPage) -> None:
    """Everything is told, and both pictures are drawn."""
    page.session.flush()
    QApplication.processEvents()
    qtbot.waitUntil(lambda: not (page.eye.worker.busy or page.outside.worker.busy), timeout=20_000)


def drag(
    qtbot: QtBot,
    view: SceneView,
    start: tuple[float, float],
    by: tuple[int, int],
    button: Qt.MouseButton = LEFT,
    held: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
) -> None:
    """In four moves, as a hand does."""
    begin = QPoint(round(start[0]), round(start[1]))
    qtbot.mousePress(view, button, held, begin)
    for part in (1, 2, 3, 4):
        place = QPointF(begin) + QPointF(*by) * part / 4
        where = view.mapToGlobal(place)
        QApplication.sendEvent(view, QMouseEvent(QEvent.Type.MouseMove, place, where, NONE, button, held))
        QApplication.processEvents()
    qtbot.mouseRelease(view, button, held, begin + QPoint(*by))
    QApplication.processEvents()


def camera_of(page: ProjectionPage) -> Camera:
    scene = page.session.sheet.scene
    assert scene is not None
    return scene.camera


def scene_of(page: ProjectionPage) -> Scene:
    scene = page.session.sheet.scene
    assert scene is not None
    return scene
