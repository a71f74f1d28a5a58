"""What no field of a scene can say by itself; each law gives the first fault as ``check`` does."""

from collections.abc import Callable
from typing import Any

from workbench.document.faults import Fault
from workbench.document.scene.model import Camera, Object, Scene
from workbench.document.scene.solids import MeshSolid
from workbench.document.storage.blobs import Named
from workbench.document.transforms.chains import LARGEST
from workbench.language import _

MOST_TRIANGLES = 1_500_000
"""In a scene: of more, drawing takes over 500 MB."""


def _reason(error: ValueError) -> str:
    sentence = str(error).rstrip(".")
    return sentence[:1].lower() + sentence[1:]  # it goes on with another


def _points(thing: Object, _before: Any) -> Fault | None:
    least, most, count = thing.solid.least_points, thing.solid.most_points, len(thing.points)
    if least <= count <= most:
        return None
    problem = _("has {count} entries, and this solid needs {least} to {most}; add or remove some")
    return "points", problem.format(count=count, least=least, most=most)


def _chain(thing: Object, _before: Any) -> Fault | None:
    try:
        matrix = thing.matrix
    except ValueError as error:
        return "transforms", _("cannot be worked out ({reason})").format(reason=_reason(error))
    if matrix is None or abs(matrix).max() <= LARGEST:
        return None
    problem = _("has a matrix with numbers beyond {most:g}; make a scale factor or a shear smaller")
    return "transforms", problem.format(most=LARGEST)


def _solid(thing: Object, before: Object | None) -> Fault | None:
    if before is not None and before.solid is thing.solid and before.points is thing.points:
        return None
    if _is_to_come(thing):
        return None
    try:
        _mesh = thing.mesh
    except ValueError as error:
        return "solid", _("cannot be made ({reason})").format(reason=_reason(error))
    return None


def _is_to_come(thing: Object) -> bool:
    """Whether its mesh is named, and not there yet."""
    return isinstance(thing.solid, MeshSolid) and isinstance(thing.solid.content, Named)


def _triangles(scene: Scene, before: Scene | None) -> Fault | None:
    if before is not None and len(before.objects) == len(scene.objects):
        pairs = zip(before.objects, scene.objects, strict=True)
        if all(old.solid is new.solid and old.points is new.points for old, new in pairs):
            return None
    count = sum(thing.triangle_count for thing in scene.objects if not _is_to_come(thing))
    if count <= MOST_TRIANGLES:
        return None
    problem = _(
        "has {count:,} triangles in all, but a scene can have at most {most:,}; remove an object, or give "
        "one fewer faces"
    )
    return "objects", problem.format(count=count, most=MOST_TRIANGLES)


def _camera(camera: Camera, _before: Any) -> Fault | None:
    from workbench.document.scene.viewing import projection_matrix, view_matrix  # as the solids' makers

    if not any(camera.up.xyz):
        return "", _("has no up direction: u_x, u_y and u_z are all 0; change one of them")
    try:
        view_matrix(camera)
        projection_matrix(camera)
    except ValueError as error:
        return "", _("sees nothing ({reason})").format(reason=_reason(error))
    return None


def _materials(scene: Scene, _before: Any) -> Fault | None:
    known = {material.id for material in scene.materials}
    for index, thing in enumerate(scene.objects):
        if thing.material not in known:
            problem = _("is {id!r}, but the scene has no such material; choose one that it has")
            return f"objects[{index}].material", problem.format(id=thing.material)
    return None


LAWS: dict[type, tuple[Callable[[Any, Any], Fault | None], ...]] = {
    Object: (_points, _chain, _solid),
    Camera: (_camera,),
    Scene: (_materials, _triangles),
}
