"""The interface goes before the threads beside it until what it has to do now is laid out and painted."""

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, QTimer

from workbench.engine.turns import interface

_SHOWN = QEvent.Type(QEvent.registerEventType())
_SETTLE_MS = 8
_AFTER_PAINTING = Qt.EventPriority.LowEventPriority.value - 1


class _UntilPainted(QObject):
    """Views are laid out by timers of no time, one after the other; they are painted by posted events."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._laid_out = QTimer(self)
        self._laid_out.setSingleShot(True)
        self._laid_out.setInterval(_SETTLE_MS)
        self._laid_out.timeout.connect(self._wait_for_painting)

    def begin(self) -> None:
        """The interface works from now on."""
        interface.works()
        self._laid_out.start()

    def _wait_for_painting(self) -> None:
        QCoreApplication.postEvent(self, QEvent(_SHOWN), _AFTER_PAINTING)

    def event(self, event: QEvent) -> bool:
        """Everything has been shown."""
        if event.type() != _SHOWN:
            return super().event(event)
        interface.rests()
        return True


def go_first() -> None:
    """Before what takes long to lay out or to paint: let recorders wait until it is done."""
    application = QCoreApplication.instance()
    if application is not None:
        (application.findChild(_UntilPainted) or _UntilPainted(application)).begin()
