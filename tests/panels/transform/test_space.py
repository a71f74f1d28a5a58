"""The page of Transform about space: the numbers of the course, by card, key and step, and refusals."""

import math

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QComboBox, QLineEdit

from tests.panels.by_hand import settle
from tests.panels.transform.hand import type_into
from workbench.algorithms.transforms import rotation_by_quaternion, transform_points
from workbench.algorithms.transforms.axis import STEP_NAMES
from workbench.document.samples.examples import example
from workbench.document.scene.links import Reflect3D, Rotate3D, Scale3D, Shear3D, Translate3D
from workbench.exchange.formulas.terms import Matrix, Phrase
from workbench.exchange.written import FORMATS
from workbench.panels.transform.panel import TransformPanel
from workbench.panels.transform.space_scene import scene_of
from workbench.rendering.subjects.registry import calls_of
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=example("transform-axis").document)
    yield made
    made.close()


@pytest.fixture
def panel(qtbot, session):
    made = TransformPanel(session)
    for part in (made, made.chains):
        qtbot.addWidget(part)
        part.resize(900, 620)
        part.show()
    made.show_page("space")
    settle()
    qtbot.waitUntil(lambda: session.run.done)
    settle()
    return made


def thing(session):
    return session.sheet.scene.objects[0]


def shown(panel, name):
    """The last matrix in the row that begins with a name."""
    row = next(row for row in panel.space.matrices.rows if row.terms[0] == Phrase(name, strong=True))
    cells = [term for term in row.terms if isinstance(term, Matrix)][-1].cells
    return np.array([[cell.value for cell in line] for line in cells])


def go(panel, session, step):
    session.update_state(step=step)
    session.flush()
    settle()
    panel.space.chain.stage_pointed.emit(None)  # the pointer may rest where a card is now
    settle()


def test_the_whole_is_the_quaternion_and_takes_the_point_of_the_course_to_its_place(panel):
    whole = shown(panel, "M")
    np.testing.assert_allclose(whole, rotation_by_quaternion(np.pi / 2, (1, 0, 1), (2, 2, 3)), atol=1e-12)
    image = transform_points(whole, np.array([[3.0, 1.0, 1.0]]))[0]
    assert np.round(image, 4).tolist() == [0.7778, 2.2222, 0.8889]
    told = [term.formula for term in panel.space.matrices.rows[-1].terms if isinstance(term, Phrase)]
    assert '"(0.7071, 0.2357, 0.4714, 0.4714)"' in told
    assert '"the same R"' in told


@pytest.mark.parametrize("step", range(8))
def test_each_step_of_the_run_is_a_stage_of_the_picture(panel, session, step):
    go(panel, session, step)
    scene = scene_of(thing(session), session.subject, panel.space.step)
    assert panel.space.step == step
    (call,) = calls_of(session.sheet, session.subject)
    places = np.array(list(call.entry.function(*call.arguments)))
    np.testing.assert_allclose(scene.way[1:], [call.arguments[1:4], *places[:step]], atol=1e-12)
    along = scene.axis[1] - scene.axis[0]
    if 3 <= step <= 4:  # the axis lies on z
        np.testing.assert_allclose(scene.axis[0], 0.0, atol=1e-12)
        np.testing.assert_allclose(along / 3.0, (0.0, 0.0, 1.0), atol=1e-12)
    if step in (0, 7):
        np.testing.assert_allclose(scene.axis, [(1, 0, 1), (2, 2, 3)], atol=1e-12)
    assert (scene.stage is None) == (step in (0, 7))
    whole = rotation_by_quaternion(np.pi / 2, (1, 0, 1), (2, 2, 3))
    np.testing.assert_allclose(scene.image, transform_points(whole, scene.made), atol=1e-12)


@pytest.mark.parametrize("step", range(1, 8))
def test_the_matrix_of_the_step_stands_beside_its_symbols(panel, session, step):
    go(panel, session, step)
    name = STEP_NAMES[step - 1]
    row = next(row for row in panel.space.matrices.rows if row.terms[0] == Phrase(name, strong=True))
    symbols, numbers = [term for term in row.terms if isinstance(term, Matrix)][:2]
    a, b, c, d = 1 / 3, 2 / 3, 2 / 3, math.sqrt(8) / 3  # along (1, 2, 2); the turn is by 90 degrees
    worth = {"a": a, "d": d, "b/d": b / d, "c/d": c / d, "cos θ": 0, "sin θ": 1, "x_1": 1, "y_1": 0, "z_1": 1}
    for line, values in zip(symbols.cells, numbers.cells, strict=True):
        for cell, value in zip(line, values, strict=True):
            sign, text = (-1, cell.symbol[1:]) if cell.symbol.startswith("−") else (1, cell.symbol)
            assert value.value == pytest.approx(sign * float(worth.get(text, text)), abs=1e-12)
    named = next(row for row in panel.space.matrices.rows if row.terms[0].formula == "R")
    assert [term.formula for term in named.terms if isinstance(term, Phrase) and term.strong] == ["R", name]


def test_a_number_of_the_axis_is_typed_and_taken_back(qtbot, panel, session):
    card = panel.space.chain.cards[0]
    before = session.document
    type_into(qtbot, card.fields["angle"], "180/2+30")
    assert thing(session).transforms[0].angle == 120.0
    assert session.undo_stack.count() == 1
    np.testing.assert_allclose(
        shown(panel, "M"), rotation_by_quaternion(np.radians(120), (1, 0, 1), (2, 2, 3)), atol=1e-12
    )
    session.undo_stack.undo()
    assert session.document == before


def test_an_axis_without_direction_is_refused_in_its_field(qtbot, panel, session):
    fields = panel.space.chain.cards[0].fields
    type_into(qtbot, fields["x_axis"], "0")
    type_into(qtbot, fields["y_axis"], "0")
    before = session.document
    type_into(qtbot, fields["z_axis"], "0")
    assert session.document is before
    assert "has no direction" in fields["z_axis"].complaint.text()


def test_a_mirror_without_direction_is_refused_in_its_field(qtbot, panel, session):
    dock = panel.space.chain
    for action in dock.menu.actions():
        action.trigger()
        settle()
    for card in (card for card in dock.cards if card.kind is Reflect3D):
        link = next(link for link in thing(session).transforms if link.id == card.identity)
        *others, name = (name for name in ("x_normal", "y_normal", "z_normal") if getattr(link, name))
        for other in others:
            type_into(qtbot, card.fields[other], "0")
        before = session.document
        type_into(qtbot, card.fields[name], "0")
        assert session.document is before
        assert "normal" in card.fields[name].complaint.text()


def test_every_kind_of_transform_is_added_and_a_flat_one_says_so(panel, session):
    dock = panel.space.chain
    for action in dock.menu.actions():
        action.trigger()
        settle()
    kinds = {type(link) for link in thing(session).transforms}
    assert {Translate3D, Rotate3D, Scale3D, Reflect3D, Shear3D} <= kinds
    assert len(dock.cards) == 1 + len(dock.menu.actions())
    flat = next(card for card in dock.cards if card.kind is Scale3D)
    flat.fields["sx"].edited.emit(0.0)
    settle()
    assert "flattens" in flat.complaint.text()


def test_cards_are_moved_switched_and_removed(panel, session):
    dock = panel.space.chain
    dock.menu.actions()[0].trigger()
    settle()
    first, second = thing(session).transforms
    dock.cards[1].grip.moved.emit(-1)
    settle()
    assert thing(session).transforms == (second, first)
    dock.cards[0].eye.click()
    settle()
    assert not thing(session).transforms[0].on
    dock.cards[0].bin.click()
    settle()
    assert thing(session).transforms == (first,)


def test_keys_look_round_and_follow_the_next_vertex(qtbot, panel, session):
    view = panel.space.view
    angles = view.angles
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert view.angles == (angles[0] + 5.0, angles[1])
    qtbot.keyClick(view, Qt.Key.Key_Return)
    session.flush()
    settle()
    assert session.subject.arguments["vertex"] == 1
    assert view.accessibleDescription().startswith("The vertex P is drawn at (1, 0, -1)".replace("-", "−"))


def test_each_page_has_a_position_of_its_own_and_only_its_own_commands(qtbot, panel, session):
    go(panel, session, 5)
    assert not panel._actions["delete"].isEnabled()
    assert not panel._actions["polygon"].isEnabled()
    panel.chains.buttons["plane"].click()
    settle()
    assert session.state.workspace == "transform"
    assert session.state.step == 0
    assert panel._actions["polygon"].isEnabled()
    panel._actions["page_space"].trigger()
    settle()
    assert session.state.step == 5


def test_what_can_be_given_the_focus_has_a_name(panel):
    for part in (panel.space, panel.chains):
        for kind in (QAbstractButton, QLineEdit, QComboBox):
            for widget in part.findChildren(kind):
                if widget.isVisibleTo(part) and widget.focusPolicy() != Qt.FocusPolicy.NoFocus:
                    assert widget.accessibleName() or getattr(widget, "text", str)(), widget


def test_its_derivation_is_written_with_the_drawing_and_seven_matrices(panel):
    page = panel.derivation()
    assert page is not None
    (svg,) = [each for each in FORMATS if each.kind == "derivation" and each.suffix == ".svg"]
    written: list[bytes] = []
    svg.encode(page, written.append, lambda *_progress: None)
    text = b"".join(written).decode()
    assert text.count("R") > 6
    assert "<svg" in text


def test_a_sheet_without_objects_says_so(qtbot, panel, session):
    session.new()
    settle()
    assert panel.space.empty.isVisible()
    panel.space.empty.button.click()
    settle()
    assert session.sheet.scene is not None


def test_how_high_matrices_are_to_be_does_not_depend_on_a_scroll_bar(panel):
    """It comes and goes with the height: neither would ever come to rest."""
    matrices, broken = panel.space.matrices, 0
    matrices.blockSignals(True)
    for width in range(380, 900, 8):
        panel.resize(width, 620)
        told, widths = [], []
        for height in (40, 500):
            matrices.setFixedHeight(height)
            settle()
            widths.append(matrices.viewport().width())
            told.append([matrices.height_within(room) for room in (1000, 100, 60)])
        assert told[0] == told[1], width
        broken += widths[0] < widths[1]
    assert broken  # a scroll bar took some of the width
