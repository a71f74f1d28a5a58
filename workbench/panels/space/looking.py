"""What is seen of the session's scene: looking around is its state, what is kept is the document."""

import math
from collections.abc import Callable
from contextlib import suppress

import numpy as np
from msgspec.structs import replace

from workbench.algorithms.projection import vanishing_points, with_vanishing_point, with_vanishing_points
from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.motion.groups import CAMERA
from workbench.document.motion.tracks import motion_of
from workbench.document.scene.edits import set_camera, set_thing
from workbench.document.scene.looking import centred_on, facing, kind_of, orbited, projecting, tumbled
from workbench.document.scene.model import Camera, Point3D, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.document.state import seen_scene, with_look
from workbench.geometry.meshes import Array
from workbench.language import _, reason_of
from workbench.rendering.scene.render import placed
from workbench.session.session import Session


class Looking:
    """The scene of a session as it is seen, and the ways to see it otherwise.

    Each gives a sentence, empty where nothing was wrong.
    """

    def __init__(self, session: Session) -> None:
        self.session = session
        self.trackball = False
        self.z_towards_eye = False  # the view coordinates of Hearn and Baker

    @property
    def scene(self) -> Scene | None:
        """The scene in its frame, with its own camera or that of whoever looks around."""
        scene, looked = self.session.frames.sheet.scene, self._looked
        return scene if scene is None or looked is None else replace(scene, camera=looked)

    @property
    def _looked(self) -> Camera | None:
        """The camera of whoever looks around; it stays in other frames too."""
        kept = self.session.sheet.scene
        seen = seen_scene(self.session.state, self.session.sheet)
        return None if seen is None or seen is kept else seen.camera

    @property
    def tracked(self) -> bool:
        """Whether tracks move the camera of the scene."""
        tracks = motion_of(self.session.sheet).tracks
        return any(track.target.split(".")[:2] == CAMERA.split(".") for track in tracks)

    @property
    def camera(self) -> Camera:
        """The camera that the scene is seen by now."""
        scene = self.scene
        return Camera() if scene is None else scene.camera

    @property
    def around(self) -> bool:
        """Whether it is seen otherwise than the document says."""
        scene = self.session.frames.sheet.scene
        return scene is not None and self.camera != scene.camera

    @property
    def radius(self) -> float:
        """How far the scene reaches from what is looked at."""
        points = points_of(self.scene)
        if not len(points):
            return 1.0
        away = np.sqrt(((points - self.camera.look_at.xyz) ** 2).sum(axis=1))
        return max(float(away.max()), 1e-6)

    def look(self, camera: Camera | None) -> str:
        """See the scene by another camera, with None by its own again; the document stays as it is."""
        session = self.session
        try:
            session.update_state(looks=with_look(session.state, session.sheet, camera))
        except DocumentError as problem:
            return problem.short
        return ""

    def change(self, camera: Camera, name: str, merge: str = "") -> str:
        """Give the document another camera, as one step of undo."""
        sheet = self.session.sheet
        try:
            self.session.apply(set_camera(sheet.id, camera), name, merge)
        except DocumentError as problem:
            return problem.short
        return self.look(None)

    def move_light(self, identity: str, position: Point3D) -> str:
        """Put a light of the document elsewhere, as a part of a drag."""
        edit = light_moved_to(self.session.sheet.scene or Scene(), identity, position)
        if edit is None:
            return ""
        try:
            self.session.apply(edit, _("Move a light"), f"light {identity}")
        except DocumentError as problem:
            return problem.short
        return ""

    def keep(self) -> str:
        """Write what is seen now into the document."""
        return self.change(self.camera, _("Keep this view")) if self.around else ""

    def orbit(self, d_theta: float, d_phi: float, about: Point3D | None = None) -> str:
        """Go round what is looked at, or round ``about``, radians; with ``trackball`` freely."""
        turn = tumbled if self.trackball else orbited
        return self._try(lambda: turn(self.camera, d_theta, d_phi, about))

    def centre(self, place: Point3D) -> str:
        """Look at a place of the world, from as far away and in the direction as before."""
        return self.look(centred_on(self.camera, place))

    def face(self, side: str) -> str:
        """Stand before one of the six sides."""
        return self._try(lambda: facing(self.camera, side))

    def glance(self, slug: str) -> str:
        """See the scene by another projection, from where it is seen at its best by that."""
        return self._try(lambda: projecting(self.camera, slug, self.radius))

    def vanish(self, axis: int, at: tuple[float, float], pinned: bool) -> str:
        """Turn so that the lines along an axis run together at a place of the view plane.

        ``pinned``: that of another axis stays where it is, which takes another distance of the plane.
        """
        camera = self.camera
        try:
            if pinned and (other := self._other_vanishing(axis)) is not None:
                eye, up, d = with_vanishing_points(
                    camera.eye.xyz, camera.look_at.xyz, camera.up.xyz, other, (axis, at)
                )
            else:
                d = camera.distance
                eye, up = with_vanishing_point(camera.eye.xyz, camera.look_at.xyz, camera.up.xyz, axis, at, d)
        except ValueError as error:
            return reason_of(error)
        return self.look(replace(camera, eye=Point3D(*eye), up=Point3D(*up), distance=d))

    def _other_vanishing(self, axis: int) -> tuple[int, tuple[float, float]] | None:
        """The nearest vanishing point of another axis."""
        points = vanishing_points(projection_matrix(self.camera) @ view_matrix(self.camera))
        others = [(k, point) for k, point in enumerate(points) if point is not None and k != axis]
        return min(others, key=lambda other: math.hypot(*other[1]), default=None)

    def choose(self, slug: str, name: str) -> str:
        """Give the document another projection; the one that is seen already stays as it is."""
        with suppress(ValueError):  # what is seen now is of no kind
            if slug == kind_of(self.camera):
                return ""
        try:
            camera = projecting(self.camera, slug, self.radius)
        except ValueError as error:
            return reason_of(error)
        return self.change(camera, name)

    def _try(self, camera: Callable[[], Camera]) -> str:
        try:
            return self.look(camera())
        except ValueError as error:
            return reason_of(error)


def points_of(scene: Scene | None) -> Array:
    """The outermost vertices (n, 3) of what is visible, world."""
    parts = () if scene is None else placed(scene)
    return np.concatenate([np.zeros((0, 3)), *(lasting.outermost for *_rest, lasting in parts)])


def light_moved_to(scene: Scene, identity: str, position: Point3D) -> Edit | None:
    """The edit that puts a light elsewhere; None where the scene has no such light."""
    light = next((each for each in scene.lights if each.id == identity), None)
    return None if light is None else set_thing(replace(light, position=position))
