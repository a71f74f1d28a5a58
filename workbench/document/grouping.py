"""Groups: figures of a sheet with the same number, other than 0, stay together."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import count

from msgspec.structs import replace

from workbench.document.addresses import figures_with
from workbench.document.building import Edit, checked, with_changed, with_figures
from workbench.document.model import AnyFigure, Document


def regrouped(figures: Sequence[AnyFigure], beside: Iterable[AnyFigure] = ()) -> list[AnyFigure]:
    """``figures`` in groups of their own, none of which is ``beside`` them; one that is alone is in none."""
    sizes = Counter(figure.group for figure in figures)
    free = _free_numbers(beside)
    numbers = {group: next(free) if group and size > 1 else 0 for group, size in sizes.items()}
    return [
        figure if figure.group == numbers[figure.group] else replace(figure, group=numbers[figure.group])
        for figure in figures
    ]


def _free_numbers(figures: Iterable[AnyFigure]) -> Iterator[int]:
    taken = {figure.group for figure in figures}
    return (number for number in count(1) if number not in taken)


@checked
def group_figures(figures: Iterable[str]) -> Edit:
    """Make these figures of each sheet one group, behind its front one; the groups they were in lose them."""
    chosen = frozenset(figures)

    def edit(document: Document) -> Document:
        figures_with(document, chosen)
        for sheet in document.sheets:
            own = [k for k, figure in enumerate(sheet.figures) if figure.id in chosen]
            if len(own) < 2:
                continue
            number = next(_free_numbers(sheet.figures))
            members = [replace(sheet.figures[k], group=number) for k in own]
            behind = [figure for figure in sheet.figures[: own[-1]] if figure.id not in chosen]
            document = with_figures(document, sheet, (*behind, *members, *sheet.figures[own[-1] + 1 :]))
        return document

    return edit


@checked
def ungroup_figures(figures: Iterable[str]) -> Edit:
    """Dissolve every group that one of these figures is in."""
    chosen = frozenset(figures)

    def edit(document: Document) -> Document:
        figures_with(document, chosen)
        for sheet in document.sheets:
            groups = {figure.group for figure in sheet.figures if figure.id in chosen} - {0}
            freed = [replace(figure, group=0) for figure in sheet.figures if figure.group in groups]
            document = with_changed(document, freed)
        return document

    return edit


@checked
def shift_order(figures: Iterable[str], by: int) -> Edit:
    """Move these figures past what is next in front of them, or with a negative ``by`` behind them.

    A group goes as a whole, and is passed as a whole; of one that is not ``figures`` as a whole they move
    within it, too.
    """
    chosen = frozenset(figures)

    def edit(document: Document) -> Document:
        figures_with(document, chosen)
        for sheet in document.sheets:
            blocks = _blocks(sheet.figures, chosen)[:: 1 if by > 0 else -1]
            for k in reversed(range(len(blocks) - 1)):
                if blocks[k][0].id in chosen and blocks[k + 1][0].id not in chosen:
                    blocks[k], blocks[k + 1] = blocks[k + 1], blocks[k]
            blocks = blocks[:: 1 if by > 0 else -1]
            order = tuple(figure for block in blocks for figure in block)
            if order != sheet.figures:
                document = with_figures(document, sheet, order)
        return document

    return edit


def _blocks(figures: Sequence[AnyFigure], chosen: frozenset[str]) -> list[list[AnyFigure]]:
    """What is passed and moved as one: neighbours of one group, unless only some of it are ``chosen``."""
    sides: dict[int, set[bool]] = {}
    for figure in figures:
        sides.setdefault(figure.group, set()).add(figure.id in chosen)
    blocks: list[list[AnyFigure]] = []
    for figure in figures:
        goes_along = blocks and figure.group and figure.group == blocks[-1][0].group
        if goes_along and len(sides[figure.group]) == 1:
            blocks[-1].append(figure)
        else:
            blocks.append([figure])
    return blocks
