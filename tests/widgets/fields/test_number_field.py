"""A number field as a person uses it: typing, arithmetic, stepping, scrubbing, being told what is wrong."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtWidgets import QHBoxLayout, QWidget

from workbench.widgets.fields.arithmetic import evaluate
from workbench.widgets.fields.number_field import EntryLine, NumberField, lowered, with_subscript


@given(st.integers(-999, 999), st.integers(1, 99), st.integers(-99, 99))
def test_arithmetic_is_pythons(a, b, c):
    text = f"({a} - {c})/{b} + {c}*{b} - -{abs(a)}"
    assert evaluate(text) == (a - c) / b + c * b + abs(a)


@given(st.text(max_size=12))
def test_whatever_is_typed_gives_a_finite_number_or_a_sentence(text):
    said = ""
    value = 0.0
    try:
        value = evaluate(text)
    except ValueError as problem:
        said = str(problem)
    assert math.isfinite(value)
    assert said == "" or said.endswith(".")


@pytest.mark.parametrize(
    "text", ["", "  ", "x", "1/0", "1e999", "2**9", "(1", "True", "'a'", "f(1)", "1j", "9" * 101]
)
def test_what_is_no_number_is_refused(text):
    with pytest.raises(ValueError, match=r"\.$"):
        evaluate(text)


@pytest.mark.parametrize("text", ["-0", "0", "-0.0", "0*-3", "-1e-400"])
def test_zero_has_no_sign(text):
    assert str(evaluate(text)) == "0.0"


@pytest.mark.parametrize(("text", "pointed"), [("0,5", "0.5"), (" −12,25 ", "-12.25"), (",5", ".5")])
def test_a_decimal_comma_is_answered_with_the_point(text, pointed):
    with pytest.raises(ValueError, match=rf"comma; write {re.escape(pointed)}\.$"):
        evaluate(text)
    assert evaluate(pointed) == float(pointed)


def typed(qtbot, field, text):
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)


@pytest.fixture
def field(qtbot):
    made = NumberField("x_0", "px", low=0, high=100, integer=True)
    qtbot.addWidget(made)
    made.show()
    made.set_value(20)
    return made


def test_arithmetic_can_be_typed_and_the_unit_stays(qtbot, field):
    with qtbot.waitSignal(field.edited) as sent:
        typed(qtbot, field, "30/2 px")
    assert sent.args == [15.0]
    assert field.field.text() == "15"
    assert field.unit.text() == "px"


@pytest.mark.parametrize(
    ("text", "says"),
    [("7/2", "3.5 is not whole"), ("101", "too large"), ("-1", "too small"), ("a", "not a number")],
)
def test_a_bad_value_is_said_in_place_and_not_sent(qtbot, field, text, says):
    with qtbot.assertNotEmitted(field.edited):
        typed(qtbot, field, text)
    assert field.complaint.isVisible()
    assert says in field.complaint.text()
    assert field.value() == 20
    typed(qtbot, field, "21")
    assert not field.complaint.isVisible()
    assert field.value() == 21


def test_arrows_step_and_escape_brings_back(qtbot, field):
    field.field.setFocus()
    qtbot.keyClick(field.field, Qt.Key.Key_Up)
    assert field.value() == 21
    qtbot.keyClick(field.field, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert field.value() == 11
    qtbot.keyClicks(field.field, "99")
    qtbot.keyClick(field.field, Qt.Key.Key_Escape)
    assert field.field.text() == "11"


def test_the_label_scrubs_within_the_range(qtbot, field):
    seen = []
    field.scrubbed.connect(seen.append)
    at = QPoint(5, 5)
    qtbot.mousePress(field.label, Qt.MouseButton.LeftButton, pos=at)
    qtbot.mouseMove(field.label, at + QPoint(20, 0))
    assert field.value() == 25
    qtbot.mouseMove(field.label, at + QPoint(2000, 0))
    with qtbot.waitSignal(field.scrub_ended):
        qtbot.mouseRelease(field.label, Qt.MouseButton.LeftButton, pos=at)
    assert seen == [25.0, 100.0]


def test_names_get_real_subscripts():
    assert with_subscript("x_0") == "x<sub>0</sub>"
    assert with_subscript("r") == "r"
    assert with_subscript("a<b") == "a&lt;b"


def test_a_field_that_is_entered_by_tab_is_typed_over_although_its_neighbour_was_edited(qtbot):
    window = QWidget()
    row = QHBoxLayout(window)
    first, second = NumberField("x_0"), NumberField("y_0")
    for each in (first, second):
        row.addWidget(each)
    second.set_value(42)
    # As a card shows all anew, once the picture has changed
    first.edited.connect(lambda _value: QTimer.singleShot(0, lambda: second.set_value(second.value())))
    qtbot.addWidget(window)
    window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    first.field.setFocus()
    first.field.selectAll()
    qtbot.keyClicks(first.field, "20")
    qtbot.keyClick(first.field, Qt.Key.Key_Tab)
    qtbot.wait(1)
    assert second.field.hasFocus()
    qtbot.keyClicks(second.field, "40")
    qtbot.keyClick(second.field, Qt.Key.Key_Return)
    assert (first.value(), second.value()) == (20, 40)


def test_a_long_number_shows_its_beginning(qtbot, field):
    field.field.clearFocus()
    field.set_value(42 + 1 / 6)
    assert field.field.cursorPosition() == 0
    assert field.field.text().startswith("42.1666")


def test_a_number_that_is_cut_ends_in_dots_and_is_whole_in_the_tooltip(qtbot, field):
    field.field.clearFocus()
    field.set_value(42.5)
    whole = field.field.grab().toImage()
    assert not field.field.overflows
    field.set_value(1234567.25)
    assert field.field.overflows
    assert field.field.toolTip().startswith("1234567.25\n")
    cut = field.field.grab().toImage()
    field.field.setFixedWidth(200)
    assert not field.field.overflows
    # What stands at the right end is no digit: it lies low, as dots do.
    dots = [y for y in range(6, cut.height() - 5) for x in range(cut.width() - 10, cut.width() - 5)
            if abs(cut.pixelColor(x, y).lightness() - cut.pixelColor(5, 5).lightness()) > 90]  # fmt: skip
    assert dots
    assert min(dots) > whole.height() / 2


def test_only_another_number_or_another_room_is_measured(qtbot, field, monkeypatch):
    measured = []
    whole = EntryLine.overflows.fget
    monkeypatch.setattr(EntryLine, "overflows", property(lambda line: measured.append(line) or whole(line)))
    field.field.clearFocus()
    field.set_value(123456)
    assert len(measured) == 1
    for _move in range(5):
        field.set_value(123456)
    assert len(measured) == 1
    assert field.field.toolTip().startswith("123456\n") == field.field.overflows
    field.field.setFixedWidth(30)
    assert field.field.toolTip().startswith("123456\n")
    field.field.setFixedWidth(200)
    assert "123456" not in field.field.toolTip()


def test_names_are_lowered_and_apostrophes_stay():
    assert lowered("At the anode's voltage") == "At the anode's voltage"
    assert lowered("V_a < 2") == "V<sub>a</sub> &lt; 2"
