"""A question of the paper opens its workspace, its example and its step, wherever one comes from."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from tests.shell.dialogs import dialog_of
from workbench.algorithms import catalogue
from workbench.document.samples.examples import example_document
from workbench.document.state import SessionState
from workbench.document.storage.files import Stored, write
from workbench.panels.display.gun.page import GunPage
from workbench.panels.display.page import pages as display_pages
from workbench.panels.display.panel import DisplayPanel
from workbench.panels.space.page import pages as space_pages
from workbench.panels.space.panel import SpacePanel
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.panels.transform.panel import TransformPanel
from workbench.panels.transform.space_page import SLUG
from workbench.session.session import Session
from workbench.shell.command_palette import CommandPalette
from workbench.shell.home import HomePage
from workbench.shell.questions import questions
from workbench.shell.start import Building, make_window
from workbench.shell.workspaces import panel_of, workspaces


def test_the_twelfth_question_opens_the_turn_about_a_point_at_its_step(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    (question,) = (each for each in questions() if each.number == 12)
    window.open_question(question)
    qtbot.waitUntil(lambda: window.place == "transform", timeout=60_000)
    qtbot.waitUntil(lambda: window.session.run.number == question.step, timeout=60_000)
    assert window.session.run.entry is not None
    assert window.session.run.entry.slug == "matrix_product"
    assert window.session.sheet.figures[-1].transforms
    leave(window)


def test_the_eleventh_question_opens_a_dda_whose_sum_drifts(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    (question,) = (each for each in questions() if each.number == 11)
    window.open_question(question)
    qtbot.waitUntil(lambda: window.place == "draw", timeout=60_000)
    run = window.session.run
    qtbot.waitUntil(lambda: run.number == question.step > 0 and run.done, timeout=60_000)
    active = window.session.active_figure
    assert active is not None
    assert (active.drawn_with, active.name) == ("dda_line", "DDA")
    assert run.entry is not None
    assert run.entry.slug == "dda_line"
    assert run.steps is not None
    drifts = [run.steps[k].row[-1] for k in range(1, len(run.steps) + 1)]
    assert drifts[question.step - 1] != 0.0
    leave(window)


@pytest.mark.parametrize(("number", "page"), [(1, "space"), (2, "visibility"), (5, "space"), (7, "arena")])
def test_questions_of_space_open_their_page_with_a_dock_and_a_diagram(
    qtbot: QtBot, number: int, page: str
) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    (question,) = (each for each in questions() if each.number == number)
    window.open_question(question)
    qtbot.waitUntil(lambda: window.place == "space", timeout=60_000)
    qtbot.waitUntil(lambda: window.session.run.number == question.step, timeout=60_000)
    panel = panel_of(window.panels("space"), SpacePanel)
    assert panel.page == page
    dock = next(each for each in window.arrangements.docks("space") if each.objectName() == question.dock)
    qtbot.waitUntil(lambda: not dock.visibleRegion().isEmpty(), timeout=10_000)
    diagram = panel.derivation()
    assert diagram is not None
    assert len(diagram.blocks) > 5
    leave(window)


def test_the_sixth_question_opens_the_tube_cut_open_at_its_start(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    (question,) = (each for each in questions() if each.number == 6)
    window.open_question(question)
    qtbot.waitUntil(lambda: window.place == "display", timeout=60_000)
    panel = panel_of(window.panels("display"), DisplayPanel)
    beam = catalogue.get("electron_beam")
    qtbot.waitUntil(lambda: window.session.run.entry is beam and window.session.run.done, timeout=60_000)
    assert panel.page == "gun"
    assert window.session.run.number == 0
    dock = next(each for each in window.arrangements.docks("display") if each.objectName() == "gun_part")
    qtbot.waitUntil(lambda: not dock.visibleRegion().isEmpty(), timeout=10_000)
    answer, drawing = panel.derivation(), panel.drawing()
    assert answer is not None
    assert drawing is not None
    assert len(answer.blocks) > 7
    export = window.menus.actions["export_tube"]
    page = panel.page_of("gun")
    assert isinstance(page, GunPage)
    with qtbot.waitSignal(export.triggered):
        qtbot.mouseClick(page.bar.save, Qt.MouseButton.LeftButton)
    dialog_of(qtbot, window).reject()
    leave(window)


def test_the_tenth_question_leads_to_pages_that_have_the_docks_they_need_in_front(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    window.resize(1280, 680)
    (question,) = (each for each in questions() if each.number == 10)
    window.open_question(question)
    qtbot.waitUntil(lambda: window.place == "display", timeout=60_000)
    panel = panel_of(window.panels("display"), DisplayPanel)

    def seen() -> set[str]:
        docks = window.arrangements.docks("display")
        return {dock.objectName() for dock in docks if not dock.visibleRegion().isEmpty()}

    for page, dock in (
        ("comparison", "raster_or_random"),
        ("vector", "random_scan_architecture"),
        ("flicker", "phosphors"),
        ("colour", "source"),
        ("raster", "raster_sums"),
        ("display", "source"),
    ):
        panel.show_page(page)
        qtbot.waitUntil(lambda name=dock: seen() == {name, "hand_table"}, timeout=10_000)  # type: ignore[misc]
    leave(window)


def test_a_file_opens_on_the_page_that_it_was_left_on(qtbot: QtBot, tmp_path: Path) -> None:
    window = make_window()
    window.show()
    document = example_document()
    window.attach(Session(window, document))
    for workspace, run, page in (
        ("display", "comparison", "comparison"),
        ("transform", "transform_space", "space"),
        ("display", "colour", "colour"),
        ("space", "arena", "arena"),
    ):
        path = tmp_path / f"{run}.gwb"
        write(Stored(document, SessionState(workspace=run, sheet=document.sheets[0].id)), path)
        window.files.open_path(path)
        qtbot.waitUntil(lambda at=path: window.session.path == at, timeout=20_000)  # type: ignore[misc]
        assert window.place == workspace
        assert window.session.state.workspace == run
        panel = window.panels(workspace)[0]
        assert isinstance(panel, PagedPanel | TransformPanel)
        assert panel.page == page
        window.session.undo_stack.setClean()
    leave(window)


def test_every_page_of_a_workspace_is_told_with_its_run() -> None:
    told = {each.slug: set(each.pages) for each in workspaces()}
    assert told["display"] == {row.slug for row in display_pages()}
    assert told["space"] == {row.slug for row in space_pages()}
    assert told["transform"] == {"transform", SLUG}
    for each in workspaces():
        assert [row.slug for row in each.rows()] == [*each.pages.values()]


@pytest.mark.parametrize(
    ("typed", "number"), [("not the origin", 12), ("rotation about any", 12), ("viewport", 4)]
)
def test_a_question_is_found_by_its_words_and_by_its_algorithms(
    qtbot: QtBot, typed: str, number: int
) -> None:
    window = make_window()
    window.show()
    window.attach(Session(window, example_document()))
    palette = CommandPalette.open_over(window)
    qtbot.keyClicks(palette.field, typed)
    rows = [palette.list.item(row).text() for row in range(palette.list.count())]
    (question,) = (each for each in questions() if each.number == number)
    assert f"Question {number}: {question.text}" in rows[:6]
    palette.list.setCurrentRow(rows.index(f"Question {number}: {question.text}"))
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert window.place == question.workspace
    leave(window)


def test_a_wide_home_has_the_questions_in_two_columns_above_the_examples(qtbot: QtBot) -> None:
    home = HomePage([])
    qtbot.addWidget(home)
    home.show_questions()
    home.show()
    rows = home.questions.rows
    for width, columns in ((1280, 2), (960, 1), (1280, 2)):
        home.resize(width, 560)
        qtbot.waitUntil(lambda n=columns: len({row.mapTo(home, QPoint()).x() for row in rows}) == n)  # type: ignore[misc]
        heights = [row.mapTo(home, QPoint()).y() for row in rows[: 12 // columns]]
        assert heights == sorted(set(heights))
    qtbot.waitUntil(lambda: max(row.mapTo(home, QPoint()).y() for row in rows) < 400)


def test_every_question_is_chosen_by_a_click_and_by_space(qtbot: QtBot) -> None:
    home = HomePage([])
    qtbot.addWidget(home)
    home.show_questions()
    home.resize(1280, 560)
    home.show()
    chosen: list[object] = []
    home.questions.chosen.connect(chosen.append)
    for row in home.questions.rows:
        qtbot.mouseClick(row, Qt.MouseButton.LeftButton)
        qtbot.keyClick(row, Qt.Key.Key_Space)
    assert chosen == [question for question in questions() for _way in ("mouse", "key")]
