"""The built-in scenes of light: materials and lamps worth looking at."""

import math

from workbench.document.model import Document, Rectangle
from workbench.document.samples.figures import Example
from workbench.document.samples.visibility import scene_document
from workbench.document.scene.links import Translate3D
from workbench.document.scene.model import Camera, Light, Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, Jug, Sphere
from workbench.language import _

PAGE = "shading"
_WINDOW = Rectangle(-2.4, -1.6, 2.4, 1.6)


def shading_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "shading-ball",
            _("A ball with a highlight"),
            _(
                "A coarse ball: flat shading shows its faces, Gouraud tears the highlight, Phong "
                "finds it inside a face."
            ),
            "space",
            _ball(),
            PAGE,
            dock="lamps",
        ),
        Example(
            "shading-materials",
            _("Chalk, plastic and metal"),
            _("Three balls of one shape: only k_d, k_s and n tell what they are made of."),
            "space",
            _materials(),
            PAGE,
            dock="lamps",
        ),
        Example(
            "shading-lamps",
            _("A jug between two lamps"),
            _("A warm lamp nearby, whose light fades with distance, and a cold one far away."),
            "space",
            _lamps(),
            PAGE,
            dock="lamps",
        ),
    ]


def _ball() -> Document:
    lights = (Light("l1", Point3D(2.0, 3.0, 5.0), _("Lamp"), distant=False),)
    material = Material("m1", _("Plastic"), 0x2F7FC4, 0.12, 0.7, 0.6, 24.0)
    ball = Object("o1", Sphere(1.3, 10, 6), "m1", _("Ball"))
    return _document(_("A ball with a highlight"), Scene((ball,), (material,), lights, _camera()))


def _materials() -> Document:
    kinds = (
        (_("Chalk"), 0xE6DCC8, 0.15, 0.85, 0.0, 1.0),
        (_("Plastic"), 0xC43C3C, 0.12, 0.65, 0.5, 30.0),
        (_("Metal"), 0xB08A3C, 0.10, 0.30, 0.9, 90.0),
    )
    materials = tuple(Material(f"m{k}", *kind) for k, kind in enumerate(kinds, 1))
    balls = tuple(
        Object(
            f"o{k}", Sphere(0.72, 16, 10), material.id, material.name, transforms=(_beside(k, 1.6 * (k - 2)),)
        )
        for k, material in enumerate(materials, 1)
    )
    lights = (Light("l1", Point3D(-2.0, 4.0, 5.0), _("Lamp"), distant=False),)
    return _document(_("Chalk, plastic and metal"), Scene(balls, materials, lights, _camera()))


def _lamps() -> Document:
    objects = (
        Object("o1", Jug(), "m1", _("Jug")),
        Object("o2", Box(4.6, 0.2, 3.2), "m2", _("Table"), transforms=(Translate3D(id="t2", ty=-0.1),)),
    )
    materials = (
        Material("m1", _("Glaze"), 0xD8D8E4, 0.08, 0.75, 0.5, 40.0),
        Material("m2", _("Wood"), 0x8A6A48, 0.10, 0.80, 0.1, 8.0),
    )
    lights = (
        Light("l1", Point3D(-2.2, 1.2, 1.6), _("Warm lamp"), 0xFFC890, 2.4, False, 0.4, 0.2, 0.2),
        Light("l2", Point3D(4.0, 3.0, 1.0), _("Moon"), 0x90B8FF, 0.5),
    )
    return _document(_("A jug between two lamps"), Scene(objects, materials, lights, _camera(3.4, 0.8)))


def _beside(number: int, dx: float) -> Translate3D:
    return Translate3D(id=f"t{number}", tx=dx)


def _camera(height: float = 1.6, looks_at: float = 0.0) -> Camera:
    eye, look_at = Point3D(0.0, height, 7.0), Point3D(0.0, looks_at, 0.0)
    return Camera(eye=eye, look_at=look_at, near=2.0, far=16.0, distance=math.dist(eye.xyz, look_at.xyz))


def _document(name: str, scene: Scene) -> Document:
    return scene_document(name, scene, _WINDOW)
