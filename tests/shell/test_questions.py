"""A question of the paper opens its workspace, its example and its step, wherever one comes from."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.panels.space.panel import SpacePanel
from workbench.shell.questions import questions
from workbench.shell.start import Building, make_window
from workbench.shell.workspaces import panel_of


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
    window.close()


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
    window.close()
