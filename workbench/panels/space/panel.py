"""The Space workspace: a scene in three dimensions, on pages that are switched at the top."""

from collections.abc import Generator, Mapping

from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.space.mesh_import import MeshImport
from workbench.panels.space.page import pages
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.panels.stage.workspace_page import Page, pages_of
from workbench.session.session import Session


class SpacePanel(PagedPanel):
    """The pages of Space, and the mesh files that it takes."""

    def __init__(
        self, session: Session, parent: QWidget | None = None, made: Mapping[str, Page] | None = None
    ) -> None:
        super().__init__(session, "space", pages(), parent, made)
        self.title = _("Space")
        self.meshes = MeshImport(session)

    @classmethod
    def making(cls, session: Session) -> "Generator[None, None, SpacePanel]":
        """A page in two steps."""
        return cls(session, made=(yield from pages_of(pages(), session)))
