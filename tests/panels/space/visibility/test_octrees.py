"""Octrees of solids and hidden lines on the page Visibility, and the way there from a solid's card."""

import pytest

from tests.panels.by_hand import recorded, settle
from workbench.document.samples.examples import example
from workbench.document.scene.solids import PiercingPlanes, Sphere
from workbench.document.subjects import Subject
from workbench.panels.space.object_fields import ObjectFields
from workbench.rendering.subjects.registry import calls_of
from workbench.rendering.subjects.visibility import KIND, OCTREES, cutting_of
from workbench.widgets.canvas.drawing import PenStroke, Tint


@pytest.fixture
def solids(qtbot, page, session):
    session.open_example("octree-solids")
    session.visit("visibility", page.usual)
    session.update_state(subject=Subject(KIND, entry="octree_of_solid", arguments={"depth": 2}))
    recorded(qtbot, session)
    return page


def legend(page):
    settle()
    page.refresh()
    return page.card.legend.text()


def test_an_octree_grows_cell_by_cell_and_tells_its_volume_at_the_end(qtbot, solids, session):
    session.run.first()
    assert "0 cells full" in legend(solids)
    session.run.go_to_number(session.run.total_steps)
    told = legend(solids)
    assert "Volume from" in told
    drawn = solids.canvas.overlay.drawn
    assert sum(isinstance(each, Tint) for each in drawn) > 20
    session.run.back()
    assert "Volume" not in legend(solids)
    assert any(isinstance(each, PenStroke) and each.ink == "accent" for each in solids.canvas.overlay.drawn)


def test_depth_and_operation_are_chosen_on_the_card(qtbot, solids, session):
    fields = solids.card.octree
    assert fields.isVisible()
    assert not fields.operation.isVisible()
    fields.levels.activated.emit(fields.levels.findData(3))
    recorded(qtbot, session)
    assert cutting_of(session.subject).depth == 3
    session.choose("octree_combined")
    recorded(qtbot, session)
    settle()
    assert fields.operation.isVisible()
    assert fields.axis.isVisible()
    for operation in (0, 1, 2):
        fields.operation.activated.emit(fields.operation.findData(operation))
        recorded(qtbot, session)
        assert session.run.total_steps > 8
    assert not fields.axis.isVisible()
    session.choose("depth_buffer")
    recorded(qtbot, session)
    settle()
    assert not fields.isVisible()


def test_with_one_solid_there_is_nothing_to_be_combined_and_it_is_said(qtbot, solids, session):
    session.update_state(
        subject=Subject(KIND, entry="octree_combined", arguments={"depth": 2, "operation": 0}), step=0
    )
    recorded(qtbot, session)
    scene = session.sheet.scene
    from workbench.document.scene.edits import set_visible

    session.apply(set_visible(scene.objects[1].id, False), "Hide")
    settle()
    assert legend(solids).startswith("Two visible solids are combined")


def test_what_has_no_equation_offers_no_octree(qtbot, page, session):
    assert not set(OCTREES) & set(session.choices_of())


def test_the_card_of_a_solid_leads_to_its_octree(qtbot, solids, session):
    fields = ObjectFields(session)
    qtbot.addWidget(fields)
    from PySide6.QtWidgets import QPushButton

    def offered(thing):
        fields.show_object(thing)
        return [each for each in fields.findChildren(QPushButton) if each.text() == "Divide into an octree"]

    ball = session.sheet.scene.objects[1]
    assert isinstance(ball.solid, Sphere)
    (button,) = offered(ball)
    button.click()
    recorded(qtbot, session)
    assert session.state.workspace == "visibility"
    assert session.subject.ids == (ball.id,)
    assert calls_of(session.sheet, session.subject)[0].arguments[1].tolist() == [0.9, 0.9, 0.9]
    planes = example("piercing-planes").document.sheets[0].scene.objects[0]
    assert not isinstance(planes.solid, PiercingPlanes) or offered(planes) == []


def test_hidden_lines_are_stepped_edge_by_edge(qtbot, page, session):
    session.open_example("arena-bracket")
    session.visit("visibility", page.usual)
    session.update_state(subject=Subject(KIND, entry="hidden_lines"))
    recorded(qtbot, session)
    session.run.first()
    assert "0 parts" in legend(page)
    session.run.go_to_number(session.run.total_steps)
    assert "parts of edges are drawn" in legend(page)
    assert len(page.canvas.overlay.drawn) > 12
    assert not page.plot.isVisible()
    page.cost.show()
    settle()
    page.refresh()
    assert "What holds" in page.cost.words.text()
    page.cost.hide()
