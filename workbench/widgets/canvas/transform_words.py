"""What a drag on a transform box does, in the words that stand beside the pointer and are announced."""

import math

from workbench.exchange.formulas.terms import displayed
from workbench.geometry.transform_box import Motion
from workbench.language import _

_DECIMALS, _OF_DEGREES = 2, 1


def described(motion: Motion) -> str:
    """The kind and its numbers: "rotate 37.5° about (12, 8)"."""
    numbers = {name: _short(value) for name, value in motion.numbers.items()}
    match motion.kind:
        case "move":
            return _("move by ({dx}, {dy})").format(**numbers)
        case "rotate":
            return _("rotate {angle}° about ({x}, {y})").format(**_in_degrees(motion, numbers))
        case "shear":
            sentence = _("shear {factor}, {angle}°, about ({x}, {y})")
            return sentence.format(**_in_degrees(motion, numbers))
        case "scale":
            mirrored = motion.numbers["sx"] < 0 or motion.numbers["sy"] < 0
            if numbers["sx"] == numbers["sy"]:
                sentence = (
                    _("mirror and scale {sx} about ({x}, {y})")
                    if mirrored
                    else _("scale {sx} about ({x}, {y})")
                )
            else:
                sentence = (
                    _("mirror and scale {sx} × {sy} about ({x}, {y})")
                    if mirrored
                    else _("scale {sx} × {sy} about ({x}, {y})")
                )
            return sentence.format(**numbers)


def pivot_at(x: float, y: float) -> str:
    """Where the pivot is."""
    return _("pivot ({x}, {y})").format(x=_short(x), y=_short(y))


def handle_name(handle: str) -> str:
    """What a handle is called, and what it does."""
    return {
        "move": _("inside: moves"),
        "turn": _("round handle: turns about the pivot"),
        "pivot": _("pivot"),
        "bottom left": _("bottom left corner: scales"),
        "bottom": _("bottom side: scales, with Alt shears"),
        "bottom right": _("bottom right corner: scales"),
        "right": _("right side: scales, with Alt shears"),
        "top right": _("top right corner: scales"),
        "top": _("top side: scales, with Alt shears"),
        "top left": _("top left corner: scales"),
        "left": _("left side: scales, with Alt shears"),
    }[handle]


def _in_degrees(motion: Motion, numbers: dict[str, str]) -> dict[str, str]:
    return {**numbers, "angle": displayed(round(math.degrees(motion.numbers["angle"]), _OF_DEGREES))}


def _short(value: float) -> str:
    return displayed(round(value, _DECIMALS))
