"""Figures to the clipboard and back."""

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from workbench.document.building import moved_by, without_ids
from workbench.document.edits import add_figures
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure
from workbench.exchange.figures import MIME, read_figures, write_figures
from workbench.language import _, ngettext
from workbench.session.session import Session

_BESIDE = 1.0, -1.0


def copy_figures(figures: list[AnyFigure], text: str = "") -> str:
    """Put figures on the clipboard, with ``text`` for other programs; the sentence that says so."""
    data = QMimeData()
    data.setData(MIME, write_figures(figures))
    if text:
        data.setText(text)
    QGuiApplication.clipboard().setMimeData(data)
    return ngettext("{n} figure copied.", "{n} figures copied.", len(figures)).format(n=len(figures))


def figures_held() -> bool:
    """Whether the clipboard has figures."""
    data = QGuiApplication.clipboard().mimeData()
    return data is not None and data.hasFormat(MIME)  # on some systems an empty clipboard is None


def paste_figures(session: Session) -> str:
    """Put the clipboard's figures on the sheet and select them; the sentence that says what became of it.

    They come to where they were, or beside those that are there still.
    """
    if not figures_held():
        return _("There are no figures on the clipboard; copy some first.")
    sheet = session.sheet
    taken = {without_ids(figure) for figure in sheet.figures}
    try:
        figures = [without_ids(each) for each in _figures()]
        while taken.intersection(figures):
            figures = [moved_by(each, *_BESIDE) for each in figures]
        session.apply(add_figures(sheet.id, figures), _("Paste"))
    except DocumentError as problem:
        return problem.short
    made = [figure.id for figure in session.sheet.figures[len(sheet.figures) :]]
    if made:
        session.update_state(selection=tuple(made), active=made[-1])
    return ngettext("{n} figure pasted.", "{n} figures pasted.", len(made)).format(n=len(made))


def _figures() -> list[AnyFigure]:
    try:
        return read_figures(QGuiApplication.clipboard().mimeData().data(MIME).data())
    except ValueError as problem:
        raise DocumentError(
            "", _("The figures on the clipboard cannot be read; copy them again.")
        ) from problem
