"""What the Export menu offers of the scene that is seen: its picture, its edges, its meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from workbench.language import _

if TYPE_CHECKING:
    from workbench.document.scene.model import Scene
    from workbench.shell.window import MainWindow

_SIZE_PX = (1280, 960)
_PAPER = 0xFFFFFF


def export_scene_picture(window: MainWindow) -> None:
    """The scene as it is seen, through the depth buffer, on white."""
    scene = _scene(window)
    if scene is not None:
        window.files.exports.writing.ask("picture", _("scene"), lambda: _picture(scene))


def export_wireframe(window: MainWindow) -> None:
    """The edges of the scene as it is seen."""
    scene = _scene(window)
    if scene is not None:
        window.files.exports.writing.ask("wireframe", _("wireframe"), lambda: _wireframe(scene))


def export_line_drawing(window: MainWindow) -> None:
    """The edges of the scene as it is seen, without what faces hide."""
    scene = _scene(window)
    if scene is not None:
        window.files.exports.writing.ask("wireframe", _("hidden lines"), lambda: _line_drawing(scene))


def export_mesh(window: MainWindow) -> None:
    """The chosen object, or all that is visible, in the world."""
    scene = _scene(window)
    if scene is not None:
        chosen = window.session.state.thing
        window.files.exports.writing.ask("mesh", _("mesh"), lambda: _mesh(scene, chosen))


def _scene(window: MainWindow) -> Scene | None:
    """The scene as it is seen; where there is nothing in it that is said."""
    from workbench.document.state import seen_scene

    scene = seen_scene(window.session.state, window.session.sheet)
    if scene is None or not any(thing.visible for thing in scene.objects):
        window.say_status(_("There is nothing in the scene; add an object in Space first."))
        return None
    return scene


def _picture(scene: Scene) -> tuple[Any, int]:
    import numpy as np

    from workbench.algorithms.visibility import depth_buffer
    from workbench.rendering.scene import render_scene

    image, depth = render_scene(scene, depth_buffer.__name__, _SIZE_PX)
    return np.where(depth < 1.0, image, np.uint32(_PAPER)), 1


def _wireframe(scene: Scene) -> tuple[Any, Any, tuple[int, int]]:
    from workbench.rendering.scene import wireframe
    from workbench.rendering.scene.viewpoint import window_around

    segments = wireframe(scene)
    return segments, window_around(segments.reshape(-1, 2), _SIZE_PX), _SIZE_PX


def _line_drawing(scene: Scene) -> tuple[Any, Any, tuple[int, int]]:
    from workbench.rendering.scene import wireframe
    from workbench.rendering.scene.line_drawing import line_drawing
    from workbench.rendering.scene.viewpoint import window_around

    return line_drawing(scene).table, window_around(wireframe(scene).reshape(-1, 2), _SIZE_PX), _SIZE_PX


def _mesh(scene: Scene, chosen: str) -> tuple[Any, Any]:
    import numpy as np

    from workbench.geometry.meshes import Faces
    from workbench.rendering.scene.render import placed

    visible = [thing.id for thing in scene.objects if thing.visible]
    meshes = [mesh for mesh, *_rest in placed(scene)]
    if chosen in visible:
        meshes = [meshes[visible.index(chosen)]]
    counts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    faces = [mesh.faces.corners + start for mesh, start in zip(meshes, counts, strict=False)]
    sizes = np.concatenate([mesh.faces.sizes for mesh in meshes])
    vertices = np.concatenate([mesh.vertices for mesh in meshes])
    return vertices, Faces(np.concatenate(faces), np.cumsum(sizes))
