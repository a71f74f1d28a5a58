"""The built-in scenes of hidden surfaces: small enough that every fragment can be looked at."""

import math

import numpy as np

from workbench.document.model import Document, Rectangle, Sheet, View, whole_sheet
from workbench.document.samples.figures import PALETTE, Example
from workbench.document.scene.links import Rotate3D
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, MeshSolid, PiercingPlanes, Sphere, Torus
from workbench.geometry.meshes import Faces, Mesh
from workbench.language import _

PAGE = "visibility"
SIZE_PX = (48, 32)
_NEAR, _FAR = 1.0, 11.0


def visibility_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "overlapping-triangles",
            _("Two triangles that pierce"),
            _("At (23, 15) the second triangle comes in front of the first: 0.5075 against 0.52."),
            "space",
            _overlapping_triangles(),
            PAGE,
        ),
        Example(
            "piercing-planes",
            _("Piercing planes"),
            _("Three squares through one another: no painting order is right, but the depth buffer is."),
            "space",
            _piercing_planes(),
            PAGE,
        ),
        Example(
            "almost-one-plane",
            _("Two faces almost in one plane"),
            _(
                "A box just in front of a wall: with few bits of depth their surfaces flicker into "
                "each other."
            ),
            "space",
            _almost_one_plane(),
            PAGE,
        ),
        Example(
            "octree-solids",
            _("A ring and a ball in cubes"),
            _("A solid divided into octants; two of them are joined, or one is cut by a plane."),
            "space",
            _solids(),
            PAGE,
            entry="octree_of_solid",
        ),
    ]


def _overlapping_triangles() -> Document:
    """Two triangles whose device coordinates are their places in the world, seen along z."""
    first = ((3, 3, 0.296), (41, 6, 0.682), (9, 29, 0.408))
    second = ((1, 18, 0.7945), (30, 1, 0.364), (37, 25, 0.3725))
    objects = tuple(
        Object(
            f"o{number}", MeshSolid(blob_of(_triangle(corners))), f"m{number}", _("Triangle {n}").format(n=n)
        )
        for number, n, corners in ((1, 0, first), (2, 1, second))
    )
    camera = Camera(
        "orthographic",
        eye=Point3D(23.5, 15.5, 0.0),
        look_at=Point3D(23.5, 15.5, -1.0),
        near=_NEAR,
        far=_FAR,
        distance=_NEAR,
    )
    materials = even_material(0x0072B2), even_material(0xD55E00, "m2")
    window = Rectangle(-24.0, -16.0, 24.0, 16.0)
    return scene_document(_("Two triangles that pierce"), Scene(objects, materials, (), camera), window)


def _triangle(corners: tuple[tuple[float, float, float], ...]) -> Mesh:
    """A triangle by pixels and depths from 0 to 1."""
    places = np.array([(x, y, -(_NEAR + (_FAR - _NEAR) * z)) for x, y, z in corners])
    return Mesh(places, Faces.of([[0, 1, 2]]))


def even_material(colour: int, identity: str = "m1") -> Material:
    """A material that has its colour in any light, so that surfaces are told apart by it."""
    return Material(identity, colour=colour, ambient=1.0, diffuse=0.0, specular=0.0)


def _piercing_planes() -> Document:
    vertices, faces = PiercingPlanes(3.0).mesh(())
    squares = [Mesh(vertices, faces.chosen(np.arange(len(faces)) == k)) for k in range(len(faces))]
    objects = tuple(
        Object(f"o{k}", MeshSolid(blob_of(square)), f"m{k}", _("Square {n}").format(n=k))
        for k, square in enumerate(squares, 1)
    )
    materials = tuple(even_material(PALETTE[k], f"m{k}") for k in range(1, len(squares) + 1))
    camera = Camera(eye=Point3D(4.0, 3.0, 6.0), near=4.0, far=12.0, distance=5.0)
    scene = Scene(objects, materials, (), camera)
    return scene_document(_("Piercing planes"), scene, Rectangle(-1.8, -1.2, 1.8, 1.2))


def _almost_one_plane() -> Document:
    solids = (Box(4.0, 2.6, 0.2), _("Wall")), (Box(2.0, 1.4, 0.22), _("Poster"))
    objects = tuple(
        Object(f"o{k}", solid, f"m{k}", name, transforms=(Rotate3D(id=f"t{k}", angle=20.0),))
        for k, (solid, name) in enumerate(solids, 1)
    )
    camera = Camera(eye=Point3D(0.0, 0.0, 8.0), near=1.0, far=100.0, distance=5.0)
    scene = Scene(objects, (even_material(0x0072B2), even_material(0xD55E00, "m2")), (), camera)
    return scene_document(_("Two faces almost in one plane"), scene, Rectangle(-1.8, -1.2, 1.8, 1.2))


def _solids() -> Document:
    """A ring that lies about a ball."""
    objects = (
        Object("o1", Torus(1.1, 0.4), "m1", _("Ring")),
        Object("o2", Sphere(0.9), "m2", _("Ball")),
    )
    materials = Material("m1", colour=0x2F7FC4), Material("m2", colour=0xD98A3A)
    eye = Point3D(2.6, 3.2, 5.2)
    camera = Camera(eye=eye, near=2.0, far=14.0, distance=math.dist(eye.xyz, (0.0, 0.0, 0.0)))
    scene = Scene(objects, materials, (), camera)
    return scene_document(_("A ring and a ball in cubes"), scene, Rectangle(-2.7, -1.8, 2.7, 1.8))


def scene_document(name: str, scene: Scene, window: Rectangle) -> Document:
    """A sheet of a scene, of which a window of the view plane is seen."""
    width, height = SIZE_PX
    view = View("v1", window, whole_sheet(width, height))
    return Document((Sheet("s1", name, width, height, (view,), PALETTE, scene=scene),))
