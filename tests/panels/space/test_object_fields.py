"""The fields of a solid: its equation, where it has one, and numbers that are left as another is chosen."""

from PySide6.QtWidgets import QLabel

from workbench.document.scene.model import Object
from workbench.document.scene.solids import Blobs, Box, Ellipsoid
from workbench.panels.space.object_fields import ObjectFields
from workbench.session.session import Session


def test_an_ellipsoid_shows_its_equation_and_a_box_none(qtbot):
    fields = ObjectFields(Session())
    qtbot.addWidget(fields)
    for solid, equations in ((Ellipsoid(), [Ellipsoid.equation]), (Box(), []), (Blobs(), [Blobs.equation])):
        fields.show_object(Object("o1", solid, "m1"))
        words = [label.text() for label in fields.widget().findChildren(QLabel)]
        assert [word for word in words if "=" in word] == equations


def test_a_number_that_was_begun_goes_with_the_solid_it_was_of(qtbot):
    session = Session()
    fields = ObjectFields(session)
    qtbot.addWidget(fields)
    fields.show_object(Object("o1", Ellipsoid(), "m1"))
    begun = list(fields.fields)
    fields.show_object(Object("o1", Box(), "m1"))
    before = session.document
    left = [name for name in begun if name not in fields.fields]
    assert left
    for name in left:
        fields._set(name, "", 3.0)
    assert session.document == before
    session.close()
