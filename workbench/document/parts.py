"""What has an id of its own and parts that have theirs: figures, and what a scene is made of."""

import re
from functools import cached_property
from itertools import chain
from typing import Any

from workbench.document.fields import parts_of

_NUMBER = re.compile(r"[0-9]{1,15}$")


def number_of(identity: str) -> int:
    """The number that an id ends in; 0 where it ends in none."""
    number = _NUMBER.search(identity)
    return int(number.group()) if number else 0


def ids_of_copy(was: Any, copy: Any) -> dict[str, str]:
    """The ids of a copy and its parts by those in their places in what was copied."""
    lists = (zip(getattr(was, name), getattr(copy, name), strict=False) for name in parts_of(type(was)))
    return {was.id: copy.id} | {old.id: new.id for old, new in chain.from_iterable(lists)}


class WithParts:
    """The ids of a struct and of its parts, found once; it keeps what is cached, as ``dict=True`` lets it."""

    __slots__ = ()

    @cached_property
    def ids(self: Any) -> tuple[str, ...]:
        """Its own id and those of its parts."""
        return (self.id, *(part.id for part in self.parts))

    @cached_property
    def highest(self) -> int:
        """The highest number that one of its ids ends in; 0 where none does."""
        return max(map(number_of, self.ids))

    @property
    def parts(self) -> tuple[Any, ...]:
        """What in it has an id."""
        lists = [parts for name in parts_of(type(self)) if (parts := getattr(self, name))]
        return lists[0] if len(lists) == 1 else tuple(chain.from_iterable(lists))
