"""The card of the Transform panel: the points as drawn, and what the canvas shows of the chain."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QHBoxLayout, QToolButton, QWidget

from workbench.document.model import AnyFigure
from workbench.language import _
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.tools import FigureTool


class TransformCard(ParameterCard):
    """Shows and edits the numbers of what is selected; ``switched``: something else is to be shown."""

    switched = Signal()
    offers_algorithms = False

    def more_rows(self) -> list[QWidget]:
        """Points or axes, ghosts, the chain the other way round."""
        both = QWidget()
        row = QHBoxLayout(both)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        self.points, self.axes, self.both = QToolButton(), QToolButton(), QToolButton()
        group = QButtonGroup(both)
        for button, text, tip in (
            (self.points, _("Move points"), _("The chain moves the figure; the axes stay")),
            (self.axes, _("the axes"), _("The chain moves the axes; the figure gets new coordinates")),
            (self.both, _("both"), _("The points moved, and next to them the axes moved by the same chain")),
        ):
            button.setText(text)
            button.setCheckable(True)
            button.setToolTip(tip)
            button.setAccessibleName(text if button is self.points else _("Move {what}").format(what=text))
            group.addButton(button)
            row.addWidget(button)
        row.addStretch(1)
        self.points.setChecked(True)
        group.buttonToggled.connect(lambda _button, on: self.switched.emit() if on else None)
        self.ghosts = QCheckBox(_("Ghosts of every stage"))
        self.ghosts.setChecked(True)
        self.ghosts.setToolTip(_("The figure after each matrix of the chain, with its number"))
        self.reversed = QCheckBox(_("The opposite order beside it"))
        self.reversed.setToolTip(_("A second picture with the links of the chain in the opposite order"))
        self.reversed.toggled.connect(self._give_way)
        self.both.toggled.connect(self._give_way)
        for box in (self.ghosts, self.reversed):
            box.toggled.connect(self.switched)
        return [both, self.ghosts, self.reversed]

    def _give_way(self, on: bool) -> None:
        """There is room for one picture beside the first."""
        if on and self.sender() is self.both:
            self.reversed.setChecked(False)
        elif on and self.both.isChecked():
            self.points.setChecked(True)

    def refresh(self, tool: FigureTool | None, figures: Sequence[AnyFigure], summary: str) -> None:
        """Show what is selected, or what ``tool`` draws next."""
        super().refresh(tool, figures, summary)
        for field in self._size or ():
            field.hide()
        if not figures and tool is None:
            self.title.setText(_("Nothing selected"))
        self._fit()
