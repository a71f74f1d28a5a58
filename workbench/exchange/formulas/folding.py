"""Lines of words and formulas, folded at a width."""

from collections.abc import Iterator
from typing import NamedTuple

from workbench.exchange.formulas.layout import Primitive, Style, Typesetter, moved

_LEADING = 1.45


class Folded(NamedTuple):
    """Width and height in points, and what is written there, its top left at the origin."""

    width: float
    height: float
    primitives: tuple[Primitive, ...]


def folded(typesetter: Typesetter, text: str, room: float, size: float, strong: bool = False) -> Folded:
    """Words, and between dollar signs formulas, in lines of ``room`` points, folded between words; nothing is
    cut, so that a word wider than the room is wider than it.
    """
    line = _LEADING * size
    space = typesetter.metrics.width(" ", size, "upright")
    primitives: list[Primitive] = []
    x, y, widest = 0.0, typesetter.metrics.ascent(size), 0.0
    style: Style = "bold" if strong else "upright"
    for run in _runs(text):
        if run.formula:
            box = typesetter.formula(run.text, size, strong)
        else:
            box = typesetter.text(run.text, size, style)
        gap = 0.0 if run.glued or x == 0.0 else space
        if x and not run.glued and x + gap + box.width > room:
            x, y, gap = 0.0, y + line, 0.0
        primitives += moved(box.primitives, x + gap, y)
        x += gap + box.width
        widest = max(widest, x)
    return Folded(widest, y + typesetter.metrics.descent(size) + 0.3 * size, tuple(primitives))


class _Run(NamedTuple):
    """A word, or a formula; ``glued`` where no blank stands before it."""

    text: str
    formula: bool
    glued: bool


def _runs(text: str) -> Iterator[_Run]:
    """The words of a sentence, and the formulas between its dollar signs."""
    parts = text.split("$")
    if len(parts) % 2 == 0:  # a dollar sign alone is itself
        parts[-2:] = ["$".join(parts[-2:])]
    glued = True
    for number, part in enumerate(parts):
        if number % 2:
            yield _Run(part, True, glued)
            glued = True
            continue
        for k, word in enumerate(part.split()):
            yield _Run(word, False, glued and not (k or part[0].isspace()))
        if part:
            glued = not part[-1].isspace()
