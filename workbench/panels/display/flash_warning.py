"""What is said before a tube really flashes."""

from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QWidget

from workbench.language import _
from workbench.widgets.look.comfort import comfort


class FlashWarning(QFrame):
    """A strip with a warning and two answers; hidden until ``ask``."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setProperty("role", "warn")
        self.show_it = QPushButton(_("Show the flashing"))
        self.show_it.setToolTip(_("Switch Calm off: the tube flickers as the real one does"))
        self.keep = QPushButton(_("Keep it still"))
        self.keep.setToolTip(_("Leave Calm on: the mean of each picture is shown"))
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(8)
        row.addWidget(self.words, 1)
        row.addWidget(self.show_it)
        row.addWidget(self.keep)
        self.show_it.clicked.connect(lambda: self._answer(False))
        self.keep.clicked.connect(lambda: self._answer(True))
        self.hide()

    def ask(self, refresh_hz: float) -> None:
        """Warn, and leave Calm as it is until somebody has answered."""
        said = _(
            "\N{WARNING SIGN} The tube will flash {rate:.3g} times a second. Flashing between 3 and 30 times "
            "a second can bring on a seizure in people with photosensitive epilepsy."
        )
        self.words.setText(said.format(rate=refresh_hz))
        self.setAccessibleName(self.words.text())
        self.show()
        self.keep.setFocus()

    def _answer(self, calm: bool) -> None:
        self.hide()
        comfort.set_calm(calm)
