"""The twelve questions on Home: a compact list in two columns, in one where the window is narrow."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QTimer, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QPushButton, QSizePolicy

from workbench.language import _

if TYPE_CHECKING:
    from collections.abc import Sequence

    from PySide6.QtGui import QResizeEvent

    from workbench.shell.questions import Question

_COUNT = 12
_NARROW_PX = 1120
_ROW_PX, _SIDE_PX, _AROUND_PX = 30, 12, 8


class QuestionList(QFrame):
    """``chosen`` sends the question that was clicked. Its room is kept while it is still to be filled."""

    chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(16)
        self._grid.setVerticalSpacing(2)
        self._columns = 0
        self.rows: list[_Row] = []
        self._arrange()

    def fill(self) -> None:
        """List the questions anew; those that cannot be worked on yet are there to be read."""
        from workbench.shell.questions import algorithms_for, questions
        from workbench.shell.workspaces import titles

        for row in self.rows:
            row.deleteLater()
        self.rows = []
        for question in questions():
            place = titles().get(question.workspace, _("to come"))
            row = _Row(question, place, algorithms_for(question.number))
            row.clicked.connect(partial(self._choose, question))
            self.rows.append(row)
        self._columns = 0
        self._arrange()
        self._fit()

    def _choose(self, question: Question, _checked: bool = False) -> None:
        self.chosen.emit(question)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()
        self._fit()

    def _fit(self) -> None:
        width = (self.width() - self._grid.horizontalSpacing() * (self._columns - 1)) // self._columns
        for row in self.rows:
            row.fit(width)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self._columns:
            QTimer.singleShot(0, self, self._fit)  # its rows take other type after it

    def _arrange(self) -> None:
        """Down the first column, then the second, so that Tab and the eye follow the numbers."""
        columns = 1 if self.width() < _NARROW_PX else 2
        if columns == self._columns:
            return
        self._columns = columns
        high = _COUNT // columns
        for row in range(_COUNT):
            self._grid.setRowMinimumHeight(row, _ROW_PX if row < high else 0)
        for column in range(2):
            self._grid.setColumnStretch(column, 1 if column < columns else 0)
        for place, button in enumerate(self.rows):
            self._grid.removeWidget(button)
            self._grid.addWidget(button, place % high, place // high)


class _Row(QPushButton):
    """A question, its number before it and its workspace behind it; the tooltip has its algorithms."""

    def __init__(self, question: Question, place: str, titles: Sequence[str]) -> None:
        from PySide6.QtCore import Qt

        super().__init__()
        self.setProperty("card", True)
        self.setFixedHeight(_ROW_PX)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(f"{question.number} {question.text}")
        self.setEnabled(bool(question.workspace))
        tip = _("Open workspace, example and step of this question") if question.workspace else question.text
        self.setToolTip("\n".join([tip, *(f"• {title}" for title in titles)]))
        line = QHBoxLayout(self)
        line.setContentsMargins(_SIDE_PX, 0, _SIDE_PX, 0)
        line.setSpacing(_SIDE_PX)
        number, words, where = QLabel(str(question.number)), QLabel(question.text), QLabel(place)
        number.setMinimumWidth(18)
        number.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for label in (number, where):
            label.setProperty("role", "muted")
        words.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        words.setWordWrap(True)
        for label, stretch in ((number, 0), (words, 1), (where, 0)):
            label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            line.addWidget(label, stretch)
        self._words, self._beside = words, (number, where)

    def fit(self, width: int) -> None:
        """In a column of this width it is as high as its words, in one line where they have room."""
        beside = sum(label.sizeHint().width() for label in self._beside) + 4 * _SIDE_PX
        self.setFixedHeight(max(_ROW_PX, self._words.heightForWidth(max(1, width - beside)) + _AROUND_PX))
