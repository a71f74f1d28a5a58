"""What the fills with a stack show: boundary and flood fill alike, with four neighbours or eight."""

from workbench.algorithms.entry import View

COLUMNS = ("pixel", "neighbour", "its colour", "pushed", "stack")

_SEED = "Test the seed"
_DECIDE_BOUNDARY = "Colour it and push it, unless it is boundary or filled"
_DECIDE_FLOOD = "Colour it and push it, if it has the seed's old colour"
_PIXEL = "((next_x, next_y),)"
_OUTSIDE = "not is_in(image, next_x, next_y)"
_SEED_OUTSIDE = "not is_in(image, x, y)"
_STACK = {"Stack": ("stack", ("x", "y"))}


def _decided(block: str, when: str, pushed: bool, sentence: str) -> View:
    """One outcome of the test of a neighbour."""
    return View(
        block=block,
        when=when,
        candidates=_PIXEL,
        chosen=_PIXEL if pushed else "()",
        rejected="()" if pushed else _PIXEL,
        row=f"((x, y), (next_x, next_y), colour, {int(pushed)}, len(stack))",
        tables=_STACK,
        considers="(next_x, next_y)",
        sentence=sentence,
    )


def _refused(when: str, why: str) -> View:
    """A seed from which nothing is filled."""
    return View(
        block=_SEED,
        when=when,
        rejected="((x, y),)",
        considers="(x, y)",
        sentence=f"The seed {{(x, y)}} {why}: there is nothing to fill.",
    )


_START = (
    View(block="Colour the seed and push it", chosen="((x, y),)", tables=_STACK),
    View(
        block="Take a pixel from the stack",
        tables=_STACK,
        sentence="Take {(x, y)} from the stack: {len(stack)} left on it.",
    ),
)

BOUNDARY_VIEWS = (
    _refused(_SEED_OUTSIDE, "is outside the picture"),
    _refused("colour == boundary", "is boundary"),
    _refused("colour == fill", "has been filled already"),
    View(block=_SEED, considers="(x, y)", sentence="The seed {(x, y)} has colour {colour}: go."),
    *_START,
    _decided(
        _DECIDE_BOUNDARY,
        _OUTSIDE,
        False,
        "{(next_x, next_y)} beside {(x, y)} is outside the picture, which counts as boundary: leave it.",
    ),
    _decided(
        _DECIDE_BOUNDARY,
        "colour == boundary",
        False,
        "{(next_x, next_y)} beside {(x, y)} is boundary: leave it.",
    ),
    _decided(
        _DECIDE_BOUNDARY,
        "colour == fill",
        False,
        "{(next_x, next_y)} beside {(x, y)} has been filled already: leave it.",
    ),
    _decided(
        _DECIDE_BOUNDARY,
        "True",
        True,
        "{(next_x, next_y)} beside {(x, y)} has colour {colour}, neither boundary nor "
        "filled: colour it and push it, {len(stack)} on the stack.",
    ),
)

FLOOD_VIEWS = (
    _refused(_SEED_OUTSIDE, "is outside the picture"),
    _refused("old == fill", "has the fill's colour {fill} already"),
    View(
        block=_SEED,
        considers="(x, y)",
        sentence="The seed {(x, y)} has colour {old}: what has it and can be reached becomes {fill}.",
    ),
    *_START,
    _decided(
        _DECIDE_FLOOD,
        _OUTSIDE,
        False,
        "{(next_x, next_y)} beside {(x, y)} is outside the picture, which counts as filled: leave it.",
    ),
    _decided(
        _DECIDE_FLOOD,
        "colour == fill",
        False,
        "{(next_x, next_y)} beside {(x, y)} has the fill's colour already: leave it.",
    ),
    _decided(
        _DECIDE_FLOOD,
        "colour != old",
        False,
        "{(next_x, next_y)} beside {(x, y)} has colour {colour}, not {old}: leave it.",
    ),
    _decided(
        _DECIDE_FLOOD,
        "True",
        True,
        "{(next_x, next_y)} beside {(x, y)} has the old colour {old}: colour it and push it, {len(stack)} on "
        "the stack.",
    ),
)
