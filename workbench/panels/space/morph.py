"""From one projection of a scene to the next in a short moment, unless motion is held still."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QObject, QVariantAnimation

from workbench.document.scene.model import Camera, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array
from workbench.widgets.look.comfort import comfort

_MORPH_MS = 150


class Morph(QVariantAnimation):
    """``valueChanged`` asks for another picture; ``finished`` for that of the new projection itself."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.setDuration(_MORPH_MS)
        self.setStartValue(0.0)
        self.setEndValue(1.0)
        self._before: Camera | None = None

    def leave(self, camera: Camera) -> None:
        """Begin to go on from what is seen by this camera; with Calm there is no way in between."""
        if not comfort.calm:
            self._before = camera
            self.start()

    def through(self, scene: Scene) -> Scene:
        """The scene as it is seen at this moment on the way to its own camera."""
        if self._before is None or self.state() != self.State.Running:
            return scene
        try:
            return replace(scene, camera=between(self._before, scene.camera, self.currentValue()))
        except ValueError:  # halfway between these two there is no picture
            return scene


def between(before: Camera, after: Camera, share: float) -> Camera:
    """A camera that sees a ``share`` of the way (0 to 1) from one camera to another: of both matrices, where
    what is looked at has w = 1, the mean. Raises: ValueError where that flattens the scene."""
    if share >= 1.0:
        return after
    view = view_matrix(replace(after, projection="matrix"))
    whole = (1.0 - share) * _whole(before) + share * _whole(after)
    entries = whole @ np.linalg.inv(view)
    camera = replace(after, projection="matrix", entries=tuple(map(float, entries.ravel())))
    projection_matrix(camera)
    return camera


def _whole(camera: Camera) -> Array:
    """From the world to the view plane (4, 4), so that w is 1 at the point that is looked at."""
    matrix = projection_matrix(camera) @ view_matrix(camera)
    weight = matrix[3] @ (*camera.look_at.xyz, 1.0)
    if weight <= 0.0:
        raise ValueError("What is looked at lies behind the eye.")
    return np.asarray(matrix / weight)
