"""The Display workspace: cathode-ray tubes, on pages that are switched at the top."""

from collections.abc import Generator, Mapping

from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.display.page import pages
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.panels.stage.workspace_page import Page, pages_of
from workbench.session.session import Session


class DisplayPanel(PagedPanel):
    """The pages of Display."""

    def __init__(
        self, session: Session, parent: QWidget | None = None, made: Mapping[str, Page] | None = None
    ) -> None:
        super().__init__(session, "display", pages(), parent, made)
        self.title = _("Display")

    @classmethod
    def making(cls, session: Session) -> "Generator[None, None, DisplayPanel]":
        """A page in two steps."""
        return cls(session, made=(yield from pages_of(pages(), session)))
