"""What is said and typed beside the box: commands, numbers, and the notes of the card."""

import math

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu

from tests.panels.stage.boxed import ELLIPSE, LEFT, LINE, POLYGON, SHIFT, TURNED, choose, moved, seen, settle
from workbench.document.transforms.links import Rotate, Scale, Shear


def test_four_quarter_turns_are_none_and_two_flips_are_none_bit_for_bit(opened):
    panel = opened(LINE, ELLIPSE, POLYGON)
    session = panel.session
    before, names = session.document, set()
    for left in (True, True, True, True, False, True):
        panel.boxing.turn(left)
        names.add(session.undo_stack.undoText())
        for figure in session.sheet.figures:
            assert all(p.x.is_integer() and p.y.is_integer() for p in figure.points_world)
    assert session.document == before
    for axis in ("x", "y"):
        panel.boxing.flip(axis)
        assert session.document != before
        names.add(session.undo_stack.undoText())
        panel.boxing.flip(axis)
        assert session.document == before
    assert names == {"Rotate 90°", "Flip horizontally", "Flip vertically"}


def test_commands_are_there_without_the_box_in_menus_and_for_keys(qtbot, opened):
    panel = opened(LINE)
    panel.choose_tool("select")
    settle()
    menus = [action.menu() for action in panel.canvas.actions() if isinstance(action.menu(), QMenu)]
    assert [action.objectName() for action in menus[0].actions()] == [
        action.objectName() for action in panel.transforming()
    ]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_H, SHIFT)
    settle()
    assert [(p.x, p.y) for p in panel.session.sheet.figures[0].points_world] == [(35.0, 10.0), (20.0, 18.0)]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_T, Qt.KeyboardModifier.ControlModifier)
    settle()
    assert panel.boxing.on


def test_numbers_that_are_typed_act_once_about_the_pivot(qtbot, opened):
    panel = opened(POLYGON)
    form, session = panel.card.form, panel.session
    assert form.isVisibleTo(panel.card)
    old = seen(session.sheet, session.sheet.figures[0])
    x, y = panel.boxing.pivot_world
    cos, sin = math.cos(math.radians(30)), math.sin(math.radians(30))
    matrices = {
        "tx": ("3", np.array([[1, 0, 3], [0, 1, 0]])),
        "angle": ("30", np.array([[cos, -sin, x - cos * x + sin * y], [sin, cos, y - sin * x - cos * y]])),
        "sy": ("-2", np.array([[1, 0, 0], [0, -2, 3 * y]])),
        "sh_x": ("0.5", np.array([[1, 0.5, -0.5 * y], [0, 1, 0]])),
    }
    for name, (text, matrix) in matrices.items():
        field = form.fields[name]
        neutral = field.value()
        field.field.setFocus()
        field.field.selectAll()
        qtbot.keyClicks(field.field, text)
        qtbot.keyClick(field.field, Qt.Key.Key_Return)
        settle()
        assert np.allclose(seen(session.sheet, session.sheet.figures[0]), moved(matrix, old)), name
        assert field.value() == neutral
        assert session.undo_stack.count() == 1
        session.undo_stack.undo()
        settle()


def test_a_number_that_is_scrubbed_is_one_step_about_one_pivot(opened):
    panel = opened(POLYGON)
    session = panel.session
    old = seen(session.sheet, session.sheet.figures[0])
    x, y = panel.boxing.pivot_world
    field = panel.card.form.fields["sx"]
    for factor in (1.1, 1.5, 2.0):
        field.set_value(factor)
        field.scrubbed.emit(factor)
        settle()
    field.scrub_ended.emit()
    settle()
    assert session.undo_stack.count() == 1
    assert np.allclose(
        seen(session.sheet, session.sheet.figures[0]), (old - (x, y)) * (2, 1) + (x, y), atol=1e-9
    )
    assert field.value() == 1.0
    assert y == panel.boxing.pivot_world[1]


def test_the_card_bakes_and_removes_chains_or_says_why_not(qtbot, opened):
    chain = (Rotate("", angle=90.0), Scale("", sx=2.0, on=False))
    panel = opened(LINE, TURNED)
    session = panel.session
    panel.choose_tool("select")
    choose(panel, 1)
    said = []
    panel.hover_text.connect(said.append)
    before = session.document
    qtbot.mouseClick(panel.card.chain.bake, LEFT)
    assert session.document == before
    assert "its transforms stay" in said[-1]
    qtbot.mouseClick(panel.card.chain.removal, LEFT)
    settle()
    assert session.sheet.figures[1].transforms == ()
    assert session.undo_stack.undoText() == "Remove transforms"
    assert not panel.card.chain.isVisibleTo(panel.card)

    line = opened(replace(LINE, transforms=chain))
    line.choose_tool("select")
    settle()
    assert line.card.chain.links.text() == "Transforms: Rotate, Scale (off)"
    old = seen(line.session.sheet, line.session.sheet.figures[0])
    line._actions["bake"].trigger()
    settle()
    (figure,) = line.session.sheet.figures
    assert np.allclose(seen(line.session.sheet, figure), old)
    assert [type(link) for link in figure.transforms] == [Scale]
    assert line.session.undo_stack.undoText() == "Bake transforms"


def test_a_flattened_figure_says_so_on_its_card(opened):

    flat = replace(LINE, transforms=(Scale("", sx=0.0), Shear("", sh_y=1.0)))
    panel = opened(flat)
    panel.choose_tool("select")
    settle()
    assert panel.card.chain.flat.isVisibleTo(panel.card)
    assert "flatten" in panel.card.chain.flat.text()
