"""Looking around in a scene: where a camera stands and which projection it has, as values.

A camera stands on a turntable: ``theta`` is how far it has gone round the vertical through what it looks at,
counter-clockwise seen from above, from the front; ``phi`` how far above it stands. Radians.
"""

import math
from typing import Literal, NamedTuple

import numpy as np
from msgspec.structs import replace

from workbench.algorithms import projection
from workbench.document.scene.model import Camera, Point3D
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.language import _

_POLE = math.pi / 2
_NEAR_THE_POLE = 1e-3
_SAME = 1e-6
_FAR_ENOUGH = 4.0  # the eye, in radii of what is looked at, where it stood nearer than these
_LEAST_RADII = 1.5

Family = Literal["orthographic", "axonometric", "oblique", "perspective", "general"]


class Kind(NamedTuple):
    """One row of the list of projections."""

    slug: str
    family: Family
    title: str


def kinds() -> tuple[Kind, ...]:
    """Every projection that can be chosen, in the order of the course."""
    return (
        Kind("front", "orthographic", _("Front")),
        Kind("back", "orthographic", _("Back")),
        Kind("left", "orthographic", _("Left")),
        Kind("right", "orthographic", _("Right")),
        Kind("top", "orthographic", _("Top")),
        Kind("bottom", "orthographic", _("Bottom")),
        Kind("orthographic", "orthographic", _("Orthographic")),
        Kind("isometric", "axonometric", _("Isometric")),
        Kind("dimetric", "axonometric", _("Dimetric")),
        Kind("trimetric", "axonometric", _("Trimetric")),
        Kind("cavalier", "oblique", _("Cavalier")),
        Kind("cabinet", "oblique", _("Cabinet")),
        Kind("oblique", "oblique", _("Oblique")),
        Kind("one-point", "perspective", _("One-point perspective")),
        Kind("two-point", "perspective", _("Two-point perspective")),
        Kind("three-point", "perspective", _("Three-point perspective")),
        Kind("matrix", "general", _("Matrix of your own")),
    )


_POINTS = {"one-point": 1, "two-point": 2, "three-point": 3}
_ENGINEERS_F_Z = 0.5
_TRIMETRIC = (-25.0, 15.0)


def turn_of(camera: Camera) -> tuple[float, float]:
    """``theta`` and ``phi``. At a pole, where only one of them has a meaning, the picture's upright tells.

    Raises: ValueError, a sentence, where the camera sees nothing.
    """
    right, _up, forward = view_matrix(camera)[:3, :3]
    return math.atan2(-right[2], right[0]), math.asin(min(max(-forward[1], -1.0), 1.0))


def turned_to(camera: Camera, theta: float, phi: float, away: float | None = None) -> Camera:
    """``camera`` at another place of its turntable, as far ``away`` as before; the horizon is level.

    What is isometric is so from one place only: from others it is axonometric. Raises: ValueError where the
    eye is at the point it looks at.
    """
    if away is None:
        away = math.dist(camera.eye.xyz, camera.look_at.xyz)
    if not away > 0.0:
        raise ValueError(_("The eye is at the point it looks at; move one of them."))
    phi = min(max(phi, -_POLE), _POLE)
    level = math.cos(phi)
    offset = math.sin(theta) * level, math.sin(phi), math.cos(theta) * level
    x, y, z = (at + away * part for at, part in zip(camera.look_at.xyz, offset, strict=True))
    up = Point3D(0.0, 1.0, 0.0)
    if level < _NEAR_THE_POLE:
        tip = -math.copysign(1.0, phi)
        up = Point3D(tip * math.sin(theta), 0.0, tip * math.cos(theta))
    placed = replace(camera, eye=Point3D(x, y, z), up=up)
    if camera.projection in ("isometric", "axonometric"):
        angle_y = math.degrees(math.remainder(-theta, math.tau))
        placed = replace(placed, projection="axonometric", angle_y=angle_y, angle_x=math.degrees(phi))
    return placed


def orbited(camera: Camera, d_theta: float, d_phi: float, about: Point3D | None = None) -> Camera:
    """``camera`` gone round by an angle and up by another; it stops at the poles.

    It goes round what it looks at, or round another point ``about``, which stays in its place of the picture.
    Raises: ValueError.
    """
    theta, phi = turn_of(camera)
    turned = turned_to(camera, theta + d_theta, phi + d_phi)
    return turned if about is None else _with_in_place(camera, turned, about)


def tumbled(camera: Camera, right: float, up: float, about: Point3D | None = None) -> Camera:
    """``camera`` turned about the picture's own upright and level axes, as on a trackball, radians.

    Nothing keeps the horizon level, and no pole stops it; an axonometric camera, which is always upright,
    goes round as on a turntable. Raises: ValueError.
    """
    if camera.projection in ("isometric", "axonometric"):
        return orbited(camera, right, up, about)
    axes = view_matrix(camera)[:3, :3]
    away = math.dist(camera.eye.xyz, camera.look_at.xyz)
    cos, sin = math.cos(right), math.sin(right)
    forward, upright = cos * axes[2] - sin * axes[0], axes[1]
    cos, sin = math.cos(up), math.sin(up)
    forward, upright = cos * forward - sin * upright, cos * upright + sin * forward
    eye = Point3D(*(np.array(camera.look_at.xyz) - away * forward).tolist())
    turned = replace(camera, eye=eye, up=Point3D(*upright.tolist()))
    return turned if about is None else _with_in_place(camera, turned, about)


def _with_in_place(before: Camera, turned: Camera, about: Point3D) -> Camera:
    """``turned`` moved so far that ``about`` has the view coordinates that it had before."""
    place = np.array([*about.xyz, 1.0])
    shift = view_matrix(turned)[:3, :3].T @ ((view_matrix(turned) - view_matrix(before)) @ place)[:3]
    return replace(turned, eye=_moved(turned.eye, shift), look_at=_moved(turned.look_at, shift))


def _moved(point: Point3D, by: np.ndarray) -> Point3D:
    return Point3D(*(at + step for at, step in zip(point.xyz, by.tolist(), strict=True)))


def centred_on(camera: Camera, place: Point3D) -> Camera:
    """``camera`` shifted, without a turn, so that it looks at a place as far away as before."""
    by = np.subtract(place.xyz, camera.look_at.xyz)
    return replace(camera, eye=_moved(camera.eye, by), look_at=place)


def facing(camera: Camera, side: str) -> Camera:
    """``camera`` before one of the six sides, "front" to "bottom". Raises: ValueError, LookupError."""
    right, _up, forward = projection.standard_view(side)[:3, :3]
    theta = math.atan2(-right[2], right[0])
    return turned_to(camera, theta, math.asin(-forward[1]))


def projecting(camera: Camera, slug: str, radius: float) -> Camera:
    """``camera`` with another projection, one of ``kinds``, standing where this is seen at its best.

    ``radius`` is how far what is to be seen reaches from the point looked at; near and far plane make room
    for it. Raises: ValueError, LookupError.
    """
    away = math.dist(camera.eye.xyz, camera.look_at.xyz)
    if away < _LEAST_RADII * radius or away == 0.0:
        away = _FAR_ENOUGH * (radius or 1.0)
    camera = _with_room(camera, away, radius)
    if slug == "matrix":
        plane = projection_matrix(camera)
        return replace(camera, projection="matrix", entries=tuple(map(float, plane.ravel())))
    if slug in projection.STANDARD_VIEWS:
        return facing(replace(_apart(camera, away), projection="orthographic"), slug)
    if slug == "orthographic":
        return replace(_apart(camera, away), projection=slug)
    if slug == "isometric":
        turned = turned_to(camera, math.pi / 4, math.atan(math.sqrt(0.5)), away)
        return replace(turned, projection=slug)
    if slug == "dimetric":
        return _like(camera, projection.dimetric(_ENGINEERS_F_Z), away)
    if slug == "trimetric":
        angle_y, angle_x = map(math.radians, _TRIMETRIC)
        return turned_to(replace(camera, projection="axonometric"), -angle_y, angle_x, away)
    if slug in ("cavalier", "cabinet", "oblique"):
        return turned_to(replace(camera, projection=slug), 0.0, 0.0, away)
    if slug in _POINTS:
        x, y, z = projection.perspective_placement(_POINTS[slug], camera.look_at.xyz, away)
        up = Point3D(0.0, 1.0, 0.0)
        return replace(camera, projection="perspective", eye=Point3D(x, y, z), up=up)
    raise LookupError(f"There is no projection {slug!r}.")


def kind_of(camera: Camera) -> str:
    """The slug of the projection that a camera has, the most special one. Raises: ValueError."""
    view = view_matrix(camera)
    match camera.projection:
        case "perspective":
            points = projection.vanishing_points(projection_matrix(camera) @ view)
            count = sum(point is not None for point in points)
            return next(slug for slug, number in _POINTS.items() if number == count)
        case "orthographic":
            for side in projection.STANDARD_VIEWS:
                if np.allclose(view[:3, :3], projection.standard_view(side)[:3, :3], atol=_SAME):
                    return side
            return "orthographic"
        case "axonometric":
            name = projection.classify(projection_matrix(camera) @ view, view).name
            return name if name in ("isometric", "dimetric") else "trimetric"
        case name:
            return name


def receding(camera: Camera, inverse: float, radius: float) -> Camera:
    """``camera`` with its centre of projection 1/``inverse`` before a view plane through what it looks at.

    As ``inverse`` falls to 0 the centre goes to infinity, and the limit is the parallel projection.
    ``radius`` is how far the scene reaches from there. Raises: ValueError where the camera sees nothing.
    """
    theta, phi = turn_of(camera)
    if not inverse > 0.0:
        away = _FAR_ENOUGH * radius
        flat = replace(camera, projection="orthographic", near=max(away - 2 * radius, 1e-3), distance=away)
        return turned_to(replace(flat, far=away + 2 * radius), theta, phi, away)
    d = 1.0 / inverse
    near, far = max(d - 2 * radius, min(d, radius) / 100, 1e-3), d + 2 * radius
    central = replace(camera, projection="perspective", near=near, far=far, distance=d)
    return turned_to(central, theta, phi, d)


def _apart(camera: Camera, away: float) -> Camera:
    """``camera`` at least as far from what it looks at, where that is not far enough."""
    if math.dist(camera.eye.xyz, camera.look_at.xyz) >= away:
        return camera
    if camera.eye.xyz == camera.look_at.xyz:
        x, y, z = camera.look_at.xyz
        return replace(camera, eye=Point3D(x, y, z + away), up=Point3D(0.0, 1.0, 0.0))
    return turned_to(camera, *turn_of(camera), away)


def _like(camera: Camera, matrix: np.ndarray, away: float) -> Camera:
    """An axonometric camera that turns as ``matrix`` does."""
    right, _up, forward = matrix[:3, :3]
    theta, phi = math.atan2(-right[2], right[0]), math.asin(-forward[1])
    return turned_to(replace(camera, projection="axonometric"), theta, phi, away)


def _with_room(camera: Camera, away: float, radius: float) -> Camera:
    """``camera`` with near and far plane before and behind all that is seen."""
    near, far = min(camera.near, max(away - radius, radius / 100)), max(camera.far, away + 2 * radius)
    return replace(camera, near=max(near, 1e-3), far=far)
