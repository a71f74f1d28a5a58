"""What is found by a few letters of it (Ctrl+K), and what is not."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from tests.shell.conftest import OFFERED, leave
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.document.sheet_edits import add_sheet
from workbench.session.session import Session
from workbench.shell.command_palette import CommandPalette, match, offers
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow

SURFACES = "Question 7: Deciding what is hidden: surface against surface, or pixel by pixel?"


@pytest.mark.parametrize(
    ("letters", "text"),
    [
        ("GIF", SURFACES),  # g in Deciding, i of is, f in surface
        ("letter", "Example: Two triangles that pierce"),
        ("shading", "Question 6: How does a cathode-ray tube turn a beam of electrons into light?"),
        ("turn", "Export the picture as PNG..."),
    ],
)
def test_letters_out_of_the_middle_of_words_name_nothing(letters: str, text: str) -> None:
    assert match(letters, text) is None


@pytest.mark.parametrize(
    ("letters", "text"),
    [
        ("expan", "Export the animation..."),
        ("eta", "Export the animation..."),
        ("brsnm", "Bresenham's line"),
        ("line", "Polyline"),
        ("surf px", SURFACES),
        ("", "Undo"),
    ],
)
def test_beginnings_of_words_and_what_follows_in_them_name_it(letters: str, text: str) -> None:
    assert match(letters, text) is not None


WORDS = st.lists(st.text("abcde", min_size=1, max_size=6), min_size=1, max_size=5)


@given(WORDS, st.data())
def test_any_choice_of_words_by_their_first_letters_is_found(words: list[str], data: st.DataObject) -> None:
    chosen = data.draw(st.lists(st.sampled_from(range(len(words))), unique=True, min_size=1).map(sorted))
    letters = "".join(words[k][: data.draw(st.integers(1, len(words[k])))] for k in chosen)
    assert match(letters, " ".join(words)) is not None


def test_a_command_is_found_by_what_its_tip_says(qtbot: QtBot) -> None:
    window = make_window()
    window.show()
    window.attach(Session(window, example_document()))
    palette = CommandPalette.open_over(window)
    qtbot.keyClicks(palette.field, "gif")
    rows = [palette.list.item(row).text() for row in range(palette.list.count())]
    assert rows == ["Export this run...", "Export the animation..."]
    window.close()


@pytest.mark.parametrize(
    ("typed", "offered", "workspace", "page"),
    [
        ("visibility", "Space: Visibility", "space", "visibility"),
        ("flicker", "Display: Flicker", "display", "flicker"),
        ("gun", "Display: Gun", "display", "gun"),
        ("in space", "Transform: In space", "transform", "space"),
    ],
)
def test_a_page_is_found_from_another_workspace_and_leads_there(
    qtbot: QtBot, typed: str, offered: str, workspace: str, page: str
) -> None:
    window = make_window()
    qtbot.addWidget(window)
    window.attach(Session(window, example_document()))
    window.show()
    shown: list[str] = []

    class Middle:
        show_page = staticmethod(shown.append)

    window._panels._ready[workspace] = [Middle()]  # type: ignore[list-item]
    window.enter = lambda slug, then: (shown.append(slug), then())  # type: ignore[assignment, method-assign]
    palette = CommandPalette.open_over(window)
    qtbot.keyClicks(palette.field, typed)
    rows = [palette.list.item(row).text() for row in range(palette.list.count())]
    assert offered in rows[:3]
    palette.list.setCurrentRow(rows.index(offered))
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert shown == [workspace, page]


def test_pages_are_offered_of_the_other_workspaces_alone(qtbot: QtBot) -> None:
    window = make_window()
    qtbot.addWidget(window)
    window.attach(Session(window, example_document()))
    window.place = "display"
    texts = [offer.text for offer in offers(window)]
    window.place = "home"
    assert not any(text.startswith("Display: ") for text in texts)
    assert sum(text.startswith("Space: ") for text in texts) == 4


@pytest.mark.parametrize(
    ("typed", "title"),
    [("octree", "A ring and a ball in cubes"), ("leaks", "A boundary that leaks"), ("islands", "A pond")],
)
def test_an_example_is_found_by_what_it_shows(qtbot: QtBot, typed: str, title: str) -> None:
    window = make_window()
    qtbot.addWidget(window)
    window.attach(Session(window, example_document()))
    palette = CommandPalette.open_over(window)
    qtbot.keyClicks(palette.field, typed)
    rows = [palette.list.item(row).text() for row in range(palette.list.count())]
    assert any(row.startswith(f"Example: {title}") for row in rows)


def test_what_is_offered_once_the_session_is_there_is_found_in_an_open_palette(
    qtbot: QtBot, panels: None
) -> None:
    window = make_window(Settings(), OFFERED)
    window.show()
    window.complete()
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.keyClicks(palette.field, "example circle and")
    assert palette.list.count() == 0
    window.attach(Session(window, example_document()))
    assert palette.list.item(0).text() == "Example: Circle and ellipse"
    leave(window)


def test_what_can_be_done_meanwhile_is_offered_when_more_is_typed(qtbot: QtBot, window: MainWindow) -> None:
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.keyClicks(palette.field, "second though")
    assert palette.list.count() == 0
    window.session.apply(add_sheet(blank_sheet(name="Second thoughts").sheets[0]), "Add a sheet")
    qtbot.keyClicks(palette.field, "t")
    assert palette.list.item(0).text() == "Sheet: Second thoughts"
