"""The solids that can be added to a scene, and what they are called."""

from typing import NamedTuple

from workbench.document.scene.links import (
    Affine3D,
    AnyLink3D,
    Reflect3D,
    Rotate3D,
    Scale3D,
    Shear3D,
    Translate3D,
)
from workbench.document.scene.model import Object, SpacePoint
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
    PiercingPlanes,
    Prism,
    Pyramid,
    Regular,
    Revolution,
    Sphere,
    Surface,
    Torus,
)
from workbench.language import _
from workbench.panels.space.sweeps import hill, star, vase


class Offer(NamedTuple):
    """A solid to be added, as it is at first."""

    title: str
    solid: AnySolid
    points: tuple[SpacePoint, ...] = ()


def offers() -> tuple[Offer, ...]:
    """In the order of the menu."""
    return (
        Offer(_("House"), House()),
        Offer(_("Box"), Box()),
        Offer(_("Prism"), Prism()),
        Offer(_("Pyramid"), Pyramid()),
        Offer(_("Sphere"), Sphere()),
        Offer(_("Ellipsoid"), Ellipsoid()),
        Offer(_("Blobby balls"), Blobs()),
        Offer(_("Cylinder"), Cylinder()),
        Offer(_("Cone"), Cone()),
        Offer(_("Torus"), Torus()),
        Offer(_("Tetrahedron"), Regular("tetrahedron")),
        Offer(_("Cube"), Regular("cube")),
        Offer(_("Octahedron"), Regular("octahedron")),
        Offer(_("Dodecahedron"), Regular("dodecahedron")),
        Offer(_("Icosahedron"), Regular("icosahedron")),
        Offer(_("Angle, not convex"), Bracket()),
        Offer(_("Piercing planes"), PiercingPlanes()),
        Offer(_("Jug"), Jug()),
        Offer(_("Extrusion"), Extrusion(), star()),
        Offer(_("Revolution"), Revolution(), vase()),
        Offer(_("Bézier patch"), Surface(rows=4), hill()),
        Offer(_("B-spline patch"), Surface(rows=4, u_degree=2, v_degree=2), hill()),
    )


def links() -> tuple[tuple[str, AnyLink3D], ...]:
    """Name and first value of each transform that an object can be given."""
    return (
        (_("Translate"), Translate3D("")),
        (_("Rotate"), Rotate3D("")),
        (_("Scale"), Scale3D("")),
        (_("Reflect"), Reflect3D("")),
        (_("Shear"), Shear3D("")),
        (_("Matrix"), Affine3D("")),
    )


def title_of(thing: Object) -> str:
    """The name of an object, or what it is."""
    if thing.name:
        return thing.name
    if isinstance(thing.solid, Regular):
        return {offer.solid: offer.title for offer in offers()}.get(Regular(thing.solid.polyhedron), "")
    kinds = {type(offer.solid): offer.title for offer in offers()}
    return kinds.get(type(thing.solid), _("Object"))


def link_title(link: AnyLink3D) -> str:
    """What a transform is called."""
    return {type(each): name for name, each in links()}[type(link)]
