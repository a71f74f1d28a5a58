"""The built-in scenes."""

import math
from collections.abc import Sequence

from msgspec.structs import replace

from workbench.document.model import Document
from workbench.document.samples.figures import Example, document_of
from workbench.document.scene.links import AnyLink3D, Rotate3D, Translate3D
from workbench.document.scene.looking import projecting
from workbench.document.scene.model import Camera, Material, Object, Point3D, Scene
from workbench.document.scene.solids import AnySolid, Box, House, Pyramid
from workbench.language import _

_SIZE_PX = (320, 240)
Placed = tuple[str, AnySolid, tuple[float, float, float], float, int]
"""Name, solid, where it stands, by how many degrees it is turned about y, its colour."""


def space_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "space-house",
            _("A house in perspective"),
            _("Two vanishing points on the horizon: see which lines converge, and why we divide by depth."),
            "space",
            _house(),
        ),
        Example(
            "space-isometric",
            _("A cube in isometric projection"),
            _(
                "Seen from (1, 1, 1): x, y and z are shortened equally, to 0.816, and parallels "
                "stay parallel."
            ),
            "space",
            _cube("isometric", _("A cube in isometric projection")),
        ),
        Example(
            "space-street",
            _("Three equal houses, one behind another"),
            _("Equal in a parallel picture, smaller with distance in perspective: press 5 to switch."),
            "space",
            _street(),
        ),
        Example(
            "space-cabinet",
            _("A cube in cabinet projection"),
            _("The front in true size, and receding lines at half their length."),
            "space",
            _cube("cabinet", _("A cube in cabinet projection")),
        ),
    ]


def scene_of(placed: Sequence[Placed], camera: Camera) -> Scene:
    """Objects with a material each, whose ids are "o1" and "m1" onwards."""
    objects, materials = [], []
    for number, (name, solid, (x, y, z), degrees, colour) in enumerate(placed, 1):
        links: list[AnyLink3D] = []
        if degrees:
            links.append(Rotate3D(f"r{number}", angle=degrees))
        if any((x, y, z)):
            links.append(Translate3D(f"t{number}", tx=x, ty=y, tz=z))
        materials.append(Material(f"m{number}", name=name, colour=colour, ambient=0.45, diffuse=0.6))
        objects.append(Object(f"o{number}", solid, f"m{number}", name, transforms=tuple(links)))
    return Scene(tuple(objects), tuple(materials), camera=camera)


def _document(name: str, scene: Scene) -> Document:
    document = document_of(name, *_SIZE_PX, ())
    return Document((replace(document.sheets[0], scene=scene),))


def _house() -> Document:
    eye, look_at = Point3D(4.5, 1.6, 6.0), Point3D(0.0, 1.6, 0.0)
    away = math.dist(eye.xyz, look_at.xyz)
    camera = Camera(eye=eye, look_at=look_at, near=0.1, far=4.0 * away, distance=3.0)
    placed = (
        (_("House"), House(3.0, 2.2, 5.0, 1.5), (0.0, 0.0, 0.0), 0.0, 0x9CC8E6),
        (_("Chimney"), Box(0.5, 1.4, 0.5), (0.8, 3.1, -0.8), 0.0, 0xF0A878),
        (_("Shed"), Pyramid(4, 1.0, 1.4), (-2.6, 0.0, 1.4), 45.0, 0x8CCDB0),
    )
    return _document(_("A house in perspective"), scene_of(placed, camera))


def _street() -> Document:
    """From the place of the isometric view, where the perspective has three vanishing points."""
    house, colours = House(1.6, 1.1, 1.8, 0.8), (0x9CC8E6, 0xF0A878, 0x8CCDB0)
    placed = [
        (_("House {n}").format(n=n), house, (0.0, 0.0, 3.2 - 3.2 * k), 0.0, colours[k])
        for k, n in enumerate((1, 2, 3))
    ]
    look_at = Point3D(0.0, 0.8, 0.0)
    camera = projecting(Camera(look_at=look_at, eye=Point3D(0.0, 0.8, 10.0)), "isometric", 4.6)
    return _document(_("Three equal houses, one behind another"), scene_of(placed, camera))


def _cube(slug: str, name: str) -> Document:
    camera = projecting(Camera(look_at=Point3D(0.0, 0.0, 0.0), eye=Point3D(0.0, 0.0, 9.0)), slug, 2.0)
    return _document(name, scene_of(((_("Cube"), Box(), (0.0, 0.0, 0.0), 0.0, 0x9CC8E6),), camera))
