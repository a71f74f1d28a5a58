"""The pages of a workspace that has several: what each is called, and the class that shows it.

A page is one row of its wing's table and a widget made with the session. Alt and its number in the table show
it; the page switch at the top of the workspace has a button for it. What a page offers beside itself it says
as a panel does, by ``docks()`` and ``commands()``; ``usual`` is the subject that is stepped on it at first,
``example`` what is opened where there is nothing to see, and each page has a position of its own.
"""

from collections.abc import Callable, Generator, Iterable, Sequence
from importlib import import_module
from typing import NamedTuple, Protocol, cast

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from workbench.algorithms import catalogue
from workbench.document.subjects import Subject
from workbench.engine.visits import read
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.panels.panel import Cell, DockPart, Said
from workbench.session.session import Session


class Page(Protocol):
    """What fills the workspace while it is chosen."""

    usual: Subject
    example: str

    @property
    def widget(self) -> QWidget:
        """The page itself."""

    def docks(self) -> Sequence[DockPart]:
        """Its docks, which are there on every page."""

    def commands(self) -> Sequence[QAction]:
        """Its commands."""

    def said(self) -> Said:
        """What it says in the status bar."""

    def tables(self) -> Sequence[tuple[str, Table]]:
        """Title and content of each table of its own that can be exported now."""

    def copy(self) -> bool:
        """Put what is chosen, or the picture, on the clipboard; whether it has anything to copy."""

    def paste(self) -> bool:
        """Take what is on the clipboard; whether anything can be pasted into it."""

    def derivation(self) -> Derivation | None:
        """The page that derives what is shown, if there is any."""

    def drawing(self) -> Derivation | None:
        """The drawing alone of what the page explains, if it has one."""

    def offer_export(self, menu: QMenu) -> None:
        """Let its own menus lead to what can be exported."""

    def point_at(self, cell: Cell | None) -> None:
        """Show where a pixel is that the sentence names; None when no longer."""


class PageRow(NamedTuple):
    """``slug`` names the page and its position in the session, ``maker`` is "module:class"; it is empty where
    the workspace has its pages from elsewhere.
    """

    slug: str
    title: str
    tooltip: str
    maker: str = ""

    def make(self, session: Session) -> Page:
        """The page, over a session."""
        module, _colon, name = self.maker.partition(":")
        made = cast("Callable[[Session], Page]", getattr(import_module(module), name))
        return made(session)


def pages_of(rows: Iterable[PageRow], session: Session) -> Generator[None, None, dict[str, Page]]:
    """The pages of these rows, by slug; each comes in three steps: its module, itself, the text it steps."""
    pages = {}
    for row in rows:
        import_module(row.maker.partition(":")[0])
        yield
        pages[row.slug] = row.make(session)
        yield
        for usual in session.choices_of(pages[row.slug].usual)[:1]:
            read(catalogue.get(usual))
            yield
    return pages
