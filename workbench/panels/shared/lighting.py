"""Shows a scene that cannot be lit yet as soon as it can."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from workbench.document.model import Sheet
from workbench.rendering.scene.backdrop import can_be_lit

_AGAIN_MS = 500


class Lighting(QObject):
    """Calls ``again`` half a second after a scene was asked for that cannot be lit yet."""

    def __init__(self, again: Callable[[], object], parent: QObject) -> None:
        super().__init__(parent)
        self._due = QTimer(self, singleShot=True, interval=_AGAIN_MS)
        self._due.timeout.connect(again)

    def lit(self, sheet: Sheet) -> bool:
        """Whether its scene, if it has one, can be lit; if not, it is asked for again."""
        lit = can_be_lit(sheet)
        if not lit:
            self._due.start()
        return lit
