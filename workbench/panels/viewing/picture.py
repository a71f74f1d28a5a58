"""One of the two pictures of View: a heading over a stage of the pipeline."""

from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from workbench.panels.viewing.stages import Stage
from workbench.widgets.canvas.plane_view import PlaneView


class StagePicture(QWidget):
    """Shows one stage; the panel says which, and what is in it."""

    def __init__(self, stage: Stage, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage = stage
        self.plane = PlaneView()
        self._heading = QLabel()
        bold = self._heading.font()
        bold.setBold(True)
        self._heading.setFont(bold)
        self._hint = QLabel()
        self._hint.setProperty("role", "caption")
        row = QHBoxLayout()
        row.setContentsMargins(12, 4, 8, 4)
        row.setSpacing(8)
        row.addWidget(self._heading)
        row.addWidget(self._hint)
        row.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(row)
        column.addWidget(self.plane, 1)
        self.setFocusProxy(self.plane)
        self.set_stage(stage)

    def set_stage(self, stage: Stage) -> None:
        """Open another stage."""
        self.stage = stage
        self._heading.setText(stage.heading)
        self._hint.setText(stage.hint)
        self.plane.setAccessibleName(stage.heading)
        self.plane.setToolTip("")
