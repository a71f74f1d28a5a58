"""A row of matrices as a person reads and changes it: with the pointer, with the keys, in both themes."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QAccessible, QColor, QGuiApplication, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QVBoxLayout, QWidget

from workbench.exchange.formulas.copying import latex, numpy_text, plain
from workbench.exchange.formulas.terms import Cell, Matrix, Phrase, Sign, matrix
from workbench.widgets.formulas.matrix_row import MatrixRow
from workbench.widgets.formulas.row_surface import Highlight
from workbench.widgets.look.tokens import DARK, LIGHT, theme

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
Key = Qt.Key
CORNER = "x_p(1 - cos theta) + y_p sin theta"
PRODUCT = Matrix(
    (
        (Cell("cos theta", 0.5), Cell("-sin theta", -0.25), Cell(CORNER, 4.2)),
        (Cell("0", 0.0), Cell("0", 0.0), Cell("1", 1.0)),
    ),
    "M",
)
FACTOR = matrix([[1, 0, 3], [0, 1, -2]], [["1", "0", "x_p"], ["0", "1", "y_p"]], name="T", editable=True)
TERMS = (PRODUCT, Sign("="), FACTOR, Phrase('"first product"', note=True))
X_P = (2, 0, 2)


@pytest.fixture
def row(qtbot):
    made = MatrixRow()
    qtbot.addWidget(made)
    made.set_terms(TERMS)
    made.resize(640, 120)
    with qtbot.waitActive(made):
        made.show()
        made.activateWindow()
    return made


@pytest.fixture(autouse=True)
def light():
    yield
    theme.use(LIGHT)


def middle(row, place):
    return row.cell_box(place).center().toPoint()


def value(row, place):
    return row.terms[place[0]].cells[place[1]][place[2]].value


def drag(qtbot, row, place, right, modifiers=NONE, release=True):
    at = middle(row, place)
    qtbot.mousePress(row, LEFT, modifiers, at)
    for k in (1, 2, 3, 4):
        send_move(row, at + QPoint(right * k // 4, 0), modifiers)
    if release:
        qtbot.mouseRelease(row, LEFT, modifiers, at + QPoint(right, 0))


def send_move(row, at, modifiers):
    where = QPointF(at)
    event = QMouseEvent(
        QEvent.Type.MouseMove, where, row.mapToGlobal(where), Qt.MouseButton.NoButton, LEFT, modifiers
    )
    QApplication.sendEvent(row, event)


@pytest.mark.parametrize(("modifiers", "notch"), [(NONE, 0.1), (SHIFT, 0.01), (CTRL, 1.0)])
def test_a_number_is_dragged_sideways(qtbot, row, modifiers, notch):
    sent, ended = [], []
    row.edited.connect(lambda *each: sent.append(each))
    row.edit_ended.connect(lambda: ended.append(len(sent)))
    drag(qtbot, row, X_P, 40, modifiers)
    assert sent[-1] == (*X_P, pytest.approx(3 + 10 * notch))
    assert value(row, X_P) == sent[-1][3]
    assert ended == [len(sent)]
    assert [each[3] for each in sent] == sorted(each[3] for each in sent)
    assert "0000000" not in f"{sent[-1][3]!r}"


def test_escape_brings_the_number_back(qtbot, row):
    sent = []
    row.edited.connect(lambda *each: sent.append(each[3]))
    drag(qtbot, row, X_P, -40, release=False)
    assert value(row, X_P) == 2
    with qtbot.waitSignal(row.edit_ended):
        qtbot.keyClick(row, Key.Key_Escape)
    assert value(row, X_P) == sent[-1] == 3
    with qtbot.assertNotEmitted(row.edited):
        qtbot.mouseRelease(row, LEFT, NONE, middle(row, X_P))


def test_what_is_not_to_be_changed_is_not(qtbot, row):
    with qtbot.assertNotEmitted(row.edited):
        drag(qtbot, row, (0, 0, 0), 60)
        qtbot.mouseDClick(row, LEFT, NONE, middle(row, (0, 0, 0)))
    assert not row.editor.is_open
    row.set_shows("symbols")
    with qtbot.assertNotEmitted(row.edited):
        drag(qtbot, row, X_P, 60)  # x_p is a name there, no number


def test_a_number_is_typed_where_it_stands(qtbot, row):
    qtbot.mouseDClick(row, LEFT, NONE, middle(row, (2, 1, 2)))
    assert row.editor.isVisible()
    assert row.editor.text() == "−2"
    assert row.rect().contains(row.editor.geometry())
    assert row.editor.geometry().contains(middle(row, (2, 1, 2)))
    sent = []
    row.edited.connect(lambda *each: sent.append(each))
    row.edit_ended.connect(lambda: sent.append("ended"))
    qtbot.keyClicks(row.editor, "30/4 - 1")
    qtbot.keyClick(row.editor, Key.Key_Return)
    assert sent == [(2, 1, 2, 6.5), "ended"]
    assert not row.editor.isVisible()
    assert value(row, (2, 1, 2)) == 6.5


def test_what_is_no_number_is_said_and_not_sent(qtbot, row):
    row.edit(X_P)
    with qtbot.assertNotEmitted(row.edited):
        qtbot.keyClicks(row.editor, "4 +")
        qtbot.keyClick(row.editor, Key.Key_Return)
    assert row.editor.complaint.isVisible()
    assert "not a number" in row.editor.complaint.text()
    assert not row.editor.complaint.geometry().intersects(row.editor.geometry())
    qtbot.keyClick(row.editor, Key.Key_Escape)
    assert not row.editor.isVisible()
    assert not row.editor.complaint.isVisible()
    assert value(row, X_P) == 3
    assert row.hasFocus()


@pytest.mark.parametrize("at_the_foot", [False, True])
def test_what_is_wrong_is_said_in_full_also_beside_a_low_row(qtbot, at_the_foot):
    dock = QWidget()
    column = QVBoxLayout(dock)
    row = MatrixRow()
    row.set_terms((matrix([[1.0, 2.0]], editable=True),))
    column.addStretch(1 if at_the_foot else 0)
    column.addWidget(row)
    column.addStretch(0 if at_the_foot else 1)
    qtbot.addWidget(dock)
    dock.resize(300, 260)
    with qtbot.waitActive(dock):
        dock.show()
        dock.activateWindow()
    row.edit((0, 0, 1))
    qtbot.keyClicks(row.editor, "x")
    qtbot.keyClick(row.editor, Key.Key_Return)
    said = row.editor.complaint
    assert said.isVisible()
    assert dock.rect().contains(said.geometry())
    assert said.height() >= said.heightForWidth(said.width())
    field = QRect(row.editor.mapTo(dock, QPoint()), row.editor.size())
    assert not said.geometry().intersects(field)


def test_keys_walk_through_the_cells_and_type(qtbot, row):
    row.setFocus()
    assert row.current == (0, 0, 0)
    for key in (Key.Key_Right,) * 3:
        qtbot.keyClick(row, key)
    assert row.current == (2, 0, 0)
    qtbot.keyClick(row, Key.Key_Down)
    qtbot.keyClick(row, Key.Key_Down)
    assert row.current == (2, 1, 0)
    qtbot.keyClick(row, Key.Key_Left)
    assert row.current == (0, 1, 2)
    qtbot.keyClick(row, Key.Key_End)
    with qtbot.waitSignal(row.edited) as sent:
        qtbot.keyClick(row, Key.Key_Return)
        qtbot.keyClicks(row.editor, "8")
        qtbot.keyClick(row.editor, Key.Key_Return)
    assert sent.args == [2, 1, 2, 8.0]
    assert row.hasFocus()
    with qtbot.waitSignal(row.edited) as sent:
        qtbot.keyClick(row, Key.Key_9)
        qtbot.keyClicks(row.editor, "5")
        qtbot.keyClick(row.editor, Key.Key_Return)
    assert sent.args == [2, 1, 2, 95.0]
    qtbot.keyClick(row, Key.Key_Home)
    with qtbot.waitSignal(row.cell_clicked) as clicked:
        qtbot.keyClick(row, Key.Key_Return)
    assert clicked.args == [0, 0, 0]


def test_the_cell_is_told_to_who_does_not_see_it(qtbot, row):
    row.setFocus()
    qtbot.keyClick(row, Key.Key_Right)
    qtbot.keyClick(row, Key.Key_Right)
    interface = QAccessible.queryAccessibleInterface(row)
    told = interface.text(QAccessible.Text.Name)
    assert told == "M, row 1, column 3: x_p(1 − cos θ) + y_p sin θ = 4.2"
    row.set_values({0: np.array([[0.5, -0.25, 4.3], [0, 0, 1]])})
    assert interface.text(QAccessible.Text.Name).endswith("= 4.3")


def test_a_hidden_cell_tells_nothing_and_its_click_is_reported(qtbot, row):
    cells = ((Cell("x_p", 17.0, hidden=True), Cell()),)
    row.set_terms((Matrix(cells),))
    row.setFocus()
    with qtbot.waitSignal(row.cell_clicked) as clicked:
        qtbot.mouseClick(row, LEFT, NONE, middle(row, (0, 0, 0)))
    assert clicked.args == [0, 0, 0]
    assert row.accessibleName() == "row 1, column 1: ?"
    row.copy()
    assert "17" not in QGuiApplication.clipboard().text()


def test_hovering_is_told_once_a_cell(qtbot, row):
    seen = []
    row.cell_hovered.connect(lambda *place: seen.append(place))
    row.hover_left.connect(lambda: seen.append(None))
    for at in (middle(row, (0, 0, 0)), middle(row, (0, 0, 0)) + QPoint(2, 0), middle(row, X_P), QPoint(1, 1)):
        qtbot.mouseMove(row, at)
    assert seen == [(0, 0, 0), X_P, None]


def test_the_menu_copies_and_chooses_what_is_shown(qtbot, row):
    actions = {action.text(): action for action in row.actions() if action.text()}
    for format_, text in (
        ("LaTeX", latex(TERMS, "numbers")),
        ("NumPy", numpy_text(TERMS)),
        ("text", plain(TERMS, "numbers")),
    ):
        with qtbot.waitSignal(row.copied) as said:
            actions[f"Copy as {format_}"].trigger()
        assert QGuiApplication.clipboard().text() == text
        assert format_ in said.args[0]
    with qtbot.waitSignal(row.shows_changed) as chosen:
        actions["Symbols"].trigger()
    assert chosen.args == ["symbols"]
    assert row.shows == "symbols"


@pytest.mark.parametrize("shows", ["symbols", "numbers", "both"])
@pytest.mark.parametrize("width", [640, 300, 180])
def test_a_narrow_dock_breaks_the_row_and_cuts_nothing(qtbot, shows, width):
    dock = QWidget()
    column = QVBoxLayout(dock)
    column.setContentsMargins(0, 0, 0, 0)
    row = MatrixRow()
    row.set_terms(TERMS)
    row.set_shows(shows)
    column.addWidget(row)
    column.addStretch(1)
    qtbot.addWidget(dock)
    dock.resize(width, 700)
    dock.show()
    qtbot.waitExposed(dock)
    room = row.rect()
    assert all(room.contains(row.cell_box(place).toAlignedRect()) for place in row.places)
    assert row.height() >= row.laid.height
    assert row.width() >= row.laid.width
    if shows == "both" and width == 300:
        assert row.width() == width
        assert len({row.cell_box((n, 0, 0)).top() for n in (0, 2)}) == 2


def colours(row, box):
    image = row.grab().toImage()
    box = box.toAlignedRect() & QRect(QPoint(), image.size())
    return [
        image.pixelColor(x, y).name()
        for x in range(box.left(), box.right() + 1)
        for y in range(box.top(), box.bottom() + 1)
    ]


@pytest.mark.parametrize("look", [LIGHT, DARK], ids=lambda each: each.name)
def test_highlights_show_in_both_themes(qtbot, row, look):
    theme.use(look)
    plain_row = colours(row, row.cell_box(X_P))
    row.set_highlights([Highlight(2, None, 2, "data2", "dash"), Highlight(0, 0, 2, "text", "double")])
    marked = colours(row, row.cell_box(X_P))
    data2, ground = QColor(look.data[1]).name(), QColor(look.surface).name()
    assert ground in plain_row
    assert data2 not in plain_row
    assert data2 in marked
    assert ground not in colours(row, row.cell_box((2, 1, 2)).adjusted(6, 6, -6, -6))
    assert QColor(look.text).name() in colours(row, row.cell_box((0, 0, 2)))


def test_letting_numbers_change_lays_nothing_else_out(row):
    row.set_values({2: np.array([[1, 0, -123.4567], [0, 1, -2]])})
    before = row.laid
    row.set_values({2: np.array([[1, 0, 3], [0, 1, 5]])})
    assert row.laid.cells == before.cells
    assert row.laid.height == before.height
    row.set_terms(TERMS[:1])
    row.set_terms(TERMS)
    assert row.laid.cells != before.cells  # another row begins anew


def test_other_numbers_behind_symbols_are_kept_and_copied_but_not_laid_out_anew(row):
    row.set_shows("symbols")
    before = row.laid
    row.set_terms((PRODUCT, Sign("="), FACTOR.with_values([[1, 0, 8], [0, 1, -2]]), TERMS[3]))
    assert row.laid is before
    assert value(row, X_P) == 8.0
    row.set_shows("numbers")
    assert row.laid is not before
    row.set_shows("symbols")
    row.set_terms((PRODUCT, Sign("="), matrix([[1, 0, 8], [0, 1, -2]]), TERMS[3]))
    assert row.laid.primitives != before.primitives


@pytest.mark.parametrize("held", [CTRL, Qt.KeyboardModifier.AltModifier])
def test_a_digit_with_another_key_held_is_typed_into_no_cell(qtbot, row, held):
    row.setFocus()
    row.set_current(X_P)
    QApplication.sendEvent(row, QKeyEvent(QEvent.Type.KeyPress, Key.Key_1, held, "1"))
    assert row.findChild(QLineEdit) is None or not row.findChild(QLineEdit).isVisible()
    QApplication.sendEvent(row, QKeyEvent(QEvent.Type.KeyPress, Key.Key_1, NONE, "1"))
    assert row.findChild(QLineEdit).text() == "1"
