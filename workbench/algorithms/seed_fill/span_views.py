"""What the boundary fill by spans shows of its blocks."""

from workbench.algorithms.entry import View


def run_text(left: int, right: int) -> str:
    """The columns of a run: 2 to 6, or a single one."""
    return f"{left} to {right}" if left < right else f"{left}"


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


def _no_run(when: str, why: str) -> View:
    """A pixel at which no run begins; a large picture is not recorded, and why is not told there."""
    return View(
        block=_FILL,
        when=f"right < before.left and {when}",
        candidates="tested_pixels(y, left, right)",
        rejected=_END,
        row="(y, (span_left, span_right), '', 0, len(stack))",
        tables=_STACK,
        considers="(right + 1, y)",
        sentence=f"{{(right + 1, y)}} {why}: no run begins here.",
    )


def _refused(when: str, why: str) -> View:
    """A seed from which nothing is filled."""
    return View(
        block=_SEED,
        when=when,
        rejected="((x, y),)",
        considers="(x, y)",
        tables=_STACK,
        sentence=f"The seed {{(x, y)}} {why}: there is nothing to fill.",
    )


VIEWS = (
    _refused("not stack and not is_in(image, x, y)", "is outside the picture"),
    _refused("not stack and colour == boundary", "is boundary"),
    _refused("not stack", "has been filled already"),
    View(
        block=_SEED,
        chosen="tested_pixels(y, left, right - 1)",
        considers="(x, y)",
        tables=_STACK,
        sentence="On row {y} the run of the seed is {run_text(left, right)}: fill it, and push it for the "
        "rows below and above.",
    ),
    View(
        block=_BACK,
        when="left < span_left - 1",
        considers="(left - 1, y)",
        sentence="On row {y} the first run begins at {left}, left of the span from {span_left}: push "
        "{run_text(left, span_left - 2)} for the way back.",
    ),
    View(block=_BACK, considers="(left - 1, y)"),
    _no_run("not is_recorded(image)", "is boundary or has been filled already"),
    _no_run("image[y, right + 1] == boundary", "is boundary"),
    _no_run("True", "has been filled already"),
    _filled(
        "right > span_right + 1",
        "Fill {run_text(before.left, right)} on row {y} and push it for the next row. It reaches further "
        "right than the span up to {span_right}: push {run_text(span_right + 2, right)} for the way back, "
        "{len(stack)} on the stack.",
    ),
    _filled(
        "True",
        "Fill {run_text(before.left, right)} on row {y} and push it for the next row, "
        "{len(stack)} on the stack.",
    ),
)
