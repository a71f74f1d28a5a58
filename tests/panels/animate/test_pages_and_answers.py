"""What the Animate panel tells of a track: its page, the scene it moves, falling by its equation, answers."""

import pytest

from tests.document.motion.moving import sheet_of, track
from tests.panels.by_hand import LEFT, settle
from workbench.algorithms.marks import Spot, Word
from workbench.document.model import Document
from workbench.document.motion.evaluation import at as at_frame
from workbench.exchange.diagram_svg import write_diagram
from workbench.exchange.diagrams import Drawing, Sentence
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.animate.path import alone
from workbench.panels.animate.physics import by_equation, equation_of
from workbench.rendering import frame_buffer
from workbench.rendering.scene.backdrop import with_scene


def target_of(panel: AnimatePanel, row: int) -> str:
    return panel.timeline.shown.tracks[row].target


def test_the_page_of_a_track_has_the_numbers_of_its_frame(panel: AnimatePanel) -> None:
    panel.session.frames.show(34)
    page = panel.derivation()
    assert page is not None
    sentences = [block.text for block in page.blocks if isinstance(block, Sentence)]
    assert "Frame 34 is in-between 6 of 11: t = 6 / 12 = 0.5." in sentences
    assert "P = 46 + 0.2929 · (10 − 46) = 35.4558" in sentences
    way, graph = (block for block in page.blocks if isinstance(block, Drawing))
    named = [item.text for item in way.items if isinstance(item, Word)]
    assert named == [f"k = {frame}" for frame in (0, 16, 28, 34, 40, 49, 58)]
    assert [item.text for item in graph.items if isinstance(item, Word)][2] == "P_{2} = 46"
    assert "<svg" in write_diagram(page)
    panel.session.new()
    assert panel.derivation() is None


def test_a_scene_is_seen_from_where_its_camera_has_come(panel: AnimatePanel) -> None:
    panel.session.open_example("animate-drive")
    settle()
    assert panel.empty.isHidden()
    panel.session.frames.show(22)
    near = with_scene(frame_buffer(panel.session.shown), panel.session.shown)
    panel.session.frames.show(0)
    far = with_scene(frame_buffer(panel.session.shown), panel.session.shown)
    paper = panel.session.sheet.palette[panel.session.sheet.background]
    assert 0 < (far != paper).sum() < (near != paper).sum() / 2
    assert "Camera, eye" in panel.timeline.shown.tracks[0].label


def test_asked_first_a_click_tells_where_it_is_in_the_next_frame(qtbot, panel: AnimatePanel) -> None:
    session, run = panel.session, panel.session.run
    session.frames.show(29)
    qtbot.waitUntil(lambda: run.number == 2, timeout=5000)
    run.set_ask_first(True)
    settle()
    assert run.waiting
    assert len([mark for mark in panel.canvas.overlay.drawn if isinstance(mark, Spot)]) < 20
    value = float(str(run.steps[3].answer))
    other = min(float(str(option)) for option in run.options)
    assert abs(other - value) > 2
    qtbot.mouseClick(panel.canvas, LEFT, pos=panel.canvas.widget_position(140.0, other).toPoint())
    settle()
    assert run.refused
    run.try_again()
    qtbot.mouseClick(panel.canvas, LEFT, pos=panel.canvas.widget_position(140.0, value).toPoint())
    settle()
    assert run.right + run.wrong == 1
    assert session.frames.number == 30
    assert not session.dirty


def test_falling_by_its_equation_lies_beside_the_easing(panel: AnimatePanel) -> None:
    session = panel.session
    ball, target = session.sheet.figures[-1], target_of(panel, 0)
    own = alone(session.sheet, ball)
    equation = equation_of(own, target)
    assert equation is not None
    falling = by_equation(own, equation)
    for frame in range(28, 41):
        t = (frame - 28) / 12
        assert at_frame(falling, frame).figures[0].points_world[0].y == pytest.approx(46 - 36 * t * t)
    for frame in range(16, 29):
        t = (28 - frame) / 12
        assert at_frame(falling, frame).figures[0].points_world[0].y == pytest.approx(46 - 36 * t * t)
    assert equation_of(own, target_of(panel, 1)) is None
    session.frames.show(34)
    settle()
    assert "by t²: 46 + 0.25 · (10 − 46) = 37" in panel.between.sums.text()


@pytest.mark.parametrize("numbers", [(), (1.0, 2.0, 3.0, 4.0, 5.0)])
def test_a_track_that_moves_nothing_has_no_page(panel: AnimatePanel, numbers: tuple[float, ...]) -> None:
    sheet = sheet_of(track("f2/points_world", (0, numbers), (8, numbers)))
    panel.session.new(Document((sheet,)))
    settle()
    panel.session.frames.show(4)
    settle()
    assert [each.problem for each in panel.timeline.shown.tracks] == ["nothing there"]
    assert panel.derivation() is None
