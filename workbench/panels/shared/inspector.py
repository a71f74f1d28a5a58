"""The inspector serves every algorithm: source, about, variables, structures, hand table."""

from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QWidget

from workbench.language import _
from workbench.panels.panel import DockPart, PlainPanel, Said
from workbench.panels.shared.about import choose, may_choose
from workbench.session.session import Session
from workbench.widgets.stepping.about_view import AboutView
from workbench.widgets.stepping.source_view import SourceView
from workbench.widgets.stepping.step_bar import Steps
from workbench.widgets.tables.hand_table import HandTable
from workbench.widgets.tables.structure_table import StructureTable
from workbench.widgets.tables.values import Values
from workbench.widgets.tables.variable_table import VariableTable


class InspectorPanel(PlainPanel, QWidget):
    """Docks over the run of a session, and the step bar below the workspace.

    ``hover_text``: what is to be said in passing. ``pixel_pointed``: a pixel (x, y) that the sentence names
    and that is pointed at or was clicked, None when no longer. ``example_asked``: for an example to inspect.
    """

    hover_text = Signal(str)
    pixel_pointed = Signal(object)
    example_asked = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        run = session.run
        self._chosen: tuple[int, int] | None = None
        self.title = _("Inspector")
        self.source = SourceView(run)
        self.about = AboutView(run, lambda slug: may_choose(session, slug))
        self.about.rung_wanted.connect(lambda slug: choose(session, slug))
        self.variables = VariableTable(run)
        self.structures = StructureTable(run)
        self.hand = HandTable(run)
        self.values = Values(self.variables, self.structures)
        self._steps = Steps(run)
        self._steps.sentence.variable_chosen.connect(self._show_variable)
        self._steps.sentence.variable_pointed.connect(self.variables.point_at)
        self._steps.sentence.pixel_chosen.connect(self._choose_pixel)
        self._steps.sentence.pixel_pointed.connect(self._point_at_pixel)
        run.moved.connect(self._choose_nothing)
        self.source.refused.connect(self.hover_text)
        self.hand.copied.connect(self.hover_text)
        for view in (self.source, self.about, self.variables, self.hand):
            view.example_wanted.connect(self.example_asked)

    def _show_variable(self, name: str) -> None:
        self.variables.point_at(name)
        self.values.show_variables()
        dock: QWidget | None = self.variables
        while dock is not None and not isinstance(dock, QDockWidget):
            dock = dock.parentWidget()
        if dock is not None:
            dock.show()
            dock.raise_()

    def _choose_nothing(self) -> None:
        self._chosen = None

    def _choose_pixel(self, x: int, y: int) -> None:
        self._chosen = (x, y)
        self.pixel_pointed.emit(self._chosen)

    def _point_at_pixel(self, cell: tuple[int, int] | None) -> None:
        """What the pointer is over; without anything there, what was clicked."""
        self.pixel_pointed.emit(cell or self._chosen)

    @property
    def center(self) -> QWidget:
        """The inspector has docks only."""
        return self

    def docks(self) -> list[DockPart]:
        """Source, about, variables with structures, hand table: all on the right."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return [
            ("source", _("Source"), self.source, right),
            ("about", _("About"), self.about, right),
            ("variables", _("Variables"), self.values, right),
            ("hand_table", _("Hand table"), self.hand, right),
        ]

    def actions(self) -> list[QAction]:
        """What this panel adds to the window's commands."""
        return [self.hand.copy_action]

    @property
    def step_bar(self) -> Steps:
        """The buttons and the sentence of the run."""
        return self._steps

    @property
    def pointing(self) -> SignalInstance:
        """The pixel that the sentence names."""
        return self.pixel_pointed

    def said(self) -> Said:
        """What was copied, and what cannot be run to."""
        return Said(self.hover_text)

    @property
    def example_wanted(self) -> SignalInstance:
        """A view without a run was asked for an example."""
        return self.example_asked
