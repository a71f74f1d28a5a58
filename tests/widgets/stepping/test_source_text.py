"""Source on narrow room: nothing runs off, the docstring is folded, every line keeps its number."""

import inspect

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QFontInfo, QGuiApplication, QTextCursor
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.algorithms.scanning.electron_beam import electron_beam
from workbench.widgets.look.tokens import tokens
from workbench.widgets.stepping.source_highlighter import SourceHighlighter
from workbench.widgets.stepping.source_text import SourceText, docstring_rows

ENTRIES = catalogue.entries()[::3]


def show(text: SourceText, entry: Entry) -> None:
    source, first = inspect.getsourcelines(entry.function)
    text.show_source("".join(source), first)


def text_of(qtbot: QtBot, entry: Entry, width: int = 396, height: int = 400) -> SourceText:
    text = SourceText()
    qtbot.addWidget(text)
    text.resize(width, height)
    text.show()
    show(text, entry)
    return text


@pytest.mark.parametrize("width", [240, 396])
def test_no_line_runs_off_and_what_goes_on_below_hangs(width: int, qtbot: QtBot) -> None:
    text = text_of(qtbot, ENTRIES[0], width)
    assert QFontInfo(text.font()).pixelSize() >= 11
    column = text.fontMetrics().horizontalAdvance("0")
    for entry in ENTRIES:
        show(text, entry)
        assert text.horizontalScrollBar().maximum() == 0
        assert not text.horizontalScrollBar().isVisible()
        block = text.document().firstBlock()
        while block.isValid():
            rows = [block.layout().lineAt(k) for k in range(block.layout().lineCount())]
            if block == text.folded_block:
                assert len(rows) == 1
            else:
                assert all(row.x() + row.naturalTextWidth() <= text.viewport().width() + 2 for row in rows)
            own = len(block.text()) - len(block.text().lstrip())
            for row in rows[1:]:
                assert row.x() > rows[0].x()
                if (own + 8) * 2 * column <= text.viewport().width():
                    assert row.x() - rows[0].x() == pytest.approx((own + 8) * column, abs=1)
            block = block.next()


def test_the_docstring_is_one_line_until_it_is_unfolded(qtbot: QtBot) -> None:
    text = text_of(qtbot, ENTRIES[0])
    for entry in ENTRIES:
        show(text, entry)
        source, first = inspect.getsourcelines(entry.function)
        lines = "".join(source).split("\n")
        rows = docstring_rows("".join(source))
        assert len(rows) > 1
        assert lines[rows[0]].strip().startswith('"""')
        assert lines[rows[-1]].endswith('"""')
        kept = [row for row in range(len(lines)) if row not in rows[1:]]
        assert text.toPlainText().split("\n") == [lines[row] for row in kept]
        numbers = [line - first for line, _top, _height in text.visible_lines()]
        assert numbers == kept[: len(numbers)]
        at = text.area_of(text.folded_block).center().toPoint()
        with qtbot.assertNotEmitted(text.line_clicked):
            qtbot.mouseClick(text.viewport(), Qt.MouseButton.LeftButton, pos=at)
        assert text.toPlainText() == "".join(source)


def test_what_is_copied_over_a_folded_docstring_has_all_of_it(qtbot: QtBot) -> None:
    entry = catalogue.get("de_boor")
    text = text_of(qtbot, entry)
    text.selectAll()
    text.copy()
    assert QGuiApplication.clipboard().text() == inspect.getsource(entry.function)
    cursor = QTextCursor(text.document().findBlockByNumber(text.folded_block.blockNumber() + 1))
    cursor.movePosition(QTextCursor.MoveOperation.End, QTextCursor.MoveMode.KeepAnchor)
    text.setTextCursor(cursor)
    text.copy()
    assert "Emits" not in QGuiApplication.clipboard().text()
    assert QGuiApplication.clipboard().text() == cursor.selection().toPlainText()


def test_a_click_below_a_folded_line_runs_to_that_line(qtbot: QtBot) -> None:
    text = text_of(qtbot, catalogue.get("flatten_bezier"), 240, 2000)
    line, top, height = max(text.visible_lines()[3:], key=lambda seen: seen[2])
    assert height > 1.5 * text.fontMetrics().height()
    with qtbot.waitSignal(text.line_clicked) as clicked:
        qtbot.mouseClick(text.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(60, top + height - 4))
    assert clicked.args == [line]


@pytest.mark.parametrize("slug", ["de_boor", "scan_line_fill", "bresenham_line"])
def test_the_marked_lines_are_scrolled_into_view(slug: str, qtbot: QtBot) -> None:
    text = text_of(qtbot, catalogue.get(slug), 260, 160)
    for line in range(text.first_line, text.last_line, 5):
        text.mark(frozenset(), line)
        block = text._block_of(line)
        if block.isValid():
            area = text.area_of(block)
            assert area.top() >= -1
            assert area.bottom() <= text.viewport().height() + 1 or area.height() > text.viewport().height()


def test_a_marked_line_is_marked_where_it_hangs_too(qtbot: QtBot) -> None:
    text = SourceText()
    qtbot.addWidget(text)
    text.resize(240, 200)
    text.show()
    text.show_source("one\n" + "a_long_name = " + " + ".join(["another"] * 8) + "\ntwo", 1)
    text.mark(frozenset({2}), None)
    area = text.area_of(text.document().findBlockByNumber(1)).toRect()
    row = text.fontMetrics().lineSpacing()
    assert area.height() >= 2 * row
    picture = text.viewport().grab().toImage()
    colours = {picture.pixelColor(2, y).name() for y in range(area.top() + row + 1, area.bottom())}
    assert colours == {tokens().selected.lower()}
    assert picture.pixelColor(2, area.bottom() + row // 2).name() != tokens().selected.lower()


def test_every_line_is_coloured_at_most_twice_when_another_text_comes(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    coloured: list[str] = []
    colour = SourceHighlighter.highlightBlock

    def counting(self: SourceHighlighter, text: str) -> None:
        coloured.append(text)
        colour(self, text)

    monkeypatch.setattr(SourceHighlighter, "highlightBlock", counting)
    text = SourceText()
    qtbot.addWidget(text)
    text.resize(460, 300)
    with qtbot.waitExposed(text):
        text.show()
    source, first = inspect.getsourcelines(electron_beam)
    text.show_source("".join(source), first)
    coloured.clear()
    text.show_source("".join(source), first)
    assert len(coloured) <= 2 * text.document().blockCount()
    assert text.verticalScrollBar().value() == 0
