"""What methods for hidden surfaces count and keep, in words."""

from collections.abc import Mapping

from workbench.algorithms import catalogue
from workbench.algorithms.counted import Counted, Kept
from workbench.language import _, ngettext
from workbench.rendering.scene.arena import MethodRun


def counted_texts(run: MethodRun) -> list[str]:
    """How many there were of each thing that the method counts."""
    return _texts(run.counted, catalogue.get(run.method).counted)


def kept_texts(run: MethodRun) -> list[str]:
    """How many there are at most of each thing that the method keeps."""
    return _texts(run.keeps, catalogue.get(run.method).keeps)


def _texts(numbers: Mapping[str, int], declared: Mapping[str, Counted] | Mapping[str, Kept]) -> list[str]:
    return [
        _("{n:,} {what}").format(n=n, what=ngettext(declared[plural].singular, plural, n))
        for plural, n in numbers.items()
    ]
