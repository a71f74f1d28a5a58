"""Figures to the clipboard and back."""

from collections.abc import Callable
from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from workbench.document.building import Edit, foreseen, moved_by, without_ids
from workbench.document.edits import add_drawing, add_moving_figures
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document, Sheet
from workbench.exchange.figures import MIME, write_figures
from workbench.exchange.reading import LIMITS, Job
from workbench.exchange.svg_reading import Imported
from workbench.exchange.svg_writing import write_svg
from workbench.language import _, ngettext
from workbench.session.session import Session

_SVG = "image/svg+xml"
_BESIDE = 1.0, -1.0


def copy_figures(sheet: Sheet, figures: list[AnyFigure]) -> str:
    """Put figures of a sheet on the clipboard, with their tracks, and for other programs as SVG; the sentence
    that says so.
    """
    data = QMimeData()
    data.setData(MIME, write_figures(sheet, figures))
    data.setData(_SVG, write_svg(replace(sheet, figures=tuple(figures), scene=None)).text.encode())
    QGuiApplication.clipboard().setMimeData(data)
    return ngettext("{n} figure copied.", "{n} figures copied.", len(figures)).format(n=len(figures))


def figures_held() -> bool:
    """Whether the clipboard has figures of this program."""
    data = QGuiApplication.clipboard().mimeData()
    return data is not None and data.hasFormat(MIME)  # on some systems an empty clipboard is None


def paste_figures(session: Session, say: Callable[[str], object]) -> None:
    """Put the clipboard's figures, or its SVG, on the sheet and select them; ``say`` tells what became of it.

    They come to where they were, or beside those that are there still. Many are read beside the interface.
    """
    sheet = session.sheet
    job = _job_held(sheet)
    if job is None:
        say(_refusal())
        return
    take, prepare = partial(_take, session, sheet, say), partial(_placed, session.document, sheet)
    session.incoming.read(job, _("figures"), take, say, prepare)


def _refusal() -> str:
    """Why nothing is pasted, and what to do."""
    data = QGuiApplication.clipboard().mimeData()
    if data is not None and data.hasText() and data.text().strip():
        return _("The text on the clipboard is not an SVG; go to Curves to paste points or path data.")
    return _("There are no figures on the clipboard; copy some first.")


def _job_held(sheet: Sheet) -> Job | None:
    """How the figures on the clipboard are read; None where there are none."""
    data = QGuiApplication.clipboard().mimeData()
    if data is None:
        return None
    if data.hasFormat(MIME):
        return Job("figures", content=bytes(data.data(MIME).data()))
    if data.hasFormat(_SVG):
        return Job("drawing", content=bytes(data.data(_SVG).data()), sheet=sheet)
    text = data.text() if data.hasText() else ""
    if "<svg" in text or "<path" in text:
        return Job("drawing", content=text[: LIMITS["drawing"] + 1].encode(), sheet=sheet)
    return None


def _placed(document: Document, sheet: Sheet, pasted: Imported) -> Edit:
    """The edit that puts figures on the sheet. Raises: DocumentError."""
    taken = {_alone(figure) for figure in sheet.figures}
    figures = [without_ids(each) for each in pasted.figures]
    while taken.intersection(map(_alone, figures)):
        figures = [moved_by(each, *_BESIDE) for each in figures]
    edit = add_drawing(sheet.id, figures, pasted.palette)
    if pasted.motion is not None:
        edit = add_moving_figures(sheet.id, figures, pasted.figures, pasted.motion)
    return foreseen(edit, document)


def _alone(figure: AnyFigure) -> AnyFigure:
    """A figure as it would be drawn at its place, whatever it is called and is together with."""
    return replace(without_ids(figure), group=0)


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
