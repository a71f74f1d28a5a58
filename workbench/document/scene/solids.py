"""The solids of a scene: what each is made of by its numbers, a mesh, or points of its own.

What makes them is imported when one is made: few pictures have any, and the first frame waits for this.
"""

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import msgspec
import numpy as np

from workbench.document.fields import Choice, Number
from workbench.document.numbers import MAX_COORDINATE
from workbench.document.scene.meshes import mesh_of
from workbench.document.storage.blobs import Blob
from workbench.geometry.meshes import Faces, Mesh
from workbench.language import _
from workbench.memory import Memory

if TYPE_CHECKING:
    from workbench.algorithms.surfaces import Patches
    from workbench.document.scene.model import SpacePoint

REGULAR = ("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron")
LEAST_SIZE = 1e-6
MOST_STEPS = 200


def _size(label: str, symbol: str = "") -> Number:
    return Number(label=label, symbol=symbol, low=LEAST_SIZE, high=MAX_COORDINATE, unit="world", keyed=True)


def _steps(label: str, least: int = 3, most: int = MOST_STEPS) -> Number:
    return Number(label=label, low=least, high=most, whole=True, keyed=False)


class Solid(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", cache_hash=True):
    """What all solids share. ``least_points`` and ``most_points`` bound the points of its object."""

    least_points: ClassVar[int] = 0
    most_points: ClassVar[int] = 0
    equation: ClassVar[str] = ""
    """Of what its faces come near to, where that has one, in the symbols of its numbers."""

    def mesh(self, points: "tuple[SpacePoint, ...]") -> Mesh:
        """Its vertices, in coordinates of its own, and faces. Raises: ValueError, a sentence."""
        raise NotImplementedError


class _Simple(Solid, frozen=True):
    """A solid that the function of ``algorithms.solids`` with its tag for a name makes of its numbers."""

    def mesh(self, _points: Any) -> Mesh:
        """By that function."""
        from workbench.algorithms import solids

        made: Mesh = getattr(solids, str(self.__struct_config__.tag))(**msgspec.structs.asdict(self))
        return made


class Box(_Simple, frozen=True, tag="box"):
    """A box around the origin."""

    width: Annotated[float, _size(_("width"))] = 2.0
    height: Annotated[float, _size(_("height"))] = 2.0
    depth: Annotated[float, _size(_("depth"))] = 2.0


class Prism(_Simple, frozen=True, tag="prism"):
    """A prism on y = 0 over a regular polygon."""

    sides: Annotated[int, _steps(_("sides"))] = 6
    radius: Annotated[float, _size(_("radius"), "r")] = 1.0
    height: Annotated[float, _size(_("height"))] = 2.0


class Pyramid(_Simple, frozen=True, tag="pyramid"):
    """A pyramid on y = 0 over a regular polygon."""

    sides: Annotated[int, _steps(_("sides"))] = 4
    radius: Annotated[float, _size(_("radius"), "r")] = 1.0
    height: Annotated[float, _size(_("height"))] = 2.0


class Sphere(_Simple, frozen=True, tag="sphere"):
    """A sphere around the origin, in flat faces."""

    equation: ClassVar[str] = "x² + y² + z² = r²"

    radius: Annotated[float, _size(_("radius"), "r")] = 1.0
    slices: Annotated[int, _steps(_("slices"))] = 24
    stacks: Annotated[int, _steps(_("stacks"), 2)] = 12


class Ellipsoid(_Simple, frozen=True, tag="ellipsoid"):
    """An ellipsoid around the origin, in flat faces."""

    equation: ClassVar[str] = "(x / r_x)² + (y / r_y)² + (z / r_z)² = 1"

    r_x: Annotated[float, _size(_("half axis along x"), "r_x")] = 1.5
    r_y: Annotated[float, _size(_("half axis along y"), "r_y")] = 1.0
    r_z: Annotated[float, _size(_("half axis along z"), "r_z")] = 0.75
    slices: Annotated[int, _steps(_("slices"))] = 24
    stacks: Annotated[int, _steps(_("stacks"), 2)] = 12


class Blobs(_Simple, frozen=True, tag="blobs"):
    """Blobby balls round a circle, which flow together where their densities add up to the threshold."""

    equation: ClassVar[str] = "Σ exp(−a r_k²) = T"

    balls: Annotated[int, _steps(_("balls"), 1, 8)] = 2
    spread: Annotated[float, _size(_("distance of the balls from the middle"))] = 0.75
    tightness: Annotated[float, _size(_("tightness"), "a")] = 2.0
    threshold: Annotated[float, Number(label=_("threshold"), symbol="T", low=0.01, high=0.99, keyed=True)] = (
        0.5
    )
    cells: Annotated[int, _steps(_("cells across"), 4, 48)] = 20


class Cylinder(_Simple, frozen=True, tag="cylinder"):
    """A cylinder on y = 0, in flat faces."""

    radius: Annotated[float, _size(_("radius"), "r")] = 1.0
    height: Annotated[float, _size(_("height"))] = 2.0
    slices: Annotated[int, _steps(_("slices"))] = 24


class Cone(_Simple, frozen=True, tag="cone"):
    """A cone on y = 0, in flat faces."""

    radius: Annotated[float, _size(_("radius"), "r")] = 1.0
    height: Annotated[float, _size(_("height"))] = 2.0
    slices: Annotated[int, _steps(_("slices"))] = 24


class Torus(_Simple, frozen=True, tag="torus"):
    """A ring around the y axis."""

    equation: ClassVar[str] = "(x² + y² + z² + R² − r²)² = 4 R² (x² + z²)"

    radius: Annotated[float, _size(_("radius"), "R")] = 2.0
    thickness: Annotated[float, _size(_("thickness"), "r")] = 0.75
    slices: Annotated[int, _steps(_("slices"))] = 32
    sections: Annotated[int, _steps(_("sections"))] = 16


class House(_Simple, frozen=True, tag="house"):
    """A house on y = 0."""

    width: Annotated[float, _size(_("width"))] = 2.0
    height: Annotated[float, _size(_("height"))] = 1.5
    depth: Annotated[float, _size(_("depth"))] = 3.0
    roof: Annotated[float, _size(_("roof"))] = 1.0


class Bracket(_Simple, frozen=True, tag="bracket"):
    """An angle of two arms, a solid that is not convex."""

    width: Annotated[float, _size(_("width"))] = 2.0
    height: Annotated[float, _size(_("height"))] = 2.0
    depth: Annotated[float, _size(_("depth"))] = 1.0
    thickness: Annotated[float, _size(_("thickness"))] = 0.5


class PiercingPlanes(_Simple, frozen=True, tag="piercing_planes"):
    """Three squares that pierce one another."""

    side: Annotated[float, _size(_("side"))] = 2.0


class Jug(_Simple, frozen=True, tag="jug"):
    """A jug of Bézier patches."""

    height: Annotated[float, _size(_("height"))] = 2.0
    steps: Annotated[int, _steps(_("steps"), 1, 64)] = 6


class Regular(Solid, frozen=True, tag="regular"):
    """One of the five regular solids; its corners are ``radius`` away from the origin."""

    polyhedron: Annotated[str, Choice(REGULAR)] = REGULAR[0]
    radius: Annotated[float, _size(_("radius"), "r")] = 1.0

    def mesh(self, _points: Any) -> Mesh:
        """By its name."""
        from workbench.algorithms import solids

        if self.polyhedron == "cube":
            return solids.cube(2.0 * self.radius / 3.0**0.5)
        make = {
            "tetrahedron": solids.tetrahedron,
            "octahedron": solids.octahedron,
            "dodecahedron": solids.dodecahedron,
            "icosahedron": solids.icosahedron,
        }[self.polyhedron]
        return make(self.radius)


class Extrusion(Solid, frozen=True, tag="extrusion"):
    """The outline of the object's points, x and y, carried along z."""

    least_points: ClassVar[int] = 3
    most_points: ClassVar[int] = 2_000

    depth: Annotated[float, _size(_("depth"))] = 1.0

    def mesh(self, points: "tuple[SpacePoint, ...]") -> Mesh:
        """By ``extruded``."""
        from workbench.algorithms.solids import extruded

        return extruded([(point.x, point.y) for point in points], self.depth)


class Revolution(Solid, frozen=True, tag="revolution"):
    """The profile of the object's points, x from the axis and y upwards, carried round the y axis."""

    least_points: ClassVar[int] = 2
    most_points: ClassVar[int] = 500

    slices: Annotated[int, _steps(_("slices"))] = 24
    closed: bool = False

    def mesh(self, points: "tuple[SpacePoint, ...]") -> Mesh:
        """By ``turned``."""
        from workbench.algorithms.solids import turned

        return turned([(point.x, point.y) for point in points], self.slices, self.closed)


class Surface(Solid, frozen=True, tag="surface"):
    """A Bézier or B-spline surface over the object's points, ``rows`` of equally many, one after the other.

    Degrees of 0 make it one Bézier patch; else the knots are open and uniform. It is cut into triangles
    nowhere farther from it than ``tolerance``.
    """

    least_points: ClassVar[int] = 4
    most_points: ClassVar[int] = 10_000

    rows: Annotated[int, _steps(_("rows"), 2)] = 4
    u_degree: Annotated[int, _steps(_("degree along u"), 0, 7)] = 0
    v_degree: Annotated[int, _steps(_("degree along v"), 0, 7)] = 0
    tolerance: Annotated[
        float, Number(label=_("tolerance"), low=1e-6, high=MAX_COORDINATE, unit="world", keyed=False)
    ] = 0.01

    def mesh(self, points: "tuple[SpacePoint, ...]") -> Mesh:
        """By ``tessellate``."""
        from workbench.algorithms.surfaces import tessellate

        vertices, faces = tessellate(self.patches(points), self.tolerance)
        return Mesh(vertices, Faces.of(faces))

    def patches(self, points: "tuple[SpacePoint, ...]") -> "Patches":
        """The surface itself. Raises: ValueError."""
        from workbench.algorithms.surfaces import b_spline_patch, bezier_patch
        from workbench.geometry.curves.knots import open_uniform_knots

        if len(points) % self.rows:
            sentence = _("{count} points do not make {rows} rows of equal length; add or remove some.")
            raise ValueError(sentence.format(count=len(points), rows=self.rows))
        net = np.array([(p.x, p.y, p.z) for p in points]).reshape(self.rows, -1, 3)
        weights = np.array([p.weight for p in points]).reshape(self.rows, -1)
        if not (self.u_degree and self.v_degree):
            if max(net.shape[:2]) > 16:
                raise ValueError(
                    _("A Bézier patch has at most 16 rows and columns; give the surface degrees.")
                )
            return bezier_patch(net, weights)
        degrees = self.u_degree, self.v_degree
        u_knots, v_knots = (open_uniform_knots(n, d) for n, d in zip(net.shape, degrees, strict=False))
        return b_spline_patch(net, u_knots, v_knots, degrees, weights)


class MeshSolid(Solid, frozen=True, tag="mesh"):
    """A mesh that came from a file."""

    content: Blob

    def mesh(self, _points: Any) -> Mesh:
        """Itself."""
        return mesh_of(self.content)


AnySolid = (
    Box
    | Prism
    | Pyramid
    | Sphere
    | Ellipsoid
    | Blobs
    | Cylinder
    | Cone
    | Torus
    | Regular
    | House
    | Bracket
    | PiercingPlanes
    | Jug
    | Extrusion
    | Revolution
    | Surface
    | MeshSolid
)


_meshes: Memory[Mesh] = Memory(128 * 2**20, lambda mesh: mesh.arrays)


def mesh_over(solid: Solid, points: "tuple[SpacePoint, ...]") -> Mesh:
    """The mesh of a solid over the points of its object, made once. Raises: ValueError, a sentence."""
    return _meshes.get((solid, points), partial(solid.mesh, points))
