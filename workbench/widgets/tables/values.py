"""Variables and structures of a run: one above the other, or where that is too low as two tabs."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QTabBar, QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.look.split import Split
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.tables.structure_table import StructureTable
from workbench.widgets.tables.variable_table import VariableTable

_VARIABLES, _STRUCTURES = range(2)
_LEAST_VARIABLES_PX = 90


class Values(QWidget):
    """``variables`` over ``structures``; as tabs where no row of one of the structures would be seen."""

    def __init__(
        self, variables: VariableTable, structures: StructureTable, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._variables, self._structures = variables, structures
        self.tabs = QTabBar()
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        self.tabs.setAccessibleName(_("Variables or structures"))
        for title in (_("Variables"), _("Structures")):
            self.tabs.addTab(title)
        self.tabs.setCurrentIndex(_STRUCTURES)
        self._area = QScrollArea()
        self._area.setFrameShape(QFrame.Shape.NoFrame)
        self._area.setWidgetResizable(True)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._area.setWidget(structures)
        both = Split(Qt.Orientation.Vertical)
        both.addWidget(variables)
        both.addWidget(self._area)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.tabs)
        column.addWidget(both, 1)
        self.setFocusProxy(variables)
        structures.changed.connect(self._arrange)
        self.tabs.currentChanged.connect(self._arrange)
        self._arrange()

    def show_variables(self) -> None:
        """Bring the variables before the structures."""
        self.tabs.setCurrentIndex(_VARIABLES)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """As much as there is room for."""
        super().resizeEvent(event)
        self._arrange()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))

    def _arrange(self) -> None:
        some = bool(self._structures.parts)
        least = self._structures.heightForWidth(self.width()) if some else 0
        low = some and self.height() < least + _LEAST_VARIABLES_PX
        chosen = self.tabs.currentIndex()
        self.tabs.setVisible(low)
        self._area.setMinimumHeight(0 if low else least)
        self._variables.setVisible(not low or chosen == _VARIABLES)
        self._area.setVisible(some and (not low or chosen == _STRUCTURES))
