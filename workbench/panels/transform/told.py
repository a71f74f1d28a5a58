"""What links and stages are called: on cards, beside matrices, in the legend."""

import math

from workbench.document.scene.links import (
    Affine3D,
    Reflect3D,
    Rotate3D,
    Scale3D,
    Shear3D,
    Translate3D,
)
from workbench.document.transforms.links import Link, Reflect, Rotate, Scale, Shear, Translate
from workbench.document.transforms.names import title as kind_title
from workbench.document.transforms.stages import Stage
from workbench.exchange.formulas.terms import displayed
from workbench.language import _

ICONS: dict[str, str] = {
    "Translate": "arrows-out-cardinal",
    "Rotate": "arrow-clockwise",
    "Scale": "arrows-out",
    "Reflect": "arrows-left-right",
    "Shear": "text-italic",
    "Affine": "brackets-square",
}


def title(link: Link) -> str:
    """What the card of a link is headed with."""
    match link:
        case Rotate() if _has_pivot(link):
            return _("Rotation about a pivot")
        case Rotate():
            return _("Rotation about the origin")
        case Scale() if _has_pivot(link):
            return _("Scaling about a fixed point")
        case Scale():
            return _("Scaling from the origin")
        case Translate():
            return _("Translation")
        case Shear():
            return _("Shear")
        case Reflect(mirror="point"):
            return _("Reflection in a point")
        case Reflect():
            return _("Reflection in a line")
        case Rotate3D():
            return _("Rotation about an axis")
        case Reflect3D():
            return _("Reflection in a plane")
        case Scale3D():
            return _("Scaling")
        case Translate3D():
            return _("Translation")
        case Shear3D():
            return _("Shear")
        case Affine3D():
            return _("Matrix")
    return kind_title(link)


def _has_pivot(link: Rotate | Scale) -> bool:
    return link.x_pivot != 0.0 or link.y_pivot != 0.0


def in_numbers(stage: Stage) -> str:
    """The matrix of a stage with its numbers, as a formula: R(45°), T(−3, −3)."""
    name, arguments = stage.elementary.name, stage.elementary.arguments
    match name:
        case "translation":
            return f"T({_listed(arguments)})"
        case "rotation":
            return f"R({_degrees(arguments[0])})"
        case "scaling":
            return f"S({_listed(arguments)})"
        case "reflection":
            return f"F({_degrees(arguments[2])})"
        case "shear":
            return f"Sh({_listed(arguments[:2])})"
    return stage.symbols.name


def caption(stage: Stage) -> str:
    """What a stage does, in a few words."""
    if stage.parts > 1 and stage.part != 1:
        shear = isinstance(stage.link, Shear)
        if stage.part == 0:
            return _("base lines to the axes") if shear else _("pivot to the origin")
        return _("back again")
    name, arguments = stage.elementary.name, stage.elementary.arguments
    match name:
        case "translation":
            return _("moved by ({numbers})").format(numbers=_listed(arguments))
        case "rotation":
            return _("turned by {angle}").format(angle=_degrees(arguments[0]))
        case "scaling" if isinstance(stage.link, Reflect):
            return _("turned by half a turn")
        case "scaling":
            return _("scaled by {numbers}").format(numbers=_listed(arguments))
        case "reflection":
            return _("mirrored at {angle}").format(angle=_degrees(arguments[2]))
        case "shear":
            return _("sheared by {numbers}").format(numbers=_listed(arguments[:2]))
    return _("by the matrix {name}").format(name=stage.symbols.name)


def product_name(number: int, count: int) -> str:
    """What the product up to stage ``number`` of ``count`` is called: M_2, M_3 and so on, the last one M."""
    return "M" if number == count else f"M_{{{number}}}"


def _listed(numbers: tuple[float, ...]) -> str:
    return ", ".join(displayed(round(number, 4)) for number in numbers)


def _degrees(angle: float) -> str:
    return f"{displayed(round(math.degrees(angle), 2))}°"


def place_text(x: float, y: float) -> str:
    """A point."""
    return f"({displayed(x)}, {displayed(y)})"


def space_text(x: float, y: float, z: float) -> str:
    """A point of space."""
    return f"({displayed(x)}, {displayed(y)}, {displayed(z)})"
