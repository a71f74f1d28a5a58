"""Animation: key frames, the in-betweens of a value, of an outline and of an orientation, and easings."""

from workbench.algorithms.animation.easings import (
    constant,
    cubic_bezier_easing,
    ease_in,
    ease_in_cubic,
    ease_in_out,
    ease_in_out_cubic,
    ease_out,
    ease_out_cubic,
    eased,
    linear,
)
from workbench.algorithms.animation.morph import morph
from workbench.algorithms.animation.slerp import slerp
from workbench.algorithms.animation.spline_tween import spline_tween
from workbench.algorithms.animation.tween import tween

__all__ = [
    "constant",
    "cubic_bezier_easing",
    "ease_in",
    "ease_in_cubic",
    "ease_in_out",
    "ease_in_out_cubic",
    "ease_out",
    "ease_out_cubic",
    "eased",
    "linear",
    "morph",
    "slerp",
    "spline_tween",
    "tween",
]
