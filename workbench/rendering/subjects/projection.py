"""A vertex of an object on its way into the picture, or its faces clipped to what the camera sees."""

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.projection import clip_to_view_volume, project_point
from workbench.algorithms.viewing import window_to_viewport
from workbench.document.fields import Number
from workbench.document.model import Sheet, whole_sheet
from workbench.document.scene.model import Camera, Object
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.document.subjects import Subject
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.scene.around import whole_window
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "projection"
SLUG, CLIPPING = project_point.__name__, clip_to_view_volume.__name__
MOST_CLIPPED = 60
_MOST_VERTICES = 2**31


def vertex_of(sheet: Sheet, subject: Subject) -> tuple[Object, int] | None:
    """The object and the number of its vertex that are projected, by default the first of the front one.

    None where nothing can be: there is no scene, or no object in it.
    """
    objects = sheet.scene.objects if sheet.scene else ()
    thing = next((each for each in objects if each.id in subject.ids), next(iter(objects), None))
    number = subject.arguments.get("vertex", 0)
    if thing is None or not isinstance(number, int):
        return None
    return thing, min(number, len(thing.mesh.vertices) - 1)


def is_of_a_vertex(subject: Subject) -> bool:
    """Whether a vertex on its way into the picture is what is stepped."""
    return subject.kind == KIND


def clips(subject: Subject) -> bool:
    """Whether the faces of an object are clipped, rather than a vertex projected."""
    return subject.entry == CLIPPING


def seen_from(camera: Camera) -> dict[str, tuple[float, ...]]:
    """The arguments by which a subject is seen otherwise than by the camera of its scene."""
    view, plane = view_matrix(camera), projection_matrix(camera)
    return {"view": tuple(map(float, view.ravel())), "projection": tuple(map(float, plane.ravel()))}


def _matrix(subject: Subject, name: str, usual: Array) -> Array:
    entries = subject.arguments.get(name, ())
    return np.array(entries).reshape(4, 4) if isinstance(entries, tuple) and len(entries) == 16 else usual


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    chosen = vertex_of(sheet, subject)
    if chosen is None or sheet.scene is None:
        return []
    thing, number = chosen
    camera = sheet.scene.camera
    model = np.eye(4) if thing.matrix is None else thing.matrix
    view = _matrix(subject, "view", view_matrix(camera))
    plane = _matrix(subject, "projection", projection_matrix(camera))
    size = sheet.width_px, sheet.height_px
    window, whole = whole_window(sheet.scene, size), whole_sheet(*size)
    sides = [(each.xmin, each.ymin, each.xmax, each.ymax) for each in (window, whole)]
    if clips(subject):
        given = subject.arguments.get("window", ())
        seen = given if isinstance(given, tuple) and len(given) == 4 else sides[0]
        return [_clipped(thing, plane @ view @ model, seen)]
    viewport = window_to_viewport(sides[0], sides[1], True)
    arguments = model, view, plane, viewport, thing.mesh.vertices[number].copy()
    return [Call(catalogue.get(SLUG), arguments)]


def _clipped(thing: Object, whole: Array, window: tuple[float, ...]) -> Call:
    """The faces of an object, of very many the first, through all matrices to the planes of the volume."""
    vertices, faces = thing.mesh
    count = min(len(faces), MOST_CLIPPED)
    ends = np.cumsum(faces.sizes[:count])
    corners = faces.corners[: int(ends[-1]) if count else 0]
    placed_corners = vertices[corners] @ whole[:, :3].T + whole[:, 3]
    return Call(catalogue.get(CLIPPING), (placed_corners, ends, *map(float, window)))


register(
    KIND,
    SubjectKind(
        title=_("A vertex on its way into the picture"),
        invitation=_("Add an object in Space, to see how its vertices come into the picture, step by step."),
        calls=_calls,
        choices=lambda _sheet, _subject: (SLUG, CLIPPING),
        entries=(SLUG, CLIPPING),
        arguments={
            "vertex": Given(
                0, Number(label=_("vertex"), low=0, high=_MOST_VERTICES, whole=True, keyed=False)
            ),
            "view": Given((0.0,)),
            "projection": Given((0.0,)),
            "window": Given((0.0,)),
        },
    ),
)
