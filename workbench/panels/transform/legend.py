"""The legend on the Transform canvas: a line for each stage that is drawn, with number and pattern."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRectF, QSizeF, Signal
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from workbench.document.transforms.stages import Stage
from workbench.language import _
from workbench.panels.transform.scene import ghosts_of, ink_of_stage
from workbench.panels.transform.stage_row import Badge, StageRow
from workbench.panels.transform.told import caption

_NARROW_PX, _LOW_PX, _MOST, _GAP_PX = 700, 200, 6, 8


class Legend(QFrame):
    """Stands in a corner at the right of ``canvas``, where it covers least of the figure, if there is room.

    ``pointed`` sends a stage or None.
    """

    pointed = Signal(object)

    def __init__(self, canvas: QWidget) -> None:
        super().__init__(canvas)
        self.setObjectName("card")
        self.setAccessibleName(_("Legend of the stages"))
        self._canvas = canvas
        self._shape: tuple[int, ...] = ()
        self._figure = QRectF()
        self.rows: list[StageRow] = []
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(4, 4, 4, 4)
        self._column.setSpacing(0)
        canvas.installEventFilter(self)
        self.hide()

    def follow(self, chain: Sequence[Stage], ghosts: bool, lit: int | None, figure: QRectF) -> None:
        """Name the stages of ``chain`` that are drawn, away from where the ``figure`` is (logical pixels)."""
        self._figure = figure
        count = len(chain)
        words = [_("as drawn"), *(caption(stage) for stage in chain)]
        numbers = ghosts_of(count) if ghosts else [0, count]
        numbers = [] if not count or len(numbers) > _MOST else numbers
        shape = (count, *numbers)
        if shape != self._shape:
            self._shape = shape
            for row in self.rows:
                row.blockSignals(True)
                self._column.removeWidget(row)
                row.hide()
                row.deleteLater()
            self.rows = []
            for number in numbers:
                badge = Badge(number, *ink_of_stage(number, count), lined=True)
                row = StageRow(number, badge, "", "", words[number])
                row.pointed.connect(self.pointed)
                self._column.addWidget(row)
                self.rows.append(row)
        for row in self.rows:
            if row.words.text() != words[row.number]:
                row.tell("", "", words[row.number])
            row.set_lit(row.number == lit)
        self._place()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Stay in the corner."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show):
            self._place()
        return False

    def _place(self) -> None:
        canvas = self._canvas
        room = canvas.width() >= _NARROW_PX and canvas.height() >= _LOW_PX
        self.setVisible(bool(self.rows) and room)
        if not self.isHidden():
            self.adjustSize()
            left = canvas.width() - self.width() - _GAP_PX
            corners = [QPoint(left, canvas.height() - self.height() - _GAP_PX), QPoint(left, _GAP_PX)]
            corners.sort(key=lambda corner: corner != self.pos())  # it stays unless another is better
            self.move(min(corners, key=self._covered))

    def _covered(self, corner: QPoint) -> float:
        """How much of the figure it would hide, square pixels."""
        hidden = self._figure.intersected(QRectF(QPointF(corner), QSizeF(self.size())))
        return hidden.width() * hidden.height()
