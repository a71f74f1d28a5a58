"""What is done for one move of a handle that is dragged: nothing twice, and nothing that stays as it was."""

from collections import Counter
from functools import wraps

import pytest

from tests.panels.by_hand import LEFT, at, keep_until_the_end, settle
from workbench.algorithms import catalogue
from workbench.document.samples.examples import example_document
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.stage import card
from workbench.rendering import raster
from workbench.session.session import Session
from workbench.widgets.canvas import handle_names, marks, surface
from workbench.widgets.look.tokens import DARK, theme


@pytest.fixture
def calls(monkeypatch):
    """How often each function that is named to ``calls.of(module, name)`` was called."""

    class Calls(Counter):
        def of(self, place, name):
            function = getattr(place, name)

            @wraps(function)
            def counted(*arguments, **named):
                self[name] += 1
                return function(*arguments, **named)

            monkeypatch.setattr(place, name, counted)

    return Calls()


@pytest.fixture
def move(qtbot):
    """Moves the upper end of the line by one pixel; it is held already, and was moved once."""
    session = Session(document=example_document())
    panel = DrawPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(850, 600)
    panel.show()
    qtbot.waitExposed(panel)
    session.update_state(selection=("f1",))
    settle()
    qtbot.mouseMove(panel.canvas, at(panel, 30, 18))
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, 30, 18))

    def once(x, y):
        qtbot.mouseMove(panel.canvas, at(panel, x, y))
        settle()

    once(33, 20)
    once.panel, once.session = panel, session
    yield once
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, 33, 20))
    session.close()
    session.deleteLater()


def test_the_sheet_is_painted_once(move, calls):
    calls.of(raster, "_below")
    move(34, 22)
    assert calls["_below"] == 1
    move(35, 22)
    assert calls["_below"] == 2


def test_what_is_said_of_a_cell_is_of_the_picture_that_is_seen(move):
    move(34, 20)
    assert "Line" in move.panel.describe(34, 20)
    assert "Line" not in move.panel.describe(33, 3)


def test_the_name_of_the_other_handle_and_the_words_beside_the_pointer_are_placed_once(move, calls):
    calls.of(handle_names, "_corners")
    calls.of(handle_names, "handle_places")
    move(34, 22)
    assert calls == {"_corners": 2, "handle_places": 1}


def test_the_canvas_asks_once_to_be_painted_and_again_after_a_fault(move, calls, qtbot, monkeypatch):
    canvas = move.panel.canvas
    calls.of(canvas, "update")
    calls.of(surface, "paint_scene")
    move(34, 22)
    assert calls == {"update": 1, "paint_scene": 1}
    with qtbot.captureExceptions() as faults, monkeypatch.context() as patched:
        patched.setattr(canvas, "scene", lambda: 1 / 0)
        move(35, 22)
    assert faults
    move(36, 22)
    assert calls == {"update": 3, "paint_scene": 2}


def test_the_card_looks_at_one_document_and_not_through_the_catalogue(move, calls):
    calls.of(card, "with_sheet")
    calls.of(catalogue, "entries")
    move(34, 22)
    assert calls == {"with_sheet": 1}
    assert [field.value() for field in move.panel.card._fields.values()] == [20, 10, 34, 22]


def test_grips_are_painted_once_for_each_look(move, calls, request):
    marks._grip.cache_clear()
    calls.of(marks, "_paint_grip")
    light = theme.current
    request.addfinalizer(lambda: theme.use(light))
    for x in (34, 35, 36):
        move(x, 22)
    assert calls["_paint_grip"] == 2
    for look in (DARK, light):
        theme.use(look)
        settle()
    assert calls["_paint_grip"] == 4
