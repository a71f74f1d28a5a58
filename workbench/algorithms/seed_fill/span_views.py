"""What the boundary fill by spans shows of its blocks."""

from workbench.algorithms.entry import View


def tested_pixels(y: int, left: int, right: int) -> tuple[tuple[int, int], ...]:
    """The pixels of a run and the one that ends it."""
    return tuple((x, y) for x in range(left, right + 2))


COLUMNS = ("y", "looked at from", "run", "pixels", "stack")

_SEED = "Fill the seed's run and look from it both ways"
_BACK = "Look back where the first run reaches further left than the span"
_FILL = "Fill the run, if there is one, and push it"

_STACK = {"Stack": ("stack", ("y", "x left", "x right", "direction"))}
_END = "((right + 1, y),)"
_ROW = "(y, (span_left, span_right), (before.left, right), right - before.left + 1, len(stack))"


def _filled(when: str, sentence: str) -> View:
    """A run that was filled."""
    return View(
        block=_FILL,
        when=when,
        candidates="tested_pixels(y, left, right)",
        chosen="tested_pixels(y, before.left, right - 1)",
        rejected=_END,
        row=_ROW,
        tables=_STACK,
        considers="(right + 1, y)",
        sentence=sentence,
    )


VIEWS = (
    View(
        block=_SEED,
        when="not stack",
        rejected="((x, y),)",
        considers="(x, y)",
        tables=_STACK,
        sentence="The seed {(x, y)} is boundary, filled or outside the picture: there is nothing to fill.",
    ),
    View(
        block=_SEED,
        chosen="tested_pixels(y, left, right - 1)",
        considers="(x, y)",
        tables=_STACK,
        sentence="On row {y} the run of the seed is {left} to {right}: fill it, and push it for the rows "
        "below and above.",
    ),
    View(
        block=_BACK,
        when="left < span_left - 1",
        considers="(left - 1, y)",
        sentence="On row {y} the first run begins at {left}, left of the span from {span_left}: push {left} "
        "to {span_left - 2} for the way back.",
    ),
    View(block=_BACK, considers="(left - 1, y)"),
    View(
        block=_FILL,
        when="right < before.left",
        candidates="tested_pixels(y, left, right)",
        rejected=_END,
        row="(y, (span_left, span_right), '', 0, len(stack))",
        tables=_STACK,
        considers="(right + 1, y)",
        sentence="{(right + 1, y)} is boundary, filled or outside the picture: no run begins here.",
    ),
    _filled(
        "right > span_right + 1",
        "Fill {before.left} to {right} on row {y} and push it for the next row. It reaches further right "
        "than the span up to {span_right}: push {span_right + 2} to {right} for the way back, {len(stack)} "
        "on the stack.",
    ),
    _filled(
        "True",
        "Fill {before.left} to {right} on row {y} and push it for the next row, {len(stack)} on the stack.",
    ),
)
