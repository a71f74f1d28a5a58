"""An exercise in Space without a mouse: a cube is added, turned, and seen in two-point perspective."""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QMenu, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import CONTROL, camera_of, scene_of, settle, shown
from workbench.document.scene.links import Rotate3D
from workbench.panels.space.projection_page import ProjectionPage


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    for page in shown(qtbot):
        page.objects.setParent(page)  # where its dock would be
        page.objects.setGeometry(500, 0, 380, 540)
        page.objects.show()
        page.window().activateWindow()
        yield page


def tab_to(qtbot: QtBot, start: QWidget, goal: QWidget) -> None:
    """By the tab key alone, from one control to another."""
    qtbot.waitUntil(lambda: QApplication.activePopupWidget() is None)
    start.window().activateWindow()
    start.setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is start)
    for _step in range(80):
        if QApplication.focusWidget() is goal:
            return
        qtbot.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
    pytest.fail(f"The tab key does not lead to {goal.accessibleName() or goal}.")


def choose_from_menu(qtbot: QtBot, button: QPushButton, text: str) -> None:
    """Open the menu of a button with the space bar, go down to an entry, and press Enter."""

    ended = []

    def go_down() -> None:
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        for _step in menu.actions():
            qtbot.keyClick(menu, Qt.Key.Key_Down)
            if menu.activeAction() is not None and menu.activeAction().text() == text:
                break
        qtbot.keyClick(menu, Qt.Key.Key_Return)
        ended.append(True)

    QTimer.singleShot(100, go_down)
    qtbot.keyClick(button, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: bool(ended), timeout=5000)


def choose_in(qtbot: QtBot, box: QComboBox, text: str) -> None:
    for _step in range(40):
        if box.currentText() == text:
            return
        qtbot.keyClick(box, Qt.Key.Key_Down if box.currentIndex() < box.findText(text) else Qt.Key.Key_Up)


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
def test_a_cube_is_added_turned_and_seen_in_two_point_perspective(qtbot: QtBot, page: ProjectionPage) -> None:
    objects = page.objects
    qtbot.keyClick(page.eye, Qt.Key.Key_1)  # from the front: something else than what is chosen below
    settle(qtbot, page)
    tab_to(qtbot, page.eye, objects.add)
    choose_from_menu(qtbot, objects.add, "Cube")
    settle(qtbot, page)
    cube = scene_of(page).objects[-1]
    assert cube.name == "Cube"
    assert page.session.state.thing == cube.id
    qtbot.waitUntil(lambda: len(objects.fields.widget().findChildren(QPushButton)) == 1)
    (add,) = objects.fields.widget().findChildren(QPushButton)
    assert add.text() == "Add a transform"
    tab_to(qtbot, objects.add, add)
    choose_from_menu(qtbot, add, "Rotate")
    settle(qtbot, page)
    (turn,) = scene_of(page).objects[-1].transforms
    field = objects.fields.fields[f"{turn.id}/angle"].field
    tab_to(qtbot, objects.add, field)
    field.selectAll()
    qtbot.keyClicks(field, "60/2")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    settle(qtbot, page)
    (turn,) = scene_of(page).objects[-1].transforms
    assert isinstance(turn, Rotate3D)
    assert turn.angle == 30.0
    matrix = scene_of(page).objects[-1].matrix
    assert matrix is not None
    assert np.allclose(matrix[0, :3], (np.cos(np.pi / 6), 0, np.sin(np.pi / 6)))
    tab_to(qtbot, page.eye, page.card.kind)
    choose_in(qtbot, page.card.kind, "Isometric")
    settle(qtbot, page)
    assert camera_of(page).projection == "isometric"
    choose_in(qtbot, page.card.kind, "Two-point perspective")
    settle(qtbot, page)
    assert camera_of(page).projection == "perspective"
    assert [axis for axis, _place in page.eye.vanishing()] == [0, 2]


def test_the_cursor_of_a_view_chooses_an_object(qtbot: QtBot, page: ProjectionPage) -> None:
    page.session.update_state(thing="")
    settle(qtbot, page)
    for view in (page.eye, page.outside):
        assert view.accessibleName()
        assert view.focusPolicy() & Qt.FocusPolicy.TabFocus
        view.setFocus()
        qtbot.keyClick(view, Qt.Key.Key_Left, CONTROL)
        qtbot.keyClick(view, Qt.Key.Key_Right, CONTROL)
        assert view.cursor_at is not None
        assert view.cursor_at.toPoint() == view.rect().center()
    qtbot.keyClick(page.eye, Qt.Key.Key_Return)
    settle(qtbot, page)
    assert page.session.state.thing == "o1"  # the house is in the middle


def test_every_control_of_the_page_has_a_name(page: ProjectionPage) -> None:
    for part in (page, *(part for _name, _title, part, _area in page.docks())):
        for control in part.findChildren(QWidget):
            if control.focusPolicy() & Qt.FocusPolicy.TabFocus and isinstance(
                control, QAbstractButton | QComboBox
            ):
                text = control.text() if isinstance(control, QAbstractButton) else ""
                assert control.accessibleName() or text, control
