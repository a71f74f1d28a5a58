"""Every key does its command once, wherever the focus is."""

from collections import Counter
from functools import partial

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit, QPlainTextEdit, QTableView, QToolButton, QWidget

from tests.shell.keys.focus import press, settle, work_in
from workbench.shell.actions import commands
from workbench.shell.command_palette import offers
from workbench.shell.window import MainWindow
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.tube.view import TubeView

# What a line that is typed into keeps for itself.
TYPED = {",", ".", "D", "A", "Shift+A", "Shift+I", "T", "?", "Ctrl+C", "Ctrl+V", "Ctrl+X", "R"}


def places_of_focus(window: MainWindow, place: str) -> dict[str, QWidget]:
    """One part of each kind that can have the focus there, by what it is."""
    if place in ("home", "settings"):
        return {place: window._pages[place]}
    for dock in window.arrangements.docks(place):
        dock.show()
        dock.raise_()
        settle()
    parts: dict[str, QWidget] = {}
    for widget in window.findChildren(QWidget):
        if not widget.isVisible() or not widget.isEnabled() or widget.focusPolicy() == Qt.FocusPolicy.NoFocus:
            continue
        kinds = (PixelCanvas, TubeView, QTableView, QPlainTextEdit, QLineEdit, QToolButton)
        kind = next((each.__name__ for each in kinds if isinstance(widget, each)), "")
        if kind:
            name = widget.accessibleName() if kind in ("QTableView", "QLineEdit") else ""
            parts.setdefault(f"{kind} {name}".strip(), widget)
    return parts


@pytest.mark.parametrize("place", ["home", "settings", "draw", "fill", "clip", "curves", "display"])
def test_every_key_of_the_window_does_its_command_once(
    window: MainWindow, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in(window, place)
    done: list[str] = []
    monkeypatch.setattr(window, "do", lambda command: done.append(command.id))
    for name, widget in places_of_focus(window, place).items():
        for command in commands():
            for key in command.keys:
                dock = widget.parentWidget()
                if not widget.isVisible() and dock is not None:
                    window.arrangements.bring_forward(_dock_of(window, place, widget))
                widget.setFocus()
                assert widget.hasFocus() or widget.focusProxy() is not None, (place, name)
                done.clear()
                press(widget, key)
                expected = [] if isinstance(widget, QLineEdit) and key in TYPED else [command.id]
                assert done == expected, (place, name, key)
                if isinstance(widget, QLineEdit):
                    widget.undo()
                    widget.setModified(False)


def _dock_of(window: MainWindow, place: str, widget: QWidget) -> str:
    docks = window.arrangements.docks(place)
    return next(dock.objectName() for dock in docks if dock.isAncestorOf(widget))


@pytest.mark.parametrize("place", ["draw", "fill", "clip", "curves"])
def test_every_key_of_a_canvas_does_its_command_once(window: MainWindow, place: str) -> None:
    work_in(window, place)
    panel = window.panels(place)[0]
    panel.select_all()
    settle()
    done: Counter[str] = Counter()

    def note(name: str, *_checked: bool) -> None:
        done[name] += 1

    actions = [action for action in panel.actions() if not action.shortcut().isEmpty()]
    for action in actions:
        action.triggered.disconnect()
        action.triggered.connect(partial(note, action.objectName()))
    for action in actions:
        action.setEnabled(True)
        panel.canvas.setFocus()
        done.clear()
        press(panel.canvas, action.shortcut().toString())
        assert done == {action.objectName(): 1}, (place, action.shortcut().toString())
    entry = window.panels(place)[1].step_bar.bar.jump
    for action in actions:
        entry.setFocus()
        done.clear()
        press(entry, action.shortcut().toString())
        assert sum(done.values()) <= 1
        if len(action.shortcut().toString()) == 1:
            assert not done, action.shortcut().toString()


def test_a_panel_that_is_not_seen_answers_no_keys(window: MainWindow) -> None:
    work_in(window, "draw")
    work_in(window, "fill")
    session, (hidden, seen) = window.session, (window.panels(place)[0] for place in ("draw", "fill"))
    seen.choose_tool("select")
    session.update_state(selection=(session.sheet.figures[0].id,))
    settle()
    hidden.refresh()
    count = len(session.sheet.figures)
    seen.canvas.setFocus()
    press(seen.canvas, "Ctrl+D")
    settle()
    assert len(session.sheet.figures) == count + 1


def test_keys_stand_for_one_command_wherever_one_has_been(window: MainWindow) -> None:
    for slug in window.workspace_slugs:
        for _made in window.prepare(slug):
            pass
    pages = [(slug, "") for slug in window.workspace_slugs if slug != "space"]
    pages += [("space", "space"), ("space", "visibility")]
    for slug, page in (*pages, *pages):
        window.go(slug)
        window.panels(slug)[0].show_page(page)
        settle()
        able = [action for action in window.actions() if action.isEnabled()]
        times = Counter(key.toString() for action in able for key in action.shortcuts())
        assert [key for key, count in times.items() if count > 1] == [], (slug, page)
        others = [window.panels(other)[0] for other in window.workspace_slugs if other != slug]
        assert [a.objectName() for panel in others for a in panel.actions() if a.isEnabled()] == []


@pytest.mark.parametrize("place", ["draw", "fill", "clip", "curves"])
def test_what_is_selected_is_transformed_from_the_menu_and_the_list_of_commands(
    window: MainWindow, place: str
) -> None:
    work_in(window, place)
    panel, session = window.panels(place)[0], window.session
    panel.choose_tool("select")
    figure = session.sheet.figures[0]
    session.update_state(selection=(figure.id,), active=figure.id)
    settle()
    menu = window.menus._transforms
    menu.aboutToShow.emit()
    names = [action.text() for action in menu.actions()]
    assert names[:3] == ["Transform box", "Rotate 90° left", "Rotate 90° right"]
    assert [action.isEnabled() for action in menu.actions()] == [True] * 5 + [False] * 2
    before = session.document
    menu.actions()[1].trigger()
    settle()
    assert session.document != before
    offered = {offer.text: offer for offer in offers(window)}
    offered["Rotate 90° right"].act()
    settle()
    after = session.sheet.figures[0]
    for old, new in zip(figure.points_world, after.points_world, strict=True):
        assert (new.x, new.y) == pytest.approx((old.x, old.y))
    window.go("home")
    menu.aboutToShow.emit()
    assert [action.isEnabled() for action in menu.actions()] == [False]
