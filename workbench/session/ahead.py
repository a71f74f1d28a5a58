"""What is worked out of whole sheets: of small ones at once, of large ones beside the interface."""

from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

from PySide6.QtCore import QObject, Signal

from workbench.document.model import Sheet
from workbench.engine.background import report
from workbench.session.answers import Answers

T = TypeVar("T")
_Key = tuple[Any, ...]

_FEW_FIGURES, _FEW_POINTS = 300, 2000
_KEPT, _KEPT_OF_A_NAME = 12, 3


def is_large(sheet: Sheet) -> bool:
    """Whether to paint or list all of its figures may hold the interface."""
    figures = sheet.figures
    return len(figures) > _FEW_FIGURES or sum(len(each.points_world) for each in figures) > _FEW_POINTS


class Ahead(QObject):
    """Works on one thing at a time, on a thread. ``arrived``: there is one more for who asks again."""

    arrived = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._kept: list[tuple[_Key, Any]] = []
        self._waiting: dict[str, tuple[_Key, Callable[[], Any]]] = {}
        self._working: _Key | None = None
        self._forgotten = False  # what is worked on is of a document that was closed
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether anything is worked on, or waits."""
        return self._working is not None or bool(self._waiting)

    def of(self, sheet: Sheet, name: str, make: Callable[[], T], *beside: object) -> T | None:
        """What ``make`` gives of ``sheet``, under a ``name`` and what ``beside`` the sheet it depends on.

        None until it is there; of those of one name that are waited for, only the last is made. ``make``
        holds nothing of Qt. What it raises is told where the faults of threads are, and it is not made again.
        """
        if not is_large(sheet):
            return make()
        key = (sheet, name, *beside)
        for known, value in self._kept:
            if known == key:
                return value  # type: ignore[no-any-return]
        if key != self._working or self._forgotten:
            self._waiting[name] = key, make
            self._next()
        return None

    def forget(self) -> None:
        """Another document is open: nothing is kept of the one before, nor of what is still worked on."""
        self._kept.clear()
        self._waiting.clear()
        self._forgotten = self._working is not None

    def _next(self) -> None:
        if self._working is not None or not self._waiting:
            return
        key, make = self._waiting.pop(next(iter(self._waiting)))
        self._working = key
        self._answers.ask(partial(_answer, key, make), "sheets")

    def _take(self, answer: tuple[_Key, Any]) -> None:
        forgotten, self._working, self._forgotten = self._forgotten, None, False
        if not forgotten:
            (_sheet, name, *_beside), _value = answer
            alike = [each for each in self._kept if each[0][1] == name][_KEPT_OF_A_NAME - 1 :]
            rest = [each for each in self._kept if not any(each is old for old in alike)]
            self._kept = [answer, *rest][:_KEPT]
            self.arrived.emit()
        self._next()


def _answer(key: _Key, make: Callable[[], T]) -> tuple[_Key, T | None]:
    try:
        return key, make()
    except Exception:
        report()
        return key, None
