"""The scene of a sheet: objects, materials, lights and a camera, in a right-handed world, y up."""

from functools import cached_property
from typing import Annotated, ClassVar

import msgspec

from workbench.document.fields import Choice, Number
from workbench.document.numbers import LARGEST_ENTRY, MAX_COORDINATE, coordinate
from workbench.document.parts import WithParts
from workbench.document.scene.links import Transformed3D
from workbench.document.scene.solids import AnySolid, mesh_over
from workbench.geometry.meshes import Mesh
from workbench.language import _

PROJECTIONS = (
    "orthographic",
    "isometric",
    "axonometric",
    "cavalier",
    "cabinet",
    "oblique",
    "perspective",
    "matrix",
)
_IDENTITY = tuple(float(row == column) for row in range(4) for column in range(4))
_COLOUR = Number(label=_("colour"), low=0, high=0xFFFFFF, whole=True, keyed=False)


def _share(label: str, symbol: str) -> Number:
    return Number(label=label, symbol=symbol, low=0.0, high=1.0, keyed=True)


def _fading(label: str, symbol: str) -> Number:
    return Number(label=label, symbol=symbol, low=0.0, high=1e6, keyed=True)


class Point3D(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A point, or a direction, in the world."""

    x: Annotated[float, coordinate("x")]
    y: Annotated[float, coordinate("y")]
    z: Annotated[float, coordinate("z")]

    @property
    def xyz(self) -> tuple[float, float, float]:
        """Its coordinates."""
        return self.x, self.y, self.z


class SpacePoint(
    msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True
):
    """A point of an outline, a profile or a control net. Its id begins with ``letter`` by habit."""

    letter: ClassVar[str] = "p"

    id: str
    x: Annotated[float, coordinate("x")]
    y: Annotated[float, coordinate("y")]
    z: Annotated[float, coordinate("z")] = 0.0
    weight: Annotated[float, Number(label=_("weight"), symbol="w", low=1e-9, high=1e9, keyed=True)] = 1.0


class Object(
    WithParts,
    Transformed3D,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    cache_hash=True,
):
    """One thing of a scene: a solid, in coordinates of its own, which its chain takes into the world.

    ``points`` are those of an outline, a profile or a control net; ``material`` is an id of the scene.
    """

    letter: ClassVar[str] = "o"

    id: str
    solid: AnySolid
    material: str
    name: str = ""
    visible: bool = True
    points: tuple[SpacePoint, ...] = ()

    @property
    def mesh(self) -> Mesh:
        """Its faces as polygons, in coordinates of its own. Raises: ValueError, a sentence."""
        return mesh_over(self.solid, self.points)

    @cached_property
    def triangle_count(self) -> int:
        """How many triangles its faces are cut into. Raises: ValueError, a sentence."""
        return self.mesh.faces.triangle_count


class Material(
    WithParts,
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    cache_hash=True,
    dict=True,
):
    """How a surface answers light: its colour, shares of three kinds of light, the exponent of its shine.

    ``opacity`` is what it stops of the light from behind it; only the A-buffer asks for that.
    """

    letter: ClassVar[str] = "m"

    id: str
    name: str = ""
    colour: Annotated[int, _COLOUR] = 0xC8C8C8
    ambient: Annotated[float, _share(_("ambient share"), "k_a")] = 0.25
    diffuse: Annotated[float, _share(_("diffuse share"), "k_d")] = 0.75
    specular: Annotated[float, _share(_("specular share"), "k_s")] = 0.3
    shininess: Annotated[
        float, Number(label=_("shininess"), symbol="n_s", low=1.0, high=1000.0, keyed=True)
    ] = 20.0
    opacity: Annotated[float, _share(_("opacity"), "o")] = 1.0


class Light(
    WithParts,
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    cache_hash=True,
    dict=True,
):
    """A light at a point; a ``distant`` one shines from that direction, equally everywhere.

    At a distance d a light at a point keeps min(1, 1 / (a0 + a1 d + a2 d^2)) of its intensity.
    """

    letter: ClassVar[str] = "l"

    id: str
    position: Point3D = Point3D(4.0, 8.0, 6.0)
    name: str = ""
    colour: Annotated[int, _COLOUR] = 0xFFFFFF
    intensity: Annotated[float, Number(label=_("intensity"), symbol="I", low=0.0, high=100.0, keyed=True)] = (
        1.0
    )
    distant: bool = True
    a0: Annotated[float, _fading(_("attenuation"), "a_0")] = 1.0
    a1: Annotated[float, _fading(_("attenuation by distance"), "a_1")] = 0.0
    a2: Annotated[float, _fading(_("attenuation by the distance squared"), "a_2")] = 0.0


class Camera(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """From where and how a scene is seen; view coordinates are x right, y up, z into the picture.

    ``distance`` is from the eye to the view plane; all angles are degrees, the oblique ones those of oblique
    projections, angle_y and angle_x those of the axonometric one. Depths ``near`` to ``far`` are drawn. The
    projection "matrix" is ``entries``, row by row, from view coordinates to the view plane, with depths from
    0 to 1.
    """

    projection: Annotated[str, Choice(PROJECTIONS)] = "perspective"
    eye: Point3D = Point3D(6.0, 5.0, 8.0)
    look_at: Point3D = Point3D(0.0, 0.0, 0.0)
    up: Point3D = Point3D(0.0, 1.0, 0.0)
    near: Annotated[
        float, Number(label=_("near plane"), low=1e-3, high=MAX_COORDINATE, unit="world", keyed=True)
    ] = 0.1
    far: Annotated[
        float, Number(label=_("far plane"), low=1e-3, high=MAX_COORDINATE, unit="world", keyed=True)
    ] = 100.0
    distance: Annotated[
        float,
        Number(
            label=_("distance of the view plane"),
            symbol="d",
            low=1e-3,
            high=MAX_COORDINATE,
            unit="world",
            keyed=True,
        ),
    ] = 5.0
    oblique_alpha: Annotated[float, coordinate(_("angle of the projectors"), "α", "°")] = 45.0
    oblique_phi: Annotated[float, coordinate(_("direction of receding lines"), "φ", "°")] = 45.0
    angle_y: Annotated[float, coordinate(_("angle about y"), "θ_y", "°")] = -30.0
    angle_x: Annotated[float, coordinate(_("angle about x"), "θ_x", "°")] = 20.0
    entries: tuple[
        Annotated[
            float,
            Number(
                label=_("entry of the matrix"), symbol="m", low=-LARGEST_ENTRY, high=LARGEST_ENTRY, keyed=True
            ),
        ],
        ...,
    ] = _IDENTITY


class NamedView(
    WithParts,
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    cache_hash=True,
    dict=True,
):
    """A camera that was given a name, so that the scene can be seen by it again."""

    letter: ClassVar[str] = "n"

    id: str
    camera: Camera
    name: str = ""


Thing = Object | Material | Light | NamedView


class Scene(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, cache_hash=True):
    """Objects in the order of the list, the materials and lights they are seen by, the camera, and others
    to go to.
    """

    objects: tuple[Object, ...] = ()
    materials: tuple[Material, ...] = ()
    lights: tuple[Light, ...] = ()
    camera: Camera = Camera()
    named_views: tuple[NamedView, ...] = ()

    @property
    def things(self) -> tuple[Thing, ...]:
        """All in it that has an id of its own."""
        return (*self.objects, *self.materials, *self.lights, *self.named_views)
