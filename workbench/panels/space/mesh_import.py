"""Mesh files come into the scene, or onto a sheet of their own where there is no scene yet."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from msgspec.structs import replace

from workbench.document.building import Edit, foreseen
from workbench.document.check import MAX_NAME
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.edits import add_object
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Material, Object, Scene
from workbench.document.scene.solids import MeshSolid
from workbench.document.sheet_edits import add_sheet
from workbench.exchange.mesh_reading import ImportedMesh
from workbench.exchange.reading import Job
from workbench.language import _, legible
from workbench.rendering.scene.around import camera_around
from workbench.session.session import Session

_SIZE_PX = (320, 240)
_COLOUR = 0x9CC8E6

Say = Callable[[str], object]


class MeshImport:
    """Its sentences name the file: what was left out, or why nothing came in."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def take_file(self, path: Path, say: Say, refuse: Say) -> None:
        """Read a mesh file, beside the interface where it is long, and bring it in as one step of undo.

        ``say`` is told what came in, ``refuse`` why nothing did.
        """
        name, sheet = path.stem[:MAX_NAME], self._session.sheet
        beside = "" if sheet.scene is None else sheet.id
        self._session.incoming.read(
            Job("mesh", str(path)),
            path.name,
            partial(self._take, path, beside, say, refuse),
            partial(self._refuse, path, refuse),
            partial(self._edit, self._session.document, name, beside),
        )

    @staticmethod
    def _edit(document: Document, name: str, sheet: str, read: ImportedMesh) -> tuple[Edit, tuple[str, ...]]:
        solid = MeshSolid(blob_of(read.mesh))
        if sheet:
            edit = add_object(sheet, Object("", solid, "", name))
        else:
            scene = Scene(
                (Object("o1", solid, "m1", name),),
                (Material("m1", name, _COLOUR, 0.45, 0.6),),
                camera=camera_around(read.mesh.vertices),
            )
            edit = add_sheet(replace(blank_sheet(*_SIZE_PX, name).sheets[0], scene=scene))
        return foreseen(edit, document), read.notes

    @staticmethod
    def _refuse(path: Path, refuse: Say, error: str) -> None:
        sentence = _("{name} was not imported: {error}")
        refuse(sentence.format(name=legible(path.name), error=error))

    def _take(
        self, path: Path, beside: str, say: Say, refuse: Say, made: tuple[Edit, tuple[str, ...]]
    ) -> None:
        edit, notes = made
        session = self._session
        sheets = {sheet.id for sheet in session.document.sheets}
        try:
            session.apply(edit, _("Import {name}").format(name=legible(path.name)))
        except DocumentError as problem:
            self._refuse(path, refuse, problem.short)
            return
        new = [sheet.id for sheet in session.document.sheets if sheet.id not in sheets]
        onto = new[0] if new else beside
        if session.sheet.id != onto:  # another may have been shown while it was read
            session.show_sheet(onto)
        scene = session.sheet.scene
        if scene is not None:
            session.update_state(thing=scene.objects[-1].id)
        imported = _("{name} is in the scene.").format(name=legible(path.name))
        say(" ".join((imported, *notes)))
