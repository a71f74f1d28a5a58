"""Figures to the clipboard and back."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from workbench.document.building import Edit, foreseen, moved_by, without_ids
from workbench.document.edits import add_figures
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document, Sheet
from workbench.exchange.figures import MIME, write_figures
from workbench.exchange.reading import Job
from workbench.exchange.svg_reading import Imported
from workbench.language import _, ngettext
from workbench.session.session import Session

_BESIDE = 1.0, -1.0


def copy_figures(figures: list[AnyFigure]) -> str:
    """Put figures on the clipboard; the sentence that says so."""
    data = QMimeData()
    data.setData(MIME, write_figures(figures))
    QGuiApplication.clipboard().setMimeData(data)
    return ngettext("{n} figure copied.", "{n} figures copied.", len(figures)).format(n=len(figures))


def figures_held() -> bool:
    """Whether the clipboard has figures."""
    data = QGuiApplication.clipboard().mimeData()
    return data is not None and data.hasFormat(MIME)  # on some systems an empty clipboard is None


def paste_figures(session: Session, say: Callable[[str], object]) -> None:
    """Put the clipboard's figures on the sheet and select them; ``say`` is given what became of it.

    They come to where they were, or beside those that are there still. Many are read beside the interface.
    """
    if not figures_held():
        say(_("There are no figures on the clipboard; copy some first."))
        return
    job = Job("figures", content=bytes(QGuiApplication.clipboard().mimeData().data(MIME).data()))
    sheet = session.sheet
    take, prepare = partial(_take, session, sheet, say), partial(_placed, session.document, sheet)
    session.incoming.read(job, _("figures"), take, say, prepare)


def _placed(document: Document, sheet: Sheet, pasted: Imported) -> Edit:
    """The edit that puts figures on the sheet. Raises: ValueError with one sentence."""
    taken = {without_ids(figure) for figure in sheet.figures}
    figures = [without_ids(each) for each in pasted.figures]
    while taken.intersection(figures):
        figures = [moved_by(each, *_BESIDE) for each in figures]
    try:
        return foreseen(add_figures(sheet.id, figures), document)
    except DocumentError as problem:
        raise ValueError(problem.short) from None


def _take(session: Session, sheet: Sheet, say: Callable[[str], object], edit: Edit) -> None:
    if session.sheet.id != sheet.id:
        say(_("Another sheet was opened before the figures were pasted; paste them again here."))
        return
    before = len(session.sheet.figures)
    try:
        session.apply(edit, _("Paste"))
    except DocumentError as problem:
        say(problem.short)
        return
    pasted = tuple(figure.id for figure in session.sheet.figures[before:])
    if pasted:
        session.update_state(selection=pasted, active=pasted[-1])
    say(ngettext("{n} figure pasted.", "{n} figures pasted.", len(pasted)).format(n=len(pasted)))
