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


def cut(window: "MainWindow") -> None:
    """Copy the selection of a field, or the selected figures or points, and remove them."""
    if not _let(window, "cut"):
        window.say_status(_("There is nothing here to cut; select a figure first."))


def delete(window: "MainWindow") -> None:
    """Remove the selection of a field, or what is selected in the picture."""
    if not _let(window, "delete"):
        window.say_status(_("There is nothing here to delete; select a figure first."))


def duplicate(window: "MainWindow") -> None:
    """Copy the selected figures beside themselves."""
    if not _let(window, "duplicate"):
        window.say_status(_("There is nothing here to duplicate; select a figure first."))


def group(window: "MainWindow") -> None:
    """Let the selected figures stay together."""
    if not _let(window, "group"):
        window.say_status(_("There is nothing here to group; select two figures first."))


def ungroup(window: "MainWindow") -> None:
    """Let the figures of the selected groups go by themselves."""
    if not _let(window, "ungroup"):
        window.say_status(_("There is nothing here to ungroup; select a group first."))


def bring_forwards(window: "MainWindow") -> None:
    """Move the selected figures past what is next in front of them."""
    if not _let(window, "bring_forwards"):
        window.say_status(_("There is nothing here to bring forwards; select a figure first."))


def send_backwards(window: "MainWindow") -> None:
    """Move the selected figures past what is next behind them."""
    if not _let(window, "send_backwards"):
        window.say_status(_("There is nothing here to send backwards; select a figure first."))


def select_all(window: "MainWindow") -> None:
    """Select all words of a field, or all figures or points."""
    if not _let(window, "select_all"):
        window.say_status(_("There is nothing here to select; go to a workspace with a canvas."))


_Text = QLineEdit | QPlainTextEdit | QTextEdit
_OF_PANELS = {act: f"{act}_selected" for act in ("delete", "duplicate", "group", "ungroup")}


def _let(window: "MainWindow", act: str) -> bool:
    """Let the first part do it that can; False when none can."""
    return any(_acts(part, act) for part in _parts(window))


def _acts(part: object, act: str) -> bool:
    """Let a part do it; False where it cannot, as text without what that takes."""
    if not isinstance(part, _Text):
        do = getattr(part, _OF_PANELS.get(act, act), None)
        return callable(do) and do() is not False
    if not _is_fit(part, act):
        return False
    if act == "select_all":
        part.selectAll()
    elif act != "delete":
        getattr(part, act)()
    elif isinstance(part, QLineEdit):
        part.del_()
    else:
        part.textCursor().removeSelectedText()
    return True


def _is_fit(part: _Text, act: str) -> bool:
    """Whether a text has a selection where the act takes one, and is open to what changes it."""
    selected = part.hasSelectedText() if isinstance(part, QLineEdit) else part.textCursor().hasSelection()
    fit = {"copy": selected, "select_all": True, "paste": True, "cut": selected, "delete": selected}
    return fit.get(act, False) and (act in ("copy", "select_all") or not part.isReadOnly())


def _parts(window: "MainWindow") -> Iterator[object]:
    """What has the focus, what holds that, and at last the panel in the middle of the workspace."""
    part: QWidget | None = QApplication.focusWidget() or window.focusWidget()
    while part is not None:
        yield part
        part = part.parentWidget()
    yield from window.panels(window.place)[:1]
