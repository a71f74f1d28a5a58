"""Scenes with something of everything in them."""

from msgspec.structs import replace

from workbench.algorithms import solids
from workbench.document.model import Document
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.links import (
    Affine3D,
    Reflect3D,
    Rotate3D,
    Scale3D,
    Shear3D,
    Translate3D,
)
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import (
    Camera,
    Light,
    Material,
    NamedView,
    Object,
    Point3D,
    Scene,
    SpacePoint,
)
from workbench.document.scene.solids import (
    AnySolid,
    Blobs,
    Box,
    Bracket,
    Cone,
    Cylinder,
    Ellipsoid,
    Extrusion,
    House,
    Jug,
    MeshSolid,
    PiercingPlanes,
    Prism,
    Pyramid,
    Regular,
    Revolution,
    Sphere,
    Surface,
    Torus,
)

PLAIN: tuple[AnySolid, ...] = (
    Box(),
    Prism(),
    Pyramid(),
    Sphere(),
    Cylinder(),
    Cone(),
    Torus(),
    Regular("dodecahedron"),
    House(),
    Bracket(),
    PiercingPlanes(),
    Jug(),
    MeshSolid(blob_of(solids.icosahedron())),
    Ellipsoid(),
    Blobs(),
)


def points(name: str, *places: tuple[float, ...]) -> tuple[SpacePoint, ...]:
    return tuple(SpacePoint(f"{name}p{k}", *place) for k, place in enumerate(places))


def full_scene() -> Scene:
    """Every kind of solid, of link, and all else once."""
    objects = [Object(f"o{k}", solid, "m1") for k, solid in enumerate(PLAIN)]
    outline = points("e", (0, 0), (2, 0), (1, 1))
    net = points("s", *((float(u), float(u * v), float(v)) for u in range(3) for v in range(3)))
    objects += [
        Object("oe", Extrusion(2.0), "m1", points=outline),
        Object("or", Revolution(8), "m1", points=points("r", (1, 0), (2, 1), (0, 2))),
        Object("os", Surface(3, 2, 2, 0.05), "m1", points=net),
    ]
    chain = (
        Translate3D("t1", tx=1.0),
        Rotate3D("t2", angle=90.0, x_axis=1.0),
        Scale3D("t3", sx=2.0),
        Reflect3D("t4"),
        Shear3D("t5", sh_xy=0.5),
        Affine3D("t6", m14=3.0),
    )
    objects[0] = replace(objects[0], transforms=chain, name="first", visible=False)
    materials = (Material("m1", "red", 0xFF0000),)
    camera = Camera(eye=Point3D(1.0, 2.0, 9.0))
    aside = NamedView("n1", replace(camera, projection="isometric"), "aside")
    return Scene(tuple(objects), materials, (Light("l1"),), camera, (aside,))


def full_document() -> Document:
    document = blank_sheet()
    return replace(document, sheets=(replace(document.sheets[0], scene=full_scene()),))
