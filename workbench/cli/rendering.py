"""render: a mesh file or the scene of a document as a picture, with its depths if asked for."""

import argparse
import math
from typing import Any, NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.visibility import depth_buffer
from workbench.cli import outputs
from workbench.cli.failure import BadInputError
from workbench.cli.sheets import sheet_of
from workbench.cli.waiting import telling
from workbench.document import Camera, DocumentError, load
from workbench.document.model import Rectangle
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import PROJECTIONS, Material, Object, Point3D, Scene
from workbench.document.scene.solids import MeshSolid
from workbench.document.storage.content import read_content
from workbench.exchange.mesh_reading import MOST_BYTES, read_mesh
from workbench.exchange.readable import READABLE, kind_of
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.rendering.scene import (
    render_mesh,
    render_scene,
    wireframe,
    wireframe_of_mesh,
)
from workbench.rendering.scene.around import camera_around
from workbench.rendering.scene.render import refuse_way
from workbench.rendering.scene.shading import QUICK
from workbench.rendering.scene.viewpoint import window_around

_SIZE = (640, 480)
_PROJECTIONS = tuple(name for name in PROJECTIONS if name != "matrix")


class _Seen(NamedTuple):
    """What a document or a mesh file gives: how to draw it, its wireframe, size and window, what is said."""

    picture: Any
    wireframe: Any
    size: tuple[int, int]
    window: Rectangle | None
    said: tuple[str, ...]


def render_model(options: argparse.Namespace) -> str:
    """Write the picture; what was left out of the model, a line for each thing."""
    row = outputs.format_for("picture", "wireframe", path=options.output)
    try:
        refuse_way(options.visibility, options.shading)
    except ValueError as error:
        raise BadInputError(str(error)) from None
    depth_row = options.depth and outputs.format_for("picture", path=options.depth)
    try:
        seen = _scene(options) if kind_of(options.model) == "picture" else _mesh(options)
        size = options.size or seen.size
        if row.kind == "wireframe":
            segments = seen.wireframe()
            window = seen.window or window_around(segments.reshape(-1, 2), size)
            outputs.write(row, (segments, window, size), options.output)
        if row.kind == "picture" or depth_row:
            meanwhile = _(
                "Still drawing with {method}; this may take minutes. {fastest} is the fastest method."
            )
            if options.visibility == depth_buffer.__name__:
                meanwhile = _("Still drawing; a smaller size is faster.")
            meanwhile = meanwhile.format(method=options.visibility, fastest=depth_buffer.__name__)
            image, depth = telling(lambda: seen.picture(size), meanwhile)
            if row.kind == "picture":
                outputs.write(row, (image, 1), options.output)
            if depth_row:
                outputs.write(depth_row, (grey(depth), 1), options.depth)
    except DocumentError as error:
        raise BadInputError(f"{options.model}: {error}" if error.field else str(error)) from None
    except ValueError as error:
        raise BadInputError(f"{options.model}: {error}") from None
    return "".join(f"{line}\n" for line in seen.said)


def grey(depth: Array) -> NDArray[np.uint32]:
    """Depths (h, w) as greys: white at the near plane, black at the far one and where nothing is."""
    level = np.floor((1.0 - depth) * 255 + 0.5)
    return (level * 0x010101).astype(np.uint32)


def point(text: str) -> Point3D:
    """A point from a text such as 4,3,8. Raises: ArgumentTypeError."""
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != 3 or not all(map(math.isfinite, numbers)):
        sentence = _("{text!r} is not a point; write it as 4,3,8")
        raise argparse.ArgumentTypeError(sentence.format(text=text[:30]))
    return Point3D(*numbers)


def _scene(options: argparse.Namespace) -> _Seen:
    sheet = sheet_of(load(options.model), options.model, options.sheet)
    if sheet.scene is None:
        sentence = _("{file}: sheet {number} has no scene; choose one that has, or use draw.")
        raise BadInputError(sentence.format(file=options.model, number=options.sheet))
    scene = replace(sheet.scene, camera=_chosen(options, sheet.scene.camera))
    window = sheet.first_view.window_world

    def picture(size: tuple[int, int]) -> Any:
        return render_scene(scene, options.visibility, size, options.shading, window)

    return _Seen(picture, lambda: wireframe(scene), (sheet.width_px, sheet.height_px), window, ())


def _mesh(options: argparse.Namespace) -> _Seen:
    if kind_of(options.model) != "mesh":
        endings = ", ".join(
            suffix for each in READABLE if each.kind in ("picture", "mesh") for suffix in each.suffixes
        )
        sentence = _("{file}: this is neither a mesh nor a document; give one of {endings}.")
        raise BadInputError(sentence.format(file=options.model, endings=endings))
    content = read_content(options.model, MOST_BYTES)
    mesh, notes = read_mesh(content, options.model.suffix)
    camera = _chosen(options, camera_around(mesh.vertices, options.eye, options.look_at))

    def picture(size: tuple[int, int]) -> Any:
        if options.shading == QUICK:
            return render_mesh(*mesh, camera, options.visibility, size)
        thing = Object("o1", MeshSolid(blob_of(mesh)), "m1")
        scene = Scene((thing,), (Material("m1"),), (), camera)
        return render_scene(scene, options.visibility, size, options.shading)

    return _Seen(picture, lambda: wireframe_of_mesh(mesh, camera), _SIZE, None, notes)


def _chosen(options: argparse.Namespace, camera: Camera) -> Camera:
    """``camera`` as the options change it."""
    if options.projection not in (None, *_PROJECTIONS):
        sentence = _("There is no projection {name!r}; choose one of {names}.")
        names = ", ".join(_PROJECTIONS)
        raise BadInputError(sentence.format(name=options.projection[:40], names=names))
    changes = {"projection": options.projection, "eye": options.eye, "look_at": options.look_at}
    return replace(camera, **{name: value for name, value in changes.items() if value is not None})
