"""The tables of continuity and of measures as a person uses them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QFontMetrics, QGuiApplication
from PySide6.QtWidgets import QAbstractButton, QApplication, QTableView
from pytestqt.qtbot import QtBot

from workbench.algorithms.curves import continuity
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.look.type_faces import code_font
from workbench.widgets.tables.continuity_table import SMOOTHINGS, ContinuityTable, Joint, holds, residual
from workbench.widgets.tables.measure_table import Measure, Measured, MeasureTable, value_text

LEFT = Qt.MouseButton.LeftButton
DISPLAY = Qt.ItemDataRole.DisplayRole
BEFORE = np.array([[0, 0], [10, 20], [30, 30], [40, 10]], float)
AFTER = {
    "C2": [[40, 10], [50, -10], [50, -60], [0, 0]],
    "C1": [[40, 10], [50, -10], [60, 0], [70, 10]],
    "G1": [[40, 10], [45, 0], [60, 0], [70, 10]],
    "C0": [[40, 10], [52, -10], [60, 0], [70, 10]],
    "": [[41, 10], [52, -10], [60, 0], [70, 10]],
}


def joint(kind: str, name: str = "P_{3}") -> Joint:
    return Joint(name, 1.0, continuity(BEFORE, AFTER[kind]))


@pytest.fixture
def table(qtbot: QtBot) -> ContinuityTable:
    made = ContinuityTable()
    qtbot.addWidget(made)
    made.set_joints([joint("C1"), joint("C0", "P_{6}"), joint("", "")])
    made.resize(360, 220)
    made.show()
    QApplication.processEvents()
    return made


def row(view: QTableView, number: int) -> list[str]:
    model = view.model()
    return [str(model.index(number, k).data()) for k in range(model.columnCount())]


def click(qtbot: QtBot, view: QTableView, number: int, column: int = 0, double: bool = False) -> None:
    place = view.visualRect(view.model().index(number, column)).center()
    qtbot.mouseClick(view.viewport(), LEFT, pos=place)
    if double:
        qtbot.mouseDClick(view.viewport(), LEFT, pos=place)
        qtbot.mouseRelease(view.viewport(), LEFT, pos=place)


@pytest.mark.parametrize(
    ("kind", "wanted"),
    [("C2", "C0 C1 C2 G0 G1 G2"), ("C1", "C0 C1 G0 G1"), ("G1", "C0 G0 G1"), ("C0", "C0 G0"), ("", "")],
)
def test_what_holds_is_what_was_measured(kind, wanted):
    found = joint(kind).continuity
    assert [one for one in ("C0", "C1", "C2", "G0", "G1", "G2") if holds(found, one)] == wanted.split()
    assert math.radians(residual(found, "G1")) == pytest.approx(found.g1)


def test_a_row_has_signs_and_residuals(table: ContinuityTable):
    first, second, third = (row(table.view, k) for k in range(3))
    assert first[0] == "P₃"
    assert third[0] == "u = 1"
    assert [cell[0] for cell in first[1:]] == ["✓", "✓", "×", "✓", "×"]
    assert second[1:3] == ["✓ 0", "× 6"]
    assert third[1] == "× 1"
    model = table.model
    tip = model.index(1, 4).data(Qt.ItemDataRole.ToolTipRole)
    angle = math.degrees(joint("C0").continuity.g1)
    assert "P₆ is not G1" in tip
    assert f"{angle:.4f}"[:5] in tip
    heads = [model.headerData(k, Qt.Orientation.Horizontal, DISPLAY) for k in range(6)]
    assert heads == ["joint", "C0 G0", "C1", "C2", "G1", "G2"]


def test_all_columns_fit_a_narrow_dock(table: ContinuityTable):
    assert table.view.horizontalHeader().length() <= table.view.viewport().width()
    for button in table.buttons.values():
        assert button.geometry().right() < table.width()


def test_choosing_and_entering_a_joint_is_told(qtbot: QtBot, table: ContinuityTable):
    selected, activated = [], []
    table.joint_selected.connect(selected.append)
    table.joint_activated.connect(activated.append)
    click(qtbot, table.view, 1)
    qtbot.keyClick(table.view, Qt.Key.Key_Down)
    qtbot.keyClick(table.view, Qt.Key.Key_Return)
    click(qtbot, table.view, 0, double=True)
    assert selected == [1, 2, 0]
    assert activated == [2, 0]
    place = table.view.visualRect(table.model.index(0, 0)).center()
    qtbot.mouseClick(table.view.viewport(), LEFT, Qt.KeyboardModifier.ControlModifier, place)
    assert selected == [1, 2, 0, -1]


def test_commands_are_offered_where_they_change_something(qtbot: QtBot, table: ContinuityTable):
    wanted = []
    table.smoothing_wanted.connect(lambda number, kind: wanted.append((number, kind)))
    assert not any(button.isEnabled() for button in table.buttons.values())
    click(qtbot, table.view, 0)
    assert {kind for kind, button in table.buttons.items() if button.isEnabled()} == {"G2", "C2"}
    click(qtbot, table.view, 1)
    for kind in SMOOTHINGS:
        qtbot.mouseClick(table.buttons[kind], LEFT)
    assert wanted == [(1, kind) for kind in SMOOTHINGS]


def test_the_selection_stays_while_the_curve_is_dragged(qtbot: QtBot, table: ContinuityTable):
    click(qtbot, table.view, 1)
    told = []
    table.joint_selected.connect(told.append)
    moved = [joint("C1"), joint("G1", "P_{6}"), joint("", "")]
    table.set_joints(moved)
    assert table.selected == 1
    assert not table.buttons["G1"].isEnabled()
    assert row(table.view, 1)[4].startswith("✓")
    assert told == []
    changed = []
    table.model.dataChanged.connect(lambda *_where: changed.append(1))
    table.set_joints(list(moved))
    assert changed == []
    table.set_joints(moved[:1])
    assert table.selected == -1
    assert told == [-1]


def test_what_is_to_be_said_is_said(qtbot: QtBot, table: ContinuityTable):
    assert "Choose a joint" in table.words.text()
    click(qtbot, table.view, 1)
    assert table.words.isHidden()
    table.say("Moved P₇ by 3 px.")
    table.set_joints([joint("C1"), joint("G1", "P_{6}"), joint("", "")])
    assert table.words.text() == "Moved P₇ by 3 px."
    table.set_joints([])
    assert "joints" in table.words.text()
    assert not table.words.isHidden()
    assert not any(button.isEnabled() for button in table.buttons.values())


def test_a_column_widens_when_a_value_outgrows_it_and_not_before(table: ContinuityTable):
    widths = [table.view.columnWidth(k) for k in range(6)]
    found = table.model.joints[1].continuity

    def become(c2):
        rows = list(table.model.joints)
        rows[1] = replace(rows[1], continuity=found._replace(c2=c2))
        table.set_joints(rows)

    become(7.0)
    assert [table.view.columnWidth(k) for k in range(6)] == widths
    become(123456.0)
    text = row(table.view, 1)[3]
    assert text == "× 123456"
    assert table.view.columnWidth(3) >= QFontMetrics(code_font(12)).horizontalAdvance(text) + 8


# Measures

MEASURES = [
    Measure("through its points", meaning="Whether the curve passes through every point"),
    Measure("distance", "px", "From the farthest point to the curve", "least"),
    Measure("degree"),
    Measure("joints"),
]
KINDS = [
    Measured("Natural", "data1", (True, 0.0, 3.0, "C2")),
    Measured("B-spline", "data2", (False, 21.4, 3.0, "C2"), "dash"),
    Measured("Hermite", "", (True, 0.0, 3.0, None)),
]


@pytest.fixture
def measures(qtbot: QtBot) -> MeasureTable:
    made = MeasureTable()
    qtbot.addWidget(made)
    made.set_rows(MEASURES, KINDS)
    made.resize(700, 240)
    made.show()
    QApplication.processEvents()
    return made


def test_kinds_are_rows_where_there_is_room(measures: MeasureTable):
    assert not measures.model.upright
    assert row(measures.view, 0) == ["✓ yes", "0", "3", "C2"]
    assert row(measures.view, 1) == ["× no", "21.4", "3", "C2"]
    assert heads(measures, Qt.Orientation.Vertical) == ["Natural", "B-spline", "Hermite"]
    assert heads(measures, Qt.Orientation.Horizontal) == measures.model.headings()
    assert row(measures.view, 2)[-1] == "–"
    assert measures.model.headings()[1] == "distance (px)"


def heads(measures: MeasureTable, orientation: Qt.Orientation) -> list[str]:
    across = orientation == Qt.Orientation.Horizontal
    count = measures.model.columnCount() if across else measures.model.rowCount()
    return [measures.model.headerData(k, orientation, DISPLAY) for k in range(count)]


def test_and_columns_where_there_is_not(measures: MeasureTable):
    lying = [row(measures.view, k) for k in range(3)]
    measures.resize(360, 400)
    QApplication.processEvents()
    assert measures.model.upright
    standing = [row(measures.view, k) for k in range(4)]
    assert [list(column) for column in zip(*standing, strict=True)] == lying
    measures.view.scrollTo(measures.model.index(0, 2))
    assert measures.view.verticalHeader().isVisible()
    assert measures.view.viewport().rect().contains(measures.view.visualRect(measures.model.index(0, 2)))
    assert heads(measures, Qt.Orientation.Horizontal) == ["Natural", "B-spline", "Hermite"]
    assert heads(measures, Qt.Orientation.Vertical) == measures.model.headings()


@given(
    st.lists(st.floats(0, 9) | st.just(math.nan), min_size=1, max_size=6),
    st.sampled_from(["least", "greatest"]),
)
def test_the_best_number_is_the_best(numbers, which):
    table = MeasureTable()
    table.set_rows([Measure("m", best=which)], [Measured(str(k), "", (n,)) for k, n in enumerate(numbers)])
    known = [n for n in numbers if not math.isnan(n)]
    found = table.model.best(0)
    if len(set(known)) < 2:
        assert found == set()
    else:
        wanted = min(known) if which == "least" else max(known)
        assert found == {k for k, n in enumerate(numbers) if n == wanted}
    table.deleteLater()


def test_entering_a_kind_is_told(qtbot: QtBot, measures: MeasureTable):
    activated = []
    measures.kind_activated.connect(activated.append)
    click(qtbot, measures.view, 2, 1, double=True)
    assert activated == [2]
    qtbot.keyClick(measures.view, Qt.Key.Key_Up)
    qtbot.keyClick(measures.view, Qt.Key.Key_Return)
    assert activated == [2, 1]
    measures.resize(360, 400)
    QApplication.processEvents()
    click(qtbot, measures.view, 0, 2, double=True)
    assert activated == [2, 1, 2]
    header = measures.view.horizontalHeader()
    place = QPoint(header.sectionViewportPosition(1) + 10, 8)
    qtbot.mouseClick(header.viewport(), LEFT, pos=place)
    qtbot.mouseDClick(header.viewport(), LEFT, pos=place)
    qtbot.mouseRelease(header.viewport(), LEFT, pos=place)
    assert activated == [2, 1, 2, 1]


def test_the_table_is_copied(qtbot: QtBot, measures: MeasureTable):
    said = []
    measures.copied.connect(said.append)
    measures.copy()
    text = QGuiApplication.clipboard().text()
    assert text.splitlines()[0].split("\t") == ["curve", *measures.model.headings()]
    assert text.splitlines()[2].split("\t") == ["B-spline", *map(value_text, KINDS[1].values)]
    assert said == ["3 rows copied."]


def test_values_change_without_losing_the_place(qtbot: QtBot, measures: MeasureTable):
    click(qtbot, measures.view, 1, 2)
    reset = []
    measures.model.modelReset.connect(lambda: reset.append(1))
    measures.set_rows(MEASURES, [KINDS[0], replace(KINDS[1], values=(False, 7.5, 3.0, "C2")), KINDS[2]])
    assert row(measures.view, 1)[1] == "7.5"
    assert reset == []
    assert measures.view.currentIndex().row() == 1


def test_with_nothing_to_compare_one_sentence_and_one_button(qtbot: QtBot, measures: MeasureTable):
    measures.set_rows(MEASURES, [], "This curve is too long to be compared.")
    assert measures.state.empty
    assert measures.state.sentence.text() == "This curve is too long to be compared."
    with qtbot.waitSignal(measures.example_wanted):
        qtbot.mouseClick(measures.state.button, LEFT)
    measures.set_rows(MEASURES, KINDS)
    assert not measures.state.empty


def test_everything_has_a_name_and_a_tooltip(table: ContinuityTable, measures: MeasureTable):
    for widget in (table, measures):
        for control in (*widget.findChildren(QAbstractButton), *widget.findChildren(QTableView)):
            if control.metaObject().className() != "QTableCornerButton":
                assert control.accessibleName()
                assert control.toolTip()


def test_the_theme_shows_in_the_tables(table: ContinuityTable, measures: MeasureTable):
    light = [table.view.grab().toImage(), measures.view.grab().toImage()]
    theme.use(DARK)
    try:
        QApplication.processEvents()
        assert table.view.grab().toImage() != light[0]
        assert measures.view.grab().toImage() != light[1]
    finally:
        theme.use(LIGHT)
