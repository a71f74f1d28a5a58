"""About this algorithm: it tells what the run's entry declares, and leads to the next rung by a click."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt, QUrl
from PySide6.QtGui import QGuiApplication, QTextCursor, QTextDocument
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.document.edits import remove_figures
from workbench.document.subjects import Subject
from workbench.panels.shared.about import may_choose
from workbench.panels.shared.inspector import InspectorPanel
from workbench.session.session import Session
from workbench.widgets.look.tokens import DARK, LIGHT, theme
from workbench.widgets.stepping.about_view import AboutView, page_of


@pytest.fixture
def session() -> Iterator[Session]:
    session = Session()
    yield session
    session.close()
    session.deleteLater()


@pytest.fixture
def about(session: Session, qtbot: QtBot) -> Iterator[AboutView]:
    panel = InspectorPanel(session)
    keep_until_the_end(qtbot, panel)
    view = panel.about
    qtbot.addWidget(view)
    view.resize(440, 600)
    view.show()
    yield view
    panel.close()


def open_example(session: Session, name: str, stepped: str, qtbot: QtBot) -> None:
    session.open_example(name)
    figure = next(f for f in session.sheet.figures if stepped != "curve" or hasattr(f, "spline"))
    session.update_state(active=figure.id, subject=Subject(stepped))
    qtbot.waitUntil(
        lambda: session.run.entry is not None and session.run.subject == Subject(stepped, (figure.id,))
    )


def click(view: AboutView, words: str, qtbot: QtBot) -> None:
    """Click in the middle of these words."""
    cursor = view.text.document().find(words)
    assert not cursor.isNull()
    cursor.setPosition(cursor.selectionStart() + len(words) // 2, QTextCursor.MoveMode.MoveAnchor)
    place = view.text.cursorRect(cursor).center()
    qtbot.mouseClick(view.text.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place.x(), place.y()))


@pytest.mark.parametrize("entry", catalogue.entries(), ids=lambda entry: entry.slug)
def test_a_page_tells_all_that_an_entry_declares(entry: Entry, qapp: QApplication) -> None:
    document = QTextDocument()
    document.setHtml(page_of(entry, linked=True))
    told = document.toPlainText()
    sentences = [law.sentence for law in entry.laws]
    if by := entry.drawn_by:
        title, law = catalogue.get(by.slug).title, by.law.sentence
        sentences.append(f"drawn by “{title}”, which is faster, wherever this law holds: {law}")
    for text in (
        entry.title,
        entry.summary,
        entry.source,
        entry.tie,
        *sentences,
        *entry.not_laws,
        *entry.labs,
    ):
        assert text in told
    for parameter in entry.parameters:
        assert parameter.meaning in told
        if parameter.unit:
            assert parameter.unit in told
    if entry.questions:
        assert ", ".join(map(str, entry.questions)) + " on Home" in told
    assert "_" not in entry.slug or entry.slug not in told.split()


def test_ranges_and_units_are_told(about: AboutView, session: Session, qtbot: QtBot) -> None:
    open_example(session, "line", "figure", qtbot)
    told = about.text.toPlainText()
    assert told.startswith("Bresenham's line\nChooses between two pixels")
    assert "first end point, column\nwhole number, −32768 to 32767 px" in told.replace("\u2028", "\n")


def test_a_click_on_the_next_rung_lets_it_draw_the_figure(
    about: AboutView, session: Session, qtbot: QtBot
) -> None:
    open_example(session, "line", "figure", qtbot)
    session.update_state(compare="bresenham_line_two_ends")
    click(about, "Bresenham from both ends", qtbot)
    assert session.sheet.figures[0].algorithm == "bresenham_line_two_ends"
    assert session.state.compare == ""
    qtbot.waitUntil(lambda: about.text.toPlainText().startswith("Bresenham from both ends"))
    session.undo_stack.undo()
    qtbot.waitUntil(lambda: about.text.toPlainText().startswith("Bresenham's line"))


def test_in_clip_it_leads_from_one_clipper_to_the_next(
    about: AboutView, session: Session, qtbot: QtBot
) -> None:
    open_example(session, "clip", "clipper", qtbot)
    assert session.run.entry is not None
    assert session.run.entry.slug == "cohen_sutherland"
    click(about, "Liang-Barsky", qtbot)
    assert session.sheet.line_clipper == "liang_barsky"
    qtbot.waitUntil(lambda: about.text.toPlainText().startswith("Liang-Barsky"))
    # Sutherland-Hodgman clips polygons: told of, but no link on a line
    assert "Sutherland-Hodgman" in about.text.toPlainText()
    assert "href" not in about.text.toHtml()
    assert not may_choose(session, "sutherland_hodgman")


def test_where_the_next_rung_cannot_be_chosen_nothing_happens(
    about: AboutView, session: Session, qtbot: QtBot
) -> None:
    open_example(session, "circles", "figure", qtbot)
    assert "Midpoint ellipse" in about.text.toPlainText()
    assert "href" not in about.text.toHtml()
    before = session.document
    about.text.anchorClicked.emit(QUrl("midpoint_ellipse"))
    assert session.document is before


def test_without_a_figure_it_offers_an_example(about: AboutView, session: Session, qtbot: QtBot) -> None:
    open_example(session, "line", "figure", qtbot)
    assert not about.state.empty
    session.apply(remove_figures([session.sheet.figures[0].id]), "Delete")
    qtbot.waitUntil(lambda: about.state.empty)
    with qtbot.waitSignal(about.example_wanted):  # which the workspace that is seen opens
        qtbot.mouseClick(about.state.button, Qt.MouseButton.LeftButton)
    session.open_example("line")
    qtbot.waitUntil(lambda: bool(session.sheet.figures))
    session.update_state(active=session.sheet.figures[0].id)
    qtbot.waitUntil(lambda: not about.state.empty)


def test_it_can_be_copied_and_takes_the_theme_s_colours(
    about: AboutView, session: Session, qtbot: QtBot
) -> None:
    open_example(session, "line", "figure", qtbot)
    about.text.selectAll()
    about.text.copy()
    assert "integer; it only adds and compares." in QGuiApplication.clipboard().text()
    assert LIGHT.accent.lower() in about.text.toHtml()
    theme.use(DARK)
    assert DARK.accent.lower() in about.text.toHtml()
    theme.use(LIGHT)
