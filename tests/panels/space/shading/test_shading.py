"""The page Shading: stepped, lights dragged and typed, four side by side, what is wrong said in place."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication, QColorDialog
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import begin_number, keep_until_the_end
from tests.panels.space.by_hand import drag
from workbench.document.scene.edits import remove_thing, set_thing
from workbench.document.scene.model import Light, Scene
from workbench.panels.space.lamps import light_at, light_place
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.shading.page import ShadingPage
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.session.session import Session


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ShadingPage]:
    session = Session()
    session.open_example("shading-ball")
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 560)
    panel.show()
    qtbot.waitExposed(panel)
    panel.show_page("shading")
    page = panel.page_of("shading")
    assert isinstance(page, ShadingPage)
    page.lamps.resize(300, 400)
    page.lamps.show()
    qtbot.addWidget(page.lamps)
    settle(qtbot, page)
    yield page
    session.close()


def settle(qtbot: QtBot, page: ShadingPage) -> None:
    page.session.flush()
    QApplication.processEvents()
    page.refresh()
    qtbot.waitUntil(lambda: not any(view.worker.busy for view in (page.view, *page.four)), timeout=60_000)


def scene_of(page: ShadingPage) -> Scene:
    scene = page.session.sheet.scene
    assert scene is not None
    return scene


def pick_colour(qtbot: QtBot, page: ShadingPage, colour: int, meanwhile: Callable[[], object]) -> None:
    qtbot.mouseClick(page.lamps.colour, Qt.MouseButton.LeftButton)
    dialog = page.lamps.findChild(QColorDialog)
    meanwhile()
    dialog.setCurrentColor(QColor(colour))
    dialog.accept()
    qtbot.waitUntil(lambda: page.lamps.findChild(QColorDialog) is None)


def test_a_colour_goes_to_what_it_was_picked_for_and_to_nothing_else(qtbot: QtBot, page: ShadingPage) -> None:
    light, material = scene_of(page).lights[0].id, scene_of(page).materials[0]
    page.lamps.choose(light)
    pick_colour(qtbot, page, 0x123456, lambda: None)
    pick_colour(qtbot, page, 0x654321, lambda: page.lamps.choose(material.id))
    assert scene_of(page).lights[0].colour == 0x123456
    assert scene_of(page).materials[0] == material


def test_a_dragged_light_comes_back_in_one_step(qtbot: QtBot, page: ShadingPage) -> None:
    before = scene_of(page).lights[0].position
    ((_light, at, inside),) = page.view.light_marks()
    assert not inside  # its mark is at the edge, and brings it into the picture
    drag(qtbot, page.view, at.toTuple(), (-120, 90))
    settle(qtbot, page)
    after = scene_of(page).lights[0].position
    ((_light, there, inside),) = page.view.light_marks()
    assert inside
    assert there.toTuple() == pytest.approx((at.x() - 120, at.y() + 90), abs=1.0)
    assert after.x < before.x
    assert page.lamps.fields["position.x"].value() == pytest.approx(after.x)
    page.session.undo_stack.undo()
    assert scene_of(page).lights[0].position == before


def test_a_distant_light_keeps_its_length_and_turns(page: ShadingPage) -> None:
    light = replace(scene_of(page).lights[0], distant=True)
    place = light_place(light, scene_of(page))
    turned = light_at(light, scene_of(page), place[[2, 1, 0]])
    assert np.linalg.norm(turned.xyz) == pytest.approx(np.linalg.norm(light.position.xyz), abs=2e-3)
    assert turned.xyz[0] > light.position.x


def test_a_key_with_ctrl_does_not_step(qtbot: QtBot, page: ShadingPage) -> None:
    played: list[bool] = []
    page.session.run.toggle_play = lambda: played.append(True)  # type: ignore[method-assign]
    qtbot.keyClick(page, Qt.Key.Key_Space, Qt.KeyboardModifier.ControlModifier)
    assert not played
    qtbot.keyClick(page, Qt.Key.Key_Space)
    assert played == [True]


def test_numbers_of_lights_and_materials_are_typed(qtbot: QtBot, page: ShadingPage) -> None:
    lamps = page.lamps
    for name, text in (("a1", "0.25"), ("position.y", "30/10"), ("intensity", "2")):
        entry = lamps.fields[name].field
        entry.setFocus()
        entry.selectAll()
        qtbot.keyClicks(entry, text)
        qtbot.keyClick(entry, Qt.Key.Key_Return)
    light = scene_of(page).lights[0]
    assert (light.a1, light.position.y, light.intensity) == (0.25, 3.0, 2.0)
    lamps.choose("m1")
    entry = lamps.fields["shininess"].field
    entry.selectAll()
    qtbot.keyClicks(entry, "80")
    qtbot.keyClick(entry, Qt.Key.Key_Return)
    assert scene_of(page).materials[0].shininess == 80.0
    lamps.add_light()
    assert [each.name for each in scene_of(page).lights] == ["Lamp", "Lamp"]
    assert lamps.chosen == scene_of(page).lights[1]
    lamps.delete()
    assert len(scene_of(page).lights) == 1


@pytest.mark.parametrize("other", ["another light", "a material"])
def test_a_number_that_was_begun_goes_with_the_light_it_was_of(
    qtbot: QtBot, page: ShadingPage, other: str
) -> None:
    lamps, light = page.lamps, scene_of(page).lights[0].id
    lamps.add_light()
    before = scene_of(page)
    lamps.choose(light)
    line = lamps.fields["intensity"].field
    begin_number(qtbot, line, "0.25")
    lamps.choose(before.lights[1].id if other == "another light" else before.materials[0].id)
    if line.hasFocus():
        qtbot.keyClick(line, Qt.Key.Key_Return)
    settle(qtbot, page)
    assert scene_of(page) == before


def test_four_shadings_side_by_side_from_one_command(qtbot: QtBot, page: ShadingPage) -> None:
    page.together.trigger()
    settle(qtbot, page)
    assert [view.isVisible() for view in page.four] == [True] * 4
    assert not page.canvas.isVisible()
    pictures = [view.grab().toImage() for view in page.four]
    assert [view.title for view in page.four] == [
        "Flat shading",
        "Gouraud shading",
        "Phong shading",
        "Fast Phong shading",
    ]
    assert len({bytes(picture.constBits()) for picture in pictures}) == len(LIT_SHADINGS)
    page.together.trigger()
    assert page.canvas.isVisible()


def test_each_shading_is_stepped_and_the_picture_follows(qtbot: QtBot, page: ShadingPage) -> None:
    session = page.session
    for slug in LIT_SHADINGS:
        session.choose(slug)
        settle(qtbot, page)
        qtbot.waitUntil(lambda: session.run.recording is not None and not session.run.waiting, timeout=30_000)
        assert session.run.entry is not None
        assert session.run.entry.slug == slug
        for _step in range(3):
            session.run.forward()
        settle(qtbot, page)
        assert np.isfinite(page._light).sum() >= 1


def test_what_is_wrong_with_a_light_is_said_in_place(qtbot: QtBot, page: ShadingPage) -> None:
    def word(**changes: object) -> str:
        page.session.apply(set_thing(replace(light, **changes)), "change")
        settle(qtbot, page)
        return page.lamps.word.text()

    light = scene_of(page).lights[0]
    corner = scene_of(page).objects[0].mesh.vertices[12]
    assert word(a0=0.0, a1=0.0, a2=0.0).startswith("a₀, a₁ and a₂ are all 0")
    assert word(
        position=replace(light.position, **dict(zip("xyz", corner.tolist(), strict=True)))
    ).startswith("This light is in a face")
    assert word(distant=True, position=replace(light.position, x=0.0, y=0.0, z=0.0)).startswith(
        "The direction"
    )
    assert word() == ""
    page.session.apply(remove_thing(light.id), "remove")
    settle(qtbot, page)
    assert page.lamps.word.text() == "The scene has no light of its own, so it is lit from above the eye."


def test_a_scene_without_polygons_says_so_and_keeps_its_lights(qtbot: QtBot, page: ShadingPage) -> None:
    page.session.apply(remove_thing("o1"), "remove")
    settle(qtbot, page)
    assert page.nothing.isVisible()
    assert page.nothing.sentence.text() == "The scene has no faces to be lit; add an object."
    assert scene_of(page).lights == (Light("l1", scene_of(page).lights[0].position, "Lamp", distant=False),)
    page.session.undo_stack.undo()
    settle(qtbot, page)
    assert not page.nothing.isVisible()


def test_a_sheet_without_a_scene_offers_an_example(qtbot: QtBot, page: ShadingPage) -> None:
    page.session.new()
    settle(qtbot, page)
    assert page.nothing.sentence.text() == "This sheet has no scene."
    qtbot.mouseClick(page.nothing.button, Qt.MouseButton.LeftButton, pos=QPoint(3, 3))
    settle(qtbot, page)
    assert scene_of(page).objects[0].name == "Ball"


def test_shadows_and_halfway_are_switched_in_the_bar(qtbot: QtBot, page: ShadingPage) -> None:
    for box, name in ((page.bar.halfway, "by_halfway"), (page.bar.shadows, "shadows")):
        box.click()
        settle(qtbot, page)
        assert page.session.state.subject.arguments[name] is True


def test_what_is_seen_from_elsewhere_can_be_kept(qtbot: QtBot, page: ShadingPage) -> None:
    before = scene_of(page).camera
    drag(qtbot, page.view, (200.0, 200.0), (60, 0))
    settle(qtbot, page)
    assert page.view.scene.camera != before
    assert scene_of(page).camera == before
    assert page.bar.keep.isVisible()
    page.bar.keep.click()
    settle(qtbot, page)
    assert scene_of(page).camera == page.view.scene.camera
    assert not page.bar.keep.isVisible()


def test_the_picture_of_another_document_is_never_in_the_place_of_this_one(
    qtbot: QtBot, page: ShadingPage
) -> None:
    """Also where it was under way when the other one was opened."""
    held, going_on = [], page.view._take_drawn
    page.view.worker.drawn.disconnect(page.view._take_drawn)
    page.view.worker.drawn.connect(lambda job, picture: (held.append(job.scene), going_on(job, picture)))
    page.view.set_shading("phong", page.view._lit[1])
    page.view.resize(page.view.width() - 3, page.view.height())
    page.view.redraw()
    assert page.view.worker.busy
    page.session.open_example("shading-materials")
    page.session.flush()
    assert page.view._came is None
    settle(qtbot, page)
    assert held
    assert all(scene.objects == scene_of(page).objects for scene in held)


def test_nor_is_it_asked_for_where_the_view_comes_in_sight_before_it_is_told_of_the_new_one(
    qtbot: QtBot, page: ShadingPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    page.window().hide()
    page.session.open_example("shading-materials")
    asked, ask = [], page.view.worker.ask
    monkeypatch.setattr(page.view.worker, "ask", lambda job: (asked.append(job.scene), ask(job)))
    page.window().show()
    page.view.redraw()
    settle(qtbot, page)
    assert page.view.scene.objects == scene_of(page).objects
    assert asked[-1].objects == scene_of(page).objects
    assert all(scene.objects in ((), scene_of(page).objects) for scene in asked)
