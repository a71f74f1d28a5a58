"""In every workspace, with larger type and names that look like markup, nothing is cut or read as markup."""

import re
from collections.abc import Iterator

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QApplication,
    QComboBox,
    QDockWidget,
    QLabel,
    QLineEdit,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import settle
from tests.shell.conftest import leave
from workbench.document.model import Document
from workbench.document.samples.examples import example_document, examples
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import workspaces
from workbench.widgets.fields.number_field import EntryLine
from workbench.widgets.look.tips import plain_tip
from workbench.widgets.stepping.sentence_view import SentenceView

NAME = "<b>name</b>"
PAGES = ("home", "settings", "help", "keys", "about")


@pytest.fixture(scope="module")
def window(qapp: QApplication) -> Iterator[MainWindow]:
    settings = Settings()
    settings.set("large_text", True)
    settings.set("hints", False)
    made = make_window(settings)
    made.show()
    made.resize(1280, 680)
    made.attach(Session(made, example_document()))
    for _slice in made.build():
        pass
    yield made
    settings.set("large_text", False)
    made.themes.choose("system", False)
    leave(made)


def with_names(document: Document) -> Document:
    """The document with all that has a name called by one that looks like markup."""
    sheets = []
    for sheet in document.sheets:
        lists = {
            name: tuple(replace(each, name=NAME) for each in getattr(sheet, name))
            for name in ("figures", "views")
        }
        scene = sheet.scene and replace(
            sheet.scene,
            objects=tuple(replace(each, name=NAME) for each in sheet.scene.objects),
            materials=tuple(replace(each, name=NAME) for each in sheet.scene.materials),
        )
        sheets.append(replace(sheet, name=NAME, scene=scene, **lists))
    return replace(document, sheets=tuple(sheets))


def said_of(widget: QWidget) -> str:
    around = widget.parentWidget()
    return f"{type(widget).__name__} in {type(around).__name__}"


def cut(widget: QWidget) -> str:
    """What of its words a part does not show, though nothing else shows it either; empty for nothing."""
    metrics = widget.fontMetrics()
    match widget:
        case SentenceView():
            return ""  # its two lines are fixed, and its tooltip has all
        case QLabel() if widget.text() and not widget.toolTip():
            needed = widget.heightForWidth(widget.width()) if widget.wordWrap() else metrics.height()
            wide = not widget.wordWrap() and widget.sizeHint().width() > widget.width() + 1
            return widget.text() if wide or needed > widget.height() + 1 else ""
        case QComboBox():
            option = QStyleOptionComboBox()
            widget.initStyleOption(option)
            field = QStyle.SubControl.SC_ComboBoxEditField
            room = widget.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, field, widget)
            text = widget.currentText()
            whole = metrics.horizontalAdvance(text) <= room.width() + 1 or plain_tip(text) in widget.toolTip()
            return "" if whole and metrics.height() <= widget.height() else text
        case QToolButton() if widget.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly:
            return ""
        case QAbstractButton() if widget.text():
            text = re.sub("&(?!&)", "", widget.text())
            return text if metrics.horizontalAdvance(text) > widget.width() else ""
        case QLineEdit() if not isinstance(widget, EntryLine):  # which shows that it is cut
            return widget.text() if metrics.horizontalAdvance(widget.text()) > widget.width() else ""
        case QTabBar():
            return next(
                (
                    widget.tabText(k)
                    for k in range(widget.count())
                    if widget.isTabVisible(k)
                    and metrics.horizontalAdvance(widget.tabText(k)) > widget.tabRect(k).width()
                ),
                "",
            )
    return ""


def in_front(widget: QWidget) -> bool:
    """Whether it is seen: one in a dock behind other tabs is laid out beyond the window."""
    around: QWidget | None = widget
    while around is not None and not isinstance(around, QDockWidget):
        around = around.parentWidget()
    return around is None or (around.geometry().right() >= 0 and around.geometry().bottom() >= 0)


def scrolls(widget: QWidget) -> bool:
    around = widget.parentWidget()
    while around is not None and not isinstance(around, QAbstractScrollArea):
        around = around.parentWidget()
    return around is not None


def faults(window: MainWindow, place: str) -> list[str]:
    """What is wrong with the parts that are seen now."""
    found = []
    for widget in window.findChildren(QWidget):
        if not widget.isVisible() or widget.visibleRegion().isEmpty() or not in_front(widget):
            continue
        if isinstance(widget.parentWidget(), QTabBar | QDockWidget):
            continue  # Qt's own buttons
        if text := cut(widget):
            found.append(f"{place}: cut: {text!r}, {said_of(widget)}")
        elif isinstance(widget, QLabel | QAbstractButton | QComboBox) and not (
            scrolls(widget) or (isinstance(widget, QLabel) and widget.toolTip())
        ):
            seen = widget.visibleRegion().boundingRect()
            if seen.width() < widget.width() - 2 or seen.height() < widget.height() - 2:
                found.append(f"{place}: covered: {said_of(widget)}")
        if isinstance(widget, QLabel) and NAME in widget.text():
            rich = widget.textFormat() != Qt.TextFormat.PlainText and Qt.mightBeRichText(widget.text())
            found += [f"{place}: markup: {said_of(widget)}"] * rich
        if NAME in widget.toolTip():
            found.append(f"{place}: markup in a tooltip: {said_of(widget)}")
    return found


def lasting_faults(qtbot: QtBot, window: MainWindow, place: str) -> list[str]:
    """What is wrong once the answers that are made beside the interface have found their room."""
    for _turn in range(30):
        if not (found := faults(window, place)):
            return []
        qtbot.wait(100)
    return found


@pytest.mark.parametrize("page", PAGES)
def test_pages(window: MainWindow, page: str) -> None:
    window.go(page)
    settle()
    assert faults(window, page) == []


@pytest.mark.parametrize("place", [each.slug for each in workspaces()])
def test_workspaces(qtbot: QtBot, window: MainWindow, place: str) -> None:
    chosen = next(each for each in examples() if each.workspace == place or place == "display")
    window.session.new(with_names(chosen.document))
    window.enter(place)
    settle()
    sheet = window.session.sheet
    if sheet.figures:
        front = sheet.figures[-1].id
        window.session.update_state(active=front, selection=(front,), pixel=(0, 0))
    elif sheet.scene and sheet.scene.objects:
        window.session.update_state(thing=sheet.scene.objects[0].id)
    found = lasting_faults(qtbot, window, place)
    for dock in window.arrangements.docks(place):
        if not dock.isHidden():
            dock.raise_()
            settle()
            found += lasting_faults(qtbot, window, f"{place}, {dock.windowTitle()}")
    assert not found, "\n".join(sorted(set(found)))
