"""The fields of a solid: its equation, where it has one, and numbers that are left as another is chosen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel
from shiboken6 import isValid

from tests.panels.by_hand import begin_number, settle
from workbench.document.scene.edits import set_solid
from workbench.document.scene.model import Object
from workbench.document.scene.solids import Blobs, Box, Ellipsoid, Sphere, Torus
from workbench.panels.space.object_fields import ObjectFields
from workbench.session.session import Session


def test_an_ellipsoid_shows_its_equation_and_a_box_none(qtbot):
    fields = ObjectFields(Session())
    qtbot.addWidget(fields)
    for solid, equations in ((Ellipsoid(), [Ellipsoid.equation]), (Box(), []), (Blobs(), [Blobs.equation])):
        fields.show_object(Object("o1", solid, "m1"))
        words = [label.text() for label in fields.widget().findChildren(QLabel)]
        assert [word for word in words if "=" in word] == equations


@pytest.mark.parametrize("other", [Torus(), Box()])
def test_a_number_that_was_begun_goes_with_the_solid_it_was_of(qtbot, other):
    """A torus has a radius too."""
    session = Session()
    session.open_example("space-house")
    scene = session.sheet.scene
    thing = scene.objects[0].id
    session.apply(set_solid(thing, Sphere()), "Change the solid")
    fields = ObjectFields(session)
    qtbot.addWidget(fields)
    fields.show()
    fields.show_object(session.sheet.scene.objects[0])
    line = fields.fields["radius"].field
    begin_number(qtbot, line, "1.75")
    session.apply(set_solid(thing, other), "Change the solid")
    before = session.document
    fields.show_object(session.sheet.scene.objects[0])
    settle()
    if isValid(line) and line.hasFocus():
        qtbot.keyClick(line, Qt.Key.Key_Return)
    settle()
    assert session.document == before
    session.close()
