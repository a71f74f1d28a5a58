"""Source, variables, hand table, structures, sentence and step bar as a person uses them, over one run."""

import inspect
import re
from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtGui import QFontMetrics, QGuiApplication, QTextDocument
from PySide6.QtWidgets import QAbstractButton, QComboBox, QLineEdit, QSlider, QTableView, QWidget
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.document.subjects import Subject
from workbench.rendering.mapping import Call
from workbench.session.run import Run
from workbench.widgets.look.tokens import CAPTION_PX, DARK, LIGHT, TITLE_PX, theme
from workbench.widgets.look.type_faces import cell_font
from workbench.widgets.stepping.source_view import SourceView
from workbench.widgets.stepping.step_bar import Steps
from workbench.widgets.tables.hand_table import HandTable
from workbench.widgets.tables.structure_table import StructureModel, StructureTable
from workbench.widgets.tables.variable_table import VariableTable, value_text

ENTRY = catalogue.get("bresenham_line")
LINE = (20, 10, 30, 18)


@pytest.fixture
def run(qtbot: QtBot) -> Iterator[Run]:
    made = Run()
    follow(qtbot, made)
    yield made
    made.clear()


def follow(qtbot: QtBot, run: Run, slug: str = "bresenham_line", *arguments: object) -> None:
    run.follow(Subject(ids=("figure",)), [Call(catalogue.get(slug), arguments or LINE)], (40, 28))
    qtbot.waitUntil(lambda: run.done, timeout=20_000)


def shown(qtbot: QtBot, widget: QWidget, width: int = 420, height: int = 500) -> None:
    qtbot.addWidget(widget)
    widget.resize(width, height)
    widget.show()
    qtbot.waitExposed(widget)


def column(view: QTableView, number: int) -> list[str]:
    model = view.model()
    return [str(model.index(row, number).data()) for row in range(model.rowCount())]


def test_the_source_is_exactly_the_functions_own(run: Run, qtbot: QtBot) -> None:
    source = SourceView(run)
    shown(qtbot, source)
    source.text.fold(False)
    assert source.text.toPlainText() == inspect.getsource(ENTRY.function)
    lines, first = inspect.getsourcelines(ENTRY.function)
    assert source.text.first_line == first
    run.go(3)
    ran = {lines[line - first].strip() for line in source.text.marked}
    assert "p += two_dy" in ran
    assert "p += two_dy_minus_dx" not in ran
    run.set_detail(True)
    assert source.text.current == run.moment.line  # type: ignore[union-attr]


def test_a_click_on_a_line_runs_to_it(run: Run, qtbot: QtBot) -> None:
    source = SourceView(run)
    shown(qtbot, source, height=900)
    lines, first = inspect.getsourcelines(ENTRY.function)
    wanted = first + next(k for k, line in enumerate(lines) if line.strip() == "p += two_dy")
    top, height = next((top, high) for line, top, high in source.text.visible_lines() if line == wanted)
    qtbot.mouseClick(source.text.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(60, top + height // 2))
    assert run.position == 3
    never = first + next(k for k, line in enumerate(lines) if line.strip() == "yield y, x")
    top, height = next((top, high) for line, top, high in source.text.visible_lines() if line == never)
    with qtbot.waitSignal(source.refused) as refused:
        qtbot.mouseClick(source.text.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(60, top + height // 2))
    assert str(never) in refused.args[0]
    assert run.position == 3


def test_functions_that_the_entry_calls_are_reachable(run: Run, qtbot: QtBot) -> None:
    slug = next(
        entry.slug for entry in catalogue.entries() if len(_functions(qtbot, entry.slug)) > 1 and entry.views
    )
    source = SourceView(run)
    follow(qtbot, run, slug, *catalogue.get(slug).example)
    shown(qtbot, source)
    assert source.chooser.isVisible()
    other = source.chooser.itemText(1)
    source.chooser.setCurrentIndex(1)
    source.chooser.activated.emit(1)
    assert run.recording is not None
    source.text.fold(False)
    assert source.text.toPlainText() == inspect.getsource(run.recording.functions[other])


def _functions(qtbot: QtBot, slug: str) -> list[str]:
    from workbench.engine.effects import texts_of

    return [text.name for text in texts_of(catalogue.get(slug).function)]


def test_changed_variables_are_marked_and_numbers_stand_right(run: Run, qtbot: QtBot) -> None:
    table = VariableTable(run)
    shown(qtbot, table)
    run.go(3)
    names = column(table.view, 0)
    assert names[:4] == ["● x", "  y", "● p", "  k"]
    assert column(table.view, 1)[:3] == ["23", "12", "14"]
    alignment = table.model.index(0, 1).data(Qt.ItemDataRole.TextAlignmentRole)
    assert alignment & Qt.AlignmentFlag.AlignRight
    run.go(2)
    assert column(table.view, 1)[2] == "−2"
    table.point_at("two_dy")
    assert table.view.selectionModel().selectedRows()[0].row() == table.model.names.index("two_dy")


def test_values_fit_on_a_line() -> None:
    assert value_text(-3) == "−3"
    assert value_text(True) == "True"
    assert value_text([1, 2]) == "[1, 2]"
    assert "1,000" in value_text(list(range(1000)))
    assert value_text(np.zeros((28, 40), np.int64)).startswith("40 × 28")


def test_the_hand_table_follows_and_a_click_jumps(run: Run, qtbot: QtBot) -> None:
    table = HandTable(run)
    shown(qtbot, table)
    headings = [table.model.headerData(k, Qt.Orientation.Horizontal) for k in range(3)]
    assert headings == ["k", "pₖ", "(xₖ₊₁, yₖ₊₁)"]
    assert column(table.view, 1) == ["6", "2", "−2", "14", "10", "6", "2", "−2", "14", "10"]
    where = table.view.visualRect(table.model.index(6, 1)).center()
    qtbot.mouseClick(table.view.viewport(), Qt.MouseButton.LeftButton, pos=where)
    assert run.position == table.model.current == 7
    background = table.model.index(6, 0).data(Qt.ItemDataRole.BackgroundRole)
    assert background is not None
    assert table.model.index(5, 0).data(Qt.ItemDataRole.BackgroundRole) is None
    run.set_detail(True)
    run.first()
    assert table.model.current == 0


def test_columns_of_the_hand_table_grow_with_the_numbers_and_shrink_again(run: Run, qtbot: QtBot) -> None:
    table = HandTable(run)
    shown(qtbot, table, width=200)
    metrics = QFontMetrics(cell_font(False))

    def needed() -> list[int]:
        texts = [column(table.view, k) for k in range(table.model.columnCount())]
        return [max(map(metrics.horizontalAdvance, text)) for text in texts]

    def widths() -> list[int]:
        return [table.view.columnWidth(k) for k in range(table.model.columnCount())]

    def fits() -> bool:
        return all(needs < width for needs, width in zip(needed(), widths(), strict=True))

    narrow = widths()
    follow(qtbot, run, "bresenham_line", 10_000_020, 10_000_010, 10_000_030, 10_000_018)
    qtbot.waitUntil(lambda: fits() and widths() != narrow, timeout=5_000)
    follow(qtbot, run)
    qtbot.waitUntil(lambda: widths() == narrow, timeout=5_000)
    follow(qtbot, run, "midpoint_ellipse", 10, 10, 8, 6)
    qtbot.waitUntil(fits, timeout=5_000)


def test_the_hand_table_copies_as_text_and_as_a_table(run: Run, qtbot: QtBot) -> None:
    table = HandTable(run)
    shown(qtbot, table)
    with qtbot.waitSignal(table.copied):
        table.copy_action.trigger()
    data = QGuiApplication.clipboard().mimeData()
    lines = data.text().strip().splitlines()
    assert len(lines) == 11
    assert lines[1].split("\t") == ["0", "6", "(21, 11)"]
    assert data.html().count("<tr>") == 11
    follow(qtbot, run, "bresenham_line", 0, 0, 2000, 700)
    with qtbot.waitSignals([table.copied, table.copied], timeout=20_000):
        table.copy()
    assert len(QGuiApplication.clipboard().text().strip().splitlines()) == 2001


def test_rows_are_evaluated_only_where_they_are_seen(run: Run, qtbot: QtBot) -> None:
    follow(qtbot, run, "bresenham_line", 0, 0, 30_000, 9_000)
    table = HandTable(run)
    shown(qtbot, table)
    assert table.model.rowCount() == 30_000
    assert run.steps is not None
    run.go(20_000)
    table.view.viewport().repaint()
    assert len(run.steps._steps) < 200


def test_ask_first_hides_the_rows_to_come(run: Run, qtbot: QtBot) -> None:
    table = HandTable(run)
    shown(qtbot, table)
    run.set_ask_first(True)
    assert table.model.rowCount() == 0
    run.answer(21, 11)
    assert table.model.rowCount() == 1
    run.set_ask_first(False)
    assert table.model.rowCount() == 10


def test_structures_follow_the_step(run: Run, qtbot: QtBot) -> None:
    table = StructureTable(run)
    assert not table.parts
    fill = catalogue.get("boundary_fill_4")
    follow(qtbot, run, "boundary_fill_4", *fill.example)
    run.go(4)
    (view,) = [view for _, view, _ in table.parts.values()]
    assert run.moment is not None
    stack = [tuple(map(str, item)) for item in run.step.tables[next(iter(table.parts))][1]]  # type: ignore[union-attr]
    assert list(zip(column(view, 0), column(view, 1), strict=True)) == stack


def test_structures_of_another_algorithm_go_with_it(run: Run, qtbot: QtBot) -> None:
    table = StructureTable(run)
    for slug in ("boundary_fill_4", "bresenham_line", "boundary_fill_4"):
        follow(qtbot, run, slug, *catalogue.get(slug).example)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert len(table.findChildren(QTableView)) == len(table.findChildren(StructureModel)) == len(table.parts)


@pytest.fixture
def bar(run: Run, qtbot: QtBot) -> Steps:
    steps = Steps(run)
    shown(qtbot, steps, 960, 110)
    return steps


def test_buttons_and_keys_step(run: Run, bar: Steps, qtbot: QtBot) -> None:
    for name, position in (("forward", 1), ("forward", 2), ("back", 1), ("last", 10), ("first", 0)):
        bar.bar.commands[name].trigger()
        assert run.position == position
    assert not bar.bar.back.isEnabled()
    for key, position in (
        (Qt.Key.Key_End, 10),
        (Qt.Key.Key_Left, 9),
        (Qt.Key.Key_Home, 0),
        (Qt.Key.Key_Right, 1),
    ):
        qtbot.keyClick(bar.bar, key)
        assert run.position == position
    bar.bar.jump.selectAll()
    qtbot.keyClicks(bar.bar.jump, "7")
    qtbot.keyClick(bar.bar.jump, Qt.Key.Key_Return)
    assert run.position == 7
    assert bar.bar.total.text() == "/ 10"
    bar.bar.jump.selectAll()
    qtbot.keyClicks(bar.bar.jump, "far")
    qtbot.keyClick(bar.bar.jump, Qt.Key.Key_Return)
    assert run.position == 7
    assert bar.bar.jump.text() == "7"


@pytest.mark.parametrize("held", ["ControlModifier", "AltModifier", "MetaModifier", "ShiftModifier"])
def test_a_key_with_another_held_is_no_step_and_one_of_the_keypad_is(
    run: Run, bar: Steps, qtbot: QtBot, held: str
) -> None:
    run.go_to_number(4)
    for key in (Qt.Key.Key_End, Qt.Key.Key_Left, Qt.Key.Key_Home, Qt.Key.Key_Right, Qt.Key.Key_Space):
        qtbot.keyClick(bar.bar, key, Qt.KeyboardModifier[held])
        assert run.position == 4
        assert not run.playing
    qtbot.keyClick(bar.bar, Qt.Key.Key_End, Qt.KeyboardModifier.KeypadModifier)
    assert run.position == 10


def test_the_slider_scrubs_and_marks_decisions(run: Run, bar: Steps, qtbot: QtBot) -> None:
    slider = bar.bar.slider
    assert slider.maximum() == 10
    slider.setValue(6)
    assert run.position == 6
    qtbot.mouseClick(slider, Qt.MouseButton.LeftButton, pos=QPoint(slider.x_of(2), slider.height() // 2))
    assert run.position == 2
    qtbot.waitUntil(lambda: slider.marks == (3, 4, 8, 9))
    run.go(5)
    assert slider.value() == 5


def test_detail_ask_first_speed_and_play(run: Run, bar: Steps, qtbot: QtBot) -> None:
    bar.bar.detail.trigger()
    assert run.detail
    assert bar.bar.slider.maximum() == run.last_position
    bar.bar.step.trigger()
    assert not run.detail
    bar.bar.ask.trigger()
    assert run.ask_first
    assert not bar.bar.forward.isEnabled()
    assert "Which pixel comes next" in bar.sentence.plain
    bar.bar.ask.trigger()
    bar.bar.speed.setCurrentIndex(bar.bar.speed.count() - 1)
    bar.bar.speed.activated.emit(bar.bar.speed.count() - 1)
    assert run.speed == 64
    with qtbot.waitSignals([run.played, run.played], timeout=20_000):
        bar.bar.play.trigger()
        assert bar.bar.play.text() == "Pause"
    assert bar.bar.play.text() == "Play"
    assert run.position == 10


def test_the_sentence_has_links_and_two_lines(run: Run, bar: Steps, qtbot: QtBot) -> None:
    run.go(3)
    sentence = bar.sentence
    assert sentence.plain.startswith("p = −2 is negative")
    assert sentence.accessibleName() == sentence.plain
    height = sentence.height()
    links = [k for k, part in enumerate(run.sentence) if part.link is not None]
    with qtbot.waitSignal(sentence.variable_chosen) as chosen:
        sentence.linkActivated.emit(str(links[0]))
    assert chosen.args == ["p"]
    with qtbot.waitSignal(sentence.pixel_chosen) as chosen:
        sentence.linkActivated.emit(str(links[1]))
    assert chosen.args == [23, 12]
    with qtbot.waitSignal(sentence.pixel_pointed) as pointed:
        sentence.linkHovered.emit(str(links[1]))
    assert pointed.args == [(23, 12)]
    run.last()
    assert sentence.height() == height


@pytest.mark.parametrize("width", [960, 1280])
def test_a_long_sentence_is_written_smaller_until_all_of_it_is_seen(
    run: Run, bar: Steps, qtbot: QtBot, width: int
) -> None:
    bar.resize(width, 110)
    sentence = bar.sentence
    sizes = []
    for slug in ("bresenham_line", "depth_buffer"):
        follow(qtbot, run, slug, *catalogue.get(slug).example)
        run.first()
        document = QTextDocument()
        document.setDefaultFont(sentence.font())
        document.setDocumentMargin(0)
        document.setHtml(sentence.text())
        document.setTextWidth(sentence.contentsRect().width())
        assert document.toPlainText() == sentence.plain
        assert document.size().height() <= sentence.contentsRect().height()
        sizes.append(int(re.search(r"font-size:(\d+)px", sentence.text())[1]))  # type: ignore[index]
    assert sizes[0] == TITLE_PX >= sizes[1] >= CAPTION_PX
    assert sizes[1] < TITLE_PX or width > 960


def test_everything_has_a_name_a_tooltip_and_a_place_in_the_key_order(
    run: Run, bar: Steps, qtbot: QtBot
) -> None:
    views = [SourceView(run), VariableTable(run), HandTable(run)]
    for view in views:
        shown(qtbot, view)
    kinds = (QAbstractButton, QComboBox, QLineEdit, QSlider, QTableView)
    controls = [c for widget in (bar, *views) for kind in kinds for c in widget.findChildren(kind)]
    controls = [c for c in controls if c.metaObject().className() != "QTableCornerButton"]
    assert len(controls) > 12
    for control in controls:
        assert control.accessibleName() or control.text(), control
        assert control.toolTip(), control.accessibleName()
        assert control.focusPolicy() & Qt.FocusPolicy.TabFocus, control.accessibleName()


def test_without_a_run_one_sentence_and_one_button(qtbot: QtBot) -> None:
    run = Run()
    for view in (SourceView(run), VariableTable(run), HandTable(run)):
        shown(qtbot, view)
        assert view.state.empty
        with qtbot.waitSignal(view.example_wanted):
            qtbot.mouseClick(view.state.button, Qt.MouseButton.LeftButton)
    bar = Steps(run)
    shown(qtbot, bar, 960, 110)
    assert not bar.bar.play.isEnabled()
    assert bar.sentence.plain


def test_a_theme_taken_later_shows_everywhere(run: Run, bar: Steps, qtbot: QtBot) -> None:
    run.go(2)
    widgets = [bar.sentence, SourceView(run)]
    shown(qtbot, widgets[1])
    light = [widget.grab().toImage() for widget in widgets]
    try:
        theme.use(DARK)
        assert [widget.grab().toImage() != before for widget, before in zip(widgets, light, strict=True)] == [
            True,
            True,
        ]
    finally:
        theme.use(LIGHT)


def test_letters_below_a_letter_stand_below_it(run: Run, bar: Steps, qtbot: QtBot) -> None:
    follow(qtbot, run, "midpoint_ellipse", 20, 14, 9, 6)
    run.first()
    assert "r_x" in bar.sentence.plain
    assert "r<sub>x</sub>" in bar.sentence.text()
    assert "r_x" not in bar.sentence.text()
