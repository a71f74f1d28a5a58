"""How the methods for hidden surfaces are told: lists of surfaces, answers to tests."""

from collections.abc import Iterable

_LISTED = 8


def listed(numbers: Iterable[int]) -> str:
    """Numbers of surfaces as a table has them; a long list is cut, of none there is a dash."""
    texts = [str(number) for number in numbers]
    return ", ".join([*texts[:_LISTED], "…"] if len(texts) > _LISTED else texts) or "–"


def answer(holds: bool) -> str:
    """The answer to a test."""
    return "yes" if holds else "no"
