"""Home: what was worked on last, examples, and the questions of a first course."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Signal, SignalInstance
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout

from workbench.language import _, legible
from workbench.paths import resource
from workbench.shell.home_questions import QuestionList
from workbench.shell.pages import Page, heading, paragraph
from workbench.widgets.look.layouts import take_widgets
from workbench.widgets.look.tips import plain_tip

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

_EXAMPLE_COLUMNS = 5
_NAME_LENGTH = 28
THUMBNAIL = QSize(132, 84)
_CARD_PX = THUMBNAIL.height() + 46


class HomePage(Page):
    """Sends what was chosen; it knows no document. Examples arrive after the first frame."""

    new_wanted = Signal()
    open_wanted = Signal()
    file_chosen = Signal(object)
    example_chosen = Signal(str)
    question_chosen = Signal(object)

    def __init__(self, recent: Sequence[Path]) -> None:
        super().__init__("", width=1232)
        self.column.addLayout(self._head())
        self._recent_title = heading(self.column, _("Recent pictures"))
        self._recent = QGridLayout()
        self._recent.setSpacing(8)
        self.column.addLayout(self._recent)
        heading(self.column, _("Twelve questions of a first course"))
        self.questions = QuestionList()
        self.questions.chosen.connect(self.question_chosen)
        self.column.addWidget(self.questions)
        heading(self.column, _("Examples"))
        self._cards: list[QPushButton] = []
        self._examples = QGridLayout()
        self._examples.setSpacing(8)
        self._examples.setRowMinimumHeight(1, _CARD_PX)
        self.column.addLayout(self._examples)
        self.column.addStretch(1)
        self.show_recent(recent)

    def _head(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(16)
        picture = QLabel()
        factor = 1 if self.devicePixelRatioF() <= 1 else 2
        image = QPixmap(str(resource("icon", f"graphics-workbench-{64 * factor}.png")))
        image.setDevicePixelRatio(factor)
        picture.setPixmap(image)
        picture.setFixedSize(64, 64)
        row.addWidget(picture)
        words = QVBoxLayout()
        words.setSpacing(2)
        words.addStretch(1)
        heading(words, "Graphics Workbench", "title")
        paragraph(
            words, _("Draw something, watch the algorithm make it pixel by pixel, and see it glow."), "muted"
        )
        words.addStretch(1)
        row.addLayout(words, 1)
        begin = QPushButton(_("New picture"))
        begin.setProperty("primary", True)
        begin.setToolTip(_("Start an empty picture (Ctrl+N)"))
        begin.clicked.connect(self.new_wanted)
        other = QPushButton(_("Open..."))
        other.setToolTip(_("Open a picture from a file (Ctrl+O)"))
        other.clicked.connect(self.open_wanted)
        for button in (begin, other):
            row.addWidget(button)
        return row

    def show_questions(self) -> None:
        """List the questions, each a button where it can be worked on."""
        self.questions.fill()

    @staticmethod
    def _choose(signal: SignalInstance, what: object, _checked: bool = False) -> None:
        signal.emit(what)

    def show_recent(self, recent: Sequence[Path]) -> None:
        """List the files opened last; nothing of it is seen while there are none."""
        _empty(self._recent)
        self._recent_title.setVisible(bool(recent))
        for place, path in enumerate(recent[:4]):
            button = QPushButton()
            button.setProperty("card", True)
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            button.setText(legible(path.stem, _NAME_LENGTH).replace("&", "&&"))
            button.setToolTip(plain_tip(str(path)))
            button.setAccessibleName(_("Open {name}").format(name=legible(path.name)))
            button.clicked.connect(partial(self._choose, self.file_chosen, path))
            self._recent.addWidget(button, 0, place)
        for place in range(4):
            self._recent.setColumnStretch(place, 1)

    def show_examples(self, examples: Sequence[tuple[str, str, str, QPixmap]]) -> None:
        """Offer examples, those of a workspace under its title: name, title, workspace, picture."""
        from PySide6.QtCore import Qt

        _empty(self._examples)
        self._cards = []
        row, column_of_card, last = -1, 0, ""
        for name, title, workspace, picture in examples:
            if workspace != last:
                group = QLabel(workspace)
                group.setProperty("role", "muted")
                row, column_of_card, last = row + 2, 0, workspace
                self._examples.addWidget(group, row - 1, 0, 1, _EXAMPLE_COLUMNS)
            elif column_of_card == _EXAMPLE_COLUMNS:
                row, column_of_card = row + 1, 0
            card = QPushButton()
            card.setProperty("card", True)
            card.setToolTip(_("Open the example: {title}").format(title=title))
            card.setAccessibleName(title)
            card.setFixedHeight(_CARD_PX)
            card.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            column = QVBoxLayout(card)
            column.setContentsMargins(10, 6, 10, 4)
            column.setSpacing(2)
            image = QLabel()
            image.setPixmap(picture)
            image.setAlignment(Qt.AlignmentFlag.AlignCenter)
            words = QLabel(title)
            words.setWordWrap(True)
            words.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
            for label in (image, words):
                label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
                column.addWidget(label)
            self._cards.append(card)
            card.clicked.connect(partial(self._choose, self.example_chosen, name))
            self._examples.addWidget(card, row, column_of_card)
            column_of_card += 1
        for place in range(_EXAMPLE_COLUMNS):
            self._examples.setColumnStretch(place, 1)

    def example_buttons(self) -> list[QPushButton]:
        """The example cards, in order."""
        return list(self._cards)


def _empty(grid: QGridLayout) -> None:
    for widget in take_widgets(grid):
        widget.deleteLater()
