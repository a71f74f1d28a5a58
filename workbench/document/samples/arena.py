"""The built-in scenes for all methods at once: on each some fail, and it is known why."""

import math

import numpy as np

from workbench.document.model import Document, Rectangle
from workbench.document.samples.figures import Example
from workbench.document.samples.visibility import even_material, scene_document
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import AnySolid, Bracket, MeshSolid, Regular
from workbench.geometry.meshes import Faces, Mesh
from workbench.language import _

PAGE = "arena"
READY = ("arena-ring", "piercing-planes", "arena-bracket", "arena-coplanar", "arena-solid")
"""The examples that are offered on the page, those of other pages among them."""

_COLOURS = 0x0072B2, 0xD55E00, 0x00805C
_NEAR, _FAR = 1.0, 11.0
_LETTERS = "ABC"


def arena_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "arena-ring",
            _("Three bars in a ring"),
            _(
                "A hides part of B, B part of C, C part of A: no order is right, and the painter's "
                "algorithm fails."
            ),
            "space",
            _ring(),
            PAGE,
        ),
        Example(
            "arena-bracket",
            _("A bracket with a notch"),
            _("Faces turned towards the eye hide one another: leaving out the back faces is not enough."),
            "space",
            _solid(_("A bracket with a notch"), Bracket(2.6, 2.2, 1.4, 0.6), Point3D(-4.0, 5.0, -4.0), 0.9),
            PAGE,
        ),
        Example(
            "arena-coplanar",
            _("Two squares in one plane"),
            _(
                "Depths are equal where they overlap: every method that compares depths keeps the "
                "lower number."
            ),
            "space",
            _coplanar(),
            PAGE,
        ),
        Example(
            "arena-solid",
            _("One convex solid"),
            _("The only hidden faces are those turned away: here every method is right."),
            "space",
            _solid(_("One convex solid"), Regular("dodecahedron", 1.3), Point3D(2.0, 1.5, 7.0)),
            PAGE,
        ),
    ]


def _ring() -> Document:
    """Bars from each corner of a triangle to the next, far at the one and near at the other."""
    corners = np.array([(12.0, 6.0), (36.0, 6.0), (24.0, 26.0)])
    bars = []
    for k in range(3):
        start, end = corners[k], corners[(k + 1) % 3]
        along = (end - start) / np.hypot(*(end - start))
        across = 2.6 * np.array([-along[1], along[0]])
        outside = 5.0 * along
        ring = [
            start - outside - across,
            end + outside - across,
            end + outside + across,
            start - outside + across,
        ]
        bars.append([(x, y, z) for (x, y), z in zip(ring, (0.8, 0.2, 0.2, 0.8), strict=True)])
    names = [_("Bar {letter}").format(letter=letter) for letter in _LETTERS]
    return _flat(_("Three bars in a ring"), names, bars)


def _coplanar() -> Document:
    first = [(6.0, 4.0, 0.5), (30.0, 4.0, 0.5), (30.0, 22.0, 0.5), (6.0, 22.0, 0.5)]
    second = [(18.0, 10.0, 0.5), (42.0, 10.0, 0.5), (42.0, 28.0, 0.5), (18.0, 28.0, 0.5)]
    names = [_("Square {n}").format(n=n) for n in (0, 1)]
    return _flat(_("Two squares in one plane"), names, [first, second])


def _flat(name: str, names: list[str], polygons: list[list[tuple[float, float, float]]]) -> Document:
    """Polygons by pixels and depths from 0 to 1, seen along z."""
    objects = tuple(
        Object(f"o{k}", MeshSolid(blob_of(_mesh(polygon))), f"m{k}", title)
        for k, (title, polygon) in enumerate(zip(names, polygons, strict=True), 1)
    )
    materials = tuple(even_material(_COLOURS[k - 1], f"m{k}") for k in range(1, len(objects) + 1))
    camera = Camera(
        "orthographic",
        eye=Point3D(23.5, 15.5, 0.0),
        look_at=Point3D(23.5, 15.5, -1.0),
        near=_NEAR,
        far=_FAR,
        distance=_NEAR,
    )
    window = Rectangle(-24.0, -16.0, 24.0, 16.0)
    return scene_document(name, Scene(objects, materials, (), camera), window)


def _mesh(polygon: list[tuple[float, float, float]]) -> Mesh:
    places = np.array([(x, y, -(_NEAR + (_FAR - _NEAR) * z)) for x, y, z in polygon])
    return Mesh(places, Faces.of([list(range(len(polygon)))]))


def _solid(name: str, solid: AnySolid, eye: Point3D, height: float = 0.0) -> Document:
    """A solid in its own light; the camera looks at a point of its axis at a height."""
    look_at = Point3D(0.0, height, 0.0)
    camera = Camera(eye=eye, look_at=look_at, near=2.0, far=14.0, distance=math.dist(eye.xyz, look_at.xyz))
    material = Material("m1", colour=_COLOURS[0], ambient=0.3, diffuse=0.7)
    scene = Scene((Object("o1", solid, "m1", name),), (material,), (), camera)
    return scene_document(name, scene, Rectangle(-2.4, -1.6, 2.4, 1.6))
