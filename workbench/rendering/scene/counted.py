"""What methods for hidden surfaces count and keep, in words."""

from collections.abc import Mapping

from workbench.algorithms import catalogue
from workbench.algorithms.counted import Counted, Kept
from workbench.language import _, ngettext
from workbench.rendering.scene.arena import MethodRun


def counted_texts(run: MethodRun) -> list[str]:
    """How many there were of each thing that the method counts."""
    return _texts(run.counted, catalogue.get(run.method).counted)


def counted_forms(run: MethodRun) -> list[tuple[str, ...]]:
    """The same, each followed by a shorter form where there is one."""
    forms: list[tuple[str, ...]] = []
    for whole, (plural, n) in zip(counted_texts(run), run.counted.items(), strict=True):
        short = catalogue.get(run.method).counted[plural].short
        forms.append((whole, _("{n:,} {what}").format(n=n, what=_(short))) if short else (whole,))
    return forms


def kept_texts(run: MethodRun) -> list[str]:
    """How many there are at most of each thing that the method keeps."""
    return _texts(run.keeps, catalogue.get(run.method).keeps)


def _texts(numbers: Mapping[str, int], declared: Mapping[str, Counted] | Mapping[str, Kept]) -> list[str]:
    return [
        _("{n:,} {what}").format(n=n, what=ngettext(declared[plural].singular, plural, n))
        for plural, n in numbers.items()
    ]
