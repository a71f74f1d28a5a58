"""A mesh or a scene as a picture and the depths in it, by any method for hidden surfaces."""

from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.visibility import depth_buffer
from workbench.document.model import Rectangle
from workbench.document.scene.model import Camera, Light, Material, Object, Scene
from workbench.document.scene.solids import mesh_over
from workbench.geometry.meshes import Array, Faces, Index, Mesh, triangulated
from workbench.language import _
from workbench.memory import Memory
from workbench.rendering.scene import methods
from workbench.rendering.scene.lasting import Lasting
from workbench.rendering.scene.methods import picture_by
from workbench.rendering.scene.shading import LIT_SHADINGS, QUICK, flat_colours
from workbench.rendering.scene.viewpoint import Size, Viewpoint
from workbench.rendering.triangles import drawn

Picture = tuple[NDArray[np.uint32], NDArray[np.float64]]


class DeviceTriangles(NamedTuple):
    """A scene as all methods get it: corners (n, 3), x and y in pixels on a grid of 1/4096, z 0 to 1;
    triangles (t, 3), and of each (t,) its colour, 0xRRGGBB, the number of its object among the visible ones,
    and the number of its face there."""

    corners: Array
    triangles: Index
    colours: Index
    objects: Index
    faces: Index


METHODS: dict[str, Callable[..., Picture]] = {
    **{method: partial(picture_by, method) for method in methods.METHODS},
    depth_buffer.__name__: drawn,
}
"""How hidden surfaces are found, by slug: from device triangles, their colours and the size."""

SHADINGS = (QUICK, *LIT_SHADINGS)

_MOST_OF_TWO = 300_000
"""So many triangles has a scene at most whose parts are kept beside those of another one."""

_MESH_MATERIAL = Material("mesh")


def render_mesh(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[Sequence[int]] | Faces,
    camera: Camera,
    method: str,
    size: Size,
    window: Rectangle | None = None,
) -> Picture:
    """A mesh as ``camera`` sees it.

    Args: vertices (n, 3), world; faces, rows or lists of three vertices or more each, counter-clockwise seen
    from outside; a slug of METHODS; size (width, height) in pixels; the window of the view plane that is
    seen, by default one into which all fits. Returns: the picture (height, width), uint32 0xRRGGBB, row 0 at
    the bottom, 0 where nothing is, and the depth there, 0 at the near plane, 1 at the far one and where
    nothing is. Raises: ValueError, a sentence.
    """
    mesh = _checked(vertices, faces)
    part = mesh, triangulated(*mesh), _MESH_MATERIAL, Lasting(mesh)
    return _rendered([part], (), camera, method, size, "flat", window)


def render_scene(
    scene: Scene, method: str, size: Size, shading: str = "flat", window: Rectangle | None = None
) -> Picture:
    """A scene as its camera sees it; all else as of ``render_mesh``.

    ``shading`` is one of SHADINGS; all but the quick one go through the depth buffer.
    """
    if shading in LIT_SHADINGS and method == depth_buffer.__name__:
        from workbench.rendering.scene.shaded import shaded  # which gets its triangles from here

        return shaded(scene, shading, size, window)
    return _rendered(placed(scene), scene.lights, scene.camera, method, size, shading, window)


Part = tuple[Mesh, tuple[Index, Index], Material, Lasting]


def placed(scene: Scene) -> tuple[Part, ...]:
    """Each visible object: its mesh in the world, its triangles and their faces, its material, and what lasts
    while only the camera moves."""
    return _placed(scene.objects, scene.materials)


@lru_cache(maxsize=2)
def _placed(objects: tuple[Object, ...], materials: tuple[Material, ...]) -> tuple[Part, ...]:
    of_id = {material.id: material for material in materials}
    seen = [thing for thing in objects if thing.visible]
    if sum(len(_cut_up(thing.solid, thing.points)[0]) for thing in seen) > _MOST_OF_TWO:
        _placed.cache_clear()  # before this one takes as much again
    parts = [(*_in_world(thing), of_id[thing.material]) for thing in seen]
    return tuple((*part, Lasting(part[0])) for part in parts)


def _in_world(thing: Object) -> tuple[Mesh, tuple[Index, Index]]:
    """Its mesh there, and its triangles, made once for a solid and turned round where a mirror turns them."""
    vertices, faces = thing.mesh
    triangles, owners = _cut_up(thing.solid, thing.points)
    if thing.matrix is None:
        return thing.mesh, (triangles, owners)
    moved = vertices @ thing.matrix[:3, :3].T + thing.matrix[:3, 3]
    if np.linalg.det(thing.matrix[:3, :3]) < 0:
        return Mesh(moved, faces.reversed()), (triangles[:, ::-1], owners)
    return Mesh(moved, faces), (triangles, owners)


_triangles: Memory[tuple[Index, Index]] = Memory(128 * 2**20)


def _cut_up(solid: Any, points: Any) -> tuple[Index, Index]:
    return _triangles.get((solid, points), lambda: triangulated(*mesh_over(solid, points)))


def _rendered(
    parts: Sequence[Part],
    lights: Sequence[Light],
    camera: Camera,
    method: str,
    size: Size,
    shading: str,
    window: Rectangle | None,
) -> Picture:
    refuse_way(method, shading)
    device = device_triangles(parts, lights, camera, size, window)
    return METHODS[method](device.corners, device.triangles, device.colours, size)


def device_triangles(
    parts: Sequence[Part],
    lights: Sequence[Light],
    camera: Camera,
    size: Size,
    window: Rectangle | None,
) -> DeviceTriangles:
    """What of ``parts`` lies before the camera, on a picture of ``size``. Raises: ValueError, a sentence."""
    meshes = [] if window else [mesh.vertices for mesh, *_rest in parts]
    viewpoint = Viewpoint.of(camera, size, window, np.concatenate([np.zeros((0, 3)), *meshes]))
    pieces: list[DeviceTriangles] = []
    count = 0
    for number, (mesh, (cut, face_of), material, lasting) in enumerate(parts):
        colours = flat_colours(lasting, material, lights, viewpoint.viewer)
        device = viewpoint.drawn(mesh.vertices, cut, lasting.box)
        faces = device.of_owners(face_of)
        if not (device.owners is None and len(cut) == len(mesh.faces)):  # else each is a face of its own
            colours = colours[faces]
        numbers = np.broadcast_to(number, len(faces))
        triangles = device.triangles + count if count else device.triangles
        pieces.append(DeviceTriangles(device.corners, triangles, colours, numbers, faces))
        count += len(device.corners)
    if len(pieces) == 1:
        return pieces[0]
    nothing = np.zeros(0, np.int64)
    pieces.insert(0, DeviceTriangles(np.zeros((0, 3)), nothing.reshape(0, 3), nothing, nothing, nothing))
    return DeviceTriangles(*map(np.concatenate, zip(*pieces, strict=True)))


def refuse_way(method: str, shading: str) -> None:
    """Raises: ValueError, where there is no such method or shading, or they do not go together."""
    if method not in METHODS:
        sentence = _("There is no method for hidden surfaces {name!r}; choose one of {names}.")
        raise ValueError(sentence.format(name=method[:40], names=", ".join(METHODS)))
    if shading not in SHADINGS:
        sentence = _("There is no shading {name!r}; choose one of {names}.")
        raise ValueError(sentence.format(name=shading[:40], names=", ".join(SHADINGS)))
    if shading != QUICK and method != depth_buffer.__name__:
        sentence = _("{shading!r} needs the depth buffer: choose {method!r}, or {quick!r}.")
        raise ValueError(sentence.format(shading=shading, method=depth_buffer.__name__, quick=QUICK))


def _checked(vertices: ArrayLike, faces: Any) -> Mesh:
    points, polygons = np.asarray(vertices, np.float64), Faces.of(faces)
    if points.ndim != 2 or points.shape[1:] != (3,) or not np.isfinite(points).all():
        raise ValueError(_("The vertices are not rows of x, y and z; give each three finite numbers."))
    if not len(polygons):
        raise ValueError(_("The mesh has no face; give one."))
    if polygons.sizes.min() < 3:
        raise ValueError(_("A face has fewer than three corners; leave it out."))
    if not 0 <= polygons.corners.min() <= polygons.corners.max() < len(points):
        raise ValueError(_("A face names a vertex that does not exist; count them from 0."))
    return Mesh(points, polygons)
