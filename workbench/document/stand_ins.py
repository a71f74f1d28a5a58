"""What draws or clips in the place of algorithms that a file names and this version lacks."""

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import islice

from workbench.algorithms import catalogue
from workbench.document.model import Sheet
from workbench.language import _, ngettext

_MOST = 4
"""Of more sentences none is read."""


def stand_ins(sheets: Iterable[Sheet]) -> list[str]:
    """A sentence for each algorithm that the catalogue lacks: who asks for it, and what serves instead."""
    sentences = list(dict.fromkeys(_sentences(tuple(sheets))))
    more = len(sentences) - _MOST
    if more <= 0:
        return sentences
    text = ngettext("And {n} more like these.", "And {n} more like these.", more)
    return [*islice(sentences, _MOST), text.format(n=more)]


def _sentences(sheets: tuple[Sheet, ...]) -> Iterator[str]:
    drawn = Counter(
        (figure.algorithm, figure.drawn_with)
        for sheet in sheets
        for figure in sheet.figures
        if figure.algorithm != figure.drawn_with
    )
    for (slug, instead), count in drawn.items():
        text = ngettext(
            "{n} figure asks for {slug}, which this version lacks; {title} draws it, "
            "and the file keeps the name.",
            "{n} figures ask for {slug}, which this version lacks; {title} draws them, "
            "and the file keeps the name.",
            count,
        )
        yield text.format(n=count, slug=slug, title=_(catalogue.get(instead).title))
    for sheet in sheets:
        for slug, instead in (
            (sheet.line_clipper, sheet.lines_clipped_with),
            (sheet.polygon_clipper, sheet.polygons_clipped_with),
        ):
            if slug != instead:
                text = _(
                    "A sheet asks for {slug} to clip with, which this version lacks; {title} clips instead, "
                    "and the file keeps the name."
                )
                yield text.format(slug=slug, title=_(catalogue.get(instead).title))
