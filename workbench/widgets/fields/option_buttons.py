"""The choices of a person who is asked first, as buttons; they are there only while something is asked."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QPushButton, QWidget

from workbench.language import _
from workbench.session.run import Run

_HEIGHT, _IN_ONE_ROW = 22, 3


class OptionButtons(QWidget):
    """One button for each option of ``run``; the keys 1, 2, ... press them."""

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._options: tuple[object, ...] = ()
        self.buttons: list[QPushButton] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(8, 0, 12, 0)
        self._grid.setHorizontalSpacing(4)
        self._grid.setVerticalSpacing(2)
        self.setAccessibleName(_("What comes next?"))
        for signal in (run.changed, run.moved, run.grown, run.asked):
            signal.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Follow the run."""
        options = self._run.options
        if options != self._options:
            self._offer(options)
        answered = self._run.answered
        for button, option in zip(self.buttons, options, strict=True):
            button.setEnabled(answered is None or answered.given != option)

    def _offer(self, options: tuple[object, ...]) -> None:
        self._options = options
        for button in self.buttons:
            self._grid.removeWidget(button)
            button.hide()
            button.deleteLater()
        self.buttons = [self._button(number, option) for number, option in enumerate(options, 1)]
        self.setVisible(bool(options))

    def _button(self, number: int, option: object) -> QPushButton:
        text = _(str(option))
        button = QPushButton(text[:1].upper() + text[1:])
        button.setShortcut(str(number))
        button.setToolTip(_("Answer that this comes next ({key})").format(key=number))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda: self._run.choose(option))
        button.setProperty("low", True)
        button.setFixedHeight(_HEIGHT)
        columns = len(self._options) if len(self._options) <= _IN_ONE_ROW else -(-len(self._options) // 2)
        self._grid.addWidget(button, (number - 1) // columns, (number - 1) % columns)
        return button
