"""Easings as a sentence and a hand table write them."""

from workbench.algorithms.animation.easings import (
    BEZIER,
    CONSTANT,
    EASE_IN,
    EASE_IN_CUBIC,
    EASE_IN_OUT,
    EASE_IN_OUT_CUBIC,
    EASE_OUT,
    EASE_OUT_CUBIC,
    LINEAR,
)
from workbench.algorithms.numerals import numeral

_TITLES = {
    CONSTANT: "held",
    LINEAR: "linear",
    EASE_IN: "ease in",
    EASE_OUT: "ease out",
    EASE_IN_OUT: "ease in and out",
    EASE_IN_CUBIC: "cubic ease in",
    EASE_OUT_CUBIC: "cubic ease out",
    EASE_IN_OUT_CUBIC: "cubic ease in and out",
    BEZIER: "Bézier easing",
}
_FORMULAS = {
    EASE_IN: "1 − cos(π · {t} / 2)",
    EASE_OUT: "sin(π · {t} / 2)",
    EASE_IN_OUT: "(1 − cos(π · {t})) / 2",
    EASE_IN_CUBIC: "{t}³",
    EASE_OUT_CUBIC: "1 − (1 − {t})³",
}


def easing_title(easing: int) -> str:
    """What an easing is called."""
    return _TITLES[easing]


def easing_formula(easing: int, t: float) -> str:
    """What is worked out at ``t``, with its number; where there is no formula, what is done."""
    number = numeral(t)
    if easing == CONSTANT:
        return "the value before, held,"
    if easing == LINEAR:
        return f"t = {number} itself"
    if easing == EASE_IN_OUT_CUBIC:
        return f"4 · {number}³" if t < 0.5 else f"1 − 4 (1 − {number})³"
    if easing == BEZIER:
        return f"the height of the curve above {number}"
    return _FORMULAS[easing].format(t=number)


def way_text(first: float, second: float, part: float) -> str:
    """How much of the way is gone, with its numbers: first + part (second − first)."""
    start = f"({numeral(first)})" if first < 0 else numeral(first)
    return f"{numeral(first)} + {numeral(part)} · ({numeral(second)} − {start})"
