"""What is said before a tube really flashes."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QFrame, QHBoxLayout, QLabel, QPushButton, QWidget

from workbench.language import _
from workbench.widgets.look.comfort import comfort


class CalmSwitch(QCheckBox):
    """Calm, on or off. A hand switches it on at once; off it stays on and asks for the warning first.

    ``flash_wanted``: connect it with ``FlashWarning.ask``, whose answer alone switches Calm off.
    """

    flash_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Calm"), parent)
        self.setAccessibleName(_("Calm"))
        self.setToolTip(_("Hold flicker, flashing and motion still, here and everywhere"))
        comfort.changed.connect(self._show_calm)
        self._show_calm()

    def nextCheckState(self) -> None:
        """What a click and the space bar do."""
        if comfort.calm:
            self.flash_wanted.emit()
        else:
            comfort.set_calm(True)

    def _show_calm(self) -> None:
        self.setChecked(comfort.calm)


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
        comfort.changed.connect(self.hide)
        self.hide()

    def ask(self, flash_hz: float | None = None) -> None:
        """Warn, with the rate where one tube is meant; leave Calm as it is until somebody has answered."""
        flashes = _("Tubes will flash as real ones do.")
        if flash_hz is not None:
            flashes = _("The tube will flash {rate:.3g} times a second.").format(rate=flash_hz)
        danger = _(
            "Flashing between 3 and 30 times a second can bring on a seizure in people with "
            "photosensitive epilepsy."
        )
        self.words.setText(f"\N{WARNING SIGN} {flashes} {danger}")
        self.setAccessibleName(self.words.text())
        self.show()
        self.keep.setFocus()

    def _answer(self, calm: bool) -> None:
        self.hide()
        comfort.set_calm(calm)
