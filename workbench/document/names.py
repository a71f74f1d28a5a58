"""Names that tell things of one list apart. None is longer than MAX_NAME, if those given are not."""

import re
from collections.abc import Collection, Iterable, Iterator
from itertools import chain, count

from workbench.document.check import MAX_NAME
from workbench.language import _

_NUMBER = re.compile(r"(?<=\S) ([0-9]{1,3})\Z")  # a longer one is a year, or otherwise part of the name


def free_name(name: str, taken: Collection[str]) -> str:
    """``name``, or where it is taken, with the first number that makes it another, from its own on."""
    if name not in taken:
        return name
    plain, number = _parted(name)
    return first_free(_numbered("{name}", number + 1), taken, plain)


def name_of_copy(name: str, taken: Collection[str]) -> str:
    """What a copy of ``name`` is called; a copy of a copy is one more of the original."""
    template = _("{name} copy")
    before, _name, after = template.partition("{name}")
    plain, _number = _parted(name)
    original = plain.removeprefix(before).removesuffix(after)
    if not original or template.format(name=original) != plain:
        original = name
    return first_free(chain([template], _numbered(template, 2)), taken, original)


def first_free(templates: Iterable[str], taken: Collection[str], name: str = "") -> str:
    """The first of ``templates`` that is not taken, each filled with as much of ``name`` as has room."""
    filled = (
        template.format(name=name[: MAX_NAME - len(template.format(name=""))].rstrip())
        for template in templates
    )
    return next(each for each in filled if each not in taken)


def _numbered(template: str, first: int) -> Iterator[str]:
    return (f"{template} {number}" for number in count(max(first, 2)))


def _parted(name: str) -> tuple[str, int]:
    """``name`` without the number at its end, and that, or 0."""
    number = _NUMBER.search(name)
    return (name[: number.start()], int(number[1])) if number else (name, 0)
