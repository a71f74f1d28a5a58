"""The chosen object to the clipboard and back, into this scene or another."""

from msgspec.structs import replace
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from workbench.document.building import Edit, both, without_ids
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.scene.edits import add_material, add_object, move_last_object_as
from workbench.document.scene.links import Translate3D
from workbench.exchange.objects import MIME, CopiedObject, read_object, write_object
from workbench.language import _
from workbench.session.session import Session

_ASIDE = 1.2


def copy_object(session: Session) -> bool:
    """Put the chosen object on the clipboard; False where none is chosen."""
    scene, chosen = session.sheet.scene, session.state.thing
    thing = next((each for each in scene.objects if each.id == chosen), None) if scene else None
    if thing is None or scene is None:
        return False
    material = next(each for each in scene.materials if each.id == thing.material)
    data = QMimeData()
    data.setData(MIME, write_object(session.sheet, thing, material))
    QGuiApplication.clipboard().setMimeData(data)
    return True


def copy_chosen(session: Session, picture: QWidget) -> str:
    """Put the chosen object on the clipboard, or with none chosen a picture; the sentence that says so."""
    if copy_object(session):
        return _("The object is on the clipboard.")
    QGuiApplication.clipboard().setPixmap(picture.grab())
    return _("The picture is on the clipboard.")


def object_held() -> bool:
    """Whether the clipboard has an object."""
    data = QGuiApplication.clipboard().mimeData()
    return data is not None and data.hasFormat(MIME)  # on some systems an empty clipboard is None


def paste_object(session: Session) -> str:
    """Put the clipboard's object into the scene, as one step of undo, and choose it; what was wrong.

    It comes to where it was, or aside from those that are there still.
    """
    try:
        held = read_object(bytes(QGuiApplication.clipboard().mimeData().data(MIME).data()))
        session.apply(_pasted(session, held), _("Paste"))
    except DocumentError as problem:
        return problem.short
    except ValueError as error:
        return str(error)
    scene = session.sheet.scene
    assert scene is not None
    session.update_state(thing=scene.objects[-1].id)
    return ""


def _pasted(session: Session, held: CopiedObject) -> Edit:
    sheet = session.sheet.id
    scene = session.sheet.scene
    thing = without_ids(held.thing)
    there = (
        []
        if scene is None
        else [replace(without_ids(each), material=thing.material) for each in scene.objects]
    )
    while thing in there:
        vertices = thing.mesh.vertices
        aside = Translate3D("", tx=_ASIDE * float((vertices.max(axis=0) - vertices.min(axis=0))[0]))
        thing = replace(thing, transforms=(*thing.transforms, aside))

    def add(document: Document) -> Document:
        """With the material that was added just before."""
        on = next(each for each in document.sheets if each.id == sheet)
        assert on.scene is not None
        return add_object(sheet, replace(thing, material=on.scene.materials[-1].id))(document)

    edit = both(add_material(sheet, replace(held.material, id="")), add)
    if held.motion is None:
        return edit
    return both(edit, move_last_object_as(sheet, held.thing, held.motion))
