"""The scene of a sheet under a method for hidden surfaces, on a coarse picture, so that it can be stepped."""

from collections.abc import Iterable
from functools import lru_cache

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Frame, Mark
from workbench.algorithms.visibility import depth_buffer
from workbench.display.phosphor import linear_from_srgb
from workbench.document.fields import Number
from workbench.document.model import Rectangle, Sheet
from workbench.document.scene.model import Object, Scene
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.marks import on_device
from workbench.rendering.scene import back_face_calls
from workbench.rendering.scene.back_face_calls import BACK_FACES
from workbench.rendering.scene.fragments import fragments_of
from workbench.rendering.scene.line_calls import HIDDEN_LINES, line_call
from workbench.rendering.scene.methods import A_BUFFER, METHODS, method_call
from workbench.rendering.scene.render import DeviceTriangles, device_triangles, placed
from workbench.rendering.scene.solid_octree import (
    COMBINED,
    CUT,
    OCTREE,
    Cutting,
    combined_call,
    octree_call,
    octree_things,
)
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "visibility"
DEPTH_BUFFER = depth_buffer.__name__
LEAST_COLUMNS, USUAL_COLUMNS, MOST_COLUMNS = 8, 48, 96
SURFACE_METHODS = (*(method for method in METHODS if method != DEPTH_BUFFER), A_BUFFER)
"""Those that keep no depths, and are told by their own marks and what they have painted."""
OCTREES = OCTREE, COMBINED
"""Those that divide solids into cells."""
NOT_ROUNDED = 0
LEAST_BITS, MOST_BITS = 4, 32
MOST_TRIANGLES = 2_500
USUAL_DEPTH, MOST_DEPTH = 3, 5
_MOST_ROWS = 192

Size = tuple[int, int]


def is_of_the_scene(subject: Subject) -> bool:
    """Whether a method for hidden surfaces is what is stepped."""
    return subject.kind == KIND


def window_of(sheet: Sheet) -> Rectangle | None:
    """What is seen of the view plane; None, all of the scene, where nobody has chosen a window for it.

    Of a sheet whose world is its pixels nobody has.
    """
    view = sheet.first_view
    return None if view.window_world == view.viewport_device else view.window_world


def scene_size(sheet: Sheet, subject: Subject) -> Size:
    """Columns and rows of the coarse picture, in the proportions of what is seen."""
    return size_of(sheet, _number(subject, "columns", USUAL_COLUMNS))


def size_of(sheet: Sheet, columns: int) -> Size:
    """The size with so many columns."""
    seen = window_of(sheet) or sheet.first_view.viewport_device
    share = (seen.ymax - seen.ymin) / (seen.xmax - seen.xmin)
    return columns, min(max(round(columns * share), 1), _MOST_ROWS)


def depth_bits(subject: Subject) -> int:
    """How many bits the depth buffer has for a pixel; NOT_ROUNDED for depths as they are."""
    bits = _number(subject, "bits", NOT_ROUNDED)
    return bits if bits == NOT_ROUNDED else max(bits, LEAST_BITS)


def farthest(subject: Subject) -> float:
    """The depth that the buffer begins with: 1, or the largest whole number that its bits can hold."""
    bits = depth_bits(subject)
    return float(2**bits - 1) if bits else 1.0


def backwards(subject: Subject) -> bool:
    """Whether the surfaces are drawn the last one first."""
    return bool(subject.arguments.get("backwards", False))


def triangles_of(sheet: Sheet, subject: Subject) -> DeviceTriangles | None:
    """The scene on the coarse picture, in the order in which it is drawn; None where nothing can be stepped.

    z is as the depth buffer counts it, from 0 to ``farthest``.
    """
    if sheet.scene is None or fault_of(sheet):
        return None
    return _triangles(
        sheet.scene,
        scene_size(sheet, subject),
        window_of(sheet),
        farthest(subject),
        backwards(subject),
    )


def fault_of(sheet: Sheet) -> str:
    """Why the scene cannot be stepped, in a sentence; empty where it can."""
    return _("This sheet has no scene.") if sheet.scene is None else _fault(sheet.scene)


@lru_cache(maxsize=16)
def _fault(scene: Scene) -> str:
    try:
        count = sum(len(cut) for _mesh, (cut, _faces), *_rest in placed(scene))
    except ValueError as problem:
        return str(problem)
    if count > MOST_TRIANGLES:
        said = _(
            "The scene has {count:,} triangles; at most {most:,} can be stepped. Hide some of its objects."
        )
        return said.format(count=count, most=MOST_TRIANGLES)
    return ""


def visible_objects(scene: Scene) -> tuple[Object, ...]:
    """The objects that the numbers in ``DeviceTriangles.objects`` mean."""
    return tuple(thing for thing in scene.objects if thing.visible)


def depth_call(sheet: Sheet, subject: Subject) -> Call | None:
    """The run of the depth buffer on the scene; None where nothing can be stepped."""
    if sheet.scene is None or fault_of(sheet):
        return None
    return _depth_call(
        sheet.scene,
        scene_size(sheet, subject),
        window_of(sheet),
        depth_bits(subject),
        backwards(subject),
    )


@lru_cache(maxsize=16)
def _triangles(
    scene: Scene, size: Size, window: Rectangle | None, largest: float, last_first: bool
) -> DeviceTriangles:
    device = device_triangles(placed(scene), scene.lights, scene.camera, size, window)
    order = slice(None, None, -1 if last_first else 1)
    corners = device.corners * (1.0, 1.0, largest)
    return DeviceTriangles(corners, *(np.ascontiguousarray(column[order]) for column in device[1:]))


@lru_cache(maxsize=16)
def _depth_call(scene: Scene, size: Size, window: Rectangle | None, bits: int, last_first: bool) -> Call:
    largest = 2**bits - 1 if bits else 1
    device = _triangles(scene, size, window, float(largest), last_first)
    image = np.zeros(size[::-1], np.uint32)
    # Into a buffer of whole numbers the text's own writing cuts a depth off, as a real one does.
    depth = np.full(size[::-1], largest, np.int64 if bits else np.float64)
    arguments = image, depth, device.corners, device.triangles, device.colours
    return Call(catalogue.get(DEPTH_BUFFER), arguments)


def surface_call(sheet: Sheet, subject: Subject) -> Call | None:
    """The run of one of SURFACE_METHODS on the scene; None where nothing can be stepped."""
    method = method_of(sheet, subject)
    device = triangles_of(sheet, replace(subject, arguments=_exact(subject)))
    if device is None or method not in SURFACE_METHODS:
        return None
    size = scene_size(sheet, subject)
    if method != A_BUFFER:
        return method_call(method, device.corners, device.triangles, device.colours, size)
    greys = np.array([sum(linear_from_srgb(colour)) / 3 for colour in device.colours.tolist()])
    opacities = opacities_of(sheet, device)
    return method_call(method, device.corners, device.triangles, greys, size, opacities)


def opacities_of(sheet: Sheet, device: DeviceTriangles) -> NDArray[np.float64]:
    """What each triangle (t,) stops of the light from behind it, 0 to 1."""
    assert sheet.scene is not None
    of_id = {material.id: material.opacity for material in sheet.scene.materials}
    of_object = np.array([of_id[thing.material] for thing in visible_objects(sheet.scene)])
    return of_object[device.objects] if len(of_object) else np.zeros(0)


def _exact(subject: Subject) -> dict[str, Argument]:
    """The arguments of a subject, but for the rounding of depths, which only a buffer has."""
    return {**subject.arguments, "bits": NOT_ROUNDED}


def cutting_of(subject: Subject) -> Cutting:
    """How deep octrees are, and what is done to them."""
    given = subject.arguments
    share = given.get("cut_at", 0.5)
    assert isinstance(share, float | int)
    return Cutting(
        _number(subject, "depth", USUAL_DEPTH),
        _number(subject, "operation", CUT),
        _number(subject, "cut_axis", 2),
        float(share),
    )


def octree_objects(sheet: Sheet, subject: Subject) -> tuple[Object, ...]:
    """The objects whose octrees are stepped: that which the subject names first, and what is combined with it
    after it."""
    things = () if sheet.scene is None else octree_things(sheet.scene)
    things = tuple(sorted(things, key=lambda thing: thing.id not in subject.ids))
    two = method_of(sheet, subject) == COMBINED and cutting_of(subject).operation != CUT
    return things[: 2 if two else 1]


def octrees_call(sheet: Sheet, subject: Subject) -> Call | None:
    """The run of one of OCTREES; None where there is no solid for it."""
    things, cutting = octree_objects(sheet, subject), cutting_of(subject)
    if not things:
        return None
    if method_of(sheet, subject) == OCTREE:
        return octree_call(things, cutting.depth)
    if cutting.operation != CUT and len(things) < 2:
        return None
    return combined_call(things, cutting)


def _line_call(sheet: Sheet, subject: Subject) -> Call | None:
    if sheet.scene is None or fault_of(sheet):
        return None
    return _lines(sheet.scene, scene_size(sheet, subject), window_of(sheet))


_lines = lru_cache(maxsize=16)(line_call)


def faces_in_order(sheet: Sheet) -> list[tuple[int, int]]:
    """The number of its object and its own of each face, in the order in which back faces are looked for."""
    return [] if sheet.scene is None else back_face_calls.faces_in_order(sheet.scene)


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    if sheet.scene is None:
        return ()
    backs = (BACK_FACES,) if back_face_calls.looks_from_a_point(sheet.scene.camera) else ()
    octrees = OCTREES if octree_things(sheet.scene) else ()
    return DEPTH_BUFFER, *backs, *SURFACE_METHODS, HIDDEN_LINES, *octrees


def method_of(sheet: Sheet, subject: Subject) -> str:
    """The slug that a subject is run under: the one it names where the camera allows it; empty: none."""
    choices = _choices(sheet, subject)
    return subject.entry if subject.entry in choices else next(iter(choices), "")


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    if method_of(sheet, subject) == BACK_FACES:
        return [] if sheet.scene is None or fault_of(sheet) else back_face_calls.back_face_calls(sheet.scene)
    others = {
        DEPTH_BUFFER: depth_call,
        HIDDEN_LINES: _line_call,
        OCTREE: octrees_call,
        COMBINED: octrees_call,
    }
    call = others.get(method_of(sheet, subject), surface_call)(sheet, subject)
    return [] if call is None else [call]


def _on_device(sheet: Sheet, subject: Subject, frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """Marks of the device as they are, to the edge of the coarse picture; there is no place for others."""
    width, height = scene_size(sheet, subject)
    coarse = replace(sheet, width_px=width, height_px=height)
    return on_device(coarse, frame, marks) if frame == "device" else ()


def _landmarks(sheet: Sheet, subject: Subject) -> tuple[int, ...]:
    """The steps with which a surface begins, but the first."""
    call = depth_call(sheet, subject) if method_of(sheet, subject) == DEPTH_BUFFER else None
    return () if call is None else tuple((fragments_of(call).begins[1:] + 1).tolist())


def _number(subject: Subject, name: str, usual: int) -> int:
    value = subject.arguments.get(name, usual)
    assert isinstance(value, int)
    return value


register(
    KIND,
    SubjectKind(
        title=_("How hidden surfaces are found"),
        invitation=_("Add an object in Space, to see how hidden surfaces are found, step by step."),
        calls=_calls,
        choices=_choices,
        on_device=_on_device,
        landmarks=_landmarks,
        entries=(DEPTH_BUFFER, BACK_FACES, *SURFACE_METHODS, HIDDEN_LINES, *OCTREES),
        arguments={
            "columns": Given(
                USUAL_COLUMNS,
                Number(label=_("columns"), low=LEAST_COLUMNS, high=MOST_COLUMNS, whole=True, keyed=False),
            ),
            "bits": Given(
                NOT_ROUNDED,
                Number(label=_("depth bits"), low=NOT_ROUNDED, high=MOST_BITS, whole=True, keyed=False),
            ),
            "backwards": Given(False),
            "depth": Given(
                USUAL_DEPTH, Number(label=_("depth"), low=1, high=MOST_DEPTH, whole=True, keyed=False)
            ),
            "operation": Given(CUT, Number(label=_("operation"), low=0, high=CUT, whole=True, keyed=False)),
            "cut_axis": Given(2, Number(label=_("axis"), low=0, high=2, whole=True, keyed=False)),
            "cut_at": Given(0.5, Number(label=_("place of the cut"), low=0.0, high=1.0, keyed=False)),
        },
    ),
)
