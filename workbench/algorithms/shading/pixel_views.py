"""What every shading shows of a pixel: whether the triangle is nearer there, and so lit."""

from collections.abc import Mapping

from workbench.algorithms.entry import View

NO_TABLES: Mapping[str, tuple[str, tuple[str, ...]]] = {}
_PIXEL = "((x, y),)"
_OPTIONS = "('nearer: it is lit', 'hidden: nothing is written')"


def pixel_view(
    block: str,
    row: str,
    when: str,
    written: bool,
    sentence: str,
    tables: Mapping[str, tuple[str, tuple[str, ...]]] = NO_TABLES,
) -> View:
    """The view of the block that lights a pixel or leaves it; ``row`` is its line of the hand table."""
    return View(
        block=block,
        when=when,
        candidates=_PIXEL,
        chosen=_PIXEL if written else "()",
        rejected="()" if written else _PIXEL,
        row=row,
        considers="(x, y)",
        tables=tables,
        options=_OPTIONS,
        answer="'nearer: it is lit'" if written else "'hidden: nothing is written'",
        sentence=sentence,
    )
