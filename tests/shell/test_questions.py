"""A question of the paper opens its workspace, its example and its step, wherever one comes from."""

from pytestqt.qtbot import QtBot

from workbench.shell.questions import questions
from workbench.shell.start import Building, make_window


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
