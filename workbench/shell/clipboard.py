"""Copy and paste act on what has the focus, and where that cannot, on the picture of the workspace."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QPlainTextEdit, QTextEdit, QWidget

from workbench.language import _

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


def copy(window: "MainWindow") -> None:
    """Copy the selection of a field, words or table, the selected figures, or the picture."""
    focus = QApplication.focusWidget()
    if isinstance(focus, QLabel) and focus.hasSelectedText():
        QApplication.clipboard().setText(focus.selectedText())
    elif not _let(window, "copy"):
        window.say_status(_("There is nothing here to copy."))


def paste(window: "MainWindow") -> None:
    """Paste into a field, or figures and points into the picture."""
    if not _let(window, "paste"):
        window.say_status(_("Nothing can be pasted here; go to a workspace with a canvas."))


def _let(window: "MainWindow", act: str) -> bool:
    """Let the first part do it that can; False when none can."""
    return any(_can(part, act) and getattr(part, act)() is not False for part in _parts(window))


def _can(part: object, act: str) -> bool:
    """Whether a part knows how; text also needs a selection to copy, and to be open to what is pasted."""
    if isinstance(part, QLineEdit):
        selected = part.hasSelectedText()
    elif isinstance(part, QPlainTextEdit | QTextEdit):
        selected = part.textCursor().hasSelection()
    else:
        return callable(getattr(part, act, None))
    return selected if act == "copy" else not part.isReadOnly()


def _parts(window: "MainWindow") -> Iterator[object]:
    """What has the focus, what holds that, and at last the panel in the middle of the workspace."""
    part: QWidget | None = QApplication.focusWidget() or window.focusWidget()
    while part is not None:
        yield part
        part = part.parentWidget()
    yield from window.panels(window.place)[:1]
