"""Views of a scene with names: kept, gone to, renamed and removed, by the list, the menu and the keyboard."""

from collections.abc import Iterator

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QLineEdit
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import LEFT, SHIFT, camera_of, drag, scene_of, settle, shown
from workbench.document.scene.model import Camera
from workbench.panels.space.projection_page import ProjectionPage


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    for page in shown(qtbot):
        page.named_views.setParent(page)  # where its dock would be
        page.named_views.setGeometry(0, 0, 300, 200)
        page.named_views.show()
        page.window().activateWindow()
        page.eye.setFocus()
        yield page


def names(page: ProjectionPage) -> list[str]:
    page.session.flush()
    QApplication.processEvents()
    listed = [page.named_views.list.item(row).text() for row in range(page.named_views.list.count())]
    assert listed == [view.name for view in scene_of(page).named_views]
    return listed


def type_name(qtbot: QtBot, page: ProjectionPage, text: str) -> None:
    """Into the editor that has come up in the list."""
    (editor,) = (each for each in page.named_views.list.findChildren(QLineEdit) if each.isVisible())
    editor.selectAll()
    qtbot.keyClicks(editor, text)
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    settle(qtbot, page)


def cameras(page: ProjectionPage) -> list[Camera]:
    return [view.camera for view in scene_of(page).named_views]


def test_a_view_is_named_gone_to_renamed_and_removed_by_keys(qtbot: QtBot, page: ProjectionPage) -> None:
    views, first = page.named_views, camera_of(page)
    qtbot.keyClick(page.eye, Qt.Key.Key_N, SHIFT)
    type_name(qtbot, page, "street")
    assert names(page) == ["street"]
    qtbot.keyClick(page.eye, Qt.Key.Key_7)
    settle(qtbot, page)
    above = page.looking.camera
    assert above != first
    qtbot.keyClick(page.eye, Qt.Key.Key_N, SHIFT)
    settle(qtbot, page)
    assert names(page) == ["street", "One-point perspective"]  # until it is typed over
    assert cameras(page) == [first, above]
    assert camera_of(page) == first  # the document's own view stays
    for camera in (first, above, first):
        qtbot.keyClick(page.eye, Qt.Key.Key_N)
        settle(qtbot, page)
        assert page.looking.camera == camera
    qtbot.keyClick(views.list, Qt.Key.Key_F2)
    type_name(qtbot, page, "from the gate")
    assert names(page) == ["from the gate", "One-point perspective"]
    qtbot.keyClick(views.list, Qt.Key.Key_Delete)
    assert names(page) == ["One-point perspective"]
    assert page.looking.camera == first
    for expected in (["from the gate", "One-point perspective"], ["street", "One-point perspective"]):
        page.session.undo_stack.undo()
        assert names(page) == expected


def test_a_click_on_the_list_and_an_entry_of_the_menu_go_to_a_view(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    views = page.named_views
    assert views.empty.empty
    qtbot.mouseClick(views.empty.button, LEFT)
    type_name(qtbot, page, "R & D")
    own = page.looking.camera
    page.face("left")
    settle(qtbot, page)
    views.list.clearSelection()
    place = views.list.visualItemRect(views.list.item(0)).center()
    qtbot.mouseClick(views.list.viewport(), LEFT, pos=QPoint(place))
    assert page.looking.camera == own
    page.face("left")
    views.menu.aboutToShow.emit()
    (entry,) = views.menu.actions()
    assert entry.text() == "R && D"
    entry.trigger()
    assert page.looking.camera == own
    qtbot.mouseClick(views.bin, LEFT)
    assert names(page) == []
    assert views.empty.empty


def test_an_empty_name_gives_way_to_the_old_one(qtbot: QtBot, page: ProjectionPage) -> None:
    page.named_views.name_view()
    type_name(qtbot, page, "  ")
    assert names(page) == ["Two-point perspective"]
    page.named_views.name_view()
    assert names(page) == ["Two-point perspective", "Two-point perspective 2"]


def test_without_a_scene_or_a_view_one_sentence_says_so(qtbot: QtBot, page: ProjectionPage) -> None:
    said: list[str] = []
    page.hover_text.connect(said.append)
    for act in (page.named_views.go_to_next, page.named_views.rename_view, page.named_views.remove_view):
        act()
        assert said.pop().endswith(".")
    page.session.new()
    settle(qtbot, page)
    page.named_views.name_view()
    assert "no scene" in said.pop()
    assert page.session.sheet.scene is None


def test_a_view_keeps_every_number_of_its_camera(qtbot: QtBot, page: ProjectionPage) -> None:
    oblique = replace(camera_of(page), projection="oblique", oblique_alpha=60.0, near=1.5)
    page.looking.look(oblique)
    page.named_views.name_view()
    page.looking.look(None)
    settle(qtbot, page)
    page.named_views.go_to_next()
    assert page.looking.camera == oblique


def test_views_of_one_camera_are_named_and_gone_through_one_by_one(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    views = page.named_views
    for name in ("first", "second", "third"):  # nothing is turned in between
        qtbot.keyClick(page.eye, Qt.Key.Key_N, SHIFT)
        settle(qtbot, page)
        type_name(qtbot, page, name)
        page.eye.setFocus()
    assert names(page) == ["first", "second", "third"]
    for row in (0, 1, 2, 0):
        qtbot.keyClick(page.eye, Qt.Key.Key_N)
        settle(qtbot, page)
        assert views.list.currentRow() == row


def test_a_view_without_a_name_keeps_the_one_it_had(qtbot: QtBot, page: ProjectionPage) -> None:
    said: list[str] = []
    page.named_views.said.connect(said.append)
    qtbot.keyClick(page.eye, Qt.Key.Key_N, SHIFT)
    type_name(qtbot, page, "street")
    page.named_views.rename_view()
    type_name(qtbot, page, "   ")
    assert names(page) == ["street"]
    assert said == ["A view needs a name; this one keeps the name street."]


def test_the_button_that_keeps_a_view_is_whole_in_larger_type(qtbot: QtBot, page: ProjectionPage) -> None:
    font = page.card.font()
    font.setPixelSize(20)
    for part in (page.card.note, page.card.keep):
        part.setFont(font)
    drag(qtbot, page.eye, (20, 300), (60, -30))
    settle(qtbot, page)
    assert page.card.keep.isVisible()
    assert page.card.keep.width() >= page.card.keep.sizeHint().width()
