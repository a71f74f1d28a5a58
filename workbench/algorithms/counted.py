"""What an algorithm counts and keeps beside the arithmetic and its picture."""

from typing import NamedTuple


class Counted(NamedTuple):
    """What is counted, as it is called of one, and how the titles of the blocks begin that count it.

    ``short`` is what is said behind the number, of one and of many, where there is no room for more.
    """

    singular: str
    blocks: tuple[str, ...]
    short: str = ""


class Kept(NamedTuple):
    """What is kept, as it is called of one, and an expression for how many there are at most.

    That is over the parameters and ``counted``, the numbers of what is counted, each by its plural.
    """

    singular: str
    most: str
