"""The built-in picture for colour tubes: bars of all that three beams make at full strength."""

from msgspec.structs import replace

from workbench.document.model import Document
from workbench.document.samples.figures import Example, document_of, polygon
from workbench.language import _

_WIDTH, _HEIGHT = 64, 48
_BAR = 8
_PALETTE = (0x000000, 0xFFFFFF, 0xFFFF00, 0x00FFFF, 0x00FF00, 0xFF00FF, 0xFF0000, 0x0000FF, 0xFF8000)


def colour_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "colour-bars",
            _("Colour bars"),
            _("White, the three pairs of beams, each beam alone, and orange: for the mask close up."),
            "display",
            _bars(),
            page="colour",
        ),
    ]


def _bars() -> Document:
    names = (
        _("White"),
        _("Yellow"),
        _("Cyan"),
        _("Green"),
        _("Magenta"),
        _("Red"),
        _("Blue"),
        _("Orange"),
    )
    bars = [polygon([_bar(number)], number + 1, name, closed=True) for number, name in enumerate(names)]
    document = document_of(_("Colour bars"), _WIDTH, _HEIGHT, bars)
    return replace(document, sheets=(replace(document.sheets[0], palette=_PALETTE),))


def _bar(number: int) -> list[tuple[float, float]]:
    """Its corners are pixels, which belong to it."""
    left, right = float(_BAR * number), float(_BAR * (number + 1) - 1)
    low, high = 4.0, _HEIGHT - 5.0
    return [(left, low), (right, low), (right, high), (left, high)]
