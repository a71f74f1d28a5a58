"""A built-in picture for the raster tube: ramps that few bits cannot hold, and lines one pixel high."""

import colorsys

from msgspec.structs import replace

from workbench.document.model import AnyFigure, Document
from workbench.document.samples.figures import Example, document_of, line, polygon
from workbench.language import _

_WIDTH, _HEIGHT = 64, 48
_BARS = 32
_HUES, _GREYS, _FINE = (29.5, 45.5), (13.5, 27.5), (2, 5, 6, 9)


def raster_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "raster-card",
            _("A test card"),
            _("All hues, a ramp of greys and lines one pixel high: what few bits lose, and what twitters."),
            "display",
            _card(),
            "raster",
            dock="raster_buffer",
        )
    ]


def _card() -> Document:
    """Bars of all hues, below them bars of greys, and lines."""
    hues = [_packed(colorsys.hsv_to_rgb(k / _BARS, 1.0, 1.0)) for k in range(_BARS)]
    greys = [_packed((k / (_BARS - 1),) * 3) for k in range(_BARS)]
    figures: list[AnyFigure] = []
    for first, (low, high), title in ((1, _HUES, _("Hue {k}")), (1 + _BARS, _GREYS, _("Grey {k}"))):
        for k in range(_BARS):
            left, right = k * _WIDTH // _BARS - 0.5, (k + 1) * _WIDTH // _BARS - 0.5
            bar = [(left, low), (right, low), (right, high), (left, high)]
            figures.append(polygon([bar], first + k, title.format(k=k + 1)))
    white = 2 * _BARS
    figures += [line((4, y), (_WIDTH - 5, y), white, name=_("Fine line {y}").format(y=y)) for y in _FINE]
    document = document_of(_("A test card"), _WIDTH, _HEIGHT, figures)
    sheet = replace(document.sheets[0], palette=(0x000000, *hues, *greys))
    return replace(document, sheets=(sheet,))


def _packed(channels: tuple[float, ...]) -> int:
    red, green, blue = (round(255 * channel) for channel in channels)
    return (red << 16) + (green << 8) + blue
