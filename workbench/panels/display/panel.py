"""The Display workspace: cathode-ray tubes, on pages that are switched at the top."""

from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.display.page import pages
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.session.session import Session


class DisplayPanel(PagedPanel):
    """The pages of Display."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, "display", pages(), parent)
        self.title = _("Display")
