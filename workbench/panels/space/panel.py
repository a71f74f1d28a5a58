"""The Space workspace: a scene in three dimensions, on pages that are switched at the top."""

from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.space.mesh_import import MeshImport
from workbench.panels.space.page import pages
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.session.session import Session


class SpacePanel(PagedPanel):
    """The pages of Space, and the mesh files that it takes."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(session, "space", pages(), parent)
        self.title = _("Space")
        self.meshes = MeshImport(session)
