"""Sees how a recovery file fares: its thread knows nothing of Qt, and is asked now and then."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from workbench.language import _
from workbench.session.recovery import RecoveryFile

_LOOK_MS = 250


class RecoveryWatch(QObject):
    """``failed`` is given a sentence when trouble begins or has another reason, ``mended`` one at its end."""

    def __init__(
        self,
        file: RecoveryFile,
        failed: Callable[[str], object],
        mended: Callable[[str], object],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._file, self._failed, self._mended = file, failed, mended
        self._trouble = ""
        timer = QTimer(self)
        timer.timeout.connect(self._look)
        timer.start(_LOOK_MS)
        self._look()

    def _look(self) -> None:
        before, self._trouble = self._trouble, self._file.trouble
        if self._trouble == before:
            return
        if self._trouble:
            self._failed(self._trouble)
        else:
            self._mended(_("Unsaved work is kept safe again."))
