"""Objects of a scene: chosen, added, changed in the list and in fields, listed in tables."""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QModelIndex, QPoint, QPointF, Qt
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import LEFT, scene_of, settle, shown
from workbench.algorithms.solids.tables import polygon_tables
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.edits import add_link
from workbench.document.scene.links import Translate3D
from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.geometry.meshes import Mesh
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.pointing import at
from workbench.panels.space.polygon_tables import PolygonTablesView
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.space.solids_offered import offers
from workbench.rendering.scene.render import placed


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


def test_a_click_chooses_an_object_and_a_vertex_is_stepped(qtbot: QtBot, page: ProjectionPage) -> None:
    eye, session = page.eye, page.session
    scene = scene_of(page)
    inside = np.array([[0.8, 3.5, -0.8]])  # in the chimney, above the roof
    eye.zoom(4.0, QPointF(*eye.projected(inside)[0]))
    settle(qtbot, page)
    (middle,) = eye.projected(inside)
    qtbot.mouseClick(eye, LEFT, pos=QPoint(*map(round, middle)))
    settle(qtbot, page)
    assert session.state.thing == "o2"
    eye.fit()
    settle(qtbot, page)
    house = scene.objects[0]
    (corner,) = eye.projected(house.mesh.vertices[[7]])
    qtbot.mouseClick(eye, LEFT, pos=QPoint(*map(round, corner)))
    settle(qtbot, page)
    assert session.subject == Subject("projection", ("o1",), arguments={"vertex": 7})
    assert page.eye.vertex is not None
    assert page.eye.vertex.place == pytest.approx(tuple(house.mesh.vertices[7]))


def test_objects_are_added_renamed_hidden_copied_moved_and_deleted(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    dock, session = page.objects, page.session

    def names() -> list[str]:
        settle(qtbot, page)
        return [thing.name for thing in scene_of(page).objects]

    dock.add_solid(offers()[4])
    assert names() == ["House", "Chimney", "Shed", "Sphere"]
    assert dock.chosen is not None
    assert dock.chosen.name == "Sphere"
    session.undo_stack.undo()
    assert names() == ["House", "Chimney", "Shed"]  # with its material, in one step
    assert len(scene_of(page).materials) == 3
    dock.list.setCurrentRow(1)
    assert dock.chosen is not None
    assert dock.chosen.name == "Chimney"
    dock.list.item(1).setText("Stack")
    assert names() == ["House", "Stack", "Shed"]
    dock.list.item(1).setCheckState(Qt.CheckState.Unchecked)
    settle(qtbot, page)
    assert not scene_of(page).objects[1].visible
    dock.shift(1)
    assert names() == ["House", "Shed", "Stack"]
    dock.duplicate()
    assert names() == ["House", "Shed", "Stack", "Stack"]
    dock.delete()
    assert names() == ["House", "Shed", "Stack"]


@pytest.mark.parametrize("text", ["x" * 10_000, "  House ", "House"])
def test_a_name_that_is_refused_or_no_other_leaves_the_list_as_the_scene(
    qtbot: QtBot, page: ProjectionPage, text: str
) -> None:
    dock, before = page.objects, page.session.document
    said: list[str] = []
    dock.said.connect(said.append)
    dock.list.item(0).setText(text)
    settle(qtbot, page)
    assert page.session.document is before
    assert dock.list.item(0).text() == "House"
    assert said == (
        ["The name is too long; give a text of at most 200 characters."] if len(text) > 200 else []
    )


def test_a_colour_is_the_object_s_own(qtbot: QtBot, page: ProjectionPage) -> None:
    dock = page.objects
    dock.list.setCurrentRow(0)
    dock.duplicate()
    settle(qtbot, page)
    first, second = scene_of(page).objects[:2]
    assert first.material == second.material
    dock.colour.menu().actions()[3].trigger()
    settle(qtbot, page)
    colours = {material.id: material.colour for material in scene_of(page).materials}
    first, second = scene_of(page).objects[:2]
    assert colours[first.material] != colours[second.material]
    page.session.undo_stack.undo()
    settle(qtbot, page)
    first, second = scene_of(page).objects[:2]
    assert first.material == second.material


def test_solids_and_transforms_are_numbers_in_fields(qtbot: QtBot, page: ProjectionPage) -> None:
    dock = page.objects
    dock.list.setCurrentRow(0)
    settle(qtbot, page)
    fields = dock.fields

    def house() -> Object:
        settle(qtbot, page)
        return scene_of(page).objects[0]

    fields.fields["width"].edited.emit(4.5)
    assert np.ptp(house().mesh.vertices[:, 0]) == 4.5
    page.session.apply(add_link("o1", Translate3D("")), "")
    link = house().transforms[0].id
    settle(qtbot, page)
    fields.fields[f"{link}/ty"].edited.emit(2.0)
    matrix = house().matrix
    assert matrix is not None
    assert matrix[:3, 3].tolist() == [0.0, 2.0, 0.0]
    field = fields.fields["width"]
    field.field.selectAll()
    qtbot.keyClicks(field.field, "-1")
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    assert "too small" in field.complaint.text()


def test_tables_have_the_chosen_object_in_the_world(qtbot: QtBot, page: ProjectionPage) -> None:
    page.tables_view.show()
    page.objects.list.setCurrentRow(1)  # the chimney, a box of 0.5 x 1.4 x 0.5 around (0.8, 3.1, -0.8)
    settle(qtbot, page)
    tables = dict(page.tables_view.content())
    assert [len(table.rows) for table in tables.values()] == [8, 12, 6, 6]
    vertices = np.array([row[1:] for row in tables["Vertices"].rows], float)
    assert np.allclose(vertices.min(axis=0), (0.55, 2.4, -1.05))
    for _face, a, b, c, d in tables["Planes, in the world"].rows:
        assert a * 0.8 + b * 3.1 + c * -0.8 + d < 0  # the middle is inside


def test_an_empty_scene_offers_a_house(qtbot: QtBot, page: ProjectionPage) -> None:
    page.session.new(blank_sheet())
    settle(qtbot, page)
    assert page.empty.isVisible()
    assert not page.strip.isVisible()
    qtbot.mouseClick(page.empty.button, LEFT)
    settle(qtbot, page)
    assert not page.empty.isVisible()
    assert [thing.name for thing in scene_of(page).objects] == ["House"]
    assert page.eye.vanishing()


def test_the_objects_beside_the_other_page_are_those_of_the_picture(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    panel, dock = page.parentWidget().parentWidget(), page.objects
    qtbot.addWidget(dock)
    assert isinstance(panel, SpacePanel)
    panel.show_page("visibility")
    dock.show()
    qtbot.waitExposed(dock)
    settle(qtbot, page)
    assert dock.list.count() == len(scene_of(page).objects) == 3
    page.session.new()
    dock.list.setCurrentRow(1)  # of the picture before, as long as the list is not told
    assert page.session.state.thing == ""
    settle(qtbot, page)
    assert dock.list.count() == 0
    dock.hide()
    page.session.open_example("space-house")
    settle(qtbot, page)
    dock.show()
    settle(qtbot, page)
    assert dock.list.count() == 3


def test_tables_and_picture_light_up_together(qtbot: QtBot, page: ProjectionPage) -> None:
    tables = page.tables_view
    qtbot.addWidget(tables)
    tables.resize(420, 300)
    tables.show()
    page.session.update_state(thing="o1")
    settle(qtbot, page)
    mesh = placed(scene_of(page))[0][0]
    # From the table to the picture: an edge, and the sides of a face
    tables.choice.setCurrentIndex(1)
    qtbot.mouseClick(tables.table.viewport(), LEFT, pos=tables.table.visualRect(row_of(tables, 2)).center())
    ends = polygon_tables(mesh).edges[2]
    assert np.array_equal(page.eye.marked, mesh.vertices[ends][None])
    tables.choice.setCurrentIndex(3)
    assert len(page.eye.marked) == 0
    tables.table.selectRow(4)
    corners = mesh.faces[4]
    assert {tuple(end) for end in page.outside.marked[:, 0].tolist()} == {
        tuple(mesh.vertices[k].tolist()) for k in corners
    }
    # From the picture to the table: the face and the vertex under the pointer
    for number in range(len(mesh.faces)):
        middle = page.eye.projected(mesh.vertices[list(mesh.faces[number])].mean(axis=0)[None])[0]
        there = at(page.eye, QPointF(*middle.tolist()))
        if there is not None and (there.thing, there.face) == ("o1", number):
            page.eye.hovered.emit(QPointF(*middle.tolist()))
            assert tables.table.currentIndex().row() == number
            break
    else:
        pytest.fail("no face of the house is seen at its middle")
    tables.choice.setCurrentIndex(0)
    vertex = next(
        k for k in range(len(mesh.vertices)) if page.eye.vertex_at(place_of(page, mesh, k)) is not None
    )
    nearest = page.eye.vertex_at(place_of(page, mesh, vertex))
    assert nearest is not None
    page.eye.hovered.emit(place_of(page, mesh, vertex))
    assert tables.table.currentIndex().row() == nearest.number
    tables.hide()
    assert len(page.eye.marked) == 0


def row_of(tables: PolygonTablesView, number: int) -> QModelIndex:
    return tables.table.model().index(number, 0)


def place_of(page: ProjectionPage, mesh: Mesh, number: int) -> QPointF:
    return QPointF(*page.eye.projected(mesh.vertices[[number]])[0].tolist())


def test_every_solid_that_can_be_added_is_a_command(qtbot: QtBot, page: ProjectionPage) -> None:
    commands = {action.text(): action for action in page.commands()}
    for offer in offers():
        commands[f"Add object: {offer.title}"].trigger()
        settle(qtbot, page)
        assert scene_of(page).objects[-1].solid == offer.solid
    page.session.undo_stack.undo()
    assert scene_of(page).objects[-1].solid == offers()[-2].solid
