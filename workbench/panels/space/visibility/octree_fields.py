"""On the Visibility card: how deep octrees of solids are, and what two of them are made into."""

from collections.abc import Callable

from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from workbench.algorithms.solids.octree_pairs import DIFFERENCE, INTERSECTION, UNION
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.scene.solid_octree import COMBINED, CUT
from workbench.rendering.subjects.visibility import MOST_DEPTH, OCTREES, cutting_of, method_of
from workbench.widgets.fields.number_field import NumberField


class OctreeFields(QWidget):
    """``give`` takes the name of an argument of the subject, and its value."""

    def __init__(self, give: Callable[[str, Argument], None]) -> None:
        super().__init__()
        self.levels, self.operation, self.axis = QComboBox(), QComboBox(), QComboBox()
        self.share = NumberField(
            _("at"), "", low=0.0, high=1.0, step=0.05, meaning=_("Share of the cube below the plane")
        )
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for box, argument, name, tip in (
            (self.levels, "depth", _("Depth"), _("How often the cube is divided at most")),
            (
                self.operation,
                "operation",
                _("Operation"),
                _("What is made of both solids, or of one and a plane"),
            ),
            (self.axis, "cut_axis", _("Plane"), _("The axis that the cutting plane is across")),
        ):
            box.setAccessibleName(name)
            box.setToolTip(tip)
            box.activated.connect(lambda k, box=box, argument=argument: give(argument, int(box.itemData(k))))
            column.addWidget(box)
        self.share.edited.connect(lambda value: give("cut_at", float(value)))
        self.share.scrubbed.connect(lambda value: give("cut_at", float(value)))
        column.addWidget(self.share)

    def refresh(self, sheet: Sheet, subject: Subject) -> None:
        """Show what is set; nothing where no octree is stepped."""
        method, cutting = method_of(sheet, subject), cutting_of(subject)
        self.share.belong_to((sheet.id, subject.ids))
        self.setVisible(method in OCTREES)
        depths = [(n, _("Depth {n}").format(n=n)) for n in range(1, MOST_DEPTH + 1)]
        fill_choices(self.levels, depths, cutting.depth)
        operations = [
            (CUT, _("Cut by a plane")),
            (UNION, _("Union of both")),
            (INTERSECTION, _("Intersection")),
            (DIFFERENCE, _("First without second")),
        ]
        fill_choices(self.operation, operations, cutting.operation)
        planes = [(axis, _("Plane across {axis}").format(axis="xyz"[axis])) for axis in range(3)]
        fill_choices(self.axis, planes, cutting.axis)
        self.share.set_value(cutting.share)
        self.operation.setVisible(method == COMBINED)
        for part in (self.axis, self.share):
            part.setVisible(method == COMBINED and cutting.operation == CUT)
