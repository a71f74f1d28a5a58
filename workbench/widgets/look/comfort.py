"""What a person has asked for about motion: widgets hold still while ``comfort.calm`` is on."""

from PySide6.QtCore import QObject, Signal


class Comfort(QObject):
    """``calm`` is on until switched off: no flashing, no motion unasked for. ``changed`` follows it."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._calm = True

    @property
    def calm(self) -> bool:
        """Whether motion and flashing are held still."""
        return self._calm

    def set_calm(self, calm: bool) -> None:
        """Hold motion still, or let it run; called by the shell."""
        if calm != self._calm:
            self._calm = calm
            self.changed.emit()


comfort = Comfort()
