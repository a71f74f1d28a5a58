"""The docks of every workspace under rough handling: entered again and again, their tabs dragged about."""

import random
import sys
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSize, Qt
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QLabel,
    QLineEdit,
    QScrollArea,
    QStackedWidget,
    QTabBar,
    QWidget,
)
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.shared.tube_dock import TubeDock
from workbench.session.session import Session
from workbench.shell.arrangement import Arrangements
from workbench.shell.dock_area import DockArea
from workbench.shell.hints import Hints
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import panel_of
from workbench.widgets.plots.library import library


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    window.attach(Session(window, example_document()))
    qtbot.waitExposed(window)
    yield window
    window.close()
    window.deleteLater()
    QApplication.processEvents()


def area(window: MainWindow) -> DockArea:
    """The area of the workspace that is shown."""
    there = window.arrangements.area(window.place)
    assert there is not None
    return there


def tab_bars(window: MainWindow) -> list[QTabBar]:
    """The bars of tabbed docks that are seen."""
    bars = area(window).findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
    return [bar for bar in bars if bar.isVisible() and bar.geometry().intersects(area(window).rect())]


def settle(times: int = 4) -> None:
    while library.busy:
        QTest.qWait(5)
    for _turn in range(times):
        QApplication.processEvents()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def test_switches_leave_the_number_of_widgets_unchanged(qtbot: QtBot, window: MainWindow) -> None:
    slugs = window.workspace_slugs
    library.ask()
    qtbot.waitUntil(lambda: "pyqtgraph" in sys.modules and library._there, timeout=30_000)
    counts: list[tuple[int, int]] = []
    # What a first run makes when it ends comes late where kernels still compile; what each switch left would
    # never come to an end.
    for _round in range(25):
        for slug in slugs:
            window.go(slug)
            settle()
        for slug in slugs:
            window.go(slug)
        settle()
        counts.append((len(window.findChildren(QWidget)), len(QApplication.allWidgets())))
        if len(counts) > 4 and len(set(counts[-4:])) == 1:
            return
    pytest.fail(f"after each round of switches, widgets of the window and of all: {counts}")


def test_resetting_leaves_the_number_of_widgets_unchanged(window: MainWindow) -> None:
    window.go("curves")
    for _first in range(2):
        window.reset_workspace()
        settle()
    before = len(QApplication.allWidgets())
    for _again in range(4):
        window.reset_workspace()
        settle()
    assert len(QApplication.allWidgets()) == before


@pytest.mark.parametrize("size", [(1280, 680), (960, 540), (1400, 900)])
def test_no_workspace_paints_the_tabs_of_another(window: MainWindow, size: tuple[int, int]) -> None:
    window.resize(*size)
    for slug in ("draw", "curves", "draw", "fill", "clip", "draw"):
        window.go(slug)
        settle()
        titles = {dock.windowTitle() for dock in area(window).docks}
        bars = tab_bars(window)
        for bar in bars:
            assert {bar.tabText(k) for k in range(bar.count())} <= titles
        seen = [text for bar in bars for text in (bar.tabText(k) for k in range(bar.count()))]
        assert len(seen) == len(set(seen))
        for one in bars:
            for other in bars:
                assert one is other or not one.geometry().intersects(other.geometry())


class Resized(QLabel):
    """Keeps the sizes that it is given."""

    def __init__(self) -> None:
        super().__init__("part")
        self.sizes: list[QSize] = []

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.sizes.append(event.size())


@pytest.mark.parametrize("kept", [False, True])
def test_docks_are_not_laid_out_again_and_again_on_the_way_in(qtbot: QtBot, kept: bool) -> None:
    stack = QStackedWidget()
    qtbot.addWidget(stack)
    stack.resize(1200, 700)
    stack.addWidget(QWidget())
    stack.show()
    right = Qt.DockWidgetArea.RightDockWidgetArea
    settings = Settings()
    for _time in range(1 + kept):
        arrangements = Arrangements(stack, settings)
        parts = [Resized() for _part in range(5)]
        docks = [(f"d{n}", f"D{n}", part, right) for n, part in enumerate(parts)]
        steps = sum(1 for _step in arrangements.add("some", QLabel("middle"), docks, ("d3", "d4")))
        assert steps == len(docks)  # each comes into the window in a step of its own
        assert arrangements.show("some")
        settle()
        assert max(len(part.sizes) for part in parts) <= 3
        upper, lower = arrangements.docks("some")[0], arrangements.docks("some")[3]
        assert upper.width() == lower.width() == pytest.approx(0.36 * 1200, abs=6)
        assert upper.height() > lower.height()
        arrangements.leave()


def drag(bar: QTabBar, start: QPoint, places: list[QPoint]) -> None:
    """Press on a tab, move over ``places`` (global), release."""

    def send(kind: QEvent.Type, at: QPoint, held: bool) -> None:
        local = bar.mapFromGlobal(at)
        buttons = Qt.MouseButton.LeftButton if held else Qt.MouseButton.NoButton
        button = Qt.MouseButton.NoButton if kind is QEvent.Type.MouseMove else Qt.MouseButton.LeftButton
        event = QMouseEvent(
            kind, QPointF(local), QPointF(at), button, buttons, Qt.KeyboardModifier.NoModifier
        )
        target: QWidget = QWidget.mouseGrabber() or bar
        if target is not bar:
            event = QMouseEvent(
                kind,
                QPointF(target.mapFromGlobal(at)),
                QPointF(at),
                button,
                buttons,
                Qt.KeyboardModifier.NoModifier,
            )
        QApplication.sendEvent(target, event)
        QApplication.processEvents()

    first = bar.mapToGlobal(start)
    send(QEvent.Type.MouseButtonPress, first, True)
    for place in places:
        send(QEvent.Type.MouseMove, place, True)
    send(QEvent.Type.MouseButtonRelease, places[-1], False)


@pytest.mark.qt_log_ignore("does not support raise", "does not support grabbing", extend=True)
@pytest.mark.parametrize("seed", range(2))
def test_tabs_are_dragged_onto_one_another_and_away(window: MainWindow, seed: int) -> None:
    chance = random.Random(seed)
    for _round in range(14):
        window.go(chance.choice(window.workspace_slugs))
        settle()
        bars = tab_bars(window)
        assert all(bar.count() > 1 for bar in bars)
        if not bars:
            window.reset_workspace()
            continue
        bar = chance.choice(bars)
        tab = bar.tabRect(chance.randrange(bar.count())).center()
        if chance.random() < 0.5:
            ends = [bar.mapToGlobal(bar.tabRect(chance.randrange(bar.count())).center())]
        else:
            box = window.geometry()
            ends = [
                QPoint(chance.randrange(box.left(), box.right()), chance.randrange(box.top(), box.bottom()))
            ]
        begin = bar.mapToGlobal(tab)
        drag(bar, tab, [begin + (end - begin) * k / 6 for end in ends for k in range(1, 7)])
        if chance.random() < 0.2:
            chance.choice(area(window).docks).setFloating(chance.random() < 0.5)
        if chance.random() < 0.1:
            chance.choice(area(window).docks).close()
        if chance.random() < 0.1:
            window.reset_workspace()
        if chance.random() < 0.1:
            window.menus.actions["alone"].trigger()
    window.views.together()
    for slug in window.workspace_slugs:
        window.go(slug)
        window.reset_workspace()
        settle()
        assert all(dock.isVisibleTo(window) for dock in area(window).docks if not dock.isFloating())


def test_the_focus_is_kept_for_each_workspace(window: MainWindow) -> None:
    window.go("draw")
    draws = next(dock for dock in area(window).docks if dock.objectName() == "source")
    draws.raise_()
    source = draws.widget()
    source.setFocus()
    focused = window.focusWidget()
    assert focused is not None
    assert draws.isAncestorOf(focused)
    window.go("fill")
    assert not draws.isAncestorOf(window.focusWidget())
    assert area(window).isAncestorOf(window.focusWidget())
    window.go("draw")
    assert window.focusWidget() is focused


def in_front(docks: list[QDockWidget]) -> dict[str, QRect]:
    """The docks that are seen, and where."""
    return {dock.objectName(): dock.geometry() for dock in docks if not dock.visibleRegion().isEmpty()}


@pytest.mark.parametrize("where", ["canvas", "source"])
def test_a_view_alone_gives_every_dock_its_place_back(window: MainWindow, where: str) -> None:
    window.go("draw")
    settle()
    docks = area(window).docks
    (window.panels("draw")[0].center if where == "canvas" else docks[0].widget()).setFocus()
    before = in_front(docks)
    window.menus.actions["alone"].trigger()
    settle()
    assert sum(dock.isVisible() for dock in docks) == (where == "source")
    window.menus.actions["alone"].trigger()
    window.resize(1280, 680)
    settle()
    assert all(dock.isVisible() for dock in docks)
    assert in_front(docks) == before


def test_arrangements_of_an_older_version_are_dropped_once_and_said(window: MainWindow) -> None:
    window.settings._store.setValue("arrangement/draw", b"as version 2 had it")
    window.go("draw")
    assert "old layout was reset" in window.messages.text
    window.messages.dismiss()
    window.go("fill")
    assert window.messages.text == ""


def test_a_field_that_is_gone_does_not_get_the_focus_back(window: MainWindow) -> None:
    window.go("draw")
    field = QLineEdit()
    area(window).dock("source").widget().layout().addWidget(field)
    field.setFocus()
    window.go("fill")
    field.deleteLater()
    settle()
    window.go("draw")
    assert area(window).isAncestorOf(window.focusWidget())


def test_swapping_there_and_back_leaves_the_focus_and_every_dock(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    settle()
    canvas = window.panels("draw")[0].center
    canvas.setFocus()
    focused, before = window.focusWidget(), in_front(area(window).docks)
    qtbot.keyClick(window, Qt.Key.Key_T)
    settle()
    assert window.focusWidget() is focused
    assert canvas.visibleRegion().boundingRect().height() >= canvas.height() - 1
    qtbot.keyClick(window, Qt.Key.Key_T)
    settle()
    assert window.focusWidget() is focused
    assert in_front(area(window).docks) == before


def test_in_animate_the_tube_takes_the_place_of_the_canvas_alone(window: MainWindow) -> None:
    window.open_example("animate-ball")
    settle()
    panel = panel_of(window.panels("animate"), AnimatePanel)
    assert panel.isAncestorOf(panel.canvas)
    place, timeline = panel.canvas.mapTo(window, QPoint()), panel.timeline.geometry()
    size = panel.canvas.size()
    window.views.swap()
    settle()
    tube = area(window).findChild(TubeDock)
    assert tube is not None
    assert panel.isAncestorOf(tube)
    assert panel.timeline.isVisible()
    assert panel.timeline.geometry() == timeline
    assert tube.mapTo(window, QPoint()).y() <= place.y()
    assert tube.width() >= size.width()
    assert area(window).dock("tube").isAncestorOf(panel.canvas)
    window.views.swap()
    settle()
    assert panel.canvas.mapTo(window, QPoint()) == place
    assert panel.canvas.size() == size


@pytest.mark.qt_log_ignore("does not support raise", extend=True)
@pytest.mark.parametrize("name", ["source", "variables", "compare"])
def test_a_dock_that_is_made_to_float_is_on_the_screen(window: MainWindow, name: str) -> None:
    window.go("draw")
    settle()
    dock = area(window).dock(name)
    area(window).tabs.menu(dock).actions()[0].trigger()
    settle()
    assert dock.isFloating()
    assert window.geometry().intersects(dock.geometry())
    assert window.screen().availableGeometry().contains(dock.geometry().center())
    assert dock.width() >= 420


@pytest.mark.qt_log_ignore("does not support raise", "does not support grabbing", extend=True)
def test_a_tab_that_is_dragged_off_its_bar_takes_its_dock_along(window: MainWindow) -> None:
    window.go("draw")
    settle()
    bar = next(bar for bar in tab_bars(window) if bar.tabText(0) == "Source")
    dock = area(window).dock("source")
    begin = bar.tabRect(0).center()
    away = bar.mapToGlobal(begin) - QPoint(500, -200)
    drag(bar, begin, [bar.mapToGlobal(begin) + QPoint(-4, 3), bar.mapToGlobal(begin) + QPoint(-60, 80), away])
    settle()
    assert dock.isFloating()
    assert dock.isVisible()
    assert (dock.geometry().center() - away).manhattanLength() < dock.width() + dock.height()
    assert [each.objectName() for each in area(window).docks if each.isFloating()] == ["source"]


def test_a_hint_does_not_outlive_the_docks_that_it_points_at(window: MainWindow) -> None:
    window.show_hints_again()
    settle()
    assert window.findChild(Hints) is not None
    window.reset_workspace()
    settle()
    window.resize(1100, 640)
    settle()
    assert window.findChild(Hints) is None
    window.show_hints()
    assert window.findChild(Hints) is not None


@pytest.mark.parametrize("slug", ["transform", "view", "space", "animate"])
def test_in_a_low_window_no_dock_lies_over_another(window: MainWindow, slug: str) -> None:
    window.go(slug)
    settle(10)
    window.resize(952, 500)
    window.messages.say("One picture stays open beside this example.")
    settle(30)
    docks = [dock for dock in area(window).docks if not dock.visibleRegion().isEmpty()]
    assert len(docks) > 1
    for k, dock in enumerate(docks):
        for other in docks[k + 1 :]:
            assert not dock.geometry().intersects(other.geometry()), (dock.objectName(), other.objectName())


@pytest.mark.parametrize("size", [(1280, 680), (960, 540)])
def test_docks_have_their_share_of_the_width_and_nothing_in_them_is_cut_off(
    window: MainWindow, size: tuple[int, int]
) -> None:
    window.resize(*size)
    never, right = Qt.ScrollBarPolicy.ScrollBarAlwaysOff, Qt.DockWidgetArea.RightDockWidgetArea
    for slug in window.workspace_slugs:
        window.go(slug)
        settle()
        docks = area(window)
        for dock in (each for each in docks.docks if docks.dockWidgetArea(each) == right):
            dock.raise_()
            settle(2)
            assert dock.width() >= 0.3 * size[0], (slug, dock.windowTitle())
            for place in dock.findChildren(QScrollArea):
                if place.isVisible() and place.horizontalScrollBarPolicy() == never:
                    inner = place.widget().width()
                    assert inner <= place.viewport().width(), (slug, dock.windowTitle())
