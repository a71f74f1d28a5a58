"""Placing the camera of a sheet so that all of its scene is seen."""

import numpy as np
from msgspec.structs import replace

from workbench.document.building import Edit
from workbench.document.model import Document, Sheet
from workbench.document.scene.edits import set_camera
from workbench.document.view_edits import set_window
from workbench.language import _
from workbench.rendering.scene.around import camera_around, window_of
from workbench.rendering.scene.render import placed


def framed(sheet: Sheet) -> Edit:
    """The edit that puts the camera before the scene, its projection as it is; where the sheet has a window
    of its own, it shows all then. Raises: ValueError, a sentence, where there is nothing to be seen."""
    scene, view = sheet.scene, sheet.first_view
    meshes = [] if scene is None else [mesh.vertices for mesh, *_rest in placed(scene)]
    if scene is None or not meshes:
        raise ValueError(_("The scene has no visible object; add one, or show one that is hidden."))
    points = np.concatenate(meshes)
    around = camera_around(points)
    camera = replace(
        scene.camera,
        eye=around.eye,
        look_at=around.look_at,
        up=around.up,
        near=around.near,
        far=around.far,
        distance=around.distance,
    )
    window, device = view.window_world, view.viewport_device
    own = window != device
    size = round(device.xmax - device.xmin), round(device.ymax - device.ymin)

    def edit(document: Document) -> Document:
        document = set_camera(sheet.id, camera)(document)
        return set_window(view.id, window_of(camera, size, points))(document) if own else document

    return edit
