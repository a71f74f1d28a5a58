"""Colours of SVG, and those of a sheet's palette."""

from functools import lru_cache

from workbench.document.model import Sheet

_LONGEST = 60


@lru_cache(1000)
def colour_of(text: str) -> int | None:
    """A colour as 0xRRGGBB; None where nothing is painted. What cannot be understood is black."""
    word = text.strip()
    if word in ("none", "transparent"):
        return None
    if len(word) > _LONGEST:
        return 0
    import svgelements

    try:
        found = svgelements.Color(word).rgb
    except (ValueError, TypeError, AttributeError, IndexError):
        return 0
    return 0 if found is None else int(found) & 0xFFFFFF


def nearest_colour(colour: int, sheet: Sheet) -> int:
    """The palette index nearest to 0xRRGGBB; the background's only where no other has that very colour."""
    return _nearest(colour, sheet.palette, sheet.background)


@lru_cache(1000)
def _nearest(colour: int, palette: tuple[int, ...], background: int) -> int:
    def distance(index: int) -> tuple[int, bool]:
        own = palette[index]
        apart = sum(((own >> shift & 255) - (colour >> shift & 255)) ** 2 for shift in (0, 8, 16))
        return apart + (index == background and apart > 0) * 10**6, index == background

    return min(range(len(palette)), key=distance)


def written(colour: int) -> str:
    """0xRRGGBB as SVG writes it."""
    return f"#{colour:06x}"
