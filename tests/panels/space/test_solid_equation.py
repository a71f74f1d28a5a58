"""The fields of a solid show its equation, where it has one."""

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
